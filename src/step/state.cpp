#include "step/state.h"

#include "boundary/rigid_motion.h"
#include "step/watch.h"

#include <algorithm>

namespace abut {

namespace {

LawTable law_table(const ContactSpec& contact, const std::vector<ModelBody>& bodies) {
    LawTable table;
    table.standard = make_contact_law(contact.law);
    // A name may stand for all the bodies that a legend entry makes.
    const auto indices = [&](const std::string& name) {
        std::vector<std::int32_t> found;
        for (std::size_t b = 0; b < bodies.size(); ++b)
            if (bodies[b].is_called(name)) found.push_back(static_cast<std::int32_t>(b));
        return found;
    };
    for (const PairLawSpec& pair : contact.laws) {
        const ContactLaw law = make_contact_law(pair.law);
        const bool same_group = pair.bodies[0] == pair.bodies[1];
        for (const std::int32_t a : indices(pair.bodies[0]))
            for (const std::int32_t b : indices(pair.bodies[1]))
                if (a < b || (a > b && !same_group)) table.pairs.push_back({std::min(a, b), std::max(a, b), law});
    }
    std::stable_sort(table.pairs.begin(), table.pairs.end(), [](const LawTable::Pair& x, const LawTable::Pair& y) {
        return std::pair(x.a, x.b) < std::pair(y.a, y.b);
    });
    return table;
}

Vector center_of_volume(const Model& model, int body) {
    Vector moment{};
    double volume = 0;
    for (std::size_t p = 0; p < model.size(); ++p) {
        if (model.body[p] != body) continue;
        const Vector& h = model.half_size[p];
        const double v = h[0] * h[1] * (h[2] > 0 ? h[2] : 1);
        for (std::size_t a = 0; a < 3; ++a) moment[a] += v * model.position[p][a];
        volume += v;
    }
    for (double& m : moment) m /= volume;
    return moment;
}

} // namespace

template <int D>
State<D> make_state(const Scene& scene, const Model& model) {
    State<D> state;
    state.scene = scene;
    state.effects = effects_of(scene);
    state.bodies = model.bodies;
    for (const MaterialSpec& spec : scene.materials) state.materials.push_back(make_material(spec));
    for (const Vector& x : model.position) state.initial_position.push_back(to_vec<D>(x));
    state.temperature = model.temperature;
    state.orientation = model.orientation;
    state.grid = make_grid<D>(scene.grid);
    state.particles = make_particles<D>(model, scene);
    if (scene.contact) {
        state.contact.laws = law_table(*scene.contact, model.bodies);
        // Perfect interfaces need no pairs: lumping makes all bodies of a node one, exactly.
        if (state.effects.planes) state.contact.three_or_more = scene.contact->three_or_more;
    }
    for (const BoundarySpec& boundary : scene.boundaries) {
        const auto number = static_cast<std::int32_t>(state.boundaries.size());
        state.boundaries.push_back({boundary.name, boundary.condition, {}});
        if (const auto* traction = std::get_if<TractionSpec>(&boundary.condition)) {
            const auto body = std::find_if(model.bodies.begin(), model.bodies.end(),
                                           [&](const ModelBody& b) { return b.name == traction->body; });
            const auto faces =
                find_faces(*traction, number, static_cast<std::int32_t>(body - model.bodies.begin()), state.particles);
            state.traction_faces.insert(state.traction_faces.end(), faces.begin(), faces.end());
        }
    }
    for (std::size_t b = 0; b < state.bodies.size(); ++b)
        if (std::optional<RigidSpec>& rigid = state.bodies[b].rigid; rigid && !rigid->center)
            rigid->center = center_of_volume(model, static_cast<int>(b));
    for (std::size_t p = 0; p < state.particles.size(); ++p)
        if (const std::optional<RigidSpec>& rigid = state.bodies[state.particles.body[p]].rigid)
            state.particles.velocity[p] =
                to_vec<D>(rigid_pose(*rigid, 0).velocity_at(to_array<D>(state.particles.position[p])));
    for (const ModelBody& body : model.bodies) {
        if (body.rigid) continue;
        const Material& material = state.materials[body.material];
        double stiffness = std::visit(
            [](const auto& law) { return law.template stiffness<D>(strain_of<D>(Mat<D>::Identity())); }, material.law);
        if (body.stress) { // as in update_stress()
            Stress<D> stress;
            for (int c = 0; c < static_cast<int>(stress.size()); ++c) stress[c] = (*body.stress)[c];
            stiffness += stress.norm();
        }
        state.largest_wave_speed = std::max(state.largest_wave_speed, std::sqrt(stiffness / material.density));
    }
    state.speed_limit = speed_limit(state);
    return state;
}

template State<2> make_state<2>(const Scene&, const Model&);
template State<3> make_state<3>(const Scene&, const Model&);

} // namespace abut
