#pragma once
/// The mapping matrices of a small state in dense form, from definitions of the shape functions that share nothing with
/// src/shape: quadrature of Eq. (2) and (12) of the contact paper for uGIMP, the corner definition with the gradient as
/// a boundary integral for CPDI.

#include "support.h"

#include <Eigen/Dense>

namespace test {

struct Weight {
    double S = 0;
    Vec<2> G = Vec<2>::Zero();
};

inline double hat(double t) {
    return std::max(0.0, 1 - std::abs(t));
}
inline double hat_slope(double t) {
    return std::abs(t) < 1 ? (t < 0 ? 1.0 : -1.0) : 0.0;
}
/// N_i at a point; everything in cells.
inline double node_function(const Vec<2>& x, const Vec<2>& node) {
    return hat(x[0] - node[0]) * hat(x[1] - node[1]);
}

/// Mean of N_i and its gradient over an axis-parallel box: two-point Gauss quadrature in every piece between grid
/// lines, which is exact for the bilinear function.
inline Weight box_average(const Vec<2>& center, const Vec<2>& half, const Vec<2>& node, const Vec<2>& cell) {
    const auto points = [](double a, double b) {
        std::vector<std::pair<double, double>> list; // place, weight
        for (double from = a; from < b;) {
            const double to = std::min(b, std::floor(from + 1 + 1e-12));
            for (const double g : {-1 / std::sqrt(3.0), 1 / std::sqrt(3.0)})
                list.emplace_back(0.5 * (from + to) + 0.5 * g * (to - from), 0.5 * (to - from) / (b - a));
            from = to;
        }
        return list;
    };
    Weight w;
    for (const auto& [x, wx] : points(center[0] - half[0], center[0] + half[0]))
        for (const auto& [y, wy] : points(center[1] - half[1], center[1] + half[1])) {
            w.S += wx * wy * node_function({x, y}, node);
            w.G[0] += wx * wy * hat_slope(x - node[0]) * hat(y - node[1]) / cell[0];
            w.G[1] += wx * wy * hat(x - node[0]) * hat_slope(y - node[1]) / cell[1];
        }
    return w;
}

/// CPDI: S the mean over the corners, G = 1/V ∮ N n dl with N linear along the edges of the domain.
inline Weight corner_average(const Vec<2>& center, const Mat<2>& sides, const Vec<2>& node, const Vec<2>& cell) {
    const Vec<2> corner[4] = {center - sides.col(0) - sides.col(1), center + sides.col(0) - sides.col(1),
                              center + sides.col(0) + sides.col(1), center - sides.col(0) + sides.col(1)};
    Weight w;
    double area = 0;
    for (int c = 0; c < 4; ++c) {
        const Vec<2> a = (corner[c] - center).cwiseProduct(cell);
        const Vec<2> b = (corner[(c + 1) % 4] - center).cwiseProduct(cell);
        const double at_a = node_function(corner[c], node);
        const double at_b = node_function(corner[(c + 1) % 4], node);
        w.S += at_a / 4;
        w.G += 0.5 * (at_a + at_b) * Vec<2>(b[1] - a[1], a[0] - b[0]); // outward normal times length
        area += 0.5 * (a[0] * b[1] - a[1] * b[0]);
    }
    w.G /= area;
    return w;
}

/// Weight of a particle at a node by the definition of its shape.
inline Weight reference_weight(ShapeKind kind, const Grid<2>& grid, const Domain<2>& p, const Index<2>& node) {
    const Vec<2> x = grid.lattice_position(p.position);
    const Vec<2> half = p.half_size.cwiseQuotient(grid.cell);
    const Vec<2> at(node[0], node[1]);
    if (kind == ShapeKind::ugimp) return box_average(x, half, at, grid.cell);
    if (kind == ShapeKind::cpdi) {
        const Mat<2> sides =
            grid.inverse_cell.asDiagonal() * (p.deformation_gradient * Mat<2>(p.half_size.asDiagonal()));
        return corner_average(x, sides, at, grid.cell);
    }
    Weight w;
    w.S = node_function(x, at);
    w.G = {hat_slope(x[0] - at[0]) * hat(x[1] - at[1]) / grid.cell[0],
           hat(x[0] - at[0]) * hat_slope(x[1] - at[1]) / grid.cell[1]};
    return w;
}

/// Node of every slot.
inline std::vector<Index<2>> slot_nodes(const VelocityFields<2>& fields) {
    std::vector<Index<2>> nodes(fields.size());
    for (const auto& block : fields.blocks)
        for (int local = 0; local < block_edge * block_edge; ++local)
            for (int slot = block.first_slot[local]; slot < block.first_slot[local + 1]; ++slot)
                nodes[slot] = {block.first_node[0] + local % block_edge, block.first_node[1] + local / block_edge};
    return nodes;
}

/// S, G and the masses of a state; rows are particles, columns slots.
struct Dense {
    Eigen::MatrixXd S, Gx, Gy;
    Eigen::VectorXd M, m;
    Eigen::MatrixXd S_plus; ///< m^-1 S^T M, zero where there is no mass

    explicit Dense(const State<2>& state) {
        const auto& particles = state.particles;
        const auto nodes = slot_nodes(state.fields);
        const auto N = static_cast<Eigen::Index>(particles.size());
        const auto n = static_cast<Eigen::Index>(nodes.size());
        S = Gx = Gy = Eigen::MatrixXd::Zero(N, n);
        M.resize(N);
        for (Eigen::Index p = 0; p < N; ++p) {
            M[p] = particles.mass[p];
            const int field = state.effects.contact ? particles.body[p] : 0;
            for (Eigen::Index i = 0; i < n; ++i) {
                if (state.fields.field[i] != field) continue;
                const Weight w =
                    reference_weight(state.scene.method.shape, state.grid, domain_of(particles, p), nodes[i]);
                S(p, i) = w.S;
                Gx(p, i) = w.G[0];
                Gy(p, i) = w.G[1];
            }
        }
        m = S.transpose() * M;
        S_plus = over_mass(S.transpose() * M.asDiagonal());
    }
    Eigen::MatrixXd over_mass(Eigen::MatrixXd rows) const {
        for (Eigen::Index i = 0; i < m.size(); ++i)
            rows.row(i) = m[i] > 0 ? (rows.row(i) / m[i]).eval() : rows.row(i) * 0;
        return rows;
    }
};

/// A vector quantity of the particles as a matrix of N rows.
inline Eigen::MatrixXd rows_of(const std::vector<Vec<2>>& values) {
    Eigen::MatrixXd result(static_cast<Eigen::Index>(values.size()), 2);
    for (std::size_t i = 0; i < values.size(); ++i) result.row(static_cast<Eigen::Index>(i)) = values[i].transpose();
    return result;
}

} // namespace test
