#include "contact/find_contacts.h"

namespace abut {

namespace {

/// The active body with the most mass but `own`: lumped bodies take the law of that pair.
template <int D>
std::int32_t main_partner(const State<D>& state, const ContactGroup<D>& group, std::int32_t own) {
    std::int32_t best = -1;
    for (std::int32_t i = group.first; i < group.last; ++i) {
        const std::int32_t slot = state.contact.active[i];
        if (slot == own) continue;
        if (best < 0 || state.nodes.momentum[slot][0] > state.nodes.momentum[best][0]) best = slot;
    }
    return best;
}

template <int D>
ContactPoint<D> make_point(const State<D>& state, const ContactGroup<D>& group, std::int32_t slot) {
    const std::int32_t partner = main_partner(state, group, slot);
    ContactPoint<D> point;
    point.slot_a = slot;
    point.slot_b = group.lumped() ? -1 : partner;
    point.body_a = state.fields.field[slot];
    point.body_b = state.fields.field[partner];
    return point;
}

} // namespace

template <int D>
void find_groups(State<D>& state) {
    Contact<D>& contact = state.contact;
    contact.groups.clear();
    contact.points.clear();
    contact.active.clear();
    for (const ContactNode<D>& node : state.fields.contact_nodes) {
        double total = 0;
        for (std::int32_t slot = node.first; slot < node.first + node.count; ++slot)
            total += state.nodes.momentum[slot][0];

        ContactGroup<D> group;
        group.node = node.node;
        group.first = static_cast<std::int32_t>(contact.active.size());
        for (std::int32_t slot = node.first; slot < node.first + node.count; ++slot)
            if (state.nodes.momentum[slot][0] > contact.smallest_share * total) contact.active.push_back(slot);
        group.last = static_cast<std::int32_t>(contact.active.size());
        if (group.last - group.first < 2) {
            contact.active.resize(group.first);
            continue;
        }
        group.first_point = static_cast<std::int32_t>(contact.points.size());
        const std::int32_t with_points = group.lumped() ? group.last : group.first + 1;
        for (std::int32_t i = group.first; i < with_points; ++i)
            contact.points.push_back(make_point(state, group, contact.active[i]));
        group.last_point = static_cast<std::int32_t>(contact.points.size());
        contact.groups.push_back(group);
    }
}

template void find_groups<2>(State<2>&);

} // namespace abut
