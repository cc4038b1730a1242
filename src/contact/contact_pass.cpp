#include "contact/contact_pass.h"

#include <algorithm>

namespace abut {

namespace {

/// Mass and velocity of all bodies of a group but body a, lumped (contact paper Eq. 50).
template <int D>
Pack other_side(const State<D>& state, const ContactGroup<D>& group, const ContactPoint<D>& point,
                const std::vector<Pack>& velocity) {
    double mass = 0;
    Pack momentum{};
    for (std::int32_t i = group.first; i < group.last; ++i) {
        const std::int32_t slot = state.contact.active[i];
        if (slot == point.slot_a) continue;
        mass += velocity[slot][0];
        momentum += velocity[slot][0] * velocity[slot];
    }
    Pack result = momentum / mass;
    result[0] = mass;
    return result;
}

double reduced_mass(const Pack& a, const Pack& b) {
    return a[0] * b[0] / (a[0] + b[0]);
}

template <int D>
void apply(std::int32_t slot, const Vec<D>& impulse, std::vector<Pack>& velocity, std::vector<Pack>* change) {
    const Pack delta = pack<D>(0, impulse / velocity[slot][0]);
    velocity[slot] += delta;
    if (change) (*change)[slot] += delta;
}

/// Δp' of every body of a group against the others lumped, each with the velocities as they were before.
template <int D>
void correct_lumped(State<D>& state, const ContactGroup<D>& group, double carry, std::vector<Pack>& velocity,
                    std::vector<Pack>* change) {
    Contact<D>& contact = state.contact;
    for (std::int32_t i = group.first_point; i < group.last_point; ++i) {
        ContactPoint<D>& point = contact.points[i];
        const Pack a = velocity[point.slot_a];
        const Pack b = other_side(state, group, point, velocity);
        const Vec<D> approach = vector_of<D>(b - a);
        point.touching = point.separation + approach.dot(point.normal) * carry < 0;
        point.impulse = law_impulse<D>(contact.laws.between(point.body_a, point.body_b), reduced_mass(a, b) * approach,
                                       point.normal, point.touching);
    }
    for (std::int32_t i = group.first_point; i < group.last_point; ++i) {
        const ContactPoint<D>& point = contact.points[i];
        apply<D>(point.slot_a, point.impulse, velocity, change);
    }
}

/// Which pairs of a group touch, from the velocities before any correction, and how fast those that overlap shall part.
template <int D>
void begin_pairs(State<D>& state, const ContactGroup<D>& group, double carry, const std::vector<Pack>& velocity) {
    for (std::int32_t i = group.first_point; i < group.last_point; ++i) {
        ContactPoint<D>& point = state.contact.points[i];
        const Vec<D> approach = vector_of<D>(velocity[point.slot_b] - velocity[point.slot_a]);
        point.touching = point.separation + approach.dot(point.normal) * carry < 0;
        const double mass_a = velocity[point.slot_a][0];
        const double mass_b = velocity[point.slot_b][0];
        point.light = carry > 0 && point.touching &&
                      std::min(mass_a, mass_b) < state.scene.contact->screening * (mass_a + mass_b);
        if (point.light) {
            const std::vector<Pack>& start = state.nodes.velocity;
            point.sliding = vector_of<D>(start[point.slot_b] - start[point.slot_a]);
            point.sliding -= point.sliding.dot(point.normal) * point.normal;
        }
        point.impulse = Vec<D>::Zero();
        point.parting = carry > 0 ? state.scene.contact->overlap_correction * point.overlap / carry : 0;
    }
}

/// Δp' of every pair of a group: each pair's law is satisfied in turn, with what the other pairs do at that moment,
/// until nothing changes (Gauss and Seidel). A single pair, and two bodies with a third between them that don't touch
/// each other, are the cases with an explicit solution (contact paper §3.4); more touching pairs are solved alike.
/// Momentum is conserved pair by pair. May be called again after velocities have changed for another reason (walls).
template <int D>
void correct_pairs(State<D>& state, const ContactGroup<D>& group, std::vector<Pack>& velocity,
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
            const Pack a = velocity[point.slot_a];
            const Pack b = velocity[point.slot_b];
            const double mass = reduced_mass(a, b);
            // What would stop the pair if the pair's own impulse had not been given yet.
            const Vec<D> stick = point.impulse + mass * (vector_of<D>(b - a) - point.parting * point.normal);
            const LawSpec& law = contact.laws.between(point.body_a, point.body_b);
            const Vec<D> impulse = point.light ? Vec<D>(stick - mass * point.sliding)
                                               : law_impulse<D>(law, stick, point.normal, point.touching);
            const Vec<D> more = impulse - point.impulse;
            if (more.isZero(0)) continue;
            point.impulse = impulse;
            apply<D>(point.slot_a, more, velocity, change);
            apply<D>(point.slot_b, -more, velocity, change);
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

template <int D>
void correct_all(State<D>& state, double carry, std::vector<Pack>& velocity, std::vector<Pack>* change) {
    const auto n = static_cast<std::ptrdiff_t>(state.contact.groups.size());
#pragma omp parallel for schedule(static)
    for (std::ptrdiff_t g = 0; g < n; ++g) {
        const ContactGroup<D>& group = state.contact.groups[g];
        if (is_lumped(state, group)) {
            correct_lumped(state, group, carry, velocity, change);
        } else {
            begin_pairs(state, group, carry, velocity);
            correct_pairs(state, group, velocity, change);
        }
    }
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
        if (any && !is_lumped(state, group)) groups.push_back(static_cast<std::ptrdiff_t>(g));
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
    correct_all(state, 0, state.nodes.velocity, change);
}

template <int D>
void second_contact_pass(State<D>& state) {
    std::vector<Pack>& velocity = state.nodes.end_velocity;
    correct_all<D>(state, state.dt, velocity, nullptr);
    if (!state.conditions_on_lumped()) return;
    // Where a body is pressed against a wall and another body, walls and contact take turns until both are satisfied,
    // or nearly: walls have the last word.
    constexpr int turns = 10;
    const std::vector<std::ptrdiff_t> groups = groups_at_walls(state);
    for (int turn = 0; turn < turns && !groups.empty(); ++turn) {
        impose(state.controls, velocity);
        for (const std::ptrdiff_t g : groups) correct_pairs<D>(state, state.contact.groups[g], velocity, nullptr);
    }
    impose(state.controls, velocity);
}

template <int D>
void correct_for_contact(State<D>& state, std::vector<Pack>& velocity, std::vector<Pack>* change) {
    if (change) change->assign(state.fields.size(), Pack{});
    const std::vector<ContactPoint<D>> points = state.contact.points;
    correct_all(state, 0, velocity, change);
    state.contact.points = points;
}

template <int D>
double contact_work(const State<D>& state) {
    const NodeArrays<D>& nodes = state.nodes;
    const auto mean_velocity = [&](std::int32_t slot) {
        return vector_of<D>(0.5 * (nodes.velocity[slot] + nodes.end_velocity[slot]));
    };
    double work = 0;
    for (const ContactPoint<D>& point : state.contact.points) {
        if (point.impulse.isZero(0)) continue;
        work += point.impulse.dot(mean_velocity(point.slot_a));
        if (point.slot_b >= 0) work -= point.impulse.dot(mean_velocity(point.slot_b));
    }
    return work;
}

template void first_contact_pass<2>(State<2>&);
template void first_contact_pass<3>(State<3>&);
template void second_contact_pass<2>(State<2>&);
template void second_contact_pass<3>(State<3>&);
template void correct_for_contact<2>(State<2>&, std::vector<Pack>&, std::vector<Pack>*);
template void correct_for_contact<3>(State<3>&, std::vector<Pack>&, std::vector<Pack>*);
template double contact_work<2>(const State<2>&);
template double contact_work<3>(const State<3>&);

} // namespace abut
