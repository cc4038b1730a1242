// CGAL's exact predicates tell whether outlines cross.
#include "geometry/shapes/outline.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

namespace abut {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_2;

struct Segment {
    Point a, b;
    std::size_t outline;
    double left() const { return std::min(a.x(), b.x()); }
    double right() const { return std::max(a.x(), b.x()); }
};

/// A place that two segments share, if it makes what is inside doubtful: where they cross, or run along each other.
/// Outlines may touch in a point.
std::optional<Point> doubtful(const Segment& s, const Segment& t) {
    if (std::max(s.a.y(), s.b.y()) < std::min(t.a.y(), t.b.y()) ||
        std::max(t.a.y(), t.b.y()) < std::min(s.a.y(), s.b.y()))
        return {};
    const CGAL::Orientation sa = CGAL::orientation(t.a, t.b, s.a);
    const CGAL::Orientation sb = CGAL::orientation(t.a, t.b, s.b);
    if (sa == CGAL::COLLINEAR && sb == CGAL::COLLINEAR) {
        // On one line, in the order along it.
        const auto [s0, s1] = std::minmax(s.a, s.b, [](const Point& p, const Point& q) { return p < q; });
        const auto [t0, t1] = std::minmax(t.a, t.b, [](const Point& p, const Point& q) { return p < q; });
        const Point from = std::max(s0, t0);
        if (from < std::min(s1, t1)) return from;
        return {};
    }
    if (sa * sb != CGAL::NEGATIVE) return {};
    const CGAL::Orientation ta = CGAL::orientation(s.a, s.b, t.a);
    const CGAL::Orientation tb = CGAL::orientation(s.a, s.b, t.b);
    if (ta * tb != CGAL::NEGATIVE) return {};
    const double da = (s.b.x() - s.a.x()) * (t.a.y() - s.a.y()) - (s.b.y() - s.a.y()) * (t.a.x() - s.a.x());
    const double db = (s.b.x() - s.a.x()) * (t.b.y() - s.a.y()) - (s.b.y() - s.a.y()) * (t.b.x() - s.a.x());
    const double share = da / (da - db);
    return Point(t.a.x() + share * (t.b.x() - t.a.x()), t.a.y() + share * (t.b.y() - t.a.y()));
}

} // namespace

void check_outlines(const std::vector<Outline2D>& outlines, const std::vector<std::string>& names) {
    const auto name = [&](std::size_t k) { return k < names.size() ? names[k] : fmt::format("outline {}", k + 1); };
    std::vector<Segment> segments;
    for (std::size_t k = 0; k < outlines.size(); ++k) {
        const Outline2D& outline = outlines[k];
        for (const PlanePoint& point : outline)
            if (!std::isfinite(point[0]) || !std::isfinite(point[1]))
                throw std::runtime_error(name(k) + " has a coordinate that is not a number");
        if (outline.size() < 3)
            throw std::runtime_error(fmt::format("{} has {} different corners; it needs 3", name(k), outline.size()));
        for (std::size_t i = 0; i < outline.size(); ++i) {
            const PlanePoint& a = outline[i];
            const PlanePoint& b = outline[(i + 1) % outline.size()];
            segments.push_back({{a[0], a[1]}, {b[0], b[1]}, k});
        }
    }
    std::sort(segments.begin(), segments.end(), [](const Segment& s, const Segment& t) { return s.left() < t.left(); });
    std::vector<std::size_t> active; // those that a line along y at the present x may meet
    for (std::size_t next = 0; next < segments.size(); ++next) {
        const Segment& segment = segments[next];
        std::erase_if(active, [&](std::size_t other) { return segments[other].right() < segment.left(); });
        for (const std::size_t other : active)
            if (const std::optional<Point> place = doubtful(segments[other], segment)) {
                const std::size_t k = segment.outline;
                const std::size_t l = segments[other].outline;
                throw std::runtime_error(fmt::format("{} crosses {} at ({:.6g} m, {:.6g} m)", name(std::min(k, l)),
                                                     k == l ? "itself" : name(std::max(k, l)), place->x(), place->y()));
            }
        active.push_back(next);
    }
    for (std::size_t k = 0; k < outlines.size(); ++k)
        if (!(area_of(outlines[k]) > 0)) throw std::runtime_error(name(k) + " has no area");
}

} // namespace abut
