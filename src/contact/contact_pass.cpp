#include "contact/contact_pass.h"

namespace abut {

namespace {

/// Mass and velocity of the other side of a point: body b, or all others lumped (contact paper Eq. 50).
template <int D>
Pack other_side(const State<D>& state, const ContactGroup<D>& group, const ContactPoint<D>& point,
                const std::vector<Pack>& velocity) {
    if (point.slot_b >= 0) return velocity[point.slot_b];
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

/// Δp' of body a.
/// \param carry time by which the separation is carried forward with the velocities (notes 3.56) [s]
template <int D>
Vec<D> point_impulse(const State<D>& state, const ContactPoint<D>& point, const Pack& a, const Pack& b, double carry,
                     bool& touching) {
    const double reduced_mass = a[0] * b[0] / (a[0] + b[0]);
    const Vec<D> approach = vector_of<D>(b - a);
    const double separation = point.separation + approach.dot(point.normal) * carry;
    touching = separation < 0;
    return law_impulse<D>(state.contact.laws.between(point.body_a, point.body_b), reduced_mass * approach, point.normal,
                          touching);
}

/// Applies the laws at every point of a group to `velocity`. All points see the velocities as they were before.
template <int D>
void correct_group(State<D>& state, const ContactGroup<D>& group, double carry, std::vector<Pack>& velocity,
                   std::vector<Pack>* change) {
    const auto apply = [&](std::int32_t slot, const Vec<D>& impulse) {
        const Pack delta = pack<D>(0, impulse / velocity[slot][0]);
        velocity[slot] += delta;
        if (change) (*change)[slot] += delta;
    };
    for (std::int32_t i = group.first_point; i < group.last_point; ++i) {
        ContactPoint<D>& point = state.contact.points[i];
        const Pack other = other_side(state, group, point, velocity);
        point.impulse = point_impulse(state, point, velocity[point.slot_a], other, carry, point.touching);
    }
    for (std::int32_t i = group.first_point; i < group.last_point; ++i) {
        ContactPoint<D>& point = state.contact.points[i];
        if (point.impulse.isZero(0)) continue;
        apply(point.slot_a, point.impulse);
        if (point.slot_b >= 0) apply(point.slot_b, -point.impulse);
    }
}

template <int D>
void correct_all(State<D>& state, double carry, std::vector<Pack>& velocity, std::vector<Pack>* change) {
    const auto n = static_cast<std::ptrdiff_t>(state.contact.groups.size());
#pragma omp parallel for schedule(static)
    for (std::ptrdiff_t g = 0; g < n; ++g) correct_group(state, state.contact.groups[g], carry, velocity, change);
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
    correct_all<D>(state, state.dt, state.nodes.end_velocity, nullptr);
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
template void second_contact_pass<2>(State<2>&);
template double contact_work<2>(const State<2>&);

} // namespace abut
