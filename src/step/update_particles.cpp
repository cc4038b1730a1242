#include "boundary/rigid_body.h"
#include "contact/contact_pass.h"
#include "grid/parallel.h"
#include "step/run_error.h"
#include "step/tasks.h"
#include "step/update_stress.h"
#include "step/watch.h"
#include "transfer/transfer.h"

namespace abut {

namespace {

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

/// A ring on the wrong side of the axis would have negative mass at nodes.
template <int D>
bool has_crossed_axis(const State<D>& state, std::int32_t p) {
    return state.effects.ring && !(state.particles.position[p][0] > 0);
}

/// Whether a particle is where it may be, with a speed that it may have; not so if either is not a number.
template <int D>
bool moves_soundly(const State<D>& state, std::int32_t p) {
    return state.grid.contains(state.particles.position[p]) && !has_crossed_axis(state, p) &&
           state.particles.velocity[p].squaredNorm() <= state.speed_limit * state.speed_limit;
}

/// What a sweep does with the particles.
template <int D>
struct Sweep {
    const MoveRule* rule = nullptr;        ///< null: particles stay where they are
    const std::vector<Pack>& end_velocity; ///< E
    const std::vector<Pack>& deforming;    ///< velocities that deform the particles, mostly the same
    double strain_step = 0;                ///< time over which particles deform [s]; 0: not at all
};

/// Particles whose velocity gradients are gathered before their stresses are updated: the gathering loop and the
/// constitutive law stay apart, and what passes between them in the nearest cache.
constexpr int chunk = 64;

template <int D>
struct Gathered {
    VelocityGradient<D> gradient;
    Pack end{}, start{}, filtered{};
};

/// \tparam Extra velocities besides E that are wanted: 0 none, 1 B, 2 B and F, 3 those that deform the particles
template <int D, class Source, int Extra>
[[gnu::always_inline]] inline Gathered<D> gather(const State<D>& state, const Sweep<D>& sweep, const StencilView<D>& s,
                                                 bool deforms) {
    const Pack* const end = sweep.end_velocity.data();
    const Pack* const start = state.nodes.velocity.data();
    const Pack* const filtered = state.nodes.filtered.data();
    [[maybe_unused]] const Pack* const deforming = sweep.deforming.data();
    Gathered<D> sum;
    [[maybe_unused]] double hoop = 0;
    for (int k = 0; k < s.count; ++k) {
        const std::int32_t slot = s.slot[k];
        const Pack v = end[slot];
        sum.end += s.S[k] * v;
        if constexpr (Extra == 1 || Extra == 2) sum.start += s.S[k] * start[slot];
        if constexpr (Extra == 2) sum.filtered += s.S[k] * filtered[slot];
        const Pack d = Extra == 3 ? deforming[slot] : v;
        if (deforms)
            for (int a = 0; a < D; ++a) sum.gradient.column[a] += s.G[a][k] * d;
        if constexpr (Source::ring) hoop += s.T[k] * d[1];
    }
    sum.gradient.hoop = hoop;
    return sum;
}

template <int D>
void move(const MoveRule& rule, const Gathered<D>& g, Vec<D>& V, Vec<D>& X, double dt) {
    const Pack old = pack<D>(0, V);
    const Pack next = rule.v_V * old + rule.v_E * g.end + rule.v_B * g.start + rule.v_F * g.filtered;
    V = vector_of<D>(next);
    X += dt * vector_of<D>(rule.x_V * old + rule.x_N * next + rule.x_E * g.end + rule.x_B * g.start);
}

/// One sweep over the particles of a tile. \return the largest ρ0 c² [Pa]; the first particle that fails in `failed`
template <int D, class Source, int Extra>
double sweep_tile(State<D>& state, const Sweep<D>& sweep, const Tile<D>& tile, std::int32_t& failed) {
    Particles<D>& particles = state.particles;
    auto stencils = state.template stencils<Source>(tile);
    const bool deforms = sweep.strain_step > 0;
    double stiffest = 0;
    VelocityGradient<D> gradients[chunk];
    for (std::int32_t first = tile.first; first < tile.last; first += chunk) {
        const std::int32_t last = std::min(tile.last, first + chunk);
        for (std::int32_t p = first; p < last; ++p) {
            const Gathered<D> g =
                gather<D, Source, Extra>(state, sweep, deforms ? stencils.of(p) : stencils.values_of(p), deforms);
            gradients[p - first] = g.gradient;
            if (!sweep.rule) continue;
            move(*sweep.rule, g, particles.velocity[p], particles.position[p], state.dt);
            if (failed < 0 && !moves_soundly(state, p)) failed = p;
        }
        if (!deforms) continue;
        with_law(state.material_of(tile.body).law, [&](const auto& law) {
            for (std::int32_t p = first; p < last; ++p) {
                const double stiffness =
                    update_stress(particles, p, law, gradients[p - first], sweep.strain_step,
                                  state.scene.method.deformation_increment, state.effects.free_across);
                stiffest = std::max(stiffest, stiffness);
                // Neither negative nor infinite nor not a number; a sum of stresses is none of these if they aren't.
                const bool sound = stiffness >= 0 && std::isfinite(stiffness + particles.stress[p].sum());
                if (failed < 0 && !sound) failed = p;
            }
        });
    }
    return stiffest;
}

template <int D>
void run(State<D>& state, const Sweep<D>& sweep) {
    const std::size_t tile_count = state.tiling.tiles.size();
    Failures failures(tile_count);
    std::vector<double> fastest(tile_count, 0);
    const auto with_extra = [&](auto extra) {
        with_stencils(state, [&](auto source) {
            for_each_tile(state.tiling, [&](const Tile<D>& tile) {
                if (is_rigid(state, tile.body)) return;
                const std::size_t t = &tile - state.tiling.tiles.data();
                const double stiffest =
                    sweep_tile<D, decltype(source), decltype(extra)::value>(state, sweep, tile, failures.particle[t]);
                fastest[t] = std::sqrt(stiffest / state.material_of(tile.body).density);
            });
        });
    };
    if (&sweep.deforming != &sweep.end_velocity)
        with_extra(std::integral_constant<int, 3>{});
    else if (sweep.rule && sweep.rule->needs_filtered())
        with_extra(std::integral_constant<int, 2>{});
    else if (sweep.rule && sweep.rule->needs_start())
        with_extra(std::integral_constant<int, 1>{});
    else
        with_extra(std::integral_constant<int, 0>{});
    if (const std::int32_t p = failures.first(); p >= 0) throw_trouble_of(state, p);
    if (sweep.strain_step > 0) {
        state.largest_wave_speed = 0;
        for (const double speed : fastest) state.largest_wave_speed = std::max(state.largest_wave_speed, speed);
    }
}

/// What moves and deforms the particles at the end of the step.
template <int D>
const std::vector<Pack>& final_velocity(const State<D>& state) {
    return state.effects.fmpm && state.transfers ? state.nodes.filtered : state.nodes.end_velocity;
}

/// Velocities that deform particles apart from the momentum update: as given, then through the full mass matrix and the
/// velocity conditions (FMPM paper §2.3, task 5; notes 2.3.2).
/// \param changed takes them if they differ from `lumped`
template <int D>
const std::vector<Pack>& deforming_velocity(State<D>& state, const std::vector<Pack>& lumped,
                                            const std::vector<Pack>* delta, std::vector<Pack>& changed) {
    const bool full_mass_matrix = state.effects.fmpm && state.transfers;
    if (!state.effects.velocity_conditions && !full_mass_matrix) return lumped;
    changed = lumped;
    if (state.conditions_on_lumped()) impose_untracked(state.controls, changed);
    if (!full_mass_matrix) return changed;
    std::vector<Pack> filtered;
    apply_mass_matrix_inverse(state, changed, delta, filtered);
    keep_normal_jumps(state, changed, filtered, false);
    if (state.scene.method.velocity_conditions != VelocityConditions::lumped)
        impose_untracked(state.controls, filtered);
    changed.swap(filtered);
    return changed;
}

} // namespace

template <int D>
void update_particles(State<D>& state) {
    const bool with_stress = state.effects.stress_last && !state.effects.reextrapolate;
    const double strain_step = with_stress ? state.effects.stress_share() * state.dt : 0;
    const MoveRule rule = move_rule(state.scene.method.transfer, state.transfers);
    const std::vector<Pack>& velocity = final_velocity(state);
    const bool apart = state.effects.contact_strain && state.transfers; // fmpm, whose rules want E alone
    run<D>(state, {&rule, velocity, apart ? state.nodes.deforming : velocity, strain_step});
}

template <int D>
void update_stress_first(State<D>& state) {
    const std::vector<Pack>* delta = state.effects.delta_velocity ? &state.nodes.delta_velocity : nullptr;
    std::vector<Pack> changed;
    const std::vector<Pack>& velocity = deforming_velocity(state, state.nodes.velocity, delta, changed);
    run<D>(state, {nullptr, velocity, velocity, state.effects.stress_share() * state.dt});
}

template <int D>
void update_stress_again(State<D>& state) {
    // The stencils are still those of the step's beginning: particles and grid have moved together since.
    extrapolate_momenta(state);
    std::vector<Pack> lumped;
    divide_by_mass(state.nodes.momentum, lumped);
    if (state.effects.rigid) set_rigid_velocities(state, rigid_poses(state, state.time + state.dt), lumped);
    std::vector<Pack> delta;
    if (state.effects.contact)
        correct_for_contact(state, lumped, state.effects.fmpm && state.transfers ? &delta : nullptr);
    std::vector<Pack> changed;
    const std::vector<Pack>& velocity = deforming_velocity(state, lumped, delta.empty() ? nullptr : &delta, changed);
    run<D>(state, {nullptr, velocity, velocity, state.effects.stress_share() * state.dt});
}

template void update_particles<2>(State<2>&);
template void update_particles<3>(State<3>&);
template void update_stress_first<2>(State<2>&);
template void update_stress_first<3>(State<3>&);
template void update_stress_again<2>(State<2>&);
template void update_stress_again<3>(State<3>&);

} // namespace abut
