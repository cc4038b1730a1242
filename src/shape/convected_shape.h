#pragma once
#include "shape/grid_function.h"

#include <Eigen/LU>

#include <algorithm>

namespace abut {

/// CPDI: grid functions interpolated within the deformed particle domain from its corners (FMPM paper §2.1,
/// bracketed forms; Sadeghirad, Brannon, Burghardt, IJNME 86 (2011)). The domain is the parallelogram
/// (parallelepiped) spanned by the columns r_a of F diag(half size), so with corners x + Σ ±r_a
///   S_i = 2^-D Σ_c N_i(x_c),   G_i = A^-T 2^-D Σ_c s_c N_i(x_c),   A = [r_1 … r_D], s_c the signs of corner c.
/// A ring weighs the corners' functions M_c with the radius R + ξ r_1x + η r_2x (Nairn, Guilkey, IJNME 101 (2015)):
///   S: 1 + s_1 ρ_1 + s_2 ρ_2 with ρ_a = r_ax / 3R;  G: s_1 (1 + s_2 ρ_2), s_2 (1 + s_1 ρ_1);  T: 1 / R.
template <class Function>
struct ConvectedShape {
    static constexpr bool stored = true;
    static constexpr FaceRule face_rule = FaceRule::corners;
    template <int D>
    static constexpr int corner_nodes = power(2 * Function::nodes, D); ///< of all corners together

    using GridFunction = Function;
    template <int D>
    static int count(const Window<D>& own) {
        return std::min(corner_nodes<D>, own.size());
    }

    template <int D>
    static Window<D> window(const Grid<D>& grid, const Domain<D>& p) {
        Window<D> w;
        for (int a = 0; a < D; ++a) {
            double reach = 0;
            for (int b = 0; b < D; ++b) reach += std::abs(p.deformation_gradient(a, b)) * p.half_size[b];
            const double x = (p.position[a] - grid.origin[a]) * grid.inverse_cell[a];
            const double r = std::min(farthest, reach * grid.inverse_cell[a]);
            // Round-off in a corner's position must not carry it across the window's edge.
            constexpr double slack = 1e-9;
            w.lower[a] = Function::first_node(x - r - slack);
            w.upper[a] = Function::first_node(x + r + slack) + Function::nodes - 1;
        }
        return w;
    }

    template <bool Ring, int D>
    static void fill(const Grid<D>& grid, const Domain<D>& p, const Window<D>& own, const Window<D>& window,
                     const StencilEntries<D>& s) {
        constexpr int corners = power(2, D);
        constexpr double share = 1.0 / corners;
        Mat<D> A = p.deformation_gradient;
        for (int b = 0; b < D; ++b) A.col(b) *= p.half_size[b];
        const Mat<D> inverse_transpose = A.inverse().transpose() * share;

        // Merged into the box of nodes around the domain if that is no larger than the list of all corners' nodes:
        // an undeformed particle of CPDI sees 4 to 9 nodes of 16 corner nodes.
        const bool merged = own.size() <= corner_nodes<D>;
        const int count = ConvectedShape::count(own);
        // Summed up here, where the compiler knows that nothing else is changed.
        double S_sum[corner_nodes<D>];
        double G_sum[D][corner_nodes<D>];
        [[maybe_unused]] double T_sum[Ring ? corner_nodes<D> : 1];
        std::fill_n(S_sum, count, 0.0);
        for (auto& component : G_sum) std::fill_n(component, count, 0.0);
        if constexpr (Ring) std::fill_n(T_sum, count, 0.0);
        if (merged) {
            int k = 0;
            for_each_node(own, [&](const Index<D>& node) { s.node[k++] = window.local(node); });
        }

        const Vec<D> x = grid.lattice_position(p.position);
        // Places of a corner's nodes from the first one on: in the merged box, or in the window.
        const Window<D>& box = merged ? own : window;
        constexpr int nodes = power(Function::nodes, D);
        int offset[nodes];
        for (int n = 0; n < nodes; ++n) {
            Index<D> node = box.lower;
            for (int a = 0, rest = n; a < D; ++a, rest /= Function::nodes) node[a] += rest % Function::nodes;
            offset[n] = box.local(node);
        }
        for (int c = 0; c < corners; ++c) {
            Vec<D> sign;
            for (int a = 0; a < D; ++a) sign[a] = (c >> a) & 1 ? 1.0 : -1.0;
            const Vec<D> corner = x + (A * sign).cwiseProduct(grid.inverse_cell);
            double S = share;
            Vec<D> G = inverse_transpose * sign;
            [[maybe_unused]] double T = 0;
            if constexpr (Ring) {
                const double R = p.position[0];
                const double rho[2] = {A(0, 0) / (3 * R), A(0, 1) / (3 * R)};
                S *= 1 + sign[0] * rho[0] + sign[1] * rho[1];
                G = inverse_transpose * Vec<D>(sign[0] * (1 + sign[1] * rho[1]), sign[1] * (1 + sign[0] * rho[0]));
                T = share / R;
            }
            double w[D][Function::nodes];
            double unused[Function::nodes];
            Index<D> base;
            for (int a = 0; a < D; ++a) {
                base[a] = Function::first_node(corner[a]);
                Function::evaluate(corner[a], w[a], unused);
            }
            const int first = box.local(base);
            for (int n = 0; n < nodes; ++n) {
                double weight = 1;
                for (int a = 0, rest = n; a < D; ++a, rest /= Function::nodes) weight *= w[a][rest % Function::nodes];
                const int k = merged ? first + offset[n] : c * nodes + n;
                if (!merged) s.node[k] = first + offset[n];
                S_sum[k] += S * weight;
                for (int a = 0; a < D; ++a) G_sum[a][k] += G[a] * weight;
                if constexpr (Ring) T_sum[k] += T * weight;
            }
        }
        std::copy_n(S_sum, count, s.S);
        for (int a = 0; a < D; ++a) std::copy_n(G_sum[a], count, s.G[a]);
        if constexpr (Ring) std::copy_n(T_sum, count, s.T);
    }
};

} // namespace abut
