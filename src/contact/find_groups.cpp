#include "contact/find_contacts.h"

#include "boundary/rigid_body.h"

namespace abut {

namespace {

/// The rigid body of the group, else the active body with the most mass but `own`: lumped bodies take the law of that
/// pair.
template <int D>
std::int32_t main_partner(const State<D>& state, const ContactGroup<D>& group, std::int32_t own) {
    if (group.rigid_slot >= 0) return group.rigid_slot;
    std::int32_t best = -1;
    for (std::int32_t i = group.first; i < group.last; ++i) {
        const std::int32_t slot = state.contact.active[i];
        if (slot == own) continue;
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

template <int D>
void add_pairs(State<D>& state, const ContactGroup<D>& group) {
    Contact<D>& contact = state.contact;
    for (std::int32_t i = group.first; i < group.last; ++i)
        for (std::int32_t j = i + 1; j < group.last; ++j) {
            const ContactPoint<D> point = make_point(state, contact.active[i], contact.active[j], false);
            if (!point.rigid_a || !point.rigid_b) contact.points.push_back(point);
        }
}

template <int D>
void add_lumped(State<D>& state, const ContactGroup<D>& group) {
    Contact<D>& contact = state.contact;
    for (std::int32_t i = group.first; i < group.last; ++i) {
        const std::int32_t a = contact.active[i];
        if (!is_rigid(state, state.fields.field[a]))
            contact.points.push_back(make_point(state, a, main_partner(state, group, a), true));
    }
}

/// One point for each pair of active bodies, or for each body. Own normals are those of bodies, not of pairs (notes
/// 3.5).
template <int D>
void add_points(State<D>& state, ContactGroup<D>& group) {
    const Contact<D>& contact = state.contact;
    const auto end = [&contact] { return static_cast<std::int32_t>(contact.points.size()); };
    const bool three = group.last - group.first > 2;
    const bool own = state.effects.planes && state.scene.contact->normal == NormalMethod::own_gradient;
    group.first_point = end();
    if (own || (three && contact.three_or_more == ThreeOrMore::lumped))
        add_lumped(state, group);
    else
        add_pairs(state, group);
    group.last_point = group.first_lumped = end();
    if (!own && three && contact.three_or_more == ThreeOrMore::up_to_two) add_lumped(state, group);
    group.last_lumped = end();
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
        for (std::int32_t i = group.last; i-- > group.first;)
            if (is_rigid(state, state.fields.field[contact.active[i]])) group.rigid_slot = contact.active[i];
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
