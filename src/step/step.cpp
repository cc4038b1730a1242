#include "step/step.h"

#include "contact/contact_pass.h"
#include "contact/find_contacts.h"
#include "step/run_error.h"
#include "step/tasks.h"

#include <chrono>
#include <sstream>

namespace abut {

namespace {

template <int D>
void find_controlled_nodes(State<D>& state) {
    for (Wall<D>& wall : state.walls) find_controlled(wall, state.grid, state.fields, state.time);
}

} // namespace

template <int D>
std::vector<Task<D>> step_tasks(const Scene& scene) {
    const Effects effects = effects_of(scene);
    std::vector<Task<D>> tasks;
    const auto add = [&](bool needed, const char* name, const char* reason, void (*run)(State<D>&)) {
        if (needed) tasks.push_back({name, reason, run});
    };
    const bool usf = effects.stress_first;
    const bool walls = !scene.boundaries.empty();

    add(true, "find velocity fields", "always: particles have moved", find_velocity_fields<D>);
    add(effects.stored_stencils, "store stencils", "cpdi is dear to expand for every sweep", store_stencils<D>);
    add(walls, "find wall nodes", "the scene has walls", find_controlled_nodes<D>);
    add(!usf, "extrapolate momenta and forces", "always; in one sweep, since stress is updated last (usl)",
        extrapolate_momenta_and_forces<D>);
    add(usf, "extrapolate momenta", "always", extrapolate_momenta<D>);
    add(true, "find velocities", "always", find_velocities<D>);
    add(effects.contact, "find contact groups", "the scene has contact", find_groups<D>);
    add(effects.clouds, "gather point clouds",
        effects.regression ? "normals by regression" : "separations by particle-edges", gather_clouds<D>);
    add(effects.gradients || effects.positions, "extrapolate contact fields",
        effects.gradients ? "normals by volume gradients" : "separations by extrapolated positions",
        extrapolate_contact_fields<D>);
    add(effects.clouds || effects.gradients, "find normals and separations", "an interface is not perfect",
        find_normals_and_separations<D>);
    add(effects.contact && scene.contact->corrections == 2, "first contact pass",
        "extrapolated velocities must obey contact", first_contact_pass<D>);
    add(usf, "update stress", "stress_update is usf", update_stress_first<D>);
    add(usf, "extrapolate forces", "always", extrapolate_forces<D>);
    add(true, "update momenta", "always", update_momenta<D>);
    add(walls, "impose walls", "the scene has walls", impose_walls<D>);
    add(effects.contact, "second contact pass", "updated momenta must obey contact", second_contact_pass<D>);
    add(effects.contact || walls || effects.gravity, "settle works", "the energy balance", settle_works<D>);
    add(effects.extra_orders > 0, "filter velocities", "xpic of order 2 or more", filter_velocities<D>);
    add(true, usf ? "update particles" : "update particles and stress", "always", update_particles<D>);
    return tasks;
}

template <int D>
double stable_step(const State<D>& state) {
    return state.grid.length() / state.largest_wave_speed;
}

template <int D>
double next_step(const State<D>& state, double until) {
    const double stable = stable_step(state);
    double dt = state.scene.time.cfl * stable;
    if (state.scene.time.step) {
        dt = *state.scene.time.step;
        if (dt > stable) {
            std::ostringstream text;
            text << "step " << state.step << ", time " << state.time << " s: the time step of " << dt
                 << " s is above the stable one of " << stable << " s (cell / wave speed)";
            throw RunError(text.str());
        }
    }
    return std::min(dt, until - state.time);
}

template <int D>
void advance(State<D>& state, std::vector<Task<D>>& tasks) {
    using Clock = std::chrono::steady_clock;
    auto before = Clock::now();
    for (Task<D>& task : tasks) {
        task.run(state);
        const auto after = Clock::now();
        task.seconds += std::chrono::duration<double>(after - before).count();
        before = after;
    }
    state.time += state.dt;
    ++state.step;
}

template std::vector<Task<2>> step_tasks<2>(const Scene&);
template double stable_step<2>(const State<2>&);
template double next_step<2>(const State<2>&, double);
template void advance<2>(State<2>&, std::vector<Task<2>>&);

} // namespace abut
