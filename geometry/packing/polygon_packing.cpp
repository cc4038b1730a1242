#include "geometry/packing/polygon_packing.h"

#include "geometry/packing/ball_packing.h"
#include "geometry/packing/laguerre.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace abut {

namespace {

/// Weights are moved until areas differ from the wanted ones by at most this share of the mean.
constexpr double area_tolerance = 1e-3;

/// Changes weights until cells have the wanted areas. With len the length of the side between a and b, d the distance
/// of their centres, dA_a/dw_a = Σ len / (2 d) and dA_a/dw_b = −len / (2 d): damped Jacobi steps.
std::vector<LaguerreCell> cells_of_areas(const PolygonRequest& request, const std::vector<PlanePoint>& centres,
                                         std::vector<double> weights, const std::vector<double>& areas) {
    constexpr int most_steps = 400;
    std::vector<LaguerreCell> cells = laguerre_cells(request.width, request.height, centres, weights);
    const double mean = request.width * request.height / static_cast<double>(centres.size());
    double damping = 0.7;
    for (int step = 0; step < most_steps; ++step) {
        double worst = 0;
        std::vector<double> changed = weights;
        for (std::size_t k = 0; k < cells.size(); ++k) {
            const double missing = areas[k] - signed_area(cells[k].points);
            worst = std::max(worst, std::abs(missing));
            double stiffness = 0;
            for (std::size_t i = 0; i < cells[k].sides.size(); ++i) {
                if (cells[k].sides[i].neighbour < 0) continue;
                const PlanePoint &p = cells[k].points[i], &q = cells[k].points[(i + 1) % cells[k].points.size()];
                const PlanePoint& other = centres[cells[k].sides[i].neighbour];
                stiffness += std::hypot(q[0] - p[0], q[1] - p[1]) /
                             (2 * std::hypot(other[0] - centres[k][0], other[1] - centres[k][1]));
            }
            if (stiffness > 0) changed[k] += damping * missing / stiffness;
        }
        if (worst <= area_tolerance * mean) break;
        std::vector<LaguerreCell> next = laguerre_cells(request.width, request.height, centres, changed);
        const bool all_there =
            std::none_of(next.begin(), next.end(), [](const auto& cell) { return cell.points.empty(); });
        if (all_there) {
            weights = std::move(changed);
            cells = std::move(next);
        } else if ((damping *= 0.5) < 1e-3) {
            break;
        }
    }
    return cells;
}

/// Area that is left of all cells; 0 when one of them is gone.
double area_left(const std::vector<LaguerreCell>& cells, double distance) {
    double area = 0;
    for (const LaguerreCell& cell : cells) {
        const LaguerreCell left = inset(cell, distance);
        if (left.points.empty()) return 0;
        area += signed_area(left.points);
    }
    return area;
}

/// Half the width of the gaps that leave the wanted area.
double half_gap(const std::vector<LaguerreCell>& cells, const PolygonRequest& request) {
    const double box = request.width * request.height, wanted = request.area_fraction * box;
    if (request.area_fraction == 1 || cells.size() == 1) return 0;
    double lower = 0, upper = std::min(request.width, request.height);
    for (int step = 0; step < 60; ++step) {
        const double middle = 0.5 * (lower + upper);
        (area_left(cells, middle) >= wanted ? lower : upper) = middle;
    }
    const double left = area_left(cells, lower) / box;
    if (left - request.area_fraction > 1e-6)
        throw std::runtime_error(
            fmt::format("with gaps that leave less than {:.3f} of the area the smallest polygon is "
                        "gone, {:.3f} is not reached; ask for a larger area fraction or more equal "
                        "sizes",
                        left, request.area_fraction));
    return lower;
}

} // namespace

PackedPolygons pack_polygons(const PolygonRequest& request) {
    Random random(request.seed);
    BallRequest<2> disks;
    disks.box = {request.width, request.height};
    disks.sizes = sample_sizes(request.sizes, request.bodies, random);
    // One disk of a wide box would not fit at 0.6 of its area; so few make good cells wherever they are.
    const double shorter = std::min(request.width, request.height), longer = std::max(request.width, request.height);
    double squares = 0;
    for (const double size : disks.sizes) squares += size * size;
    const double alone = 0.25 * 3.14159 * shorter / longer * squares / (disks.sizes[0] * disks.sizes[0]);
    disks.fraction = std::min(request.bodies < 10 ? 0.4 : 0.6, 0.5 * alone);
    disks.seed = request.seed + 2;
    const PackedBalls<2> packed = pack_balls(disks);

    std::vector<double> weights, areas;
    for (const double radius : packed.radii) weights.push_back(radius * radius);
    for (const double size : disks.sizes) areas.push_back(size * size / squares * request.width * request.height);
    const std::vector<LaguerreCell> cells = cells_of_areas(request, packed.centres, weights, areas);

    PackedPolygons result;
    const double half = half_gap(cells, request);
    result.gap = 2 * half;
    if (result.gap < request.gap) {
        const double left = area_left(cells, 0.5 * request.gap) / (request.width * request.height);
        throw std::runtime_error(fmt::format("gaps of {} leave {:.3f} of the area to the polygons, not {:.3f}; ask for "
                                             "less, or for a smaller gap",
                                             request.gap, left, request.area_fraction));
    }
    for (const LaguerreCell& cell : cells) {
        result.polygons.push_back({inset(cell, half).points, {}});
        std::vector<int> neighbours;
        for (const CellSide& side : cell.sides)
            if (side.neighbour >= 0) neighbours.push_back(side.neighbour);
        std::sort(neighbours.begin(), neighbours.end());
        result.neighbours.push_back(neighbours);
    }
    return result;
}

} // namespace abut
