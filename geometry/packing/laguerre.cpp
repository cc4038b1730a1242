#include "geometry/packing/laguerre.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Regular_triangulation_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace abut {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase =
    CGAL::Triangulation_vertex_base_with_info_2<int, Kernel, CGAL::Regular_triangulation_vertex_base_2<Kernel>>;
using Triangulation = CGAL::Regular_triangulation_2<
    Kernel, CGAL::Triangulation_data_structure_2<VertexBase, CGAL::Regular_triangulation_face_base_2<Kernel>>>;

/// Pairs of sites whose cells share a side, in ascending order.
std::vector<std::pair<int, int>> adjacent_sites(const std::vector<PlanePoint>& centres,
                                                const std::vector<double>& weights) {
    std::vector<std::pair<Kernel::Weighted_point_2, int>> sites;
    for (std::size_t k = 0; k < centres.size(); ++k)
        sites.emplace_back(Kernel::Weighted_point_2({centres[k][0], centres[k][1]}, weights[k]), static_cast<int>(k));
    const Triangulation triangulation(sites.begin(), sites.end());
    std::vector<std::pair<int, int>> pairs;
    for (auto edge = triangulation.finite_edges_begin(); edge != triangulation.finite_edges_end(); ++edge) {
        const int a = edge->first->vertex(Triangulation::cw(edge->second))->info();
        const int b = edge->first->vertex(Triangulation::ccw(edge->second))->info();
        pairs.emplace_back(std::min(a, b), std::max(a, b));
    }
    std::sort(pairs.begin(), pairs.end());
    return pairs;
}

double beyond(const CellSide& side, const PlanePoint& x) {
    return side.normal[0] * x[0] + side.normal[1] * x[1] - side.offset;
}

/// Cuts off all that lies beyond a line.
LaguerreCell cut(const LaguerreCell& cell, const CellSide& side) {
    LaguerreCell result;
    for (std::size_t k = 0; k < cell.points.size(); ++k) {
        const PlanePoint &p = cell.points[k], &q = cell.points[(k + 1) % cell.points.size()];
        const double at_p = beyond(side, p), at_q = beyond(side, q);
        const auto crossing = [&] {
            const double share = at_p / (at_p - at_q);
            return PlanePoint{p[0] + share * (q[0] - p[0]), p[1] + share * (q[1] - p[1])};
        };
        if (at_p <= 0) {
            result.points.push_back(p);
            result.sides.push_back(cell.sides[k]);
            if (at_q > 0) {
                result.points.push_back(crossing());
                result.sides.push_back(side);
            }
        } else if (at_q < 0) { // a line that only touches a corner makes no side
            result.points.push_back(crossing());
            result.sides.push_back(cell.sides[k]);
        }
    }
    if (result.points.size() < 3) return {};
    return result;
}

LaguerreCell box(double width, double height) {
    return {{{0, 0}, {width, 0}, {width, height}, {0, height}},
            {{{0, -1}, 0, -1}, {{1, 0}, width, -1}, {{0, 1}, height, -1}, {{-1, 0}, 0, -1}}};
}

} // namespace

std::vector<LaguerreCell> laguerre_cells(double width, double height, const std::vector<PlanePoint>& centres,
                                         const std::vector<double>& weights) {
    std::vector<LaguerreCell> cells(centres.size(), box(width, height));
    std::vector<char> has_neighbour(centres.size(), 0);
    for (const auto& [a, b] : adjacent_sites(centres, weights)) {
        const double x = centres[b][0] - centres[a][0], y = centres[b][1] - centres[a][1], d = std::sqrt(x * x + y * y);
        // On the line both powers are equal; it is `t` away from a.
        const double t = (d * d + weights[a] - weights[b]) / (2 * d);
        const PlanePoint normal{x / d, y / d};
        const double offset = normal[0] * centres[a][0] + normal[1] * centres[a][1] + t;
        cells[a] = cut(cells[a], {normal, offset, b});
        cells[b] = cut(cells[b], {{-normal[0], -normal[1]}, -offset, a});
        has_neighbour[a] = has_neighbour[b] = 1;
    }
    for (std::size_t k = 0; k < cells.size(); ++k) // hidden by others
        if (!has_neighbour[k] && cells.size() > 1) cells[k] = {};
    return cells;
}

LaguerreCell inset(const LaguerreCell& cell, double distance) {
    LaguerreCell result = cell;
    for (CellSide side : cell.sides) {
        if (side.neighbour < 0) continue;
        side.offset -= distance;
        result = cut(result, side);
    }
    return result;
}

double signed_area(const std::vector<PlanePoint>& points) {
    double twice = 0;
    for (std::size_t k = 0; k < points.size(); ++k) {
        const PlanePoint &p = points[k], &q = points[(k + 1) % points.size()];
        twice += p[0] * q[1] - p[1] * q[0];
    }
    return 0.5 * twice;
}

} // namespace abut
