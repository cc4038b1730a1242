#include "contact/inspect.h"

#include "contact/other_search.h"
#include "contact/separation/particle_edges.h"

#include <algorithm>
#include <map>
#include <set>

namespace abut {

namespace {

/// Where both sides of a point end along a normal.
template <int D>
Edges edges_of(const State<D>& state, const Vec<D>& node, const ContactPoint<D>& point, CloudParticles cloud,
               const Vec<D>& normal) {
    const Particles<D>& particles = state.particles;
    Edges edges;
    for (const std::int32_t p : cloud)
        if (takes_part(point, particles.body[p]))
            edges.add(particles.body[p] == point.body_a, (particles.position[p] - node).dot(normal),
                      edge_distance<D>(particles.deformation_gradient[p], particles.half_size[p], normal), p);
    return edges;
}

template <int D>
std::vector<ParticleSeen<D>> cloud_seen(const State<D>& state, const Vec<D>& node, const ContactPoint<D>& point,
                                        CloudParticles cloud, const PlaneSeen<D>& plane) {
    const Particles<D>& particles = state.particles;
    const double fine = 1e-9 * state.grid.length();
    const bool has_plane = !plane.normal.isZero(0);
    std::vector<ParticleSeen<D>> seen;
    for (const std::int32_t p : cloud) {
        if (!takes_part(point, particles.body[p])) continue;
        ParticleSeen<D>& particle = seen.emplace_back();
        particle.id = particles.id[p];
        particle.body = particles.body[p];
        particle.position = particles.position[p];
        particle.half_size = particles.half_size[p];
        particle.deformation_gradient = particles.deformation_gradient[p];
        particle.distance = particle.edge_distance = std::numeric_limits<double>::quiet_NaN();
        if (!has_plane) continue;
        const double along = (particles.position[p] - node).dot(plane.normal);
        const double R = edge_distance<D>(particles.deformation_gradient[p], particles.half_size[p], plane.normal);
        particle.distance = along - plane.place();
        particle.edge_distance = R;
        particle.support =
            particle.body == point.body_a ? along + R >= plane.end_a - fine : along - R <= plane.end_b + fine;
    }
    return seen;
}

/// All points of a search by one normal method: as the normals were found, and with each separation.
template <int D>
struct Found {
    std::vector<ContactPoint<D>> fitted;
    std::vector<ContactPoint<D>> own; ///< with the scene's separation
    std::array<std::vector<ContactPoint<D>>, inspected_separations.size()> with;
};

template <int D>
Found<D> find_all(State<D>& state, OtherSearch<D>& search, NormalMethod method, const std::set<Index<D>>& wanted) {
    search.find(method, [&](const Index<D>& node) { return wanted.count(node) > 0; });
    Found<D> found;
    found.fitted = state.contact.points;
    const auto with = [&](SeparationMethod separation) {
        search.choose(method, separation);
        state.contact.points = found.fitted;
        find_separations(state);
        return state.contact.points;
    };
    for (std::size_t s = 0; s < found.with.size(); ++s) found.with[s] = with(inspected_separations[s]);
    found.own = with(search.spec().separation);
    return found;
}

template <int D>
PlaneSeen<D> plane_seen(const State<D>& state, const Vec<D>& node, const ContactPoint<D>& target, CloudParticles cloud,
                        const Found<D>& found, const Match& match) {
    constexpr double missing = std::numeric_limits<double>::quiet_NaN();
    PlaneSeen<D> plane;
    plane.end_a = plane.end_b = missing;
    plane.separation.fill(std::numeric_limits<double>::infinity());
    if (match.point < 0) return plane;
    const double sign = match.swapped ? -1 : 1;
    plane.normal = sign * found.own[match.point].normal;
    plane.fitted = sign * found.fitted[match.point].normal;
    plane.iterations = found.fitted[match.point].iterations;
    for (std::size_t s = 0; s < plane.separation.size(); ++s)
        plane.separation[s] = found.with[s][match.point].separation;
    if (plane.normal.isZero(0)) return plane;
    const Edges edges = edges_of(state, node, target, cloud, plane.normal);
    if (edges.last_a >= 0 && edges.first_b >= 0) {
        plane.end_a = edges.a;
        plane.end_b = edges.b;
    }
    return plane;
}

} // namespace

template <int D>
const PlaneSeen<D>& PointSeen<D>::chosen() const {
    return *std::find_if(planes.begin(), planes.end(), [](const PlaneSeen<D>& plane) { return plane.chosen; });
}

template <int D>
std::vector<NodeSeen<D>> inspect_contact(State<D>& state, const std::vector<Index<D>>& nodes) {
    std::vector<NodeSeen<D>> seen;
    std::set<Index<D>> wanted;
    for (const Index<D>& node : nodes) {
        const Index<D> in_grid = grid_node<D>(node);
        seen.push_back({node, state.grid.node_position(in_grid), {}});
        wanted.insert(in_grid);
    }
    if (nodes.empty()) return seen;
    OtherSearch<D> search(state);
    std::map<Index<D>, const ContactGroup<D>*> targets; // as the scene's own search has them
    for (const ContactGroup<D>& group : search.contact().groups)
        if (wanted.count(group.node) > 0) targets[group.node] = &group;

    std::map<Index<D>, std::size_t> place_of; // among the groups that are kept, the same for all methods
    const auto target_points = [&](const ContactGroup<D>& target) {
        const auto begin = search.contact().points.begin();
        return std::vector<ContactPoint<D>>(begin + target.first_point, begin + target.last_lumped);
    };
    for (const NormalMethod method : all_normals) {
        if (!search.applies(method)) continue;
        const Found<D> found = find_all<D>(state, search, method, wanted);
        for (std::size_t g = 0; g < state.contact.groups.size(); ++g) place_of[state.contact.groups[g].node] = g;
        for (NodeSeen<D>& node : seen) {
            const auto target = targets.find(grid_node<D>(node.node));
            if (target == targets.end()) continue;
            const std::size_t g = place_of.at(target->first);
            const std::vector<ContactPoint<D>> points = target_points(*target->second);
            node.points.resize(points.size());
            for (std::size_t i = 0; i < points.size(); ++i) {
                const Match same = match(state.contact, state.contact.groups[g], points[i]);
                PlaneSeen<D> plane =
                    plane_seen(state, node.position, points[i], particles_of_group(state.contact, g), found, same);
                plane.method = method;
                plane.chosen = method == search.spec().normal;
                node.points[i].planes.push_back(plane);
            }
        }
    }
    // The clouds, which all methods share, are still there.
    for (NodeSeen<D>& node : seen) {
        const auto target = targets.find(grid_node<D>(node.node));
        if (target == targets.end()) continue;
        const CloudParticles cloud = particles_of_group(state.contact, place_of.at(target->first));
        const std::vector<ContactPoint<D>> points = target_points(*target->second);
        for (std::size_t i = 0; i < points.size(); ++i) {
            PointSeen<D>& point = node.points[i];
            point.body_a = points[i].body_a;
            point.body_b = points[i].body_b;
            point.lumped = points[i].slot_b < 0;
            const Vec<D> own = point.chosen().normal;
            for (PlaneSeen<D>& plane : point.planes) plane.angle = angle_between<D>(plane.normal, own);
            point.cloud = cloud_seen(state, node.position, points[i], cloud, point.chosen());
        }
    }
    return seen;
}

template struct PointSeen<2>;
template struct PointSeen<3>;
template std::vector<NodeSeen<2>> inspect_contact<2>(State<2>&, const std::vector<Index<2>>&);
template std::vector<NodeSeen<3>> inspect_contact<3>(State<3>&, const std::vector<Index<3>>&);

} // namespace abut
