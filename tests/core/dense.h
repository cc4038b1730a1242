#pragma once
/// The mapping matrices of a small state in dense form, from definitions of the shape functions that share nothing with
/// src/shape: quadrature of the FMPM paper's §2.1 over the particle domain, or over its interpolated (bracketed) form.

#include "support.h"

#include <Eigen/Dense>

namespace test {

template <int D>
struct Weight {
    double S = 0;
    Vec<D> G = Vec<D>::Zero();
    double T = 0; ///< rings only
};

/// One way to write the grid functions, t in cells from the node: the convolution of k + 1 boxes, by the recursion of
/// Cox and de Boor. k = 1: hat, k = 2: quadratic spline.
inline double b_spline(int k, double t) {
    if (k == 0) return t >= -0.5 && t < 0.5 ? 1 : 0;
    const double half = 0.5 * (k + 1);
    return ((half + t) * b_spline(k - 1, t + 0.5) + (half - t) * b_spline(k - 1, t - 0.5)) / k;
}
inline double b_spline_slope(int k, double t) {
    return b_spline(k - 1, t + 0.5) - b_spline(k - 1, t - 0.5);
}

inline int degree_of(ShapeKind kind) {
    return kind == ShapeKind::b2spline || kind == ShapeKind::b2gimp || kind == ShapeKind::b2cpdi ? 2 : 1;
}
inline bool is_point(ShapeKind kind) {
    return kind == ShapeKind::linear || kind == ShapeKind::b2spline;
}
inline bool is_convected(ShapeKind kind) {
    return kind == ShapeKind::cpdi || kind == ShapeKind::b2cpdi;
}

/// Places and weights (sum 1) of a quadrature over [a, b] that is exact for polynomials of degree 5 between half cells.
inline std::vector<std::pair<double, double>> quadrature(double a, double b) {
    std::vector<std::pair<double, double>> list;
    const double gauss[3] = {-std::sqrt(0.6), 0, std::sqrt(0.6)};
    const double weight[3] = {5.0 / 18, 8.0 / 18, 5.0 / 18};
    for (double from = a; from < b;) {
        const double to = std::min(b, 0.5 * std::floor(2 * from + 1 + 1e-9));
        for (int g = 0; g < 3; ++g)
            list.emplace_back(0.5 * (from + to) + 0.5 * gauss[g] * (to - from), weight[g] * (to - from) / (b - a));
        from = to;
    }
    return list;
}

/// Sums of one axis' quadrature: N, dN/dx, and both times x - X (for rings).
struct AxisSums {
    double w = 0, dw = 0, m = 0, dm = 0;
};

inline AxisSums axis_sums(int degree, double x, double half, double node, double cell) {
    AxisSums sums;
    for (const auto& [t, weight] : quadrature(x - half, x + half)) {
        const double N = weight * b_spline(degree, t - node);
        const double slope = weight * b_spline_slope(degree, t - node) / cell;
        sums.w += N;
        sums.dw += slope;
        sums.m += N * (t - x) * cell;
        sums.dm += slope * (t - x) * cell;
    }
    return sums;
}

/// Mean over a box along the axes, everything in cells but the result; half size 0 is a point. A ring weighs by r.
template <int D>
Weight<D> box_weight(int degree, const Grid<D>& grid, const Vec<D>& X, const Vec<D>& half, const Index<D>& node,
                     bool ring) {
    const Vec<D> x = grid.lattice_position(X);
    AxisSums sums[D];
    for (int a = 0; a < D; ++a) {
        if (half[a] > 0)
            sums[a] = axis_sums(degree, x[a], half[a] / grid.cell[a], node[a], grid.cell[a]);
        else
            sums[a] = {b_spline(degree, x[a] - node[a]), b_spline_slope(degree, x[a] - node[a]) / grid.cell[a], 0, 0};
    }
    Weight<D> w;
    double product = 1;
    for (int a = 0; a < D; ++a) product *= sums[a].w;
    w.T = product / X[0];
    // ∫ N r / ∫ r with r = R + s: the mean of N plus that of N s over R.
    AxisSums first = sums[0];
    if (ring) first = {first.w + first.m / X[0], first.dw + first.dm / X[0], 0, 0};
    sums[0] = first;
    w.S = 1;
    for (int a = 0; a < D; ++a) w.S *= sums[a].w;
    for (int a = 0; a < D; ++a) {
        w.G[a] = sums[a].dw;
        for (int b = 0; b < D; ++b)
            if (b != a) w.G[a] *= sums[b].w;
    }
    return w;
}

/// The bracketed form of §2.1: N and its gradient interpolated in the deformed domain by the isoparametric functions
/// M_c of its corners, by 2-point Gauss quadrature (exact, with or without the weight r). A = F diag(half size).
template <int D>
Weight<D> convected_weight(int degree, const Grid<D>& grid, const Vec<D>& X, const Mat<D>& A, const Index<D>& node,
                           bool ring) {
    constexpr int corners = 1 << D;
    const double gauss = 1 / std::sqrt(3.0);
    const auto sign = [](int c, int a) { return (c >> a) & 1 ? 1.0 : -1.0; };
    double N[corners];
    for (int c = 0; c < corners; ++c) {
        Vec<D> xi;
        for (int a = 0; a < D; ++a) xi[a] = sign(c, a);
        const Vec<D> x = grid.lattice_position(X + A * xi);
        N[c] = 1;
        for (int a = 0; a < D; ++a) N[c] *= b_spline(degree, x[a] - node[a]);
    }
    const Mat<D> dxi_dx = A.fullPivLu().inverse();
    Weight<D> w;
    double volume = 0;
    for (int q = 0; q < corners; ++q) {
        Vec<D> xi;
        for (int a = 0; a < D; ++a) xi[a] = gauss * sign(q, a);
        const double r = (X + A * xi)[0];
        const double weight = ring ? r : 1;
        volume += weight;
        for (int c = 0; c < corners; ++c) {
            double M = 1;
            for (int a = 0; a < D; ++a) M *= 0.5 * (1 + sign(c, a) * xi[a]);
            Vec<D> dM; // by xi
            for (int a = 0; a < D; ++a) dM[a] = 0.5 * sign(c, a) * M / (0.5 * (1 + sign(c, a) * xi[a]));
            w.S += weight * M * N[c];
            w.G += weight * N[c] * (dxi_dx.transpose() * dM);
            w.T += M * N[c];
        }
    }
    w.S /= volume;
    w.G /= volume;
    w.T /= volume;
    return w;
}

/// Half edges of the box that has the deformed domain's variance along each axis: that of its corners.
template <int D>
Vec<D> current_box(const Mat<D>& A) {
    Vec<D> squares = Vec<D>::Zero();
    for (int c = 0; c < 1 << D; ++c) {
        Vec<D> xi;
        for (int a = 0; a < D; ++a) xi[a] = (c >> a) & 1 ? 1.0 : -1.0;
        squares += (A * xi).cwiseAbs2() / (1 << D);
    }
    return squares.cwiseSqrt();
}

/// Weight of a particle at a node by the definition of its shape.
template <int D>
Weight<D> reference_weight(ShapeKind kind, const Grid<D>& grid, const Domain<D>& p, const Index<D>& node,
                           bool ring = false) {
    const Mat<D> A = p.deformation_gradient * Mat<D>(p.half_size.asDiagonal());
    const int degree = degree_of(kind);
    if (is_convected(kind)) return convected_weight<D>(degree, grid, p.position, A, node, ring);
    Vec<D> half = p.half_size;
    if (is_point(kind)) half.setZero();
    if (kind == ShapeKind::gimp) half = current_box<D>(A);
    return box_weight<D>(degree, grid, p.position, half, node, ring);
}

/// Node of every slot.
template <int D>
std::vector<Index<D>> slot_nodes(const VelocityFields<D>& fields) {
    std::vector<Index<D>> nodes(fields.size());
    for (const auto& block : fields.blocks)
        for (int local = 0; local < static_cast<int>(nodes_per_block<D>); ++local)
            for (int slot = block.first_slot[local]; slot < block.first_slot[local + 1]; ++slot)
                for (int a = 0, rest = local; a < D; ++a, rest /= block_edge)
                    nodes[slot][a] = block.first_node[a] + rest % block_edge;
    return nodes;
}

/// S, G, T and the masses of a state; rows are particles, columns slots.
template <int D = 2>
struct Dense {
    Eigen::MatrixXd S, G[D], T;
    Eigen::VectorXd M, m;
    Eigen::MatrixXd S_plus; ///< m^-1 S^T M, zero where there is no mass

    explicit Dense(const State<D>& state) {
        const auto& particles = state.particles;
        const auto nodes = slot_nodes(state.fields);
        const auto N = static_cast<Eigen::Index>(particles.size());
        const auto n = static_cast<Eigen::Index>(nodes.size());
        S = T = Eigen::MatrixXd::Zero(N, n);
        for (auto& component : G) component = S;
        M.resize(N);
        for (Eigen::Index p = 0; p < N; ++p) {
            M[p] = particles.mass[p];
            const int field = state.effects.contact ? particles.body[p] : 0;
            for (Eigen::Index i = 0; i < n; ++i) {
                if (state.fields.field[i] != field) continue;
                const Weight<D> w = reference_weight<D>(state.scene.method.shape, state.grid, domain_of(particles, p),
                                                        nodes[i], state.effects.ring);
                S(p, i) = w.S;
                for (int a = 0; a < D; ++a) G[a](p, i) = w.G[a];
                T(p, i) = state.effects.ring ? w.T : 0;
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
    /// m_k^-1 m v = Σ_{j<k} A^j v, A = I − S+ S.
    Eigen::MatrixXd inverse(int k, const Eigen::MatrixXd& v) const {
        Eigen::MatrixXd term = v;
        Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(v.rows(), v.cols());
        for (int j = 0; j < k; ++j) {
            sum += term;
            term -= (S_plus * (S * term)).eval();
        }
        return sum;
    }
};

/// A vector quantity of the particles as a matrix of N rows.
template <int D>
Eigen::MatrixXd rows_of(const std::vector<Vec<D>>& values) {
    Eigen::MatrixXd result(static_cast<Eigen::Index>(values.size()), D);
    for (std::size_t i = 0; i < values.size(); ++i) result.row(static_cast<Eigen::Index>(i)) = values[i].transpose();
    return result;
}

/// The vector lanes of the nodes.
template <int D>
Eigen::MatrixXd rows_of(const std::vector<Pack>& values) {
    Eigen::MatrixXd result(static_cast<Eigen::Index>(values.size()), D);
    for (std::size_t i = 0; i < values.size(); ++i)
        result.row(static_cast<Eigen::Index>(i)) = vector_of<D>(values[i]).transpose();
    return result;
}

} // namespace test
