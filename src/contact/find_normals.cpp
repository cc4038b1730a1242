#include "contact/find_contacts.h"
#include "contact/group_view.h"
#include "contact/normal/average_gradient.h"
#include "contact/normal/irls_regression.h"
#include "contact/normal/linear_regression.h"
#include "contact/normal/logistic_regression.h"
#include "contact/normal/maximum_gradient.h"
#include "contact/normal/maximum_volume.h"
#include "contact/normal/own_gradient.h"
#include "contact/normal/specified.h"

namespace abut {

namespace {

/// The group's particles of a point, body a (class -1) against body b or all the rest (class +1), positions in cells
/// from the node.
template <int D>
void classify(const State<D>& state, const ContactGroup<D>& group, std::ptrdiff_t g, const ContactPoint<D>& point,
              Cloud<D>& cloud) {
    const Particles<D>& particles = state.particles;
    const Vec<D> node = state.grid.node_position(group.node);
    const double inverse_length = 1 / state.grid.length();
    cloud.clear();
    double squares = 0;
    for (const std::int32_t p : particles_of_group(state.contact, g)) {
        if (!takes_part(point, particles.body[p])) continue;
        const Vec<D> x = (particles.position[p] - node) * inverse_length;
        squares += particles.half_size[p].squaredNorm();
        cloud.add(x, particles.body[p] == point.body_a ? -1.0 : 1.0);
    }
    // A uniform domain of half edge r has the variance r²/3.
    cloud.spread = cloud.size > 0 ? squares * inverse_length * inverse_length / (3 * D * cloud.size) : 0;
}

template <int D>
Vec<D> by_gradients(const State<D>& state, const ContactGroup<D>& group, const ContactPoint<D>& point) {
    const std::vector<Pack>& gradient = state.contact.volume_gradient;
    const Pack a = gradient[point.slot_a];
    const Pack b = sum_of_others(state.contact, group, point, gradient);
    switch (state.scene.contact->normal) {
    case NormalMethod::maximum_gradient:
        return maximum_gradient<D>(a, b);
    case NormalMethod::maximum_volume:
        return maximum_volume<D>(a, b);
    case NormalMethod::own_gradient:
        return own_gradient<D>(a);
    default:
        return average_gradient<D>(a, b);
    }
}

/// The outward normal of a rigid body, which doesn't deform and may be the better known (notes 3.5): from its volume
/// gradient g, where |g| times the bias is at least as large as the other body's; else zero.
template <int D>
Vec<D> by_rigid_bias(const State<D>& state, const ContactGroup<D>& group, const ContactPoint<D>& point) {
    const std::vector<Pack>& gradient = state.contact.volume_gradient;
    Vec<D> own = vector_of<D>(gradient[point.slot_a]);
    Vec<D> other = vector_of<D>(sum_of_others(state.contact, group, point, gradient));
    if (point.rigid_b) std::swap(own, other);
    if (own.isZero(0) || own.norm() * state.scene.contact->rigid_bias < other.norm()) return Vec<D>::Zero();
    return own.normalized() * (point.rigid_b ? -1 : 1);
}

template <int D>
Regression<D> by_regression(NormalMethod method, const Cloud<D>& cloud) {
    switch (method) {
    case NormalMethod::linear_regression:
        return linear_regression(cloud);
    case NormalMethod::irls_regression:
        return irls_regression(cloud);
    default:
        return logistic_regression(cloud);
    }
}

template <int D>
void find_normal(const State<D>& state, const ContactGroup<D>& group, std::ptrdiff_t g, ContactPoint<D>& point,
                 Cloud<D>& cloud) {
    const ContactSpec& spec = *state.scene.contact;
    if ((point.rigid_a || point.rigid_b) && spec.rigid_bias > 0) {
        point.normal = by_rigid_bias(state, group, point);
        if (!point.normal.isZero(0)) return;
    }
    if (state.effects.regression) {
        classify(state, group, g, point, cloud);
        const Regression<D> regression = by_regression(spec.normal, cloud);
        point.cloud_size = cloud.size;
        point.iterations = regression.iterations;
        if (regression.found) point.normal = regression.normal;
    } else if (spec.normal == NormalMethod::specified) {
        point.normal = specified<D>(to_vec<D>(spec.direction), point.body_a, point.body_b);
        // Into rigid bodies, whatever the order (notes 3.3).
        if (point.rigid_a || point.rigid_b)
            point.normal = to_vec<D>(spec.direction).normalized() * (point.rigid_b ? 1 : -1);
    } else {
        point.normal = by_gradients(state, group, point);
    }
}

} // namespace

template <int D>
void find_normals(State<D>& state) {
    Contact<D>& contact = state.contact;
    const auto n = static_cast<std::ptrdiff_t>(contact.groups.size());
#pragma omp parallel
    {
        Cloud<D> cloud;
#pragma omp for schedule(dynamic, 64)
        for (std::ptrdiff_t g = 0; g < n; ++g)
            for_each_point(contact, contact.groups[g],
                           [&](ContactPoint<D>& point) { find_normal(state, contact.groups[g], g, point, cloud); });
    }
}

template void find_normals<2>(State<2>&);
template void find_normals<3>(State<3>&);

} // namespace abut
