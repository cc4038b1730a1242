#include "contact/find_contacts.h"
#include "grid/parallel.h"
#include "shape/dispatch.h"

namespace abut {

namespace {

/// Adds to the arrays that are wanted; the others are null.
template <int D>
void extrapolate(State<D>& state, std::vector<Pack>* gradient, std::vector<Pack>* mass_position,
                 std::vector<Pack>* mass_displacement) {
    for (std::vector<Pack>* field : {gradient, mass_position, mass_displacement})
        if (field) field->assign(state.fields.size(), Pack{});
    const Particles<D>& particles = state.particles;
    with_stencils(state, [&](auto source) {
        using Source = decltype(source);
        for_each_tile_by_colour(state.tiling, [&](const Tile<D>& tile) {
            if (!tile.contact) return;
            auto stencils = state.template stencils<Source>(tile);
            for (std::int32_t p = tile.first; p < tile.last; ++p) {
                const StencilView<D> s = stencils.of(p);
                const double volume =
                    particles.deformation_gradient[p].determinant() * particles.across_of(p) * particles.volume[p];
                const Pack position = pack<D>(0, particles.position[p] - state.grid.origin) * particles.mass[p];
                Pack displacement{};
                if (mass_displacement)
                    displacement =
                        pack<D>(0, particles.position[p] - state.initial_position[particles.id[p]]) * particles.mass[p];
                for (int k = 0; k < s.count; ++k) {
                    const std::int32_t slot = s.slot[k];
                    if (gradient) {
                        Pack G{s.S[k]};
                        for (int a = 0; a < D; ++a) G[a + 1] = s.G[a][k];
                        if constexpr (Source::ring) G[1] += s.T[k]; // the divergence of a ring's volume
                        (*gradient)[slot] += volume * G;
                    }
                    if (mass_position) (*mass_position)[slot] += s.S[k] * position;
                    if (mass_displacement) (*mass_displacement)[slot] += s.S[k] * displacement;
                }
            }
        });
    });
}

} // namespace

template <int D>
void extrapolate_contact_fields(State<D>& state) {
    const Effects& effects = state.effects;
    if (!effects.contact_fields() && !state.wants_areas) return;
    extrapolate(state,
                effects.gradients || effects.volumes || state.wants_areas ? &state.contact.volume_gradient : nullptr,
                effects.positions ? &state.contact.mass_position : nullptr,
                effects.displacements ? &state.contact.mass_displacement : nullptr);
}

template <int D>
std::vector<Pack> volume_gradients(State<D>& state) {
    std::vector<Pack> gradient;
    extrapolate<D>(state, &gradient, nullptr, nullptr);
    return gradient;
}

template void extrapolate_contact_fields<2>(State<2>&);
template void extrapolate_contact_fields<3>(State<3>&);
template std::vector<Pack> volume_gradients<2>(State<2>&);
template std::vector<Pack> volume_gradients<3>(State<3>&);

} // namespace abut
