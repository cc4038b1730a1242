#include "contact/hold_together.h"

#include "contact/group_view.h"

#include <algorithm>

namespace abut {

namespace {

template <int D>
Hold hold_of(const State<D>& state, const ContactPoint<D>& point, const std::vector<Pack>& velocity) {
    if (is_perfect(state.contact.laws.between(point.body_a, point.body_b))) return Hold::all;
    if (state.effects.fmpm || point.slot_b < 0 || point.impulse.isZero(0)) return Hold::none;
    const Pack& a = velocity[point.slot_a];
    const Pack& b = velocity[point.slot_b];
    const Vec<D> jump = vector_of<D>(b - a);
    // What round-off, and the sweeps over several pairs, leave of velocities and of what has been taken from them.
    const double given = point.impulse.norm() / (point.rigid_a ? b[0] : a[0]);
    const double nothing = 1e-10 * (vector_of<D>(a).norm() + vector_of<D>(b).norm() + given);
    if (jump.norm() <= nothing) return Hold::all;
    return std::abs(jump.dot(point.normal) - point.at_node) <= nothing ? Hold::normal : Hold::none;
}

/// Points that stand for bodies against all others of their node.
template <int D>
Range lumped_points(const State<D>& state, const ContactGroup<D>& group) {
    if (state.contact.points[group.first_point].slot_b < 0) return {group.first_point, group.last_point};
    return {group.first_lumped, group.last_lumped};
}

template <int D>
bool is_held(const State<D>& state, const ContactGroup<D>& group) {
    bool any = false;
    for_each_point(state.contact, group, [&](const ContactPoint<D>& point) { any |= point.held != Hold::none; });
    return any;
}

/// The part of a jump that a point may not have.
template <int D>
Vec<D> forbidden(const ContactPoint<D>& point, const Vec<D>& jump) {
    if (point.held == Hold::all) return jump;
    return jump.dot(point.normal) * point.normal;
}

/// All bodies of a node as one, if that is what each of them is held to.
template <int D>
void hold_lumped(const State<D>& state, const ContactGroup<D>& group, const std::vector<Pack>& masses,
                 std::vector<Pack>& momentum) {
    const Range points = lumped_points(state, group);
    if (points.first == points.last || group.rigid_slot >= 0) return;
    for (std::int32_t i = points.first; i < points.last; ++i)
        if (state.contact.points[i].held != Hold::all) return;
    double mass = 0;
    Pack sum{};
    for (std::int32_t i = group.first; i < group.last; ++i) {
        const std::int32_t slot = state.contact.active[i];
        mass += masses[slot][0];
        sum += momentum[slot];
    }
    for (std::int32_t i = group.first; i < group.last; ++i) {
        const std::int32_t slot = state.contact.active[i];
        momentum[slot] = masses[slot][0] / mass * sum;
    }
}

/// One pair. \return what it changed the jump by
template <int D>
double hold_pair(const ContactPoint<D>& point, const std::vector<Pack>& masses, const std::vector<Pack>& velocity,
                 std::vector<Pack>& momentum) {
    const double mass_a = masses[point.slot_a][0];
    const double mass_b = masses[point.slot_b][0];
    const auto of = [&](std::int32_t slot) -> Pack { return momentum[slot] / masses[slot][0]; };
    if (point.rigid_a || point.rigid_b) { // a rigid body is not in the sweeps, what it holds stays as it is
        const std::int32_t slot = point.rigid_a ? point.slot_b : point.slot_a;
        const Vec<D> back = forbidden<D>(point, vector_of<D>(velocity[slot] - of(slot)));
        momentum[slot] += pack<D>(0, masses[slot][0] * back);
        return back.norm();
    }
    const Vec<D> jump = forbidden<D>(point, vector_of<D>(of(point.slot_b) - of(point.slot_a)));
    const Pack impulse = pack<D>(0, mass_a * mass_b / (mass_a + mass_b) * jump);
    momentum[point.slot_a] += impulse;
    momentum[point.slot_b] -= impulse;
    return jump.norm();
}

template <int D>
void hold_group(const State<D>& state, const ContactGroup<D>& group, const std::vector<Pack>& masses,
                const std::vector<Pack>& velocity, std::vector<Pack>& momentum) {
    if (!is_held(state, group)) return;
    hold_lumped(state, group, masses, momentum);
    if (state.contact.points[group.first_point].slot_b < 0) return;
    // Several pairs: in turn, until nothing changes, as contact itself does it (contact_pass.cpp).
    constexpr int most_sweeps = 50;
    constexpr double tolerance = 1e-12; // of the largest change of the first sweep
    double first = 0;
    const int sweeps = group.last_point - group.first_point > 1 ? most_sweeps : 1;
    for (int sweep = 0; sweep < sweeps; ++sweep) {
        double largest = 0;
        for (std::int32_t i = group.first_point; i < group.last_point; ++i) {
            const ContactPoint<D>& point = state.contact.points[i];
            if (point.held != Hold::none) largest = std::max(largest, hold_pair(point, masses, velocity, momentum));
        }
        if (sweep == 0) first = largest;
        if (largest <= tolerance * first) break;
    }
}

} // namespace

template <int D>
void hold_together(const State<D>& state, const std::vector<Pack>& masses, const std::vector<Pack>& velocity,
                   std::vector<Pack>& momentum) {
    const auto n = static_cast<std::ptrdiff_t>(state.contact.groups.size());
#pragma omp parallel for schedule(static)
    for (std::ptrdiff_t g = 0; g < n; ++g) hold_group(state, state.contact.groups[g], masses, velocity, momentum);
}

template <int D>
void drop_held_part(State<D>& state, const std::vector<Pack>& velocity, std::vector<Pack>& delta) {
    std::vector<Pack>& momentum = state.nodes.round_trip; // free until the sweeps
    momentum.resize(state.fields.size());
    const Contact<D>& contact = state.contact;
    const auto n = static_cast<std::ptrdiff_t>(contact.groups.size());
#pragma omp parallel for schedule(static)
    for (std::ptrdiff_t g = 0; g < n; ++g) {
        const ContactGroup<D>& group = contact.groups[g];
        if (!is_held(state, group)) continue;
        const auto for_each_slot = [&](auto&& work) {
            for (std::int32_t i = group.first; i < group.last; ++i) work(contact.active[i]);
        };
        // Δv = v − P (v − Δv)
        for_each_slot([&](std::int32_t slot) { momentum[slot] = velocity[slot][0] * (velocity[slot] - delta[slot]); });
        hold_group(state, group, velocity, velocity, momentum);
        for_each_slot([&](std::int32_t slot) {
            if (velocity[slot][0] > 0) delta[slot] = velocity[slot] - momentum[slot] / velocity[slot][0];
            delta[slot][0] = 0;
        });
    }
}

template <int D>
void find_holds(State<D>& state, const std::vector<Pack>& velocity, std::vector<Pack>& delta) {
    for (const ContactGroup<D>& group : state.contact.groups) {
        const Range points = points_in_use(group);
        for (std::int32_t i = points.first; i < points.last; ++i)
            state.contact.points[i].held = hold_of(state, state.contact.points[i], velocity);
    }
    drop_held_part(state, velocity, delta);
}

template void hold_together<2>(const State<2>&, const std::vector<Pack>&, const std::vector<Pack>&, std::vector<Pack>&);
template void hold_together<3>(const State<3>&, const std::vector<Pack>&, const std::vector<Pack>&, std::vector<Pack>&);
template void drop_held_part<2>(State<2>&, const std::vector<Pack>&, std::vector<Pack>&);
template void drop_held_part<3>(State<3>&, const std::vector<Pack>&, std::vector<Pack>&);
template void find_holds<2>(State<2>&, const std::vector<Pack>&, std::vector<Pack>&);
template void find_holds<3>(State<3>&, const std::vector<Pack>&, std::vector<Pack>&);

} // namespace abut
