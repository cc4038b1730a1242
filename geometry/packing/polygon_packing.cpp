#include "geometry/packing/polygon_packing.h"

#include "geometry/packing/ball_packing.h"
#include "geometry/packing/laguerre.h"

#include <Eigen/SparseCholesky>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace abut {

namespace {

/// Changes weights until cells have the wanted areas: damped Newton steps (Kitagawa, Mérigot and Thibert, J. Eur. Math.
/// Soc. 21 (2019) 2603). With len the length of the side between a and b and d the distance of their centres,
/// ∂A_a/∂w_a = Σ len / (2 d) and ∂A_a/∂w_b = −len / (2 d).
class AreaFit {
public:
    AreaFit(const PolygonRequest& request, const std::vector<PlanePoint>& centres, std::vector<double> weights,
            const std::vector<double>& areas)
        : request_(request), centres_(centres), areas_(areas), weights_(std::move(weights)),
          cells_(laguerre_cells(request.width, request.height, centres_, weights_)) {}

    std::vector<LaguerreCell> run() {
        constexpr int most_steps = 60;
        constexpr double tolerance = 1e-9; // of the smallest area
        const double least_wanted = *std::min_element(areas_.begin(), areas_.end());
        const double least = 0.5 * std::min(least_wanted, smallest_area(cells_)); // no cell may get lost on the way
        for (int step = 0; step < most_steps && error(cells_) > tolerance * least_wanted; ++step) {
            const Eigen::VectorXd change = newton_step();
            double share = 1;
            for (; share > 1e-6; share *= 0.5) {
                std::vector<double> changed = weights_;
                for (std::size_t k = 0; k < changed.size(); ++k)
                    changed[k] += share * change[static_cast<Eigen::Index>(k)];
                std::vector<LaguerreCell> next = laguerre_cells(request_.width, request_.height, centres_, changed);
                if (smallest_area(next) < least || error(next) >= error(cells_)) continue;
                weights_ = std::move(changed);
                cells_ = std::move(next);
                break;
            }
            if (share <= 1e-6) break; // as good as numbers allow
        }
        return cells_;
    }

    const std::vector<double>& weights() const { return weights_; }
    /// Whether each site has a cell to begin with.
    bool complete() const { return smallest_area(cells_) > 0; }

private:
    static double smallest_area(const std::vector<LaguerreCell>& cells) {
        double least = signed_area(cells[0].points);
        for (const LaguerreCell& cell : cells) least = std::min(least, signed_area(cell.points));
        return least;
    }

    /// Root of the summed squares of what areas lack.
    double error(const std::vector<LaguerreCell>& cells) const {
        double squares = 0;
        for (std::size_t k = 0; k < cells.size(); ++k) {
            const double missing = areas_[k] - signed_area(cells[k].points);
            squares += missing * missing;
        }
        return std::sqrt(squares);
    }

    Eigen::VectorXd newton_step() const {
        const auto count = static_cast<Eigen::Index>(cells_.size());
        std::vector<Eigen::Triplet<double>> entries;
        Eigen::VectorXd missing(count);
        for (Eigen::Index k = 0; k < count; ++k) {
            const LaguerreCell& cell = cells_[k];
            missing[k] = areas_[k] - signed_area(cell.points);
            double sum = k == 0 ? 1 : 0; // only differences of weights matter: hold the first
            for (std::size_t i = 0; i < cell.sides.size(); ++i) {
                if (cell.sides[i].neighbour < 0) continue;
                const PlanePoint &p = cell.points[i], &q = cell.points[(i + 1) % cell.points.size()];
                const PlanePoint& other = centres_[cell.sides[i].neighbour];
                const double slope = std::hypot(q[0] - p[0], q[1] - p[1]) /
                                     (2 * std::hypot(other[0] - centres_[k][0], other[1] - centres_[k][1]));
                sum += slope;
                entries.emplace_back(k, cell.sides[i].neighbour, -slope);
            }
            entries.emplace_back(k, k, sum);
        }
        Eigen::SparseMatrix<double> slopes(count, count);
        slopes.setFromTriplets(entries.begin(), entries.end());
        const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(slopes);
        return solver.solve(missing);
    }

    const PolygonRequest& request_;
    const std::vector<PlanePoint>& centres_;
    const std::vector<double>& areas_;
    std::vector<double> weights_;
    std::vector<LaguerreCell> cells_;
};

PlanePoint centroid(const std::vector<PlanePoint>& points) {
    PlanePoint sum{};
    double twice = 0;
    for (std::size_t k = 0; k < points.size(); ++k) {
        const PlanePoint &p = points[k], &q = points[(k + 1) % points.size()];
        const double cross = p[0] * q[1] - p[1] * q[0];
        twice += cross;
        for (int axis = 0; axis < 2; ++axis) sum[axis] += cross * (p[axis] + q[axis]);
    }
    return {sum[0] / (3 * twice), sum[1] / (3 * twice)};
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
    AreaFit first(request, packed.centres, weights, areas);
    std::vector<LaguerreCell> cells = first.run();
    weights = first.weights();
    constexpr int rounds = 3; // Lloyd's: cells about their centroids are rounder
    for (int round = 0; round < rounds; ++round) {
        std::vector<PlanePoint> centres;
        for (const LaguerreCell& cell : cells) centres.push_back(centroid(cell.points));
        AreaFit fit(request, centres, weights, areas);
        if (!fit.complete()) break;
        cells = fit.run();
        weights = fit.weights();
    }

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
