#include "step/step.h"

#include "boundary/rigid_body.h"
#include "contact/contact_pass.h"
#include "contact/contact_totals.h"
#include "contact/find_contacts.h"
#include "plan/time_step.h"
#include "step/run_error.h"
#include "step/tasks.h"
#include "step/watch.h"

#include <chrono>
#include <cmath>
#include <sstream>

namespace abut {

namespace {

/// Decides whether this step uses the scheme's transfer or is a FLIP step between.
template <int D>
void choose_transfer(State<D>& state) {
    const double every = *state.scene.method.transfer.every_cfl * crossing_time(state);
    state.since_transfer += state.dt;
    // In the step that ends nearest to the due time: steps change a little with the wave speed.
    state.transfers = state.since_transfer + 0.5 * state.dt >= every;
    if (state.transfers) state.since_transfer = 0;
}

} // namespace

template <int D>
std::vector<Task<D>> step_tasks(const Scene& scene) {
    const Effects effects = effects_of(scene);
    std::vector<Task<D>> tasks;
    const auto add = [&](bool needed, const char* name, const char* reason, void (*run)(State<D>&)) {
        if (needed) tasks.push_back({name, reason, run});
    };
    const bool first = effects.stress_first;
    const bool again = effects.reextrapolate;
    const bool conditions = effects.velocity_conditions;
    const bool filters = effects.extra_orders > 0;

    add(effects.periodic, "choose transfer", "every_cfl: flip steps between", choose_transfer<D>);
    add(true, "find velocity fields", "always: particles have moved", find_velocity_fields<D>);
    add(effects.stored_stencils, "store stencils",
        again ? "the last extrapolation needs those of the step's beginning" : "dear to expand for every sweep",
        store_stencils<D>);
    add(!first, "extrapolate momenta and forces", "always; in one sweep, since stress is updated last",
        extrapolate_momenta_and_forces<D>);
    add(first, "extrapolate momenta", "always", extrapolate_momenta<D>);
    add(true, "find velocities", "always", find_velocities<D>);
    add(conditions, "find controlled nodes",
        effects.ring ? "radial velocity is zero on the axis" : "the scene sets velocities of nodes", find_controls<D>);
    add(effects.contact, "find contact groups", "the scene has contact", find_groups<D>);
    add(effects.clouds, "gather point clouds",
        effects.regression ? "normals by regression" : "separations by particle-edges", gather_clouds<D>);
    add(effects.contact_fields() || effects.pairs, "extrapolate contact fields",
        effects.gradients          ? "normals by volume gradients"
        : effects.positions        ? "separations by extrapolated positions"
        : effects.contact_fields() ? "a contact law or a separation needs areas or displacements"
                                   : "areas for pairs.csv, in steps before a row",
        extrapolate_contact_fields<D>);
    add(effects.planes, "find normals", "an interface is not perfect", find_normals<D>);
    add(effects.planes, "find separations", "an interface is not perfect", find_separations<D>);
    add(effects.areas || effects.pairs, "find contact areas",
        effects.interfaces ? "an interface law needs areas and displacements"
        : effects.areas    ? "a contact law needs areas"
                           : "areas for pairs.csv, in steps before a row",
        find_areas_and_displacements<D>);
    add(effects.contact && scene.contact->corrections == 2, "first contact pass",
        "extrapolated velocities must obey contact", first_contact_pass<D>);
    add(first, "update stress", effects.stress_last ? "first half (usavg)" : "stress is updated first (usf)",
        update_stress_first<D>);
    add(first, "extrapolate forces", "always", extrapolate_forces<D>);
    add(effects.tractions, "apply tractions", "the scene has tractions", apply_tractions<D>);
    add(true, "update momenta", "always", update_momenta<D>);
    add(conditions, "impose conditions", "the scene sets velocities of nodes", impose_conditions<D>);
    add(effects.contact, "second contact pass", "updated momenta must obey contact", second_contact_pass<D>);
    add(filters, "filter velocities",
        effects.fmpm ? "fmpm: full mass matrix inverse of order 2 or more" : "xpic of order 2 or more",
        filter_velocities<D>);
    add(effects.contact || conditions || effects.gravity || effects.tractions, "settle works", "the energy balance",
        settle_works<D>);
    add(true, effects.stress_last && !again ? "update particles and stress" : "update particles", "always",
        update_particles<D>);
    add(effects.rigid, "move rigid bodies", "the scene prescribes motions", move_rigid_bodies<D>);
    add(again, "update stress again", "velocities extrapolated anew (usl+, usavg+)", update_stress_again<D>);
    return tasks;
}

template <int D>
double crossing_time(const State<D>& state) {
    return state.grid.length() / state.largest_wave_speed;
}

template <int D>
double stable_step(const State<D>& state) {
    return cfl_limit(state.scene) * crossing_time(state);
}

template <int D>
double next_step(const State<D>& state, double until) {
    const double stable = stable_step(state);
    const double reduction = std::ldexp(1.0, -state.step_reductions);
    double dt = reduction * std::min(state.scene.time.cfl * crossing_time(state), stable);
    if (state.scene.time.step) {
        dt = reduction * *state.scene.time.step;
        if (dt > stable) {
            std::ostringstream text;
            text << "the time step of " << dt << " s is above the stable one of " << stable << " s ("
                 << cfl_limit(state.scene) << " cell / wave speed); waves are fastest here, "
                 << state.largest_wave_speed << " m/s";
            throw run_error(Trouble::step_too_large, state, stiffest_particle(state), text.str());
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
template std::vector<Task<3>> step_tasks<3>(const Scene&);
template double crossing_time<2>(const State<2>&);
template double crossing_time<3>(const State<3>&);
template double stable_step<2>(const State<2>&);
template double stable_step<3>(const State<3>&);
template double next_step<2>(const State<2>&, double);
template double next_step<3>(const State<3>&, double);
template void advance<2>(State<2>&, std::vector<Task<2>>&);
template void advance<3>(State<3>&, std::vector<Task<3>>&);

} // namespace abut
