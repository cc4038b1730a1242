// Plane shapes that closed forms describe.
#include "geometry/shapes/outline.h"
#include "geometry/shapes/round_solids.h"
#include "scene/turn.h"

#include <algorithm>
#include <cmath>

namespace abut {

namespace {

/// The ellipse |A r| ≤ 1 about its centre, by M = (AᵀA)⁻¹ = R diag(a², b²) Rᵀ: its half extents are √M_xx and √M_yy,
/// and at x from the centre the line has y = M_xy/M_xx x ± √(det M/M_xx (1 − x²/M_xx)).
/// \param ab product of its semi-axes, √det M: the difference of the products would lose the digits of thin ellipses
Solid solid_of_ellipse(const Vector& center, double xx, double xy, double yy, double ab) {
    Solid solid;
    const double reach = std::sqrt(xx);
    const double height = std::sqrt(yy);
    solid.lower = {center[0] - reach, center[1] - height, 0};
    solid.upper = {center[0] + reach, center[1] + height, 0};
    solid.breaks[0] = {solid.lower[0], solid.upper[0]};
    const double slope = xy / xx;
    const double half = ab / reach;
    solid.spans = [=](double x, double) -> Spans {
        const double u = (x - center[0]) / reach;
        if (!(std::abs(u) < 1)) return {};
        const double middle = center[1] + slope * (x - center[0]);
        const double way = half * std::sqrt((1 - u) * (1 + u));
        return {{middle - way, middle + way}};
    };
    return solid;
}

} // namespace

Solid plane_solid(const Box& box) {
    if (box.angle != 0) {
        const Vector middle = center(box);
        std::vector<PlanePoint> corners;
        for (const auto& [x, y] : {std::pair{box.lower[0], box.lower[1]},
                                   {box.upper[0], box.lower[1]},
                                   {box.upper[0], box.upper[1]},
                                   {box.lower[0], box.upper[1]}}) {
            const Vector corner = turned_about(middle, {x, y, 0}, box.angle);
            corners.push_back({corner[0], corner[1]});
        }
        return solid_of_outlines({corners});
    }
    Solid solid{box.lower, box.upper, {}, {}};
    solid.half_open = true;
    solid.lower[2] = solid.upper[2] = 0;
    solid.breaks[0] = {box.lower[0], box.upper[0]};
    solid.spans = [box](double x, double) -> Spans {
        if (!(x > box.lower[0] && x < box.upper[0])) return {};
        return {{box.lower[1], box.upper[1]}};
    };
    return solid;
}

Solid plane_solid(const Disk& disk) {
    const double square = disk.radius * disk.radius;
    return solid_of_ellipse(disk.center, square, 0, square, square);
}

Solid plane_solid(const Ellipse& ellipse) {
    const double c = std::cos(ellipse.angle);
    const double s = std::sin(ellipse.angle);
    const double aa = ellipse.semi_axes[0] * ellipse.semi_axes[0];
    const double bb = ellipse.semi_axes[1] * ellipse.semi_axes[1];
    return solid_of_ellipse(ellipse.center, aa * c * c + bb * s * s, (aa - bb) * c * s, aa * s * s + bb * c * c,
                            ellipse.semi_axes[0] * ellipse.semi_axes[1]);
}

Solid plane_solid(const Ring& ring) {
    const Solid inner = plane_solid(Disk{ring.center, ring.inner_radius});
    Solid solid = plane_solid(Disk{ring.center, ring.outer_radius});
    solid.breaks[0] = {solid.lower[0], inner.lower[0], inner.upper[0], solid.upper[0]};
    solid.spans = [outer = solid.spans, hole = inner.spans](double x, double y) {
        return difference(outer(x, y), hole(x, y));
    };
    return solid;
}

} // namespace abut
