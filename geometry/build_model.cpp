#include "geometry/build_model.h"

#include "geometry/image_parts.h"
#include "geometry/parts.h"
#include "geometry/shape_particles.h"
#include "scene/problem.h"

#include <fmt/format.h>

#include <algorithm>

namespace abut {

namespace {

/// What says that a body exists: an entry of scene.bodies or of a legend.
struct Mention {
    std::string pointer, name, material;
    InitialVelocity velocity;
    std::optional<RigidSpec> rigid; ///< then it has no material
};

/// Index of the named body in the model, which gets it if it is new.
int body_index(const Mention& mention, const Scene& scene, Model& model, std::vector<Problem>& problems) {
    int material = -1;
    for (std::size_t k = 0; k < scene.materials.size(); ++k)
        if (scene.materials[k].name == mention.material) material = static_cast<int>(k);
    if (material < 0 && !mention.rigid)
        problems.push_back({mention.pointer + "/material", fmt::format("no material \"{}\"", mention.material)});

    for (std::size_t k = 0; k < model.bodies.size(); ++k) {
        const ModelBody& known = model.bodies[k];
        if (known.name != mention.name) continue;
        if (mention.rigid || known.rigid)
            problems.push_back(
                {mention.pointer, fmt::format("body \"{}\" exists already; a rigid body has one shape or "
                                              "colour only",
                                              mention.name)});
        else if (material >= 0 && known.material >= 0 && known.material != material)
            problems.push_back(
                {mention.pointer + "/material", fmt::format("body \"{}\" exists already, of material \"{}\"",
                                                            mention.name, scene.materials[known.material].name)});
        else if (known.velocity != mention.velocity)
            problems.push_back({mention.pointer + "/velocity",
                                fmt::format("body \"{}\" exists already, with another velocity", mention.name)});
        return static_cast<int>(k);
    }
    model.bodies.push_back({mention.name, material, mention.velocity, mention.rigid});
    return static_cast<int>(model.bodies.size()) - 1;
}

bool has_usable_grid(const GridSpec& grid, int dimension) {
    for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimension); ++axis)
        if (!(grid.cell[axis] > 0) || !(grid.upper[axis] > grid.lower[axis])) return false;
    return true;
}

void add_shape(const BodySpec& spec, const std::string& pointer, const Scene& scene, Model& model,
               std::vector<Part>& parts, std::vector<Problem>& problems) {
    Part part{pointer, spec.name, 0, {}, {}, 0};
    part.body = body_index({pointer, spec.name, spec.material, spec.velocity, spec.rigid}, scene, model, problems);
    if (spec.particles_per_cell < 1) {
        problems.push_back({pointer + "/particles_per_cell", "must be at least 1"});
        return;
    }
    const int axes = dimension(scene.analysis);
    if (!exists_in(spec.shape, axes)) {
        problems.push_back({pointer, fmt::format("body \"{}\" has a {} shape in a {} analysis", spec.name,
                                                 axes == 3 ? "plane" : "3d", axes == 3 ? "3d" : "plane")});
        return;
    }
    ShapeParticles particles = shape_particles(spec.shape, spec.particles_per_cell, scene.grid, axes);
    if (particles.position.empty())
        problems.push_back({pointer, fmt::format("body \"{}\" got no particles: it is too small for particles of {}",
                                                 spec.name, edges_text(particles.half_size))});
    part.half_size = particles.half_size;
    part.angle = particles.angle;
    part.position = std::move(particles.position);
    parts.push_back(std::move(part));
}

void add_image(std::size_t index, const Scene& scene, const std::string& scene_name, Model& model,
               std::vector<Part>& parts, std::vector<Problem>& problems) {
    const ImageSpec& spec = scene.images[index];
    const std::string pointer = fmt::format("/images/{}", index);
    if (dimension(scene.analysis) == 3) {
        problems.push_back({pointer, "pictures make plane bodies; a 3d analysis has none"});
        return;
    }
    std::vector<int> body_of_entry(spec.legend.size(), -1);
    for (std::size_t k = 0; k < spec.legend.size(); ++k) {
        const LegendEntry& entry = spec.legend[k];
        if (!entry.is_void)
            body_of_entry[k] = body_index(
                {fmt::format("{}/legend/{}", pointer, k), entry.body, entry.material, {entry.velocity}, entry.rigid},
                scene, model, problems);
    }
    for (Part& part : image_parts(spec, scene.grid, pointer, scene_name, problems)) {
        for (std::size_t k = 0; k < spec.legend.size(); ++k)
            if (!spec.legend[k].is_void && spec.legend[k].body == part.body_name) part.body = body_of_entry[k];
        parts.push_back(std::move(part));
    }
}

} // namespace

Model build_model(const Scene& scene, const std::string& scene_name) {
    if (!has_usable_grid(scene.grid, dimension(scene.analysis)))
        throw SceneError(scene_name, {{"/grid", "needs cells larger than 0 and an upper corner above the lower one"}});
    Model model;
    std::vector<Part> parts;
    std::vector<Problem> problems;
    for (std::size_t k = 0; k < scene.bodies.size(); ++k)
        add_shape(scene.bodies[k], fmt::format("/bodies/{}", k), scene, model, parts, problems);
    for (std::size_t k = 0; k < scene.images.size(); ++k) add_image(k, scene, scene_name, model, parts, problems);

    check_inside(parts, scene.grid, problems);
    check_overlap(parts, problems);
    const bool has_particles =
        std::any_of(parts.begin(), parts.end(), [](const Part& part) { return !part.position.empty(); });
    if (!has_particles && problems.empty())
        problems.push_back({"", "the scene has no particles: it needs bodies or images"});
    if (!problems.empty()) throw SceneError(scene_name, std::move(problems));

    const bool any_turned = std::any_of(parts.begin(), parts.end(), [](const Part& part) { return part.angle != 0; });
    for (const Part& part : parts) {
        model.position.insert(model.position.end(), part.position.begin(), part.position.end());
        model.half_size.insert(model.half_size.end(), part.position.size(), part.half_size);
        model.body.insert(model.body.end(), part.position.size(), part.body);
        if (any_turned) model.angle.insert(model.angle.end(), part.position.size(), part.angle);
    }
    return model;
}

} // namespace abut
