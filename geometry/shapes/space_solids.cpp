// Solids in space that closed forms describe: planes and quadrics, cut by lines along z.
#include "geometry/shapes/round_solids.h"
#include "scene/turn3.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace abut {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

double dot(const Vector& a, const Vector& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// Where a + b t + c t² ≤ 0. The roots lose no digits where b² ≫ ac.
Spans below_zero(double a, double b, double c) {
    if (c == 0) {
        if (b == 0) return a <= 0 ? Spans{{-infinity, infinity}} : Spans{};
        const double root = -a / b;
        return b > 0 ? Spans{{-infinity, root}} : Spans{{root, infinity}};
    }
    const double discriminant = b * b - 4 * a * c;
    if (!(discriminant > 0)) return c > 0 ? Spans{} : Spans{{-infinity, infinity}};
    const double q = -0.5 * (b + std::copysign(std::sqrt(discriminant), b));
    const double first = q / c;
    const double second = q == 0 ? -first : a / q;
    const auto [from, to] = std::minmax(first, second);
    if (c > 0) return {{from, to}};
    return {{-infinity, from}, {to, infinity}};
}

/// Where lower ≤ a + b t ≤ upper.
Spans between(double a, double b, double lower, double upper) {
    return intersection(below_zero(a - upper, b, 0), below_zero(lower - a, -b, 0));
}

void add_breaks(Solid& solid) {
    for (std::size_t axis = 0; axis < 2; ++axis) solid.breaks[axis] = {solid.lower[axis], solid.upper[axis]};
}

/// What lies between two ends on an axis and within a radius that changes along it in a straight way.
Solid frustum(const Vector& from, const Vector& to, double radius, double top_radius) {
    Vector axis{to[0] - from[0], to[1] - from[1], to[2] - from[2]};
    const double length = std::sqrt(dot(axis, axis));
    for (double& component : axis) component /= length;
    Solid solid;
    for (std::size_t a = 0; a < 3; ++a) {
        // A disk across the axis reaches by r √(1 − n²) along a coordinate.
        const double reach = std::sqrt(std::max(0.0, 1 - axis[a] * axis[a]));
        solid.lower[a] = std::min(from[a] - radius * reach, to[a] - top_radius * reach);
        solid.upper[a] = std::max(from[a] + radius * reach, to[a] + top_radius * reach);
    }
    for (std::size_t a = 0; a < 2; ++a) { // both rims
        const double reach = std::sqrt(std::max(0.0, 1 - axis[a] * axis[a]));
        solid.breaks[a] = {from[a] - radius * reach, from[a] + radius * reach, to[a] - top_radius * reach,
                           to[a] + top_radius * reach};
        std::sort(solid.breaks[a].begin(), solid.breaks[a].end());
        solid.breaks[a].erase(std::unique(solid.breaks[a].begin(), solid.breaks[a].end()), solid.breaks[a].end());
    }
    const double slope = (top_radius - radius) / length;
    solid.spans = [=](double x, double y) -> Spans {
        // A point of the line is from + d + t z; it is h = d·n + t n_z along the axis.
        const Vector d{x - from[0], y - from[1], -from[2]};
        const double h = dot(d, axis);
        const double n = axis[2];
        const Spans along = between(h, n, 0, length);
        if (along.empty()) return {};
        // |d + t z|² − h² ≤ (r + slope h)²; where the radius would be negative lies the other nappe, beyond the tip.
        const double r = radius + slope * h;
        return intersection(along, below_zero(dot(d, d) - h * h - r * r, 2 * (d[2] - h * n - slope * n * r),
                                              1 - n * n - slope * slope * n * n));
    };
    return solid;
}

} // namespace

Solid space_solid(const Box& box) {
    Solid solid{box.lower, box.upper, {}, {}};
    solid.half_open = true;
    if (box.angle == 0) {
        add_breaks(solid);
        solid.spans = [box](double x, double y) -> Spans {
            if (!(x > box.lower[0] && x < box.upper[0] && y > box.lower[1] && y < box.upper[1])) return {};
            return {{box.lower[2], box.upper[2]}};
        };
        return solid;
    }
    const Rotation turn = rotation(box.axis, box.angle);
    const Vector middle{(box.lower[0] + box.upper[0]) / 2, (box.lower[1] + box.upper[1]) / 2,
                        (box.lower[2] + box.upper[2]) / 2};
    Vector half{};
    for (std::size_t a = 0; a < 3; ++a) half[a] = (box.upper[a] - box.lower[a]) / 2;
    for (std::size_t a = 0; a < 3; ++a) {
        double reach = 0;
        for (std::size_t b = 0; b < 3; ++b) reach += std::abs(turn[a][b]) * half[b];
        solid.lower[a] = middle[a] - reach;
        solid.upper[a] = middle[a] + reach;
    }
    // Corners and edges as seen along z: where the spans have kinks.
    for (std::size_t axis = 0; axis < 2; ++axis) {
        for (int corner = 0; corner < 8; ++corner) {
            double x = middle[axis];
            for (std::size_t b = 0; b < 3; ++b) x += ((corner >> b) & 1 ? 1 : -1) * turn[axis][b] * half[b];
            solid.breaks[axis].push_back(x);
        }
        std::sort(solid.breaks[axis].begin(), solid.breaks[axis].end());
    }
    solid.spans = [=](double x, double y) -> Spans {
        Spans spans{{-infinity, infinity}};
        for (std::size_t b = 0; b < 3 && !spans.empty(); ++b) { // the box's own axis b is column b of the rotation
            const double at = turn[0][b] * (x - middle[0]) + turn[1][b] * (y - middle[1]) - turn[2][b] * middle[2];
            spans = intersection(spans, between(at, turn[2][b], -half[b], half[b]));
        }
        return spans;
    };
    return solid;
}

Solid space_solid(const Ball& ball) {
    return space_solid(Ellipsoid{ball.center, {ball.radius, ball.radius, ball.radius}, {0, 0, 1}, 0});
}

Solid space_solid(const Ellipsoid& ellipsoid) {
    const Rotation turn = rotation(ellipsoid.axis, ellipsoid.angle);
    const Vector center = ellipsoid.center;
    const Vector axes = ellipsoid.semi_axes;
    Solid solid;
    for (std::size_t a = 0; a < 3; ++a) {
        double square = 0;
        for (std::size_t b = 0; b < 3; ++b) square += turn[a][b] * turn[a][b] * axes[b] * axes[b];
        solid.lower[a] = center[a] - std::sqrt(square);
        solid.upper[a] = center[a] + std::sqrt(square);
    }
    add_breaks(solid);
    solid.spans = [=](double x, double y) -> Spans {
        // |diag(1/axes) Rᵀ (r + t z)|² ≤ 1 with t from the centre's height.
        double a = -1;
        double b = 0;
        double c = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            const double u = (turn[0][k] * (x - center[0]) + turn[1][k] * (y - center[1])) / axes[k];
            const double w = turn[2][k] / axes[k];
            a += u * u;
            b += 2 * u * w;
            c += w * w;
        }
        Spans spans = below_zero(a, b, c);
        for (Span& span : spans) {
            span.from += center[2];
            span.to += center[2];
        }
        return spans;
    };
    return solid;
}

Solid space_solid(const Cylinder& cylinder) {
    return frustum(cylinder.from, cylinder.to, cylinder.radius, cylinder.radius);
}

Solid space_solid(const Cone& cone) {
    return frustum(cone.from, cone.to, cone.radius, cone.top_radius);
}

} // namespace abut
