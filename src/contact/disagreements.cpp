#include "contact/inspect.h"

#include "contact/other_search.h"

#include <algorithm>

namespace abut {

namespace {

/// For each of the scene's points in use, its normals by all methods that have a say.
template <int D>
std::vector<std::vector<Vec<D>>> normals_by_method(State<D>& state, OtherSearch<D>& search) {
    const Contact<D>& own = search.contact();
    std::vector<std::vector<Vec<D>>> normals(own.points.size());
    for (const NormalMethod method : all_normals) {
        if (!search.applies(method)) continue;
        if (method == NormalMethod::own_gradient && search.spec().normal != method) continue;
        search.find(method, [](const Index<D>&) { return true; });
        for (std::size_t g = 0; g < own.groups.size(); ++g) {
            const Range points = points_in_use(own.groups[g]);
            for (std::int32_t i = points.first; i < points.last; ++i) {
                const Match same = match(state.contact, state.contact.groups[g], own.points[i]);
                if (same.point < 0) continue;
                const Vec<D>& normal = state.contact.points[same.point].normal;
                if (!normal.isZero(0)) normals[i].push_back(same.swapped ? Vec<D>(-normal) : normal);
            }
        }
    }
    return normals;
}

template <int D>
double largest_angle(const std::vector<Vec<D>>& normals) {
    double largest = 0;
    for (std::size_t i = 0; i < normals.size(); ++i)
        for (std::size_t j = i + 1; j < normals.size(); ++j)
            largest = std::max(largest, angle_between<D>(normals[i], normals[j]));
    return largest;
}

} // namespace

template <int D>
std::vector<Disagreement<D>> nodes_in_disagreement(State<D>& state, double angle) {
    OtherSearch<D> search(state);
    const std::vector<std::vector<Vec<D>>> normals = normals_by_method(state, search);
    const Contact<D>& own = search.contact();
    const double reach = disagreement_reach * state.grid.length();
    std::vector<Disagreement<D>> found;
    for (const ContactGroup<D>& group : own.groups) {
        Disagreement<D> worst;
        const Range points = points_in_use(group);
        for (std::int32_t i = points.first; i < points.last; ++i) {
            const ContactPoint<D>& point = own.points[i];
            if (!(point.separation < reach)) continue;
            const double here = largest_angle(normals[i]);
            if (!(here > angle && here > worst.angle)) continue;
            worst = {scene_node<D>(group.node),
                     state.grid.node_position(group.node),
                     point.body_a,
                     point.body_b,
                     here,
                     point.separation,
                     point.cloud_size};
        }
        if (worst.body_a >= 0) found.push_back(worst);
    }
    std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.angle > b.angle; });
    return found;
}

template <int D>
std::optional<Index<D>> nearest_contact_node(const State<D>& state, const Vec<D>& place) {
    std::optional<Index<D>> nearest;
    double least = 0;
    for (const ContactGroup<D>& group : state.contact.groups) {
        const double distance = (state.grid.node_position(group.node) - place).squaredNorm();
        if (nearest && !(distance < least)) continue;
        nearest = scene_node<D>(group.node);
        least = distance;
    }
    return nearest;
}

template std::vector<Disagreement<2>> nodes_in_disagreement<2>(State<2>&, double);
template std::vector<Disagreement<3>> nodes_in_disagreement<3>(State<3>&, double);
template std::optional<Index<2>> nearest_contact_node<2>(const State<2>&, const Vec<2>&);
template std::optional<Index<3>> nearest_contact_node<3>(const State<3>&, const Vec<3>&);

} // namespace abut
