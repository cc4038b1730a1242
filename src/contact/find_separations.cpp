#include "contact/find_contacts.h"
#include "contact/group_view.h"
#include "contact/separation/critical_position.h"
#include "contact/separation/displacement.h"
#include "contact/separation/fitted_position.h"
#include "contact/separation/particle_edges.h"
#include "contact/separation/widest_gap.h"

#include <algorithm>
#include <limits>

namespace abut {

namespace {

/// The gap between two edges along n, and its derivative: the distance of the two places where the edges are.
template <int D>
Gap<D> gap_of(const Particles<D>& particles, const Edges& edges, const Vec<D>& n) {
    const auto place = [&](int p, const Vec<D>& outward) {
        return edge_point<D>(particles.position[p], particles.deformation_gradient[p], particles.half_size[p], outward);
    };
    return {edges.b - edges.a, place(edges.first_b, -n) - place(edges.last_a, n)};
}

/// A particle of a point's cloud and where it ends towards the other body along the normal, from the node [m].
struct EdgeParticle {
    std::int32_t p;
    bool side_a;
    double end;
};
using EdgeParticles = std::vector<EdgeParticle>;

/// Keeps the particles that may end nearest to the other body along a vector that is turned by at most a tangent from
/// the normal. Turned by a tangent t, a particle's end moves by t |x| at most and its own extent changes by t |B|, B
/// the ellipsoid's half axes.
template <int D>
void keep_candidates(const Particles<D>& particles, const Edges& edges, double turn, EdgeParticles& all) {
    const auto extent = [&](std::int32_t p) {
        return particles.deformation_gradient[p].norm() * particles.half_size[p].maxCoeff();
    };
    const double extent_a = extent(edges.last_a);
    const double extent_b = extent(edges.first_b);
    std::erase_if(all, [&](const EdgeParticle& q) {
        const std::int32_t nearest = q.side_a ? edges.last_a : edges.first_b;
        const double reach = turn * ((particles.position[q.p] - particles.position[nearest]).norm() + extent(q.p) +
                                     (q.side_a ? extent_a : extent_b));
        return q.side_a ? q.end < edges.a - reach : q.end > edges.b + reach;
    });
}

/// The gap of particles along a vector of any length (contact paper Eq. 22-24), times that length.
template <int D>
Gap<D> gap_along(const Particles<D>& particles, const Vec<D>& node, const EdgeParticles& candidates, const Vec<D>& n) {
    Edges edges;
    for (const EdgeParticle& q : candidates)
        edges.add(q.side_a, (particles.position[q.p] - node).dot(n),
                  edge_distance<D>(particles.deformation_gradient[q.p], particles.half_size[q.p], n), q.p);
    return gap_of(particles, edges, n);
}

/// How body a, or b, moves to a rigid body at the node when it moves with it at their interface. A rigid body gives its
/// velocity to whatever touches it, and nodes inside the other body, half a cell from the interface, would become rigid
/// too: the layer there would not deform. So the velocity holds at the interface, and changes from there by the other
/// body's own gradient along n, fitted to its particles' velocities (as for walls, FMPM paper Eq. 4): with d the
/// distance along n from the interface and u the normal velocity to the rigid body there, u = g d, g = Σ u d / Σ d².
/// \param edge of the rigid body, along n from the node [m]
/// \return (v_b − v_a)·n at the node [m/s]
template <int D>
double rigid_edge(const State<D>& state, const ContactGroup<D>& group, std::ptrdiff_t g, const ContactPoint<D>& point,
                  double edge) {
    const Particles<D>& particles = state.particles;
    const RigidPose& pose = state.poses[point.rigid_a ? point.body_a : point.body_b];
    const std::int32_t other = point.rigid_a ? point.body_b : point.body_a;
    const Vec<D> node = state.grid.node_position(group.node);
    double products = 0;
    double squares = 0;
    for (const std::int32_t p : particles_of_group(state.contact, g)) {
        if (particles.body[p] != other) continue;
        const double d = (particles.position[p] - node).dot(point.normal) - edge;
        const Vec<D> rigid = to_vec<D>(pose.velocity_at(to_array<D>(particles.position[p])));
        products += (particles.velocity[p] - rigid).dot(point.normal) * d;
        squares += d * d;
    }
    const double gradient = squares > 0 ? products / squares : 0;
    return point.rigid_a ? -gradient * edge : gradient * edge;
}

/// Separation of the edges of the particles nearest to the other class (contact paper Eq. 22-24), and the overlap close
/// to the node. The cloud reaches up to two cells to the sides; where the interface is curved its outermost particles
/// make the separation negative though nothing overlaps. The overlap therefore counts only particles whose centres lie
/// within half a cell of the line through the node along n, and what is left of the curvature, of the steps in a
/// body's edge and of the inscribed ellipses is covered by a tenth of a cell. Where one body has matter on both sides
/// of the other no plane parts them, and how far they reach past each other is no overlap: a particle in a hole of
/// another body would else be driven out of it, by energy from nowhere.
template <int D>
void by_edges(const State<D>& state, const ContactGroup<D>& group, std::ptrdiff_t g, ContactPoint<D>& point,
              EdgeParticles& cloud) {
    constexpr double half_width = 0.5; // [cells]
    constexpr double tolerance = 0.1;  // [cells]
    const Particles<D>& particles = state.particles;
    const double length = state.grid.length();
    const Vec<D> node = state.grid.node_position(group.node);
    Edges all;
    Edges near;
    double a_begins = std::numeric_limits<double>::infinity(); // of what is near, along n
    double b_ends = -a_begins;
    cloud.clear();
    for (const std::int32_t p : particles_of_group(state.contact, g)) {
        if (!takes_part(point, particles.body[p])) continue;
        const Vec<D> x = particles.position[p] - node;
        const double along = x.dot(point.normal);
        const double R = edge_distance<D>(particles.deformation_gradient[p], particles.half_size[p], point.normal);
        const bool side_a = particles.body[p] == point.body_a;
        all.add(side_a, along, R, p);
        cloud.push_back({p, side_a, side_a ? along + R : along - R});
        if ((x - along * point.normal).squaredNorm() < half_width * half_width * length * length) {
            near.add(side_a, along, R, p);
            if (side_a)
                a_begins = std::min(a_begins, along - R);
            else
                b_ends = std::max(b_ends, along + R);
        }
    }
    point.cloud_size = static_cast<std::int32_t>(cloud.size());
    point.separation = all.b - all.a;
    // A slightly tilted normal makes bodies touch early: look whether there is a gap along one close by.
    const double closest = -0.06 * length;
    const double farthest = 0.05 * length;
    if (closest < point.separation && point.separation < farthest) {
        // That is also the better normal, the one that logistic regression tends to: where the cloud has a column more
        // on one side, the regression's is tilted by half a degree, which brakes sliding by 1 % of the pressure.
        keep_candidates(particles, all, most_turned<D>, cloud);
        Vec<D>* const direction = state.effects.regression ? &point.normal : nullptr;
        const Vec<D> normal = point.normal;
        point.separation = widest_gap<D>(
            normal, gap_of(particles, all, normal), 1e-3 * length, 0.05 * length,
            [&](const Vec<D>& n) { return gap_along(particles, node, cloud, n); }, direction);
    }
    const bool surrounded = near.b <= a_begins || near.a >= b_ends;
    point.overlap = surrounded ? 0 : std::max(0.0, near.a - near.b - tolerance * length);
    const bool rigid = point.rigid_a || point.rigid_b;
    if (rigid && point.slot_b >= 0 && !is_interface(state.contact.laws.between(point.body_a, point.body_b)))
        point.at_node = rigid_edge(state, group, g, point, point.rigid_a ? all.a : all.b);
}

/// Mass of the other side of a point.
template <int D>
double mass_of_others(const State<D>& state, const ContactGroup<D>& group, const ContactPoint<D>& point) {
    return sum_of_others(state.contact, group, point, state.nodes.momentum)[0];
}

/// Separation from extrapolated positions (notes 3.48) [m].
template <int D>
double by_positions(const State<D>& state, const ContactGroup<D>& group, const ContactPoint<D>& point) {
    const std::vector<Pack>& mass_position = state.contact.mass_position;
    const Vec<D> node = state.grid.node_position(group.node) - state.grid.origin;
    const double inverse_length = 1 / state.grid.length();
    const auto apparent = [&](const Pack& moment, double mass) {
        return (vector_of<D>(moment) / mass - node).dot(point.normal) * inverse_length;
    };
    const double a = apparent(mass_position[point.slot_a], state.nodes.momentum[point.slot_a][0]);
    const double b =
        apparent(sum_of_others(state.contact, group, point, mass_position), mass_of_others(state, group, point));
    const ContactSpec& spec = *state.scene.contact;
    if (spec.separation == SeparationMethod::critical_position)
        return state.grid.length() * critical_position(a, b, spec.offset);
    switch (spec.fit) {
    case PositionFit::two_per_cell:
        return state.grid.length() * (two_per_cell(b) + two_per_cell(-a));
    case PositionFit::one_per_cell:
        return state.grid.length() * (one_per_cell(b) + one_per_cell(-a));
    case PositionFit::power_law:
        break;
    }
    return state.grid.length() * fitted_position(a, b, spec.exponent);
}

template <int D>
double by_displacements(const State<D>& state, const ContactGroup<D>& group, const ContactPoint<D>& point) {
    const std::vector<Pack>& moment = state.contact.mass_displacement;
    return displacement_separation<D>(moment[point.slot_a], state.nodes.momentum[point.slot_a][0],
                                      sum_of_others(state.contact, group, point, moment),
                                      mass_of_others(state, group, point), point.normal);
}

template <int D>
void find_separation(const State<D>& state, const ContactGroup<D>& group, std::ptrdiff_t g, ContactPoint<D>& point,
                     EdgeParticles& cloud) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    if (point.normal.isZero()) {
        point.separation = infinity; // no plane: no contact
        return;
    }
    switch (state.scene.contact->separation) {
    case SeparationMethod::particle_edges:
        by_edges(state, group, g, point, cloud);
        break;
    case SeparationMethod::critical_position:
    case SeparationMethod::fitted_position:
        point.separation = by_positions(state, group, point);
        break;
    case SeparationMethod::displacement:
        point.separation = by_displacements(state, group, point);
        break;
    case SeparationMethod::none:
        point.separation = -infinity;
        break;
    }
}

} // namespace

template <int D>
void find_separations(State<D>& state) {
    Contact<D>& contact = state.contact;
    const auto n = static_cast<std::ptrdiff_t>(contact.groups.size());
#pragma omp parallel
    {
        EdgeParticles cloud;
#pragma omp for schedule(dynamic, 64)
        for (std::ptrdiff_t g = 0; g < n; ++g)
            for_each_point(contact, contact.groups[g],
                           [&](ContactPoint<D>& point) { find_separation(state, contact.groups[g], g, point, cloud); });
    }
}

template void find_separations<2>(State<2>&);
template void find_separations<3>(State<3>&);

} // namespace abut
