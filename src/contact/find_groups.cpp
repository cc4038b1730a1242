#include "contact/find_contacts.h"

#include "boundary/rigid_body.h"

namespace abut {

namespace {

/// The rigid body of the group, else the active body with the most mass but `own`: lumped bodies take the law of that
/// pair.
template <int D>
std::int32_t main_partner(const State<D>& state, const ContactGroup<D>& group, std::int32_t own) {
    std::int32_t best = -1;
    for (std::int32_t i = group.first; i < group.last; ++i) {
        const std::int32_t slot = state.contact.active[i];
        if (slot == own) continue;
        if (is_rigid(state, state.fields.field[slot])) return slot;
        if (best < 0 || state.nodes.momentum[slot][0] > state.nodes.momentum[best][0]) best = slot;
    }
    return best;
}

template <int D>
ContactPoint<D> make_point(const State<D>& state, std::int32_t slot_a, std::int32_t slot_b, bool lumped) {
    ContactPoint<D> point;
    point.slot_a = slot_a;
    point.slot_b = lumped ? -1 : slot_b;
    point.body_a = state.fields.field[slot_a];
    point.body_b = state.fields.field[slot_b];
    point.rigid_a = is_rigid(state, point.body_a);
    point.rigid_b = is_rigid(state, point.body_b);
    return point;
}

/// One point for each pair of active bodies; if lumped, one for each of three or more bodies.
template <int D>
void add_points(State<D>& state, ContactGroup<D>& group) {
    Contact<D>& contact = state.contact;
    group.first_point = static_cast<std::int32_t>(contact.points.size());
    const bool lumped = group.last - group.first > 2 && contact.three_or_more == ThreeOrMore::lumped;
    for (std::int32_t i = group.first; i < group.last; ++i) {
        const std::int32_t a = contact.active[i];
        if (lumped) {
            if (!is_rigid(state, state.fields.field[a]))
                contact.points.push_back(make_point(state, a, main_partner(state, group, a), true));
            continue;
        }
        for (std::int32_t j = i + 1; j < group.last; ++j) {
            const ContactPoint<D> point = make_point(state, a, contact.active[j], false);
            if (!point.rigid_a || !point.rigid_b) contact.points.push_back(point);
        }
    }
    group.last_point = static_cast<std::int32_t>(contact.points.size());
}

} // namespace

template <int D>
void find_groups(State<D>& state) {
    Contact<D>& contact = state.contact;
    contact.groups.clear();
    contact.points.clear();
    contact.active.clear();
    for (const ContactNode<D>& node : state.fields.contact_nodes) {
        ContactGroup<D> group;
        group.node = node.node;
        group.first = static_cast<std::int32_t>(contact.active.size());
        for (std::int32_t slot = node.first; slot < node.first + node.count; ++slot)
            if (state.nodes.momentum[slot][0] > 0) contact.active.push_back(slot);
        group.last = static_cast<std::int32_t>(contact.active.size());
        if (group.last - group.first < 2) {
            contact.active.resize(group.first);
            continue;
        }
        add_points(state, group);
        if (group.first_point == group.last_point) { // rigid bodies alone
            contact.active.resize(group.first);
            continue;
        }
        contact.groups.push_back(group);
    }
}

template void find_groups<2>(State<2>&);
template void find_groups<3>(State<3>&);

} // namespace abut
