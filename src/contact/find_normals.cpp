#include "contact/find_contacts.h"
#include "contact/normal/logistic_regression.h"
#include "contact/separation/separation.h"

#include <limits>

namespace abut {

namespace {

/// The group's particles of a point, body a (class -1) against body b or all the rest (class +1), positions in cells
/// from the node.
template <int D>
void classify(const State<D>& state, const ContactGroup<D>& group, std::ptrdiff_t g, const ContactPoint<D>& point,
              Cloud<D>& cloud) {
    const Contact<D>& contact = state.contact;
    const Particles<D>& particles = state.particles;
    const Vec<D> node = state.grid.node_position(group.node);
    const double inverse_length = 1 / state.grid.length();
    const std::int32_t* first = contact.cloud_particles.data() + g * contact.cloud_capacity;
    cloud.clear();
    double squares = 0;
    for (std::int32_t i = 0; i < contact.cloud_size[g]; ++i) {
        const std::int32_t p = first[i];
        if (point.slot_b >= 0 && particles.body[p] != point.body_a && particles.body[p] != point.body_b) continue;
        const Vec<D> x = (particles.position[p] - node) * inverse_length;
        squares += particles.half_size[p].squaredNorm();
        cloud.add(x, particles.body[p] == point.body_a ? -1.0 : 1.0, p);
    }
    // A uniform domain of half edge r has the variance r²/3.
    cloud.spread = cloud.size > 0 ? squares * inverse_length * inverse_length / (3 * D * cloud.size) : 0;
}

/// Where the particles of both sides of a point end along n.
struct Edges {
    double a = -std::numeric_limits<double>::infinity();
    double b = std::numeric_limits<double>::infinity();
    void add(bool side_a, double x, double R) {
        if (side_a)
            a = std::max(a, x + R);
        else
            b = std::min(b, x - R);
    }
};

/// Separation of the edges of the particles nearest to the other class (contact paper Eq. 22-24), and the overlap close
/// to the node. The cloud reaches up to two cells to the sides; where the interface is curved its outermost particles
/// make the separation negative though nothing overlaps. The overlap therefore counts only particles whose centres lie
/// within half a cell of the line through the node along n, and what is left of the curvature, of the steps in a
/// body's edge and of the inscribed ellipses is covered by a tenth of a cell.
template <int D>
void particle_edges(const State<D>& state, const ContactGroup<D>& group, const Cloud<D>& cloud,
                    ContactPoint<D>& point) {
    constexpr double half_width = 0.5; // [cells]
    constexpr double tolerance = 0.1;  // [cells]
    const double length = state.grid.length();
    const Vec<D> node = state.grid.node_position(group.node);
    Edges all;
    Edges near;
    for (const int p : cloud.particle) {
        const Vec<D> x = state.particles.position[p] - node;
        const double along = x.dot(point.normal);
        const double R =
            edge_distance<D>(state.particles.deformation_gradient[p], state.particles.half_size[p], point.normal);
        const bool side_a = state.particles.body[p] == point.body_a;
        all.add(side_a, along, R);
        if ((x - along * point.normal).squaredNorm() < half_width * half_width * length * length)
            near.add(side_a, along, R);
    }
    point.separation = all.b - all.a;
    point.overlap = std::max(0.0, near.a - near.b - tolerance * length);
}

/// Sum of a slot quantity over the other side of a point.
template <int D>
Pack sum_of_others(const State<D>& state, const ContactGroup<D>& group, const ContactPoint<D>& point,
                   const std::vector<Pack>& values) {
    if (point.slot_b >= 0) return values[point.slot_b];
    Pack sum{};
    for (std::int32_t i = group.first; i < group.last; ++i)
        if (state.contact.active[i] != point.slot_a) sum += values[state.contact.active[i]];
    return sum;
}

/// n = (g_a − g_b)/|g_a − g_b| (contact paper Eq. 13).
template <int D>
Vec<D> average_gradient(const State<D>& state, const ContactGroup<D>& group, const ContactPoint<D>& point) {
    const std::vector<Pack>& gradient = state.contact.volume_gradient;
    const Vec<D> g = vector_of<D>(gradient[point.slot_a] - sum_of_others(state, group, point, gradient));
    const double length = g.norm();
    return length > 0 ? Vec<D>(g / length) : Vec<D>::Zero();
}

/// Separation from extrapolated positions [m].
template <int D>
double grid_separation(const State<D>& state, const ContactGroup<D>& group, const ContactPoint<D>& point) {
    const std::vector<Pack>& mass_position = state.contact.mass_position;
    const Vec<D> node = state.grid.node_position(group.node) - state.grid.origin;
    const double inverse_length = 1 / state.grid.length();
    const auto apparent = [&](const Pack& moment, double mass) {
        return (vector_of<D>(moment) / mass - node).dot(point.normal) * inverse_length;
    };
    const double a = apparent(mass_position[point.slot_a], state.nodes.momentum[point.slot_a][0]);
    const double b = apparent(sum_of_others(state, group, point, mass_position),
                              sum_of_others(state, group, point, state.nodes.momentum)[0]);
    const ContactSpec& spec = *state.scene.contact;
    return state.grid.length() * (spec.separation == SeparationMethod::critical_position
                                      ? critical_position(a, b, spec.offset)
                                      : fitted_position(a, b, spec.exponent));
}

template <int D>
void solve_point(const State<D>& state, const ContactGroup<D>& group, std::ptrdiff_t g, ContactPoint<D>& point,
                 Cloud<D>& cloud) {
    const Effects& effects = state.effects;
    if (effects.clouds) {
        classify(state, group, g, point, cloud);
        point.cloud_size = cloud.size;
    }
    if (effects.regression) {
        const Regression<D> regression = logistic_regression(cloud);
        point.iterations = regression.iterations;
        if (regression.found) point.normal = regression.normal;
    } else {
        point.normal = average_gradient(state, group, point);
    }
    if (point.normal.isZero()) {
        point.separation = std::numeric_limits<double>::infinity(); // no plane: no contact
        return;
    }
    switch (state.scene.contact->separation) {
    case SeparationMethod::particle_edges:
        particle_edges(state, group, cloud, point);
        break;
    case SeparationMethod::critical_position:
    case SeparationMethod::fitted_position:
        point.separation = grid_separation(state, group, point);
        break;
    case SeparationMethod::none:
        point.separation = -std::numeric_limits<double>::infinity();
        break;
    }
}

} // namespace

template <int D>
void find_normals_and_separations(State<D>& state) {
    Contact<D>& contact = state.contact;
    const auto n = static_cast<std::ptrdiff_t>(contact.groups.size());
#pragma omp parallel
    {
        Cloud<D> cloud;
#pragma omp for schedule(dynamic, 64)
        for (std::ptrdiff_t g = 0; g < n; ++g) {
            const ContactGroup<D>& group = contact.groups[g];
            for (std::int32_t i = group.first_point; i < group.last_point; ++i)
                solve_point(state, group, g, contact.points[i], cloud);
        }
    }
}

template void find_normals_and_separations<2>(State<2>&);
template void find_normals_and_separations<3>(State<3>&);

} // namespace abut
