#include "geometry/build_model.h"

#include "geometry/image_parts.h"
#include "geometry/parts.h"
#include "geometry/shape_parts.h"
#include "grid/effective_cell.h"
#include "scene/problem.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

namespace abut {

namespace {

/// What says that a body exists: an entry of scene.bodies or of a legend.
struct Mention {
    std::string pointer, name, material;
    InitialVelocity velocity;
    InitialState state;
    std::optional<RigidSpec> rigid; ///< then it has no material
    std::string group{};
};

/// The model while it is built: its bodies, and their initial states, which are complete only when the particles are
/// there.
struct Building {
    const Scene& scene;
    Model model{};
    std::vector<InitialState> state{}; ///< per body
    std::vector<Part> parts{};
    std::vector<Problem> problems{};
};

/// Index of the named body in the model, which gets it if it is new.
int body_index(const Mention& mention, Building& building) {
    const Scene& scene = building.scene;
    std::vector<ModelBody>& bodies = building.model.bodies;
    const auto report = [&](const std::string& key, const std::string& what) {
        building.problems.push_back({mention.pointer + key, what});
    };
    int material = -1;
    for (std::size_t k = 0; k < scene.materials.size(); ++k)
        if (scene.materials[k].name == mention.material) material = static_cast<int>(k);
    if (material < 0 && !mention.rigid) report("/material", fmt::format("no material \"{}\"", mention.material));

    for (std::size_t k = 0; k < bodies.size(); ++k) {
        const ModelBody& known = bodies[k];
        if (known.name != mention.name) continue;
        if (mention.rigid || known.rigid)
            report("",
                   fmt::format("body \"{}\" exists already; a rigid body has one shape or colour only", mention.name));
        else if (material >= 0 && known.material >= 0 && known.material != material)
            report("/material", fmt::format("body \"{}\" exists already, of material \"{}\"", mention.name,
                                            scene.materials[static_cast<std::size_t>(known.material)].name));
        else if (known.velocity != mention.velocity)
            report("/velocity", fmt::format("body \"{}\" exists already, with another velocity", mention.name));
        else if (!(building.state[k] == mention.state))
            report("", fmt::format("body \"{}\" exists already, with another initial state", mention.name));
        return static_cast<int>(k);
    }
    bodies.push_back({mention.name, material, mention.velocity, mention.rigid, mention.group, mention.state.stress});
    building.state.push_back(mention.state);
    return static_cast<int>(bodies.size()) - 1;
}

bool has_usable_grid(const GridSpec& grid, int dimension) {
    for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimension); ++axis)
        if (!(grid.cell[axis] > 0) || !(grid.upper[axis] > grid.lower[axis])) return false;
    return true;
}

void add_shapes(Building& building, const std::string& scene_name, bool wants_exact, std::vector<std::string>& notes) {
    const std::vector<BodySpec>& bodies = building.scene.bodies;
    std::vector<int> index;
    for (std::size_t k = 0; k < bodies.size(); ++k) {
        const BodySpec& body = bodies[k];
        index.push_back(body_index(
            {fmt::format("/bodies/{}", k), body.name, body.material, body.velocity, body.state, body.rigid}, building));
    }
    std::vector<Part> parts = shape_parts(building.scene, scene_name, wants_exact, notes, building.problems);
    for (std::size_t k = 0; k < parts.size(); ++k) {
        parts[k].body = index[k];
        building.parts.push_back(std::move(parts[k]));
    }
}

bool has_body(const Model& model, const std::string& name) {
    return std::any_of(model.bodies.begin(), model.bodies.end(),
                       [&](const ModelBody& body) { return body.name == name; });
}

void add_image(Building& building, std::size_t index, const std::string& scene_name, std::vector<std::string>& notes) {
    const ImageSpec& spec = building.scene.images[index];
    const auto mention = [&](std::size_t k, const std::string& name) {
        const LegendEntry& entry = spec.legend[k];
        return Mention{fmt::format("/images/{}/legend/{}", index, k),
                       name,
                       entry.material,
                       {entry.velocity},
                       entry.state,
                       entry.rigid,
                       spec.bodies == BodiesBy::legend ? "" : entry.body};
    };
    // All entries, also those that make no body of their own: a wrong material is wrong in any case.
    if (spec.bodies == BodiesBy::legend)
        for (std::size_t k = 0; k < spec.legend.size(); ++k)
            if (!spec.legend[k].is_void) body_index(mention(k, spec.legend[k].body), building);
    for (ImagePart& each : image_parts(building.scene, index, scene_name, notes, building.problems)) {
        if (spec.bodies == BodiesBy::legend) {
            for (std::size_t k = 0; k < building.model.bodies.size(); ++k)
                if (building.model.bodies[k].name == each.part.body_name) each.part.body = static_cast<int>(k);
        } else {
            if (spec.bodies == BodiesBy::component && has_body(building.model, each.part.body_name))
                building.problems.push_back({each.part.pointer + "/body",
                                             fmt::format("there is a body \"{}\" already; components of several images "
                                                         "need different names",
                                                         each.part.body_name)});
            each.part.body = body_index(mention(each.entry, each.part.body_name), building);
        }
        building.parts.push_back(std::move(each.part));
    }
}

/// Names in laws and tractions that only the images could tell to be wrong.
void check_names(Building& building) {
    const auto exists = [&](const std::string& name) {
        return std::any_of(building.model.bodies.begin(), building.model.bodies.end(),
                           [&](const ModelBody& body) { return body.name == name || body.group == name; });
    };
    const auto check = [&](const std::string& pointer, const std::string& name) {
        if (!exists(name)) building.problems.push_back({pointer, fmt::format("no body \"{}\"", name)});
    };
    const Scene& scene = building.scene;
    constexpr double most_pairs = 5e6; // a law is stored for each
    double pairs = 0;
    const auto count = [&](const std::string& name) {
        return static_cast<double>(
            std::count_if(building.model.bodies.begin(), building.model.bodies.end(),
                          [&](const ModelBody& body) { return body.name == name || body.group == name; }));
    };
    for (std::size_t k = 0; scene.contact && k < scene.contact->laws.size(); ++k)
        pairs += count(scene.contact->laws[k].bodies[0]) * count(scene.contact->laws[k].bodies[1]);
    if (pairs > most_pairs)
        building.problems.push_back(
            {"/contact/laws", fmt::format("they are for {:.0f} pairs of bodies, more than {:.0f}; "
                                          "the law of most pairs belongs to /contact/law",
                                          pairs, most_pairs)});
    for (std::size_t k = 0; scene.contact && k < scene.contact->laws.size(); ++k)
        for (std::size_t i = 0; i < 2; ++i)
            check(fmt::format("/contact/laws/{}/bodies/{}", k, i), scene.contact->laws[k].bodies[i]);
    for (std::size_t k = 0; k < scene.boundaries.size(); ++k)
        if (const auto* traction = std::get_if<TractionSpec>(&scene.boundaries[k].condition))
            check(fmt::format("/boundaries/{}/traction/body", k), traction->body);
}

/// Particles of the parts, in their order.
void add_parts(Building& building) {
    Model& model = building.model;
    const std::vector<Part>& parts = building.parts;
    bool any_turned = false;
    for (const Part& part : parts)
        any_turned = any_turned || std::any_of(part.particle.begin(), part.particle.end(),
                                               [](const PlacedParticle& particle) { return particle.angle != 0; });
    const auto any = [&](auto&& has) { return std::any_of(parts.begin(), parts.end(), has); };
    const auto state = [&](const Part& part) -> const InitialState& {
        return building.state[static_cast<std::size_t>(part.body)];
    };
    const bool any_temperature =
        any([&](const Part& part) { return !part.temperature.empty() || state(part).temperature; });
    const bool any_orientation =
        any([&](const Part& part) { return !part.orientation.empty() || state(part).orientation; });
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    for (const Part& part : parts)
        for (std::size_t k = 0; k < part.size(); ++k) {
            model.position.push_back(part.particle[k].position);
            model.half_size.push_back(part.particle[k].half_size);
            model.body.push_back(part.body);
            if (any_turned) model.angle.push_back(part.particle[k].angle);
            if (any_temperature)
                model.temperature.push_back(part.temperature.empty() ? state(part).temperature.value_or(none)
                                                                     : part.temperature[k]);
            if (any_orientation)
                model.orientation.push_back(part.orientation.empty() ? state(part).orientation.value_or(none)
                                                                     : part.orientation[k]);
        }
}

/// ω × (x − the body's centre of mass) to the initial velocities of bodies that rotate.
void add_rotations(Building& building) {
    std::vector<Vector> centre(building.model.bodies.size());
    std::vector<double> content(building.model.bodies.size(), 0);
    for (const Part& part : building.parts)
        for (std::size_t k = 0; k < part.size(); ++k) {
            double weight = part.fraction_of(k) * part.lattice.content();
            // A ring around the axis of symmetry weighs in proportion to its radius.
            if (building.scene.analysis == Analysis::axisymmetric) weight *= part.particle[k].position[0];
            for (std::size_t a = 0; a < 3; ++a)
                centre[static_cast<std::size_t>(part.body)][a] += weight * part.particle[k].position[a];
            content[static_cast<std::size_t>(part.body)] += weight;
        }
    for (std::size_t b = 0; b < building.model.bodies.size(); ++b) {
        const Vector& w = building.state[b].angular_velocity;
        if ((w[0] == 0 && w[1] == 0 && w[2] == 0) || content[b] == 0) continue;
        for (double& x : centre[b]) x /= content[b];
        // v0 + L (x - x0) + W (x - c) = v0 + W (x0 - c) + (L + W) (x - x0).
        const std::array<Vector, 3> W{Vector{0, -w[2], w[1]}, Vector{w[2], 0, -w[0]}, Vector{-w[1], w[0], 0}};
        InitialVelocity& velocity = building.model.bodies[b].velocity;
        for (std::size_t i = 0; i < 3; ++i)
            for (std::size_t j = 0; j < 3; ++j) {
                velocity.value[i] += W[i][j] * (velocity.center[j] - centre[b][j]);
                velocity.gradient[i][j] += W[i][j];
            }
    }
}

void fill_report(const Building& building, ModelReport& report) {
    const Vector cell = effective_cell(building.scene.grid);
    double shortest = cell[0];
    for (std::size_t a = 1; a < static_cast<std::size_t>(dimension(building.scene.analysis)); ++a)
        shortest = std::min(shortest, cell[a]);
    std::vector<std::vector<const Part*>> of_body(building.model.bodies.size());
    for (const Part& part : building.parts) of_body[static_cast<std::size_t>(part.body)].push_back(&part);
    for (std::size_t b = 0; b < of_body.size(); ++b) {
        BodyReport body{building.model.bodies[b].name, 0, 0, 0, 0};
        for (const Part* part : of_body[b]) {
            body.particles += part->size();
            body.content += content_of(*part);
            body.exact += part->exact;
        }
        body.thinnest = thinnest_width(of_body[b], shortest);
        report.bodies.push_back(body);
    }
}

} // namespace

namespace {

/// More places than this per axis are a mistake in a unit: numbers of places would overflow.
void check_places(const Scene& scene, const std::string& scene_name) {
    constexpr double most_along_an_axis = 1e6;
    std::vector<Problem> problems;
    int finest = 1;
    for (const BodySpec& body : scene.bodies) finest = std::max(finest, body.particles_per_cell);
    for (const ImageSpec& image : scene.images) finest = std::max(finest, image.particles_per_cell);
    for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimension(scene.analysis)); ++axis) {
        const double places = (scene.grid.upper[axis] - scene.grid.lower[axis]) / scene.grid.cell[axis] * finest;
        if (!(places <= most_along_an_axis))
            problems.push_back(
                {"/grid/cell", fmt::format("the grid would have {:.3g} places for particles along {}: is the "
                                           "unit of the cells right?",
                                           places, "xyz"[axis])});
    }
    if (!problems.empty()) throw SceneError(scene_name, std::move(problems));
}

} // namespace

Model build_model(const Scene& scene, const std::string& scene_name, ModelReport* report) {
    if (!has_usable_grid(scene.grid, dimension(scene.analysis)))
        throw SceneError(scene_name, {{"/grid", "needs cells larger than 0 and an upper corner above the lower one"}});
    check_places(scene, scene_name);
    Building building{scene};
    std::vector<std::string> notes;
    add_shapes(building, scene_name, report != nullptr, notes);
    for (std::size_t k = 0; k < scene.images.size(); ++k) add_image(building, k, scene_name, notes);

    check_inside(building.parts, scene.grid, building.problems);
    if (scene.overlap == Overlap::refuse) {
        check_overlap(building.parts, building.problems);
    } else if (building.problems.empty()) {
        for (const GivenUp& gift : settle_overlap(building.parts, scene.overlap)) {
            Part& from = building.parts[gift.from];
            // A shape was cut by the shapes that come before it already.
            if (from.pointer.starts_with("/images") || building.parts[gift.to].pointer.starts_with("/images"))
                from.exact -= gift.content;
            notes.push_back(fmt::format("body \"{}\" ({}) gave {} to \"{}\" ({})", from.body_name, from.pointer,
                                        count_text(gift.particles, "particle"), building.parts[gift.to].body_name,
                                        building.parts[gift.to].pointer));
            if (from.size() == 0)
                building.problems.push_back(
                    {from.pointer, fmt::format("body \"{}\" got no particles: others have all of "
                                               "its place",
                                               from.body_name)});
        }
    }
    check_names(building);
    const bool has_particles =
        std::any_of(building.parts.begin(), building.parts.end(), [](const Part& part) { return part.size() > 0; });
    if (!has_particles && building.problems.empty())
        building.problems.push_back({"", "the scene has no particles: it needs bodies or images"});
    if (!building.problems.empty()) throw SceneError(scene_name, std::move(building.problems));

    add_parts(building);
    add_rotations(building);
    if (report) {
        fill_report(building, *report);
        report->notes = std::move(notes);
    }
    return std::move(building.model);
}

} // namespace abut
