#include "boundary/rigid_body.h"
#include "contact/contact_totals.h"
#include "step/tasks.h"

namespace abut {

void divide_by_mass(const std::vector<Pack>& momentum, std::vector<Pack>& velocity) {
    const auto n = static_cast<std::ptrdiff_t>(momentum.size());
    velocity.resize(n);
#pragma omp parallel for schedule(static)
    for (std::ptrdiff_t slot = 0; slot < n; ++slot) {
        const Pack p = momentum[slot];
        // A slot within a window that no particle reaches has no mass.
        Pack v = p[0] > 0 ? p / p[0] : Pack{};
        v[0] = p[0];
        velocity[slot] = v;
    }
}

template <int D>
void find_velocities(State<D>& state) {
    divide_by_mass(state.nodes.momentum, state.nodes.velocity);
    if (!state.effects.rigid) return;
    state.poses = rigid_poses(state, state.time);
    set_rigid_velocities(state, state.poses, state.nodes.velocity);
}

template <int D>
void find_controls(State<D>& state) {
    std::vector<Control>& controls = state.controls;
    controls.clear();
    bool only_walls = true;
    for (std::size_t b = 0; b < state.boundaries.size(); ++b) {
        const auto number = static_cast<std::int32_t>(b);
        const auto& condition = state.boundaries[b].condition;
        if (const auto* wall = std::get_if<WallSpec>(&condition))
            control_wall(*wall, number, state.grid, state.fields, state.nodes.velocity, state.time, state.dt, controls);
        if (const auto* box = std::get_if<VelocitySpec>(&condition)) {
            control_box(*box, number, state.grid, state.fields, state.time, state.dt, controls);
            only_walls = false;
        }
    }
    if (!only_walls) make_orthogonal(controls, state.fields.size());
    if (state.effects.rigid)
        std::erase_if(controls,
                      [&](const Control& control) { return is_rigid(state, state.fields.field[control.slot]); });
    if constexpr (D == 2)
        if (state.effects.ring) control_axis(state.grid, state.fields, controls);
}

template <int D>
void update_momenta(State<D>& state) {
    const auto n = static_cast<std::ptrdiff_t>(state.fields.size());
    state.nodes.end_velocity.resize(n);
    Pack gravity = pack<D>(0, to_vec<D>(state.scene.gravity));
    const double dt = state.dt;
#pragma omp parallel for schedule(static)
    for (std::ptrdiff_t slot = 0; slot < n; ++slot) {
        const Pack v = state.nodes.velocity[slot];
        state.nodes.end_velocity[slot] = v[0] > 0 ? v + dt * (state.nodes.force[slot] / v[0] + gravity) : v;
    }
    if (state.effects.rigid) set_rigid_velocities(state, rigid_poses(state, state.time + dt), state.nodes.end_velocity);
}

template <int D>
void impose_conditions(State<D>& state) {
    if (state.conditions_on_lumped()) impose(state.controls, state.nodes.end_velocity);
}

template <int D>
void settle_works(State<D>& state) {
    const NodeArrays<D>& nodes = state.nodes;
    state.ledger.external_work += settle(state.controls, state.boundaries);
    if (state.effects.contact) settle_contact(state);
    if (!state.effects.gravity && !state.effects.tractions) return;
    const Pack gravity = pack<D>(0, to_vec<D>(state.scene.gravity));
    double work = 0;
    for (std::size_t slot = 0; slot < nodes.velocity.size(); ++slot) {
        if (is_rigid(state, state.fields.field[slot])) continue;
        Pack force = nodes.velocity[slot][0] * gravity;
        if (state.effects.tractions) force += nodes.traction[slot];
        work += dot(force, nodes.velocity[slot] + nodes.end_velocity[slot]);
    }
    state.ledger.external_work += 0.5 * state.dt * work;
}

template void find_velocities<2>(State<2>&);
template void find_velocities<3>(State<3>&);
template void find_controls<2>(State<2>&);
template void find_controls<3>(State<3>&);
template void update_momenta<2>(State<2>&);
template void update_momenta<3>(State<3>&);
template void impose_conditions<2>(State<2>&);
template void impose_conditions<3>(State<3>&);
template void settle_works<2>(State<2>&);
template void settle_works<3>(State<3>&);

} // namespace abut
