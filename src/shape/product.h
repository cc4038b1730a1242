#pragma once
/// \file product.h
/// Shapes that are tensor products of functions along the axes: a point, or a box along the axes.

#include "shape/grid_function.h"

namespace abut {

/// Shape functions and derivatives along one axis for K neighbouring nodes from `base` on.
template <int K>
struct AxisFactors {
    int base;
    double w[K];
    double dw[K]; ///< [1/m]
};

/// Tensor product of factors along the axes.
template <int D, int K, int N>
[[gnu::always_inline]] inline void expand_product(const std::array<AxisFactors<K>, D>& f, const Window<D>& window,
                                                  Stencil<D, N>& s) {
    if constexpr (D == 2) {
        const int row = window.extent(0);
        const int first = (f[1].base - window.lower[1]) * row + f[0].base - window.lower[0];
        for (int j = 0, k = 0; j < K; ++j)
            for (int i = 0; i < K; ++i, ++k) {
                s.node[k] = first + j * row + i;
                s.S[k] = f[0].w[i] * f[1].w[j];
                s.G[0][k] = f[0].dw[i] * f[1].w[j];
                s.G[1][k] = f[0].w[i] * f[1].dw[j];
            }
    } else {
        const int row = window.extent(0);
        const int plane = row * window.extent(1);
        const int first =
            (f[2].base - window.lower[2]) * plane + (f[1].base - window.lower[1]) * row + f[0].base - window.lower[0];
        for (int l = 0, k = 0; l < K; ++l)
            for (int j = 0; j < K; ++j) {
                const double ww = f[1].w[j] * f[2].w[l];
                const double dw = f[1].dw[j] * f[2].w[l];
                const double wd = f[1].w[j] * f[2].dw[l];
                for (int i = 0; i < K; ++i, ++k) {
                    s.node[k] = first + l * plane + j * row + i;
                    s.S[k] = f[0].w[i] * ww;
                    s.G[0][k] = f[0].dw[i] * ww;
                    s.G[1][k] = f[0].w[i] * dw;
                    s.G[2][k] = f[0].w[i] * wd;
                }
            }
    }
}

/// The shape functions alone, and the slots of the nodes: all that the sweeps of the full mass matrix need.
template <int D, int K, int N>
[[gnu::always_inline]] inline void expand_values(const std::array<AxisFactors<K>, D>& f, const Window<D>& window,
                                                 const std::int32_t* table, std::int32_t (&slot)[N], double (&S)[N]) {
    const int row = window.extent(0);
    const int plane = D == 3 ? row * window.extent(1) : 0;
    const std::int32_t* first = table + (f[1].base - window.lower[1]) * row + f[0].base - window.lower[0];
    if constexpr (D == 3) first += (f[2].base - window.lower[2]) * plane;
    int k = 0;
    for (int l = 0; l < (D == 3 ? K : 1); ++l)
        for (int j = 0; j < K; ++j) {
            const std::int32_t* const here = first + l * plane + j * row;
            double w = f[1].w[j];
            if constexpr (D == 3) w *= f[2].w[l];
            for (int i = 0; i < K; ++i, ++k) {
                slot[k] = here[i];
                S[k] = f[0].w[i] * w;
            }
        }
}

/// The factors of a particle's stencil along all axes, for shapes that are expanded on the spot.
template <class Shape, int D>
[[gnu::always_inline]] inline auto factors_of(const Grid<D>& grid, const Domain<D>& p) {
    std::array<AxisFactors<Shape::axis_nodes>, D> f;
    for (int a = 0; a < D; ++a) f[a] = Shape::factors(grid, p, a);
    return f;
}

/// Nodes that a particle may see along an axis; a run stops before (see find_velocity_fields.cpp).
constexpr int most_axis_nodes = 64;

/// Factors along one axis for any number of nodes, with what the ring of an axisymmetric particle needs: `m` and `dm`
/// are the means of N s and dN/dx s over the domain, s the distance from the particle's centre.
struct AxisTable {
    int base;
    int size;
    double w[most_axis_nodes];
    double dw[most_axis_nodes]; ///< [1/m]
    double m[most_axis_nodes];  ///< [m]
    double dm[most_axis_nodes];
};

/// Means of a grid function over [x - r, x + r], everything in cells of width 1/h, for `size` nodes from `base` on.
template <class Function, bool Ring>
void average(double x, double r, double h, int base, int size, AxisTable& f) {
    f.base = base;
    f.size = size;
    for (int i = 0; i < f.size; ++i) {
        // Ends of the domain as seen from the node. What lies beyond the node is mirrored: on this side the integrals
        // are small numbers where the domain only just reaches the node, on the other differences of large ones, and a
        // node's mass must keep its digits, for forces are divided by it.
        const bool beyond = x - r > f.base + i;
        const double sign = beyond ? -1 : 1;
        const double a = beyond ? f.base + i - (x + r) : x - r - (f.base + i);
        const double b = beyond ? f.base + i - (x - r) : x + r - (f.base + i);
        const double end_a = Function::value(a);
        const double end_b = Function::value(b);
        const double P_a = Function::integral(a);
        const double P_b = Function::integral(b);
        f.w[i] = (P_b - P_a) / (2 * r);
        f.dw[i] = sign * h * (end_b - end_a) / (2 * r);
        if constexpr (Ring) { // by parts: ∫ N s = [P s] − ∫ P, ∫ N' s = [N s] − ∫ N
            const double second = (Function::second_integral(b) - Function::second_integral(a)) / (2 * r);
            f.m[i] = sign * (0.5 * (P_a + P_b) - second) / h;
            f.dm[i] = 0.5 * (end_a + end_b) - f.w[i];
        }
    }
}

/// Values at a point.
template <class Function>
void evaluate(double x, double h, AxisTable& f) {
    double w[Function::nodes];
    double dw[Function::nodes];
    Function::evaluate(x, w, dw);
    f.base = Function::first_node(x);
    f.size = Function::nodes;
    for (int i = 0; i < Function::nodes; ++i) {
        f.w[i] = w[i];
        f.dw[i] = h * dw[i];
        f.m[i] = f.dm[i] = 0;
    }
}

/// Tensor product of the tables. A ring weighs every point of the domain with its radius (Nairn, Guilkey, IJNME 101
/// (2015)): S = ∫ N r / ∫ r = w + m / R, likewise G, and T = ∫ N / ∫ r = w / R, with R the particle's radius.
template <bool Ring, int D>
void fill_product(const AxisTable (&f)[D], const Window<D>& window, [[maybe_unused]] double R,
                  const StencilEntries<D>& s) {
    Window<D> own;
    for (int a = 0; a < D; ++a) {
        own.lower[a] = f[a].base;
        own.upper[a] = f[a].base + f[a].size - 1;
    }
    int k = 0;
    for_each_node(own, [&](const Index<D>& node) {
        const auto w = [&](int a) { return f[a].w[node[a] - f[a].base]; };
        const auto dw = [&](int a) { return f[a].dw[node[a] - f[a].base]; };
        s.node[k] = window.local(node);
        double first = w(0);
        double first_slope = dw(0);
        if constexpr (Ring) {
            const int i = node[0] - f[0].base;
            first += f[0].m[i] / R;
            first_slope += f[0].dm[i] / R;
            s.T[k] = w(0) * w(1) / R;
        }
        double rest = 1;
        for (int a = 1; a < D; ++a) rest *= w(a);
        s.S[k] = first * rest;
        s.G[0][k] = first_slope * rest;
        for (int a = 1; a < D; ++a) {
            double G = first * dw(a);
            for (int b = 1; b < D; ++b)
                if (b != a) G *= w(b);
            s.G[a][k] = G;
        }
        ++k;
    });
}

} // namespace abut
