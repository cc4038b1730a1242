#include "contact/contact_pass.h"
#include "step/tasks.h"

namespace abut {

template <int D>
void find_velocities(State<D>& state) {
    const auto n = static_cast<std::ptrdiff_t>(state.fields.size());
    state.nodes.velocity.resize(n);
#pragma omp parallel for schedule(static)
    for (std::ptrdiff_t slot = 0; slot < n; ++slot) {
        const Pack p = state.nodes.momentum[slot];
        // A slot within a window that no particle reaches has no mass.
        Pack v = p[0] > 0 ? p / p[0] : Pack{};
        v[0] = p[0];
        state.nodes.velocity[slot] = v;
    }
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
}

template <int D>
void impose_walls(State<D>& state) {
    for (Wall<D>& wall : state.walls) impose(wall, state.nodes.end_velocity);
}

template <int D>
void settle_works(State<D>& state) {
    const NodeArrays<D>& nodes = state.nodes;
    for (Wall<D>& wall : state.walls) state.ledger.external_work += settle(wall);
    if (state.effects.contact) state.ledger.contact_work += contact_work(state);
    if (state.effects.gravity) {
        const Pack gravity = pack<D>(0, to_vec<D>(state.scene.gravity));
        double work = 0;
        for (std::size_t slot = 0; slot < nodes.velocity.size(); ++slot)
            work += nodes.velocity[slot][0] * dot(gravity, nodes.velocity[slot] + nodes.end_velocity[slot]);
        state.ledger.external_work += 0.5 * state.dt * work;
    }
}

template void find_velocities<2>(State<2>&);
template void update_momenta<2>(State<2>&);
template void impose_walls<2>(State<2>&);
template void settle_works<2>(State<2>&);

} // namespace abut
