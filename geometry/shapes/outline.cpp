#include "geometry/shapes/outline.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

namespace abut {

namespace {

/// An edge from left to right.
struct Edge {
    double x0, y0, x1, y1;
    double rightmost = 0; ///< right end of what lies below it in the tree
};

/// Edges by their left ends, as a balanced tree: the root of a range is its middle (an interval tree). It takes as much
/// memory as the edges however long they are, and a line O(log n) time for each edge that it meets.
class EdgesAlongX {
public:
    explicit EdgesAlongX(std::vector<Edge> edges) : edges_(std::move(edges)) {
        std::stable_sort(edges_.begin(), edges_.end(), [](const Edge& a, const Edge& b) { return a.x0 < b.x0; });
        if (!edges_.empty()) set_rightmost(0, edges_.size());
    }

    /// Heights at which the line at x crosses edges, ascending. An edge owns its left end and not its right one, so
    /// that a corner counts once where the outline passes on, and twice or never where it turns back.
    std::vector<double> crossings(double x) const {
        std::vector<double> heights;
        collect(0, edges_.size(), x, heights);
        std::sort(heights.begin(), heights.end());
        return heights;
    }

private:
    std::vector<Edge> edges_;

    double set_rightmost(std::size_t first, std::size_t last) {
        const std::size_t root = first + (last - first) / 2;
        double rightmost = edges_[root].x1;
        if (first < root) rightmost = std::max(rightmost, set_rightmost(first, root));
        if (root + 1 < last) rightmost = std::max(rightmost, set_rightmost(root + 1, last));
        return edges_[root].rightmost = rightmost;
    }

    void collect(std::size_t first, std::size_t last, double x, std::vector<double>& heights) const {
        while (first < last) {
            const std::size_t root = first + (last - first) / 2;
            const Edge& edge = edges_[root];
            if (edge.rightmost <= x) return;
            collect(first, root, x, heights);
            if (edge.x0 > x) return;
            if (x < edge.x1) {
                const double share = (x - edge.x0) / (edge.x1 - edge.x0);
                heights.push_back(share < 0.5 ? edge.y0 + share * (edge.y1 - edge.y0)
                                              : edge.y1 - (1 - share) * (edge.y1 - edge.y0));
            }
            first = root + 1;
        }
    }
};

} // namespace

Outline2D without_repeats(const Outline2D& points) {
    Outline2D result;
    for (const PlanePoint& point : points)
        if (result.empty() || point != result.back()) result.push_back(point);
    while (result.size() > 1 && result.front() == result.back()) result.pop_back();
    return result;
}

double area_of(const Outline2D& points) {
    double twice = 0;
    for (std::size_t k = 0; k < points.size(); ++k) {
        const PlanePoint& a = points[k];
        const PlanePoint& b = points[(k + 1) % points.size()];
        // About the first point, so that places far from the origin lose no digits.
        twice += (a[0] - points[0][0]) * (b[1] - points[0][1]) - (b[0] - points[0][0]) * (a[1] - points[0][1]);
    }
    return std::abs(twice) / 2;
}

Solid solid_of_outlines(const std::vector<Outline2D>& outlines) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    Solid solid{{infinity, infinity, 0}, {-infinity, -infinity, 0}, {}, {}};
    solid.half_open = true;
    std::vector<Edge> edges;
    for (const Outline2D& outline : outlines)
        for (std::size_t k = 0; k < outline.size(); ++k) {
            const PlanePoint& a = outline[k];
            const PlanePoint& b = outline[(k + 1) % outline.size()];
            for (std::size_t axis = 0; axis < 2; ++axis) {
                solid.lower[axis] = std::min(solid.lower[axis], a[axis]);
                solid.upper[axis] = std::max(solid.upper[axis], a[axis]);
            }
            solid.breaks[0].push_back(a[0]);
            if (a[0] < b[0])
                edges.push_back({a[0], a[1], b[0], b[1]});
            else if (b[0] < a[0])
                edges.push_back({b[0], b[1], a[0], a[1]});
        }
    std::sort(solid.breaks[0].begin(), solid.breaks[0].end());
    solid.breaks[0].erase(std::unique(solid.breaks[0].begin(), solid.breaks[0].end()), solid.breaks[0].end());
    constexpr std::size_t many = 500; // then the pieces between them are short anyway
    if (solid.breaks[0].size() > many) solid.breaks[0] = {solid.lower[0], solid.upper[0]};
    const auto sorted = std::make_shared<const EdgesAlongX>(std::move(edges));
    solid.spans = [sorted](double x, double) {
        const std::vector<double> heights = sorted->crossings(x);
        Spans spans;
        for (std::size_t k = 0; k + 1 < heights.size(); k += 2)
            if (heights[k] < heights[k + 1]) {
                if (!spans.empty() && spans.back().to == heights[k])
                    spans.back().to = heights[k + 1];
                else
                    spans.push_back({heights[k], heights[k + 1]});
            }
        return spans;
    };
    return solid;
}

} // namespace abut
