#include "scene/validate.h"

#include "scene/suggest.h"

#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <utility>

namespace abut {

namespace {

using Problems = std::vector<Problem>;

std::string entry(const std::string& list, std::size_t index) {
    return list + "/" + std::to_string(index);
}

template <class T>
std::vector<std::string> names_of(const std::vector<T>& entries) {
    std::vector<std::string> names;
    names.reserve(entries.size());
    for (const T& named : entries) names.push_back(named.name);
    return names;
}

std::string unknown(const std::string& what, const std::string& name, const std::vector<std::string>& known) {
    const std::string guess = did_you_mean(name, known);
    const std::string list = known.empty() ? "; there is none" : "; there are: " + quoted_list(known, "and");
    return "no " + what + " \"" + name + "\"" + (guess.empty() ? list : guess);
}

bool is_one_of(const std::string& name, const std::vector<std::string>& names) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

void check_material(const std::string& name, const Scene& scene, const std::string& owner, Problems& problems) {
    const std::vector<std::string> known = names_of(scene.materials);
    if (!name.empty() && !is_one_of(name, known))
        problems.push_back({owner + "/material", unknown("material", name, known)});
}

/// Names that occur before in the same list.
template <class T>
void check_unique(const std::vector<T>& entries, const std::string& list, Problems& problems) {
    std::map<std::string, std::size_t> first;
    for (std::size_t i = 0; i < entries.size(); ++i) {
        if (entries[i].name.empty()) continue;
        const auto [place, is_new] = first.emplace(entries[i].name, i);
        if (!is_new) {
            problems.push_back({entry(list, i) + "/name",
                                "\"" + entries[i].name + "\" is already the name of " + entry(list, place->second)});
        }
    }
}

/// Several colours may make up one body; then they must agree in what the body is.
void check_legends(const Scene& scene, Problems& problems) {
    std::map<std::string, std::pair<const LegendEntry*, std::string>> first;
    for (std::size_t i = 0; i < scene.images.size(); ++i) {
        const std::vector<LegendEntry>& legend = scene.images[i].legend;
        for (std::size_t j = 0; j < legend.size(); ++j) {
            const LegendEntry& colour = legend[j];
            const std::string pointer = entry(entry("/images", i) + "/legend", j);
            if (colour.is_void) continue;
            if (!colour.rigid) check_material(colour.material, scene, pointer, problems);
            if (colour.body.empty()) continue;
            for (std::size_t k = 0; k < scene.bodies.size(); ++k) {
                if (scene.bodies[k].name == colour.body)
                    problems.push_back(
                        {pointer + "/body", "\"" + colour.body + "\" is already the name of " + entry("/bodies", k)});
            }
            const auto [place, is_new] = first.try_emplace(colour.body, &colour, pointer);
            if (is_new) continue;
            const auto& [same_body, same_pointer] = place->second;
            const std::string clash = " differs from that of the same body \"" + colour.body + "\" at " + same_pointer;
            if (same_body->material != colour.material)
                problems.push_back({pointer + "/material", "the material" + clash});
            if (same_body->velocity != colour.velocity)
                problems.push_back({pointer + "/velocity", "the velocity" + clash});
            if (!(same_body->state == colour.state)) problems.push_back({pointer, "the initial state" + clash});
        }
    }
}

/// All names of bodies; an empty one among them where the scene is wrong and a name is missing.
std::vector<std::string> body_names(const Scene& scene) {
    std::vector<std::string> names = names_of(scene.bodies);
    for (const ImageSpec& image : scene.images) {
        if (image.legend.empty()) names.emplace_back();
        for (const LegendEntry& colour : image.legend)
            if (!colour.is_void && !is_one_of(colour.body, names)) names.push_back(colour.body);
    }
    return names;
}

/// What the names of bodies begin with that only reading the images will tell.
std::vector<std::string> group_names(const Scene& scene) {
    std::vector<std::string> names;
    for (const ImageSpec& image : scene.images)
        for (const LegendEntry& colour : image.legend)
            if (image.bodies != BodiesBy::legend && !colour.is_void) names.push_back(colour.body);
    return names;
}

/// Whether the name is that of a body, or may be that of one of a group.
bool may_be_body(const std::string& name, const std::vector<std::string>& known, const Scene& scene) {
    if (is_one_of(name, known)) return true;
    const std::vector<std::string> groups = group_names(scene);
    return std::any_of(groups.begin(), groups.end(),
                       [&](const std::string& group) { return name.starts_with(group + "-"); });
}

/// Names of shapes that shapes and bodies use.
void check_shape_names(const Scene& scene, Problems& problems) {
    const std::vector<std::string> known = names_of(scene.shapes);
    const auto check = [&](const ShapeSpec& shape, const std::string& pointer) {
        if (const auto* named = std::get_if<NamedShape>(&shape))
            if (!named->name.empty() && !is_one_of(named->name, known))
                problems.push_back({pointer + "/shape", unknown("shape", named->name, known)});
        const auto* combination = std::get_if<Combination>(&shape);
        if (!combination) return;
        const std::array keys{"/union/", "/difference/", "/intersection/"};
        for (std::size_t i = 0; i < combination->shapes.size(); ++i)
            if (const std::string& name = combination->shapes[i]; !name.empty() && !is_one_of(name, known))
                problems.push_back(
                    {pointer + keys[static_cast<std::size_t>(combination->operation)] + std::to_string(i),
                     unknown("shape", name, known)});
    };
    for (const NamedShapeSpec& named : scene.shapes) check(named.shape, "/shapes/" + pointer_token(named.name));
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) check(scene.bodies[i].shape, entry("/bodies", i));
}

std::vector<std::string> rigid_names(const Scene& scene) {
    std::vector<std::string> names;
    for (const BodySpec& body : scene.bodies)
        if (body.rigid) names.push_back(body.name);
    for (const ImageSpec& image : scene.images)
        for (const LegendEntry& colour : image.legend)
            if (colour.rigid) names.push_back(colour.body);
    return names;
}

void check_pair_laws(const Scene& scene, Problems& problems) {
    if (!scene.contact) return;
    const std::vector<std::string> known = body_names(scene);
    const bool all_known = !is_one_of("", known);
    std::map<std::pair<std::string, std::string>, std::size_t> first;
    for (std::size_t i = 0; i < scene.contact->laws.size(); ++i) {
        const std::string pointer = entry("/contact/laws", i) + "/bodies";
        const auto& [a, b] = scene.contact->laws[i].bodies;
        if (all_known && !a.empty() && !may_be_body(a, known, scene))
            problems.push_back({pointer + "/0", unknown("body", a, known)});
        if (all_known && !b.empty() && !may_be_body(b, known, scene))
            problems.push_back({pointer + "/1", unknown("body", b, known)});
        if (a.empty() || b.empty()) continue;
        if (a == b && !is_one_of(a, group_names(scene)))
            problems.push_back({pointer, "\"" + a + "\" is named twice; a pair is two bodies"});
        const auto [place, is_new] = first.emplace(std::minmax(a, b), i);
        if (!is_new)
            problems.push_back(
                {pointer, "the law of this pair is already given at " + entry("/contact/laws", place->second)});
    }
}

void check_output_names(const Scene& scene, Problems& problems) {
    const std::vector<std::string> known = body_names(scene);
    if (is_one_of("", known)) return;
    const std::vector<std::string>& names = scene.output.bodies;
    for (std::size_t i = 0; i < names.size(); ++i)
        if (!names[i].empty() && !may_be_body(names[i], known, scene))
            problems.push_back({entry("/output/bodies", i), unknown("body", names[i], known)});
}

void check_boundary_names(const Scene& scene, Problems& problems) {
    const std::vector<std::string> known = body_names(scene);
    if (is_one_of("", known)) return;
    const std::vector<std::string> rigid = rigid_names(scene);
    for (std::size_t i = 0; i < scene.boundaries.size(); ++i) {
        const auto* traction = std::get_if<TractionSpec>(&scene.boundaries[i].condition);
        if (traction && is_one_of(traction->body, rigid))
            problems.push_back(
                {entry("/boundaries", i) + "/traction/body", "\"" + traction->body + "\" is rigid: no force moves it"});
        if (is_one_of(scene.boundaries[i].name, rigid))
            problems.push_back({entry("/boundaries", i) + "/name",
                                "\"" + scene.boundaries[i].name +
                                    "\" is already the name of a rigid body, whose force is in history.csv too"});
        if (traction && is_one_of(traction->body, group_names(scene)))
            problems.push_back({entry("/boundaries", i) + "/traction/body",
                                "\"" + traction->body + "\" stands for several bodies; name one of them"});
        if (traction && !traction->body.empty() && !may_be_body(traction->body, known, scene))
            problems.push_back({entry("/boundaries", i) + "/traction/body", unknown("body", traction->body, known)});
    }
}

} // namespace

std::vector<Problem> validate_names(const Scene& scene) {
    Problems problems;
    for (std::size_t i = 0; i < scene.bodies.size(); ++i)
        if (!scene.bodies[i].rigid) check_material(scene.bodies[i].material, scene, entry("/bodies", i), problems);
    check_shape_names(scene, problems);
    check_unique(scene.bodies, "/bodies", problems);
    check_legends(scene, problems);
    check_pair_laws(scene, problems);
    check_output_names(scene, problems);
    check_unique(scene.boundaries, "/boundaries", problems);
    check_boundary_names(scene, problems);
    return problems;
}

std::vector<Problem> validate(const Scene& scene) {
    Problems problems = validate_numbers(scene);
    const Problems names = validate_names(scene);
    problems.insert(problems.end(), names.begin(), names.end());
    return problems;
}

} // namespace abut
