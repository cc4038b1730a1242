#include "boundary/rigid_body.h"
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
    with_stencils(state, [&](auto source) {
        using Source = decltype(source);
        for_each_tile_by_colour(state.tiling, [&](const Tile<D>& tile) {
            if (is_rigid(state, tile.body)) return;
            auto stencils = state.template stencils<Source>(tile);
            for (std::int32_t p = tile.first; p < tile.last; ++p) {
                const StencilView<D> s = stencils.values_of(p);
                Pack U{};
                for (int k = 0; k < s.count; ++k) U += s.S[k] * u[s.slot[k]];
                U *= state.particles.mass[p];
                for (int k = 0; k < s.count; ++k) round_trip[s.slot[k]] += s.S[k] * U;
            }
        });
    });
}

} // namespace

/// With A = I − S+ S, m_k^-1 p = Σ_{j<k} A^j v, v = m^-1 p. Hence
///   m_k^-1 p − m_(k−1)^-1 Δp = Σ_{j<k−1} A^j (v − Δv) + A^(k−1) v,
/// which is found from the inside out: u = v, then k − 1 times u ← (v − Δv) + u − S+ S u. This equals the recursion of
/// FMPM paper §2.2 and contact paper Eq. (43), (44) without its binomial coefficients, which alternate in sign and grow
/// with k.
template <int D>
void apply_mass_matrix_inverse(State<D>& state, const std::vector<Pack>& velocity, const std::vector<Pack>* delta,
                               std::vector<Pack>& filtered) {
    const auto n = static_cast<std::ptrdiff_t>(state.fields.size());
    std::vector<Pack>& round_trip = state.nodes.round_trip;
    filtered = velocity;
    for (int order = 0; order < state.effects.extra_orders; ++order) {
        sweep(state, filtered, round_trip);
#pragma omp parallel for schedule(static)
        for (std::ptrdiff_t slot = 0; slot < n; ++slot) {
            const Pack v = velocity[slot];
            if (!(v[0] > 0) || is_rigid(state, state.fields.field[slot])) continue;
            Pack u = v + filtered[slot] - round_trip[slot] / v[0];
            if (delta) u -= (*delta)[slot];
            filtered[slot] = u;
        }
    }
}

namespace {

/// Pairs whose velocities a contact law binds. (A perfect interface wants them filtered like the inside of a body.)
template <int D>
bool is_bound(const State<D>& state, const ContactPoint<D>& point) {
    return !point.impulse.isZero(0) && point.slot_b >= 0 &&
           !is_perfect(state.contact.laws.between(point.body_a, point.body_b));
}

/// Gives the impulse to body a of a pair and takes it from body b. \param masses in lane 0
template <int D>
void exchange(const ContactPoint<D>& point, const Vec<D>& impulse, const std::vector<Pack>& masses,
              std::vector<Pack>& velocity) {
    if (!point.rigid_a) velocity[point.slot_a] += pack<D>(0, impulse / masses[point.slot_a][0]);
    if (!point.rigid_b) velocity[point.slot_b] -= pack<D>(0, impulse / masses[point.slot_b][0]);
}

template <int D>
double reduced_mass(const ContactPoint<D>& point, const std::vector<Pack>& masses) {
    const double a = point.rigid_a ? 0 : 1 / masses[point.slot_a][0];
    const double b = point.rigid_b ? 0 : 1 / masses[point.slot_b][0];
    return 1 / (a + b);
}

/// v_b - v_a
template <int D>
Vec<D> jump(const ContactPoint<D>& point, const std::vector<Pack>& velocity) {
    return vector_of<D>(velocity[point.slot_b] - velocity[point.slot_a]);
}

/// The part of a pair's impulse that stops what approached at the start of the step; the rest balances forces. In
/// lasting contact the first pass has stopped the pair already, and there is no such part.
template <int D>
Vec<D> impact(const State<D>& state, const ContactPoint<D>& point) {
    const std::vector<Pack>& start = state.nodes.velocity;
    const double stop = -reduced_mass(point, start) * jump(point, start).dot(point.normal);
    return -std::clamp(stop, 0.0, std::max(0.0, -point.impulse.dot(point.normal))) * point.normal;
}

} // namespace

/// Gives filtered velocities the jumps along the normals that the contact law has left between lumped ones. (Not the
/// jumps along the interface: that was unstable with FMPM(8) and the law stick.)
template <int D>
void keep_normal_jumps(State<D>& state, const std::vector<Pack>& lumped, std::vector<Pack>& filtered,
                       bool moves_particles) {
    for (ContactPoint<D>& point : state.contact.points) {
        if (!is_bound(state, point)) continue;
        const double excess = (jump(point, filtered) - jump(point, lumped)).dot(point.normal);
        const Vec<D> impulse = reduced_mass(point, lumped) * excess * point.normal;
        exchange<D>(point, impulse, lumped, filtered);
        if (moves_particles) point.extra_impulse += impulse;
    }
}

namespace {

/// FMPM with contact. Impulses of contact go through the full mass matrix with the forces that they balance. But:
/// * Where bodies meet, an impulse that stops the lumped masses of a few nodes would come out of the full mass matrix k
///   times as large and throw the edges back: energy from nowhere (two blocks gained 18 % just after they
///   met, FMPM(8)). So what stops an approach is added after the filter, as it is.
/// * Behind the filter bodies don't keep out of each other any more. As with walls ("combined" conditions, FMPM paper
///   §2.4) they are made to again, with momentum kept pair by pair. Particles then move and deform alike, and don't
///   drift into overlaps.
template <int D>
void filter_with_contact(State<D>& state, const std::vector<Pack>* delta) {
    NodeArrays<D>& nodes = state.nodes;
    std::vector<Pack> without_impacts = nodes.end_velocity;
    for (const ContactPoint<D>& point : state.contact.points)
        if (is_bound(state, point)) exchange<D>(point, -impact(state, point), nodes.end_velocity, without_impacts);
    apply_mass_matrix_inverse(state, without_impacts, delta, nodes.filtered);
    for (const ContactPoint<D>& point : state.contact.points)
        if (is_bound(state, point)) exchange<D>(point, impact(state, point), nodes.end_velocity, nodes.filtered);
    keep_normal_jumps(state, nodes.end_velocity, nodes.filtered, true);
}

/// Where three or more bodies are lumped there are no pairs whose jumps could be kept. There, the edges deform by the
/// velocities that fulfil the contact law: by the filtered ones they would be pressed together more than the bodies
/// are.
template <int D>
void find_deforming_velocities(State<D>& state) {
    NodeArrays<D>& nodes = state.nodes;
    nodes.deforming = nodes.filtered;
    for (const ContactPoint<D>& point : state.contact.points) {
        if (point.slot_b >= 0 || point.impulse.isZero(0)) continue;
        if (is_perfect(state.contact.laws.between(point.body_a, point.body_b))) continue;
        nodes.deforming[point.slot_a] = nodes.end_velocity[point.slot_a];
    }
    impose_untracked(state.controls, nodes.deforming);
}

} // namespace

template <int D>
void filter_velocities(State<D>& state) {
    if (!state.filters()) return;
    NodeArrays<D>& nodes = state.nodes;
    const std::vector<Pack>* delta = state.effects.delta_velocity ? &nodes.delta_velocity : nullptr;
    if (!state.effects.fmpm) return apply_mass_matrix_inverse(state, nodes.velocity, delta, nodes.filtered);
    if (state.effects.contact_strain)
        filter_with_contact(state, delta);
    else
        apply_mass_matrix_inverse(state, nodes.end_velocity, delta, nodes.filtered);
    if (state.effects.velocity_conditions && state.scene.method.velocity_conditions != VelocityConditions::lumped) {
        // The masses, which impulses need, are in lane 0 of the lumped velocities only.
        for (const Control& control : state.controls)
            nodes.filtered[control.slot][0] = nodes.end_velocity[control.slot][0];
        impose(state.controls, nodes.filtered);
    }
    if (state.effects.contact_strain) find_deforming_velocities(state);
}

template void apply_mass_matrix_inverse<2>(State<2>&, const std::vector<Pack>&, const std::vector<Pack>*,
                                           std::vector<Pack>&);
template void apply_mass_matrix_inverse<3>(State<3>&, const std::vector<Pack>&, const std::vector<Pack>*,
                                           std::vector<Pack>&);
template void keep_normal_jumps<2>(State<2>&, const std::vector<Pack>&, std::vector<Pack>&, bool);
template void keep_normal_jumps<3>(State<3>&, const std::vector<Pack>&, std::vector<Pack>&, bool);
template void filter_velocities<2>(State<2>&);
template void filter_velocities<3>(State<3>&);

} // namespace abut
