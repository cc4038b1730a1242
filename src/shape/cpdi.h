#pragma once
#include "shape/stencil.h"

#include <Eigen/LU>

namespace abut {

/// CPDI: linear grid functions interpolated within the deformed particle domain from its corners (FMPM paper §2.1,
/// bracketed forms; Sadeghirad, Brannon, Burghardt, IJNME 86 (2011)). The domain is the parallelogram
/// (parallelepiped) spanned by the columns r_a of F diag(half size), so with corners x + Σ ±r_a
///   S_i = 2^-D Σ_c N_i(x_c),   G_i = A^-T 2^-D Σ_c s_c N_i(x_c),   A = [r_1 … r_D], s_c the signs of corner c.
struct CpdiShape {
    static constexpr bool stored = true;
    template <int D>
    static constexpr int max_nodes = power(4, D);

    template <int D>
    static Window<D> window(const Grid<D>& grid, const Domain<D>& p) {
        Window<D> w;
        for (int a = 0; a < D; ++a) {
            double reach = 0;
            for (int b = 0; b < D; ++b) reach += std::abs(p.deformation_gradient(a, b)) * p.half_size[b];
            const double x = (p.position[a] - grid.origin[a]) * grid.inverse_cell[a];
            const double r = reach * grid.inverse_cell[a];
            // Round-off in a corner's position must not carry it across the window's edge.
            constexpr double slack = 1e-9;
            w.lower[a] = floor_int(x - r - slack);
            w.upper[a] = floor_int(x + r + slack) + 1;
        }
        return w;
    }

    template <int D, int N>
    static void expand(const Grid<D>& grid, const Domain<D>& p, const Window<D>& window, Stencil<D, N>& s) {
        constexpr int corners = power(2, D);
        constexpr double share = 1.0 / corners;
        Mat<D> A = p.deformation_gradient;
        for (int b = 0; b < D; ++b) A.col(b) *= p.half_size[b];
        const Mat<D> inverse_transpose = A.inverse().transpose() * share;

        // Merged into the box of nodes around the domain if that is no larger than the list of all corners' nodes:
        // an undeformed particle sees 4 to 9 nodes of 16 corner nodes.
        const Window<D> own = CpdiShape::window(grid, p);
        const bool merged = own.size() <= max_nodes<D>;
        if (merged) {
            s.count = own.size();
            int k = 0;
            for_each_node(own, [&](const Index<D>& node) {
                s.node[k] = window.local(node);
                s.S[k] = 0;
                for (int a = 0; a < D; ++a) s.G[a][k] = 0;
                ++k;
            });
        } else {
            s.count = max_nodes<D>;
        }

        const Vec<D> x = grid.lattice_position(p.position);
        for (int c = 0; c < corners; ++c) {
            Vec<D> sign;
            for (int a = 0; a < D; ++a) sign[a] = (c >> a) & 1 ? 1.0 : -1.0;
            const Vec<D> corner = x + (A * sign).cwiseProduct(grid.inverse_cell);
            const Vec<D> direction = inverse_transpose * sign;
            Index<D> base;
            Vec<D> t;
            for (int a = 0; a < D; ++a) {
                base[a] = floor_int(corner[a]);
                t[a] = corner[a] - base[a];
            }
            for (int n = 0; n < corners; ++n) {
                double weight = 1;
                Index<D> node = base;
                for (int a = 0; a < D; ++a) {
                    const int up = (n >> a) & 1;
                    node[a] += up;
                    weight *= up ? t[a] : 1 - t[a];
                }
                if (merged) {
                    const int k = own.local(node);
                    s.S[k] += share * weight;
                    for (int a = 0; a < D; ++a) s.G[a][k] += direction[a] * weight;
                } else {
                    const int k = c * corners + n;
                    s.node[k] = window.local(node);
                    s.S[k] = share * weight;
                    for (int a = 0; a < D; ++a) s.G[a][k] = direction[a] * weight;
                }
            }
        }
    }

private:
    template <int D, class Visit>
    static void for_each_node(const Window<D>& w, Visit&& visit) {
        Index<D> node = w.lower;
        for (;;) {
            visit(node);
            int a = 0;
            while (a < D && ++node[a] > w.upper[a]) {
                node[a] = w.lower[a];
                ++a;
            }
            if (a == D) return;
        }
    }
};

} // namespace abut
