#include "contact/hold_together.h"

#include "contact/group_view.h"

#include <algorithm>

namespace abut {

namespace {

template <int D>
Hold hold_of(const State<D>& state, const ContactPoint<D>& point, HoldsOf which, const std::vector<Pack>& velocity) {
    if (is_perfect(state.contact.laws.between(point.body_a, point.body_b))) return Hold::all;
    if (which == HoldsOf::perfect || point.slot_b < 0 || point.impulse.isZero(0)) return Hold::none;
    const Pack& a = velocity[point.slot_a];
    const Pack& b = velocity[point.slot_b];
    const Vec<D> jump = vector_of<D>(b - a) - (point.at_node + point.parting) * point.normal;
    // What round-off, and the sweeps over several pairs, leave of velocities and of what has been taken from them.
    const double given = point.impulse.norm() / (point.rigid_a ? b[0] : a[0]);
    const double nothing = 1e-10 * (vector_of<D>(a).norm() + vector_of<D>(b).norm() + given);
    if (jump.norm() <= nothing) return Hold::all;
    return std::abs(jump.dot(point.normal)) <= nothing ? Hold::normal : Hold::none;
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

/// What a sweep works on. `share` of what bodies exchange in it belongs to the contact forces of the step: u ← P b + u
/// − P S+ S u leaves each body with the momentum of b, what the projection of b has given it, and less what the
/// projection in the last sweep has.
struct Held {
    const std::vector<Pack>& masses;
    const std::vector<Pack>& velocity;
    std::vector<Pack>& momentum;
    double share;
};

/// All bodies of a node as one, if that is what each of them is held to.
template <int D>
void hold_lumped(Contact<D>& contact, const ContactGroup<D>& group, Range points, const Held& held) {
    if (points.first == points.last || group.rigid_slot >= 0) return;
    for (std::int32_t i = points.first; i < points.last; ++i)
        if (contact.points[i].held != Hold::all) return;
    double mass = 0;
    Pack sum{};
    for (std::int32_t i = group.first; i < group.last; ++i) {
        mass += held.masses[contact.active[i]][0];
        sum += held.momentum[contact.active[i]];
    }
    for (std::int32_t i = points.first; i < points.last; ++i) {
        ContactPoint<D>& point = contact.points[i];
        const Pack impulse = held.masses[point.slot_a][0] / mass * sum - held.momentum[point.slot_a];
        held.momentum[point.slot_a] += impulse;
        point.extra_impulse += held.share * vector_of<D>(impulse);
    }
}

/// One pair. \return what it changed the jump by
template <int D>
double hold_pair(ContactPoint<D>& point, const Held& held) {
    const double mass_a = held.masses[point.slot_a][0];
    const double mass_b = held.masses[point.slot_b][0];
    const auto of = [&](std::int32_t slot) -> Pack { return held.momentum[slot] / held.masses[slot][0]; };
    if (point.rigid_a || point.rigid_b) { // a rigid body is not in the sweeps, what it holds stays as it is
        const std::int32_t slot = point.rigid_a ? point.slot_b : point.slot_a;
        const Vec<D> back = forbidden<D>(point, vector_of<D>(held.velocity[slot] - of(slot)));
        const Vec<D> impulse = held.masses[slot][0] * back;
        held.momentum[slot] += pack<D>(0, impulse);
        point.extra_impulse += (point.rigid_a ? -held.share : held.share) * impulse;
        return back.norm();
    }
    const Vec<D> jump = forbidden<D>(point, vector_of<D>(of(point.slot_b) - of(point.slot_a)));
    const Vec<D> impulse = mass_a * mass_b / (mass_a + mass_b) * jump;
    held.momentum[point.slot_a] += pack<D>(0, impulse);
    held.momentum[point.slot_b] -= pack<D>(0, impulse);
    point.extra_impulse += held.share * impulse;
    return jump.norm();
}

template <int D>
void hold_group(State<D>& state, const ContactGroup<D>& group, const Held& held) {
    if (!is_held(state, group)) return;
    Contact<D>& contact = state.contact;
    hold_lumped(contact, group, lumped_points(state, group), held);
    if (contact.points[group.first_point].slot_b < 0) return;
    // Several pairs: in turn, until nothing changes, as contact itself does it (contact_pass.cpp).
    constexpr int most_sweeps = 50;
    constexpr double tolerance = 1e-12; // of the largest change of the first sweep
    double first = 0;
    const int sweeps = group.last_point - group.first_point > 1 ? most_sweeps : 1;
    for (int sweep = 0; sweep < sweeps; ++sweep) {
        double largest = 0;
        for (std::int32_t i = group.first_point; i < group.last_point; ++i)
            if (contact.points[i].held != Hold::none) largest = std::max(largest, hold_pair(contact.points[i], held));
        if (sweep == 0) first = largest;
        if (largest <= tolerance * first) break;
    }
}

/// A wall that pushes: one that bodies may leave, and do not.
bool holds(const Control& control) {
    return control.impulse * control.push > 0;
}

void hold_at_walls(std::vector<Control>& controls, const std::vector<char>& holding, const Held& held) {
    for (std::size_t c = 0; c < controls.size(); ++c) {
        if (!holding[c]) continue;
        Control& control = controls[c];
        const double wanted = held.masses[control.slot][0] * dot(held.velocity[control.slot], control.direction);
        const double impulse = wanted - dot(held.momentum[control.slot], control.direction);
        held.momentum[control.slot] += impulse * control.direction;
        control.impulse += held.share * impulse;
    }
}

/// Contact and walls that hold the same slots, in turns; walls have the last word.
template <int D>
void hold_groups_at_walls(State<D>& state, const Held& held) {
    std::vector<Control>& controls = state.controls;
    std::vector<char> holding(controls.size());
    for (std::size_t c = 0; c < controls.size(); ++c) holding[c] = holds(controls[c]) ? 1 : 0;
    if (std::find(holding.begin(), holding.end(), 1) == holding.end()) return;
    hold_at_walls(controls, holding, held);
    if (state.contact.groups.empty()) return;
    std::vector<char> at_wall(state.fields.size(), 0);
    for (std::size_t c = 0; c < controls.size(); ++c)
        if (holding[c]) at_wall[controls[c].slot] = 1;
    std::vector<const ContactGroup<D>*> groups;
    for (const ContactGroup<D>& group : state.contact.groups) {
        bool any = false;
        for (std::int32_t i = group.first; i < group.last; ++i) any |= at_wall[state.contact.active[i]] != 0;
        if (any && is_held(state, group)) groups.push_back(&group);
    }
    constexpr int turns = 10; // as many as the contact pass makes
    for (int turn = 0; turn < turns && !groups.empty(); ++turn) {
        for (const ContactGroup<D>* group : groups) hold_group(state, *group, held);
        hold_at_walls(controls, holding, held);
    }
}

} // namespace

template <int D>
void hold_together(State<D>& state, const std::vector<Pack>& masses, const std::vector<Pack>& velocity,
                   std::vector<Pack>& momentum, bool last) {
    const Held held{masses, velocity, momentum, last ? -1.0 : 0.0};
    const auto n = static_cast<std::ptrdiff_t>(state.contact.groups.size());
#pragma omp parallel for schedule(static) if (n > 0)
    for (std::ptrdiff_t g = 0; g < n; ++g) hold_group(state, state.contact.groups[g], held);
    if (state.effects.fmpm && !state.controls.empty()) hold_groups_at_walls(state, held);
}

template <int D>
void drop_held_part(State<D>& state, const std::vector<Pack>& velocity, std::vector<Pack>& delta) {
    std::vector<Pack>& momentum = state.nodes.round_trip; // free until the sweeps
    momentum.resize(state.fields.size());
    const Held held{velocity, velocity, momentum, 1};
    const auto n = static_cast<std::ptrdiff_t>(state.contact.groups.size());
#pragma omp parallel for schedule(static)
    for (std::ptrdiff_t g = 0; g < n; ++g) {
        const ContactGroup<D>& group = state.contact.groups[g];
        if (!is_held(state, group)) continue;
        const auto for_each_slot = [&](auto&& work) {
            for (std::int32_t i = group.first; i < group.last; ++i) work(state.contact.active[i]);
        };
        // Δv = v − P (v − Δv)
        for_each_slot([&](std::int32_t slot) { momentum[slot] = velocity[slot][0] * (velocity[slot] - delta[slot]); });
        hold_group(state, group, held);
        for_each_slot([&](std::int32_t slot) {
            delta[slot] = velocity[slot] - momentum[slot] / velocity[slot][0];
            delta[slot][0] = 0;
        });
    }
}

template <int D>
void find_holds(State<D>& state, HoldsOf which, const std::vector<Pack>& velocity, std::vector<Pack>& delta) {
    for (const ContactGroup<D>& group : state.contact.groups) {
        const Range points = points_in_use(group);
        for (std::int32_t i = points.first; i < points.last; ++i)
            state.contact.points[i].held = hold_of(state, state.contact.points[i], which, velocity);
    }
    drop_held_part(state, velocity, delta);
}

template void hold_together<2>(State<2>&, const std::vector<Pack>&, const std::vector<Pack>&, std::vector<Pack>&, bool);
template void hold_together<3>(State<3>&, const std::vector<Pack>&, const std::vector<Pack>&, std::vector<Pack>&, bool);
template void drop_held_part<2>(State<2>&, const std::vector<Pack>&, std::vector<Pack>&);
template void drop_held_part<3>(State<3>&, const std::vector<Pack>&, std::vector<Pack>&);
template void find_holds<2>(State<2>&, HoldsOf, const std::vector<Pack>&, std::vector<Pack>&);
template void find_holds<3>(State<3>&, HoldsOf, const std::vector<Pack>&, std::vector<Pack>&);

} // namespace abut
