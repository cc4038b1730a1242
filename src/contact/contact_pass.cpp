#include "contact/contact_pass.h"

#include "boundary/rigid_body.h"
#include "contact/group_view.h"

#include <algorithm>

namespace abut {

namespace {

/// What distinguishes the two passes.
struct Pass {
    double carry = 0; ///< time by which separations have moved on since they were found [s]
    bool second = false;
};

/// One side of a contact point: 1/m, 0 for a rigid body, and velocity.
struct Side {
    double inverse_mass;
    Pack velocity;
};

double reduced_mass(const Side& a, const Side& b) {
    return 1 / (a.inverse_mass + b.inverse_mass);
}

template <int D>
Side side_a(const ContactPoint<D>& point, const std::vector<Pack>& velocity) {
    return {point.rigid_a ? 0.0 : 1 / velocity[point.slot_a][0], velocity[point.slot_a]};
}

/// Body b, or all bodies of the group but a lumped to one of their mass and momentum (contact paper Eq. 50), which
/// moves as the rigid body among them does, if there is one.
template <int D>
Side side_b(const State<D>& state, const ContactGroup<D>& group, const ContactPoint<D>& point,
            const std::vector<Pack>& velocity) {
    if (point.slot_b >= 0) return {point.rigid_b ? 0.0 : 1 / velocity[point.slot_b][0], velocity[point.slot_b]};
    if (group.rigid_slot >= 0) return {0, velocity[group.rigid_slot]};
    double mass = 0;
    Pack momentum{};
    for (std::int32_t i = group.first; i < group.last; ++i) {
        const std::int32_t slot = state.contact.active[i];
        if (slot == point.slot_a) continue;
        mass += velocity[slot][0];
        momentum += velocity[slot][0] * velocity[slot];
    }
    return {1 / mass, momentum / mass};
}

template <int D>
void apply(std::int32_t slot, double inverse_mass, const Vec<D>& impulse, std::vector<Pack>& velocity,
           std::vector<Pack>* change) {
    if (inverse_mass == 0) return;
    const Pack delta = pack<D>(0, inverse_mass * impulse);
    velocity[slot] += delta;
    if (change) (*change)[slot] += delta;
}

/// m (v_b − v_a) at the start of the step: what laws with a memory of the step take for their initial velocity.
template <int D>
Vec<D> momentum_at_start(const State<D>& state, const ContactGroup<D>& group, const ContactPoint<D>& point,
                         double mass) {
    const std::vector<Pack>& start = state.nodes.velocity;
    return mass * vector_of<D>(side_b(state, group, point, start).velocity - start[point.slot_a]);
}

/// m (f_b/m_b − f_a/m_a) of the forces without contact, where they are known before the first pass: not if stress is
/// updated between.
template <int D>
Vec<D> force_between(const State<D>& state, const ContactGroup<D>& group, const ContactPoint<D>& point, double mass) {
    if (state.effects.stress_first) return Vec<D>::Zero();
    const std::vector<Pack>& force = state.nodes.force;
    const std::vector<Pack>& masses = state.nodes.velocity;
    Vec<D> difference = Vec<D>::Zero();
    const bool rigid_side_b = point.slot_b >= 0 ? point.rigid_b : group.rigid_slot >= 0;
    if (!rigid_side_b)
        difference += vector_of<D>(sum_of_others(state.contact, group, point, force)) /
                      sum_of_others(state.contact, group, point, masses)[0];
    if (!point.rigid_a) difference -= vector_of<D>(force[point.slot_a]) / masses[point.slot_a][0];
    return mass * difference;
}

/// A point as its law sees it. \param stick Δp(0)
template <int D>
Meeting<D> meeting_at(const State<D>& state, const ContactGroup<D>& group, const ContactPoint<D>& point,
                      const Vec<D>& stick, double mass, const Pass& pass) {
    Meeting<D> at;
    at.stick = stick;
    at.normal = point.normal;
    at.mass = mass;
    at.dt = state.dt;
    at.separation = point.carried_separation;
    at.second_pass = pass.second;
    if (!state.effects.areas) return at;
    at.cell = state.grid.length();
    at.crossing = at.cell / state.largest_wave_speed;
    at.area = point.area;
    at.discontinuity = point.discontinuity;
    at.separation_at_start = point.separation;
    at.force = force_between(state, group, point, mass);
    at.start = pass.second ? momentum_at_start(state, group, point, mass) : stick;
    return at;
}

template <int D>
void carry_separation(ContactPoint<D>& point, const Vec<D>& approach, const Pass& pass) {
    point.carried_separation =
        point.separation + (approach.dot(point.normal) - point.at_node) * pass.carry; // notes 3.56
    point.touching = point.carried_separation < 0;
}

/// Δp' of every body of a group against the others lumped, each with the velocities as they were before.
template <int D>
void correct_lumped(State<D>& state, const ContactGroup<D>& group, Range points, const Pass& pass,
                    std::vector<Pack>& velocity, std::vector<Pack>* change) {
    Contact<D>& contact = state.contact;
    for (std::int32_t i = points.first; i < points.last; ++i) {
        ContactPoint<D>& point = contact.points[i];
        const Side a = side_a(point, velocity);
        const Side b = side_b(state, group, point, velocity);
        const double mass = reduced_mass(a, b);
        const Vec<D> approach = vector_of<D>(b.velocity - a.velocity);
        carry_separation(point, approach, pass);
        const InterfaceStep<D> step = apply_law(contact.laws.between(point.body_a, point.body_b),
                                                meeting_at<D>(state, group, point, mass * approach, mass, pass));
        point.impulse = step.impulse;
        // Each interface is seen from both sides, but for those with rigid bodies.
        point.interface_energy = (point.rigid_b ? 1 : 0.5) * step.energy;
    }
    for (std::int32_t i = points.first; i < points.last; ++i) {
        const ContactPoint<D>& point = contact.points[i];
        apply<D>(point.slot_a, point.rigid_a ? 0.0 : 1 / velocity[point.slot_a][0], point.impulse, velocity, change);
    }
}

/// Which pairs of a group touch, from the velocities before any correction, and how fast those that overlap shall part.
template <int D>
void begin_pairs(State<D>& state, const ContactGroup<D>& group, const Pass& pass, const std::vector<Pack>& velocity) {
    for (std::int32_t i = group.first_point; i < group.last_point; ++i) {
        ContactPoint<D>& point = state.contact.points[i];
        carry_separation(point, vector_of<D>(velocity[point.slot_b] - velocity[point.slot_a]), pass);
        point.impulse = Vec<D>::Zero();
        point.interface_energy = 0;
        point.light = false;
        point.parting = 0;
        if (!pass.second || !only_slides(state.contact.laws.between(point.body_a, point.body_b))) continue;
        const double mass_a = velocity[point.slot_a][0];
        const double mass_b = velocity[point.slot_b][0];
        point.light = point.touching && std::min(mass_a, mass_b) < state.scene.contact->screening * (mass_a + mass_b);
        if (point.light) {
            const std::vector<Pack>& start = state.nodes.velocity;
            point.sliding = vector_of<D>(start[point.slot_b] - start[point.slot_a]);
            point.sliding -= point.sliding.dot(point.normal) * point.normal;
        }
        point.parting = state.scene.contact->overlap_correction * point.overlap / pass.carry;
    }
}

/// Δp' of every pair of a group: each pair's law is satisfied in turn, with what the other pairs do at that moment,
/// until nothing changes (Gauss and Seidel). A single pair, and two bodies with a third between them that don't touch
/// each other, are the cases with an explicit solution (contact paper §3.4); more touching pairs are solved alike.
/// Momentum is conserved pair by pair. May be called again after velocities have changed for another reason (walls).
template <int D>
void correct_pairs(State<D>& state, const ContactGroup<D>& group, const Pass& pass, std::vector<Pack>& velocity,
                   std::vector<Pack>* change) {
    Contact<D>& contact = state.contact;
    constexpr int most_sweeps = 50;
    constexpr double tolerance = 1e-12; // of the largest correction of the first sweep
    double first = 0;
    const int sweeps = group.last_point - group.first_point > 1 ? most_sweeps : 1;
    for (int sweep = 0; sweep < sweeps; ++sweep) {
        double largest = 0;
        for (std::int32_t i = group.first_point; i < group.last_point; ++i) {
            ContactPoint<D>& point = contact.points[i];
            const Side a = side_a(point, velocity);
            const Side b = side_b(state, group, point, velocity);
            const double mass = reduced_mass(a, b);
            // What would stop the pair if the pair's own impulse had not been given yet.
            const Vec<D> stick = point.impulse + mass * (vector_of<D>(b.velocity - a.velocity) -
                                                         (point.parting + point.at_node) * point.normal);
            Vec<D> impulse = stick - mass * point.sliding;
            if (!point.light) {
                const InterfaceStep<D> step = apply_law(contact.laws.between(point.body_a, point.body_b),
                                                        meeting_at(state, group, point, stick, mass, pass));
                impulse = step.impulse;
                point.interface_energy = step.energy;
            }
            const Vec<D> more = impulse - point.impulse;
            if (more.isZero(0)) continue;
            point.impulse = impulse;
            apply<D>(point.slot_a, a.inverse_mass, more, velocity, change);
            apply<D>(point.slot_b, b.inverse_mass, -more, velocity, change);
            largest = std::max(largest, more.norm() / mass);
        }
        if (sweep == 0) first = largest;
        if (largest <= tolerance * first) break;
    }
}

template <int D>
bool is_lumped(const State<D>& state, const ContactGroup<D>& group) {
    return state.contact.points[group.first_point].slot_b < 0;
}

/// Whether more than two pairs of a group touch and approach (contact paper §3.4).
template <int D>
bool more_than_two_touch(const State<D>& state, const ContactGroup<D>& group, const std::vector<Pack>& velocity) {
    int count = 0;
    for (std::int32_t i = group.first_point; i < group.last_point; ++i) {
        const ContactPoint<D>& point = state.contact.points[i];
        const Vec<D> approach = vector_of<D>(velocity[point.slot_b] - velocity[point.slot_a]);
        count += point.touching && approach.dot(point.normal) < 0;
    }
    return count > 2;
}

/// Leaves no impulse at points that are not used in this pass.
template <int D>
void clear(Contact<D>& contact, Range points) {
    for (std::int32_t i = points.first; i < points.last; ++i) {
        contact.points[i].impulse = Vec<D>::Zero();
        contact.points[i].interface_energy = 0;
    }
}

template <int D>
void correct_group(State<D>& state, ContactGroup<D>& group, const Pass& pass, std::vector<Pack>& velocity,
                   std::vector<Pack>* change) {
    const Range own{group.first_point, group.last_point};
    const Range lumped{group.first_lumped, group.last_lumped};
    if (is_lumped(state, group)) return correct_lumped(state, group, own, pass, velocity, change);
    begin_pairs(state, group, pass, velocity);
    group.uses_lumped = lumped.first < lumped.last && more_than_two_touch(state, group, velocity);
    if (group.uses_lumped) return correct_lumped(state, group, lumped, pass, velocity, change);
    clear(state.contact, lumped);
    correct_pairs(state, group, pass, velocity, change);
}

template <int D>
void correct_all(State<D>& state, const Pass& pass, std::vector<Pack>& velocity, std::vector<Pack>* change) {
    const auto n = static_cast<std::ptrdiff_t>(state.contact.groups.size());
#pragma omp parallel for schedule(static)
    for (std::ptrdiff_t g = 0; g < n; ++g) correct_group(state, state.contact.groups[g], pass, velocity, change);
}

/// Groups of pairs with a slot that a wall controls.
template <int D>
std::vector<std::ptrdiff_t> groups_at_walls(const State<D>& state) {
    std::vector<char> controlled(state.fields.size(), 0);
    for (const Control& control : state.controls) controlled[control.slot] = 1;
    std::vector<std::ptrdiff_t> groups;
    for (std::size_t g = 0; g < state.contact.groups.size(); ++g) {
        const ContactGroup<D>& group = state.contact.groups[g];
        bool any = false;
        for (std::int32_t i = group.first; i < group.last; ++i) any |= controlled[state.contact.active[i]] != 0;
        if (any && !is_lumped(state, group) && !group.uses_lumped) groups.push_back(static_cast<std::ptrdiff_t>(g));
    }
    return groups;
}

} // namespace

template <int D>
void first_contact_pass(State<D>& state) {
    std::vector<Pack>* change = nullptr;
    if (state.effects.delta_velocity) {
        state.nodes.delta_velocity.assign(state.fields.size(), Pack{});
        change = &state.nodes.delta_velocity;
    }
    correct_all(state, {}, state.nodes.velocity, change);
    const bool moves_particles = state.effects.pic && state.transfers;
    if (!moves_particles) return;
    for (ContactPoint<D>& point : state.contact.points) point.extra_impulse = point.impulse;
}

template <int D>
void second_contact_pass(State<D>& state) {
    std::vector<Pack>& velocity = state.nodes.end_velocity;
    const Pass pass{state.dt, true};
    correct_all(state, pass, velocity, nullptr);
    if (!state.conditions_on_lumped()) return;
    // Where a body is pressed against a wall and another body, walls and contact take turns until both are satisfied,
    // or nearly: walls have the last word.
    constexpr int turns = 10;
    const std::vector<std::ptrdiff_t> groups = groups_at_walls(state);
    for (int turn = 0; turn < turns && !groups.empty(); ++turn) {
        impose(state.controls, velocity);
        for (const std::ptrdiff_t g : groups) correct_pairs<D>(state, state.contact.groups[g], pass, velocity, nullptr);
    }
    impose(state.controls, velocity);
}

template <int D>
void correct_for_contact(State<D>& state, std::vector<Pack>& velocity, std::vector<Pack>* change) {
    if (change) change->assign(state.fields.size(), Pack{});
    const std::vector<ContactPoint<D>> points = state.contact.points;
    const std::vector<ContactGroup<D>> groups = state.contact.groups;
    correct_all(state, {}, velocity, change);
    state.contact.points = points;
    state.contact.groups = groups;
}

template void first_contact_pass<2>(State<2>&);
template void first_contact_pass<3>(State<3>&);
template void second_contact_pass<2>(State<2>&);
template void second_contact_pass<3>(State<3>&);
template void correct_for_contact<2>(State<2>&, std::vector<Pack>&, std::vector<Pack>*);
template void correct_for_contact<3>(State<3>&, std::vector<Pack>&, std::vector<Pack>*);

} // namespace abut
