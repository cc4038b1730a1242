#include "grid/parallel.h"
#include "shape/dispatch.h"
#include "step/tasks.h"

#include <algorithm>

namespace abut {

namespace {

void clear(std::vector<Pack>& values, std::size_t size) {
    values.resize(size);
    std::fill(values.begin(), values.end(), Pack{});
}

/// Columns of −V0 τ as packs: f += column_a G_a.
template <int D>
void stress_columns(const Particles<D>& particles, std::int32_t p, Pack (&column)[D]) {
    const Stress<D>& tau = particles.stress[p];
    const double volume = -particles.volume[p];
    if constexpr (D == 2) {
        column[0] = volume * Pack{0, tau[0], tau[3], 0};
        column[1] = volume * Pack{0, tau[3], tau[1], 0};
    } else {
        column[0] = volume * Pack{0, tau[0], tau[3], tau[5]};
        column[1] = volume * Pack{0, tau[3], tau[1], tau[4]};
        column[2] = volume * Pack{0, tau[5], tau[4], tau[2]};
    }
}

template <int D, bool Momenta, bool Forces>
void extrapolate(State<D>& state) {
    if constexpr (Momenta) clear(state.nodes.momentum, state.fields.size());
    if constexpr (Forces) clear(state.nodes.force, state.fields.size());
    Pack* const momentum = state.nodes.momentum.data();
    Pack* const force = state.nodes.force.data();
    const Particles<D>& particles = state.particles;
    with_stencils(state, [&](auto source) {
        using Source = decltype(source);
        for_each_tile_by_colour(state.tiling, [&](const Tile<D>& tile) {
            auto stencils = state.template stencils<Source>(tile);
            for (std::int32_t p = tile.first; p < tile.last; ++p) {
                const StencilView<D> s = stencils.of(p);
                Pack P{};
                Pack column[D];
                [[maybe_unused]] Pack hoop{};
                if constexpr (Momenta) P = particles.mass[p] * pack<D>(1, particles.velocity[p]);
                if constexpr (Forces) {
                    stress_columns(particles, p, column);
                    if constexpr (Source::ring) hoop[1] = -particles.volume[p] * particles.stress[p][2];
                }
                for (int k = 0; k < s.count; ++k) {
                    const std::int32_t slot = s.slot[k];
                    if constexpr (Momenta) momentum[slot] += s.S[k] * P;
                    if constexpr (Forces) {
                        Pack f = s.G[0][k] * column[0];
                        for (int a = 1; a < D; ++a) f += s.G[a][k] * column[a];
                        if constexpr (Source::ring) f += s.T[k] * hoop;
                        force[slot] += f;
                    }
                }
            }
        });
    });
}

} // namespace

template <int D>
void extrapolate_momenta(State<D>& state) {
    extrapolate<D, true, false>(state);
}

template <int D>
void extrapolate_forces(State<D>& state) {
    extrapolate<D, false, true>(state);
}

template <int D>
void extrapolate_momenta_and_forces(State<D>& state) {
    extrapolate<D, true, true>(state);
}

template void extrapolate_momenta<2>(State<2>&);
template void extrapolate_momenta<3>(State<3>&);
template void extrapolate_forces<2>(State<2>&);
template void extrapolate_forces<3>(State<3>&);
template void extrapolate_momenta_and_forces<2>(State<2>&);
template void extrapolate_momenta_and_forces<3>(State<3>&);

} // namespace abut
