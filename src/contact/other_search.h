#pragma once
/// \file other_search.h
/// The search for contacts run again by other methods than the scene's, on the same state. What inspect.h needs.

#include "contact/find_contacts.h"
#include "contact/group_view.h"

#include <array>
#include <utility>

namespace abut {

inline constexpr std::array all_normals{NormalMethod::logistic_regression, NormalMethod::linear_regression,
                                        NormalMethod::irls_regression,     NormalMethod::average_gradient,
                                        NormalMethod::maximum_gradient,    NormalMethod::maximum_volume,
                                        NormalMethod::own_gradient,        NormalMethod::specified};

/// Numbers of a node from the lower corner of the scene's box, and from that of the grid with its margin.
template <int D>
Index<D> scene_node(Index<D> node) {
    for (int& i : node) i -= grid_margin;
    return node;
}
template <int D>
Index<D> grid_node(Index<D> node) {
    for (int& i : node) i += grid_margin;
    return node;
}

/// Searches contacts of a state in other ways than its scene's, and leaves all as it was.
template <int D>
class OtherSearch {
public:
    explicit OtherSearch(State<D>& state)
        : state_(state), contact_(state.contact), spec_(*state.scene.contact), effects_(state.effects) {}
    ~OtherSearch() {
        state_.contact = std::move(contact_);
        *state_.scene.contact = std::move(spec_);
        state_.effects = effects_;
    }
    OtherSearch(const OtherSearch&) = delete;
    OtherSearch& operator=(const OtherSearch&) = delete;

    const Contact<D>& contact() const { return contact_; } ///< as it was found
    const ContactSpec& spec() const { return spec_; }
    bool applies(NormalMethod method) const { return method != NormalMethod::specified || method == spec_.normal; }

    void choose(NormalMethod normal, SeparationMethod separation) {
        state_.scene.contact->normal = normal;
        state_.scene.contact->separation = separation;
        state_.effects = effects_of(state_.scene);
        // The clouds and fields of all methods, so that they are made only once.
        state_.effects.clouds = state_.effects.gradients = state_.effects.volumes = true;
        state_.effects.positions = state_.effects.displacements = true;
    }
    /// Groups and normals at the nodes for which wanted(node) is true; whatever the method, the groups are the same.
    template <class Wanted>
    void find(NormalMethod normal, Wanted&& wanted) {
        choose(normal, spec_.separation);
        find_groups(state_);
        keep_groups(wanted);
        if (!prepared_) {
            gather_clouds(state_);
            extrapolate_contact_fields(state_);
            prepared_ = true;
        }
        find_normals(state_);
    }

private:
    /// Drops other groups with their points.
    template <class Wanted>
    void keep_groups(Wanted&& wanted) {
        Contact<D>& contact = state_.contact;
        std::erase_if(contact.groups, [&](const ContactGroup<D>& group) { return !wanted(group.node); });
        std::vector<ContactPoint<D>> points;
        for (ContactGroup<D>& group : contact.groups) {
            const std::int32_t moved = static_cast<std::int32_t>(points.size()) - group.first_point;
            points.insert(points.end(), contact.points.begin() + group.first_point,
                          contact.points.begin() + group.last_lumped);
            for (std::int32_t* place : {&group.first_point, &group.last_point, &group.first_lumped, &group.last_lumped})
                *place += moved;
        }
        contact.points = std::move(points);
    }

    State<D>& state_;
    Contact<D> contact_;
    ContactSpec spec_;
    Effects effects_;
    bool prepared_ = false;
};

/// The number of a point in `contact` that is for the same bodies as `target`, and whether a and b have changed places.
/// Methods differ in whether they have points of pairs or of bodies against all others.
struct Match {
    std::int32_t point = -1;
    bool swapped = false;
};
template <int D>
Match match(const Contact<D>& contact, const ContactGroup<D>& group, const ContactPoint<D>& target) {
    Match best;
    int best_score = 0;
    for (std::int32_t i = group.first_point; i < group.last_lumped; ++i) {
        const ContactPoint<D>& point = contact.points[i];
        const bool lumped = point.slot_b < 0;
        const bool same = point.body_a == target.body_a && (lumped || point.body_b == target.body_b);
        const bool swapped = point.body_a == target.body_b && (lumped || point.body_b == target.body_a);
        const int score = (same ? 2 : swapped ? 1 : 0) * (lumped == (target.slot_b < 0) ? 4 : 1);
        if (score > best_score) {
            best = {i, !same};
            best_score = score;
        }
    }
    return best;
}

} // namespace abut
