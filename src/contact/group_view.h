#pragma once
/// \file group_view.h
/// How the searches look at a contact group: its points, the sides of a point, its particles.

#include "contact/contact.h"

namespace abut {

/// The points of a group whose impulses act: those of the pairs, or of the bodies lumped.
template <int D>
Range points_in_use(const ContactGroup<D>& group) {
    return group.uses_lumped ? Range{group.first_lumped, group.last_lumped}
                             : Range{group.first_point, group.last_point};
}

/// Calls work(point) for all points of a group, pairs and lumped.
template <class AnyContact, int D, class Work>
void for_each_point(AnyContact& contact, const ContactGroup<D>& group, Work&& work) {
    for (std::int32_t i = group.first_point; i < group.last_point; ++i) work(contact.points[i]);
    for (std::int32_t i = group.first_lumped; i < group.last_lumped; ++i) work(contact.points[i]);
}

/// Sum of a slot quantity over the other side of a point: body b, or all active bodies but a.
template <int D>
Pack sum_of_others(const Contact<D>& contact, const ContactGroup<D>& group, const ContactPoint<D>& point,
                   const std::vector<Pack>& values) {
    if (point.slot_b >= 0) return values[point.slot_b];
    Pack sum{};
    for (std::int32_t i = group.first; i < group.last; ++i)
        if (contact.active[i] != point.slot_a) sum += values[contact.active[i]];
    return sum;
}

/// The particles that a group sees (Effects::clouds).
struct CloudParticles {
    const std::int32_t* first;
    const std::int32_t* last;
    const std::int32_t* begin() const { return first; }
    const std::int32_t* end() const { return last; }
};
template <int D>
CloudParticles particles_of_group(const Contact<D>& contact, std::ptrdiff_t g) {
    const std::int32_t* first = contact.cloud_particles.data() + g * contact.cloud_capacity;
    return {first, first + contact.cloud_size[g]};
}

/// Whether a point of the group sees a particle of `body`.
template <int D>
bool takes_part(const ContactPoint<D>& point, std::int32_t body) {
    return point.slot_b < 0 || body == point.body_a || body == point.body_b;
}

} // namespace abut
