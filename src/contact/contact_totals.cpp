#include "contact/contact_totals.h"

#include "boundary/rigid_body.h"
#include "contact/group_view.h"

namespace abut {

namespace {

/// Adds up what the bodies of the groups give each other. Neighbouring nodes mostly see the same pair, so that the last
/// one found is looked at first.
template <int D>
class Settlement {
public:
    explicit Settlement(State<D>& state)
        : state_(state), last_(state.pair_totals.end()), centers_(state.bodies.size()) {
        for (std::size_t b = 0; b < state.bodies.size(); ++b)
            if (const auto& rigid = state.bodies[b].rigid)
                centers_[b] = rigid_pose(*rigid, state.time + 0.5 * state.dt).center;
    }

    void add(const ContactGroup<D>& group) {
        // Points out of use have no impulse of the second pass, but may have one of the first.
        const bool lumped = state_.contact.points[group.first_point].slot_b < 0;
        add_points(group, {group.first_point, group.last_point}, lumped);
        add_points(group, {group.first_lumped, group.last_lumped}, true);
    }

private:
    void add_points(const ContactGroup<D>& group, Range points, bool lumped) {
        for (std::int32_t i = points.first; i < points.last; ++i) {
            const ContactPoint<D>& point = state_.contact.points[i];
            add_work(group, point);
            if (!lumped) give(group, point.body_a, point.body_b, point.impulse + point.extra_impulse);
        }
        if (lumped) add_lumped(group, points);
    }

    PairTotals& pair(std::int32_t a, std::int32_t b) {
        const std::pair key = std::minmax(a, b);
        if (last_ == state_.pair_totals.end() || last_->first != std::pair<std::int32_t, std::int32_t>(key))
            last_ = state_.pair_totals.try_emplace(key).first;
        return last_->second;
    }

    Vec<D> mean_velocity(std::int32_t slot) const {
        return vector_of<D>(0.5 * (state_.nodes.velocity[slot] + state_.nodes.end_velocity[slot]));
    }

    /// Body a gets an impulse from body b at a node.
    void give(const ContactGroup<D>& group, std::int32_t a, std::int32_t b, const Vec<D>& impulse) {
        if (impulse.isZero(0)) return;
        const Vector on_a = to_array<D>(impulse);
        PairTotals& totals = pair(a, b);
        for (std::size_t axis = 0; axis < 3; ++axis) totals.impulse[axis] += a < b ? on_a[axis] : -on_a[axis];
        if (!state_.effects.rigid) return;
        if (is_rigid(state_, a)) give_rigid(a, group, impulse);
        if (is_rigid(state_, b)) give_rigid(b, group, -impulse);
    }

    void give_rigid(std::int32_t body, const ContactGroup<D>& group, const Vec<D>& impulse) {
        const Vector place = to_array<D>(state_.grid.node_position(group.node));
        const Vector p = to_array<D>(impulse);
        Vector arm{};
        RigidTotals& totals = state_.rigid_totals[body];
        for (std::size_t a = 0; a < 3; ++a) {
            arm[a] = place[a] - centers_[body][static_cast<int>(a)];
            totals.impulse[a] += p[a];
        }
        for (std::size_t a = 0; a < 3; ++a)
            totals.angular_impulse[a] += arm[(a + 1) % 3] * p[(a + 2) % 3] - arm[(a + 2) % 3] * p[(a + 1) % 3];
    }

    /// Impulses I_k on n bodies lumped need not add up to zero. As forces of pairs they are F_kl = (I_k − I_l)/n, equal
    /// and opposite, of which each body gets I_k less the mean of what is wrong; or, against a rigid body, I_k as it
    /// is.
    void add_lumped(const ContactGroup<D>& group, Range points) {
        const std::int32_t n = points.last - points.first;
        const auto impulse = [&](std::int32_t i) {
            const ContactPoint<D>& point = state_.contact.points[points.first + i];
            return Vec<D>(point.impulse + point.extra_impulse);
        };
        const auto body = [&](std::int32_t i) { return state_.contact.points[points.first + i].body_a; };
        const std::int32_t rigid = group.rigid_slot >= 0 ? state_.fields.field[group.rigid_slot] : -1;
        for (std::int32_t k = 0; k < n; ++k) {
            if (rigid >= 0) {
                give(group, body(k), rigid, impulse(k));
                continue;
            }
            for (std::int32_t l = k + 1; l < n; ++l) give(group, body(k), body(l), (impulse(k) - impulse(l)) / n);
        }
    }

    void add_work(const ContactGroup<D>& group, const ContactPoint<D>& point) {
        state_.ledger.interface_energy += point.interface_energy;
        if (point.impulse.isZero(0) && point.interface_energy == 0) return;
        PairTotals& totals = pair(point.body_a, point.body_b);
        totals.interface_energy += point.interface_energy;
        if (!point.impulse.isZero(0)) totals.area += (point.slot_b < 0 && !point.rigid_b ? 0.5 : 1) * point.area;
        // At lumped points each body's own work is counted, so that the sum over the points is that of all bodies.
        const bool lumped = point.slot_b < 0;
        const Vec<D> a = mean_velocity(point.slot_a);
        Vec<D> relative = a;
        if (!lumped) relative -= mean_velocity(point.slot_b);
        if (lumped && point.rigid_b) relative -= mean_velocity(group.rigid_slot);
        const Vec<D> along = point.impulse - point.impulse.dot(point.normal) * point.normal;
        const double work = point.impulse.dot(relative);
        const double friction =
            is_interface(state_.contact.laws.between(point.body_a, point.body_b)) ? 0 : along.dot(relative);
        totals.work += work;
        totals.friction_work += friction;
        state_.ledger.contact_work += work;
        state_.ledger.friction_work += friction;
        // What a rigid body does to the others is work from outside.
        if (point.rigid_b) state_.ledger.external_work += point.impulse.dot(a - relative);
        if (point.rigid_a) state_.ledger.external_work -= point.impulse.dot(a);
    }

    State<D>& state_;
    std::map<std::pair<std::int32_t, std::int32_t>, PairTotals>::iterator last_;
    std::vector<Vec<3>> centers_; ///< of rigid bodies
};

} // namespace

template <int D>
void find_areas_and_displacements(State<D>& state) {
    if (!state.effects.areas && !state.wants_areas) return;
    Contact<D>& contact = state.contact;
    const auto n = static_cast<std::ptrdiff_t>(contact.groups.size());
#pragma omp parallel for schedule(static)
    for (std::ptrdiff_t g = 0; g < n; ++g) {
        const ContactGroup<D>& group = contact.groups[g];
        const auto find = [&](ContactPoint<D>& point) {
            const std::vector<Pack>& gradient = contact.volume_gradient;
            point.area =
                contact_area<D>(vector_of<D>(gradient[point.slot_a]),
                                vector_of<D>(sum_of_others(state.contact, group, point, gradient)), point.normal);
            if (!state.effects.interfaces) return;
            const auto displacement = [&](const Pack& moment, const Pack& mass) {
                return vector_of<D>(moment / mass[0]);
            };
            const std::vector<Pack>& mass = state.nodes.momentum;
            point.discontinuity = displacement(sum_of_others(state.contact, group, point, contact.mass_displacement),
                                               sum_of_others(state.contact, group, point, mass)) -
                                  displacement(contact.mass_displacement[point.slot_a], mass[point.slot_a]);
        };
        for_each_point(contact, group, find);
    }
}

template <int D>
void settle_contact(State<D>& state) {
    state.ledger.interface_energy = 0;
    for (auto& [bodies, totals] : state.pair_totals) totals.interface_energy = totals.area = 0;
    Settlement<D> settlement(state);
    for (const ContactGroup<D>& group : state.contact.groups) settlement.add(group);
}

template void find_areas_and_displacements<2>(State<2>&);
template void find_areas_and_displacements<3>(State<3>&);
template void settle_contact<2>(State<2>&);
template void settle_contact<3>(State<3>&);

} // namespace abut
