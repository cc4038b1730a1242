#include "grid/parallel.h"
#include "shape/dispatch.h"
#include "step/tasks.h"

#include <algorithm>

namespace abut {

namespace {

/// round_trip = S^T M S u: with the lumped masses divided out, S+ S u.
template <int D>
void sweep(State<D>& state, const std::vector<Pack>& u, std::vector<Pack>& round_trip) {
    round_trip.resize(state.fields.size());
    std::fill(round_trip.begin(), round_trip.end(), Pack{});
    with_shape(state.scene.method.shape, [&](auto shape) {
        using Shape = decltype(shape);
        for_each_tile_by_colour(state.tiling, [&](const Tile<D>& tile) {
            auto stencils = state.template stencils<Shape>(tile);
            for (std::int32_t p = tile.first; p < tile.last; ++p) {
                const StencilView<D> s = stencils.of(p);
                Pack U{};
                for (int k = 0; k < s.count; ++k) U += s.S[k] * u[s.slot[k]];
                U *= state.particles.mass[p];
                for (int k = 0; k < s.count; ++k) round_trip[s.slot[k]] += s.S[k] * U;
            }
        });
    });
}

} // namespace

/// With A = I − S+ S, m_k^-1 p = Σ_{j<k} A^j v. Hence
///   m_k^-1 p^α − m_(k−1)^-1 Δp^α = Σ_{j<k−1} A^j (v^α − Δv^α) + A^(k−1) v^α,
/// which is found from the inside out: u = v^α, then k − 1 times u ← (v^α − Δv^α) + u − S+ S u. This equals the
/// recursion of Eq. (43), (44) without its binomial coefficients, which alternate in sign and grow with k.
template <int D>
void filter_velocities(State<D>& state) {
    NodeArrays<D>& nodes = state.nodes;
    const auto n = static_cast<std::ptrdiff_t>(state.fields.size());
    const bool multibody = state.effects.delta_velocity;
    nodes.filtered = nodes.velocity;
    for (int order = 0; order < state.effects.extra_orders; ++order) {
        sweep(state, nodes.filtered, nodes.round_trip);
#pragma omp parallel for schedule(static)
        for (std::ptrdiff_t slot = 0; slot < n; ++slot) {
            const Pack v = nodes.velocity[slot];
            if (!(v[0] > 0)) continue;
            Pack u = v + nodes.filtered[slot] - nodes.round_trip[slot] / v[0];
            if (multibody) u -= nodes.delta_velocity[slot];
            nodes.filtered[slot] = u;
        }
    }
}

template void filter_velocities<2>(State<2>&);

} // namespace abut
