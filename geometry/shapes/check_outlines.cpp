// CGAL's exact predicates tell whether outlines cross.
#include "geometry/shapes/outline.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/box_intersection_d.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <tuple>

namespace abut {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_2;

/// An edge from a to b, with the corner before it.
struct Segment {
    Point before, a, b;
    std::size_t outline, index, count; ///< count: of edges of its outline
};
using EdgeBox = CGAL::Box_intersection_d::Box_with_handle_d<double, 2, std::vector<Segment>::const_iterator>;

int side(const Point& from, const Point& to, const Point& p) {
    return static_cast<int>(CGAL::orientation(from, to, p));
}

/// Whether a point on the line through the ends of a segment lies on the segment.
bool within(const Segment& s, const Point& p) {
    return std::min(s.a, s.b) <= p && p <= std::max(s.a, s.b);
}

/// Whether p lies in the sector on the left of the way from `before` over `corner` to `after`.
bool on_left(const Point& before, const Point& corner, const Point& after, const Point& p) {
    const bool first = side(before, corner, p) > 0, second = side(corner, after, p) > 0;
    return side(before, corner, after) > 0 ? first && second : first || second;
}

struct Doubt {
    Point where;
    bool touch = false; ///< one outline, which only touches itself there
};

/// A place that two segments share, if it makes what is inside doubtful: where they cross, run along each other, or
/// touch within one outline. Two outlines may touch in a point, if one does not lead through the other there.
std::optional<Doubt> doubtful(const Segment& s, const Segment& t) {
    const int sa = side(t.a, t.b, s.a), sb = side(t.a, t.b, s.b);
    if (sa == 0 && sb == 0) {
        // On one line, in the order along it.
        const Point from = std::max(std::min(s.a, s.b), std::min(t.a, t.b));
        if (from < std::min(std::max(s.a, s.b), std::max(t.a, t.b))) return Doubt{from};
    }
    const int ta = side(s.a, s.b, t.a), tb = side(s.a, s.b, t.b);
    if (sa * sb < 0 && ta * tb < 0) {
        const double da = (s.b.x() - s.a.x()) * (t.a.y() - s.a.y()) - (s.b.y() - s.a.y()) * (t.a.x() - s.a.x());
        const double db = (s.b.x() - s.a.x()) * (t.b.y() - s.a.y()) - (s.b.y() - s.a.y()) * (t.b.x() - s.a.x());
        const double share = da / (da - db);
        return Doubt{Point(t.a.x() + share * (t.b.x() - t.a.x()), t.a.y() + share * (t.b.y() - t.a.y()))};
    }
    if (s.outline == t.outline) {
        if ((s.index + 1) % s.count == t.index || (t.index + 1) % t.count == s.index) return {}; // their corner
        if (sa == 0 && within(t, s.a)) return Doubt{s.a, true};
        if (sb == 0 && within(t, s.b)) return Doubt{s.b, true};
        if (ta == 0 && within(s, t.a)) return Doubt{t.a, true};
        if (tb == 0 && within(s, t.b)) return Doubt{t.b, true};
        return {};
    }
    // Through a corner: each corner is the first one of one segment.
    if (s.a == t.a) {
        const bool in = on_left(t.before, t.a, t.b, s.before), out = on_left(t.before, t.a, t.b, s.b);
        return in != out ? std::optional(Doubt{s.a}) : std::nullopt;
    }
    const auto leads_through = [](const Segment& edge, const Segment& other) {
        return side(edge.a, edge.b, other.a) == 0 && other.a != edge.a && other.a != edge.b && within(edge, other.a) &&
               side(edge.a, edge.b, other.before) * side(edge.a, edge.b, other.b) < 0;
    };
    if (leads_through(t, s)) return Doubt{s.a};
    if (leads_through(s, t)) return Doubt{t.a};
    return {};
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
        const std::size_t n = outline.size();
        const auto corner = [&](std::size_t i) { return Point(outline[i % n][0], outline[i % n][1]); };
        for (std::size_t i = 0; i < n; ++i) segments.push_back({corner(i + n - 1), corner(i), corner(i + 1), k, i, n});
    }
    std::vector<EdgeBox> boxes;
    boxes.reserve(segments.size());
    for (auto segment = segments.cbegin(); segment != segments.cend(); ++segment)
        boxes.emplace_back(segment->a.bbox() + segment->b.bbox(), segment);

    // The first in order of the segments: CGAL gives the pairs in any order.
    std::optional<std::tuple<std::size_t, std::size_t, Doubt>> first;
    CGAL::box_self_intersection_d(boxes.begin(), boxes.end(), [&](const EdgeBox& a, const EdgeBox& b) {
        const auto index = [&](const EdgeBox& box) {
            return static_cast<std::size_t>(box.handle() - segments.cbegin());
        };
        const std::size_t i = std::min(index(a), index(b)), j = std::max(index(a), index(b));
        if (first && std::pair(i, j) >= std::pair(std::get<0>(*first), std::get<1>(*first))) return;
        if (const std::optional<Doubt> doubt = doubtful(segments[i], segments[j])) first = {i, j, *doubt};
    });
    if (first) {
        const auto& [i, j, doubt] = *first;
        const std::size_t k = segments[i].outline, l = segments[j].outline;
        throw std::runtime_error(fmt::format("{} {} {} at ({:.6g} m, {:.6g} m)", name(k),
                                             doubt.touch ? "touches" : "crosses", k == l ? "itself" : name(l),
                                             doubt.where.x(), doubt.where.y()));
    }
    for (std::size_t k = 0; k < outlines.size(); ++k)
        if (!(area_of(outlines[k]) > 0)) throw std::runtime_error(name(k) + " has no area");
}

} // namespace abut
