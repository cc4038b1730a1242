#include "io/results/read_state.h"

#include "scene/suggest.h"

#include <algorithm>
#include <fmt/format.h>
#include <span>

namespace abut {

namespace {

/// The values of an array with so many components a particle.
template <class Value>
std::span<const Value> values_of(const PointFrame& frame, const std::string& name, std::size_t components) {
    const auto array =
        std::find_if(frame.arrays.begin(), frame.arrays.end(), [&](const Array& a) { return a.name == name; });
    if (array == frame.arrays.end())
        throw FrameError(fmt::format("the particles have no array \"{}\" (\"particle_arrays\" of the scene's output?); "
                                     "needed are {}",
                                     name, quoted_list(arrays_of_state(), "and")));
    const auto* values = std::get_if<std::vector<Value>>(&array->values);
    if (!values || values->size() != frame.points.size() / 3 * components)
        throw FrameError(fmt::format("the array \"{}\" of the particles is not as abut writes it", name));
    return *values;
}

/// The body of that name, as geometry made it of the scene.
ModelBody body_of(const Scene& scene, const std::string& name) {
    const auto with_material = [&](const auto& spec) {
        ModelBody body{name, -1, {}, spec.rigid};
        if (spec.rigid) return body;
        for (std::size_t m = 0; m < scene.materials.size(); ++m)
            if (scene.materials[m].name == spec.material) body.material = static_cast<int>(m);
        return body;
    };
    for (const BodySpec& spec : scene.bodies)
        if (spec.name == name) return with_material(spec);
    // Several bodies of a legend entry are named after it: of "grain" and "grain-big" the longer one that fits.
    std::optional<ModelBody> found;
    std::size_t fits = 0;
    for (const ImageSpec& image : scene.images)
        for (const LegendEntry& entry : image.legend) {
            const bool group = image.bodies != BodiesBy::legend && name.starts_with(entry.body + "-");
            if (entry.is_void || (entry.body != name && !group) || (found && entry.body.size() <= fits)) continue;
            fits = entry.body.size();
            found = with_material(entry);
            if (image.bodies != BodiesBy::legend) found->group = entry.body;
        }
    if (found) return *found;
    throw FrameError(fmt::format("the particles are of a body \"{}\" that the scene doesn't have", name));
}

/// Where the particle of each id is in the frame. Particles of bodies that the scene doesn't write are missing.
std::vector<std::size_t> places_of_ids(std::span<const std::int32_t> ids) {
    std::vector<std::size_t> places(ids.size(), ids.size());
    for (std::size_t p = 0; p < ids.size(); ++p) {
        if (ids[p] < 0 || static_cast<std::size_t>(ids[p]) >= ids.size() || places[ids[p]] != ids.size())
            throw FrameError("the frame doesn't hold all particles, and contacts can't be found without the others");
        places[ids[p]] = p;
    }
    return places;
}

} // namespace

const std::vector<std::string>& arrays_of_state() {
    static const std::vector<std::string> names{"displacement", "deformation_gradient", "body", "id", "half_size"};
    return names;
}

template <int D>
State<D> read_state(Scene scene, const PointFrame& frame) {
    if (!scene.output.bodies.empty())
        throw FrameError("only the particles of some bodies were written (\"bodies\" of the scene's output), and "
                         "contacts can't be found without the others");
    const auto displacement = values_of<double>(frame, "displacement", 3);
    const auto F = values_of<double>(frame, "deformation_gradient", 9);
    const auto body = values_of<std::int32_t>(frame, "body", 1);
    const auto half_size = values_of<double>(frame, "half_size", 3);
    const std::vector<std::size_t> places = places_of_ids(values_of<std::int32_t>(frame, "id", 1));

    scene.boundaries.clear(); // they change neither masses nor contacts
    Model model;
    for (const Words& words : frame.words)
        if (words.name == "body_names")
            for (const std::string& name : words.values) model.bodies.push_back(body_of(scene, name));
    const auto vector_at = [](const auto& values, std::size_t p) {
        return Vector{values[3 * p], values[3 * p + 1], values[3 * p + 2]};
    };
    for (const std::size_t p : places) {
        Vector start = vector_at(frame.points, p);
        for (std::size_t a = 0; a < 3; ++a) start[a] -= displacement[3 * p + a];
        if (body[p] < 0 || static_cast<std::size_t>(body[p]) >= model.bodies.size())
            throw FrameError("the particles' field data \"body_names\" doesn't name all their bodies");
        model.position.push_back(start);
        model.half_size.push_back(vector_at(half_size, p));
        model.body.push_back(body[p]);
    }

    State<D> state = make_state<D>(scene, model);
    state.time = frame.time;
    for (const Array& array : frame.globals)
        if (const auto* step = std::get_if<std::vector<std::int32_t>>(&array.values); array.name == "step" && step)
            state.step = step->at(0);
    for (std::size_t id = 0; id < places.size(); ++id) {
        const std::size_t p = places[id];
        state.particles.position[id] = to_vec<D>(vector_at(frame.points, p));
        for (int i = 0; i < D; ++i)
            for (int j = 0; j < D; ++j) state.particles.deformation_gradient[id](i, j) = F[9 * p + 3 * i + j];
        if (!state.particles.across.empty()) state.particles.across[id] = F[9 * p + 8];
    }
    return state;
}

template State<2> read_state<2>(Scene, const PointFrame&);
template State<3> read_state<3>(Scene, const PointFrame&);

} // namespace abut
