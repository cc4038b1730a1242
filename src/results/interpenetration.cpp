#include "results/interpenetration.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace abut {

namespace {

/// A convex polygon, counter-clockwise; clipping a quadrilateral by four lines leaves at most eight corners.
struct ConvexPolygon {
    int size = 0;
    Vec<2> corner[12];
    void add(const Vec<2>& x) { corner[size++] = x; }
};

double cross(const Vec<2>& a, const Vec<2>& b) {
    return a[0] * b[1] - a[1] * b[0];
}

double area(const ConvexPolygon& polygon) {
    double sum = 0;
    for (int i = 1; i + 1 < polygon.size; ++i)
        sum += cross(polygon.corner[i] - polygon.corner[0], polygon.corner[i + 1] - polygon.corner[0]);
    return 0.5 * sum;
}

ConvexPolygon domain_of(const Particles<2>& particles, std::size_t p) {
    const Vec<2>& x = particles.position[p];
    const Vec<2> r1 = particles.deformation_gradient[p].col(0) * particles.half_size[p][0];
    const Vec<2> r2 = particles.deformation_gradient[p].col(1) * particles.half_size[p][1];
    ConvexPolygon polygon;
    polygon.add(x - r1 - r2);
    polygon.add(x + r1 - r2);
    polygon.add(x + r1 + r2);
    polygon.add(x - r1 + r2);
    return polygon;
}

/// The part of a polygon left of the line from a to b (Sutherland and Hodgman).
ConvexPolygon clip(const ConvexPolygon& polygon, const Vec<2>& a, const Vec<2>& b) {
    ConvexPolygon result;
    for (int i = 0; i < polygon.size; ++i) {
        const Vec<2>& from = polygon.corner[i];
        const Vec<2>& to = polygon.corner[(i + 1) % polygon.size];
        const double side_from = cross(b - a, from - a);
        const double side_to = cross(b - a, to - a);
        if (side_from >= 0) result.add(from);
        if ((side_from > 0 && side_to < 0) || (side_from < 0 && side_to > 0))
            result.add(from + side_from / (side_from - side_to) * (to - from));
    }
    return result;
}

double common_area(const ConvexPolygon& p, const ConvexPolygon& q) {
    ConvexPolygon rest = p;
    for (int i = 0; i < 4 && rest.size > 2; ++i) rest = clip(rest, q.corner[i], q.corner[(i + 1) % 4]);
    return rest.size > 2 ? area(rest) : 0;
}

struct Box2 {
    Vec<2> lower, upper;
    bool meets(const Box2& other) const {
        return (lower.array() < other.upper.array()).all() && (other.lower.array() < upper.array()).all();
    }
};

Box2 box_of(const ConvexPolygon& polygon) {
    Box2 box{polygon.corner[0], polygon.corner[0]};
    for (int i = 1; i < polygon.size; ++i) {
        box.lower = box.lower.cwiseMin(polygon.corner[i]);
        box.upper = box.upper.cwiseMax(polygon.corner[i]);
    }
    return box;
}

} // namespace

Interpenetration interpenetration(const Particles<2>& particles) {
    Interpenetration result;
    const std::size_t n = particles.size();
    std::vector<ConvexPolygon> domains;
    std::vector<Box2> boxes;
    for (std::size_t p = 0; p < n; ++p) {
        domains.push_back(domain_of(particles, p));
        boxes.push_back(box_of(domains.back()));
        result.total += area(domains.back());
    }
    // Sweep along x: a domain is compared with those that begin before it ends.
    std::vector<std::size_t> order(n);
    for (std::size_t p = 0; p < n; ++p) order[p] = p;
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return boxes[a].lower[0] != boxes[b].lower[0] ? boxes[a].lower[0] < boxes[b].lower[0]
                                                      : particles.id[a] < particles.id[b];
    });
    for (std::size_t i = 0; i < n; ++i) {
        const std::size_t p = order[i];
        for (std::size_t j = i + 1; j < n && boxes[order[j]].lower[0] < boxes[p].upper[0]; ++j) {
            const std::size_t q = order[j];
            if (particles.body[p] != particles.body[q] && boxes[p].meets(boxes[q]))
                result.overlap += common_area(domains[p], domains[q]);
        }
    }
    return result;
}

} // namespace abut
