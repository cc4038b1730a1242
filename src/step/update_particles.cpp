#include "grid/parallel.h"
#include "material/deformation.h"
#include "shape/dispatch.h"
#include "step/run_error.h"
#include "step/tasks.h"
#include "transfer/transfer.h"

#include <atomic>
#include <limits>

namespace abut {

namespace {

/// dF = exp(∇v Δt), F ← dF F, stress by the law (FMPM paper Table 1, task 5). \return ρ0 c² of the particle [Pa]
template <int D, class Law>
[[gnu::always_inline]] inline double update_stress(Particles<D>& particles, std::int32_t p, const Law& law,
                                                   const Pack (&gradient)[D], double dt) {
    Mat<D> dv;
    for (int a = 0; a < D; ++a)
        for (int i = 0; i < D; ++i) dv(i, a) = gradient[a][i + 1] * dt;
    const Mat<D> F = product(exponential(dv), particles.deformation_gradient[p]);
    particles.deformation_gradient[p] = F;
    const Strain<D> strain = strain_of<D>(F);
    // NaN, J <= 0 and absurd stretch show as a negative stiffness, which the caller reports.
    constexpr double absurd = 1e8; // trace of b
    if (!(strain.J > 0 && strain.trace() < absurd)) return -1;
    particles.stress[p] = law.template kirchhoff<D>(strain);
    return law.template stiffness<D>(strain);
}

/// What went wrong with a particle, first in the order of tiles.
struct Failures {
    std::vector<std::int32_t> particle; ///< by tile; -1: none

    explicit Failures(std::size_t tiles) : particle(tiles, -1) {}
    std::int32_t first() const {
        for (const std::int32_t p : particle)
            if (p >= 0) return p;
        return -1;
    }
};

template <int D>
bool is_inside(const Grid<D>& grid, const Vec<D>& x) {
    // A particle at a wall may pass the box's face by a little.
    const Vec<D> lattice = grid.lattice_position(x);
    for (int a = 0; a < D; ++a)
        if (!(lattice[a] > grid_margin - 1 && lattice[a] < grid_margin + grid.cells[a] + 1)) return false;
    return true;
}

/// One sweep over the particles: gathers what `Move` and the stress update want of the nodes.
template <int D, class Move, bool Stress>
void sweep(State<D>& state, const std::vector<Pack>& gradient_velocity) {
    const NodeArrays<D>& nodes = state.nodes;
    Particles<D>& particles = state.particles;
    const std::size_t tile_count = state.tiling.tiles.size();
    Failures failures(tile_count);
    std::vector<double> fastest(tile_count, 0);
    with_shape(state.scene.method.shape, [&](auto shape) {
        using Shape = decltype(shape);
        for_each_tile(state.tiling, [&](const Tile<D>& tile) {
            const std::size_t t = &tile - state.tiling.tiles.data();
            const Material& material = state.material_of(tile.body);
            std::visit(
                [&](const auto& law) {
                    auto stencils = state.template stencils<Shape>(tile);
                    double stiffest = 0;
                    for (std::int32_t p = tile.first; p < tile.last; ++p) {
                        const StencilView<D> s = stencils.of(p);
                        Move move;
                        Pack gradient[D] = {};
                        for (int k = 0; k < s.count; ++k) {
                            const std::int32_t slot = s.slot[k];
                            move.gather(nodes, slot, s.S[k]);
                            if constexpr (Stress)
                                for (int a = 0; a < D; ++a) gradient[a] += s.G[a][k] * gradient_velocity[slot];
                        }
                        move.update(particles.velocity[p], particles.position[p], state.dt);
                        if constexpr (Stress) {
                            const double stiffness = update_stress(particles, p, law, gradient, state.dt);
                            stiffest = std::max(stiffest, stiffness);
                            if (!(stiffness >= 0) && failures.particle[t] < 0) failures.particle[t] = p;
                        }
                        if (!is_inside(state.grid, particles.position[p]) && failures.particle[t] < 0)
                            failures.particle[t] = p;
                    }
                    fastest[t] = std::sqrt(stiffest / material.density);
                },
                material.law);
        });
    });
    if (const std::int32_t p = failures.first(); p >= 0) {
        const bool outside = !is_inside(state.grid, particles.position[p]);
        throw RunError(describe_failure(state, p,
                                        outside ? "the particle left the grid (or its position is not a number)"
                                                : "the particle is turned inside out (det F <= 0), stretched ten "
                                                  "thousandfold or not a number; a smaller "
                                                  "time step may help"));
    }
    if constexpr (Stress) {
        state.largest_wave_speed = 0;
        for (const double speed : fastest) state.largest_wave_speed = std::max(state.largest_wave_speed, speed);
    }
}

template <int D, class Move>
void update(State<D>& state) {
    if (state.effects.stress_first)
        sweep<D, Move, false>(state, state.nodes.end_velocity);
    else
        sweep<D, Move, true>(state, state.nodes.end_velocity);
}

} // namespace

template <int D>
void update_particles(State<D>& state) {
    const TransferSpec& transfer = state.scene.method.transfer;
    const bool from_end = transfer.position == PositionUpdate::end_velocity;
    if (transfer.scheme == TransferScheme::flip) return update<D, FlipMove<D>>(state);
    if (state.effects.extra_orders > 0)
        return from_end ? update<D, XpicMove<D, true>>(state) : update<D, XpicMove<D, false>>(state);
    return from_end ? update<D, PicMove<D, true>>(state) : update<D, PicMove<D, false>>(state);
}

template <int D>
void update_stress_first(State<D>& state) {
    // Walls belong to the velocities that deform the particles, not to the momenta that forces then change
    // (notes 2.3.2).
    std::vector<Pack> velocity = state.nodes.velocity;
    for (const Wall<D>& wall : state.walls) {
        Wall<D> untracked = wall;
        impose(untracked, velocity);
    }
    sweep<D, NoMove<D>, true>(state, velocity);
}

template void update_particles<2>(State<2>&);
template void update_stress_first<2>(State<2>&);

} // namespace abut
