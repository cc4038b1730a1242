#pragma once
#include "shape/stencil.h"

namespace abut {

/// Linear shape functions of a particle without extent ("classic" MPM).
struct LinearShape {
    static constexpr bool stored = false;
    template <int D>
    static constexpr int max_nodes = power(2, D);

    template <int D>
    static AxisFactors<2> factors(const Grid<D>& grid, const Domain<D>& p, int axis) {
        const double x = (p.position[axis] - grid.origin[axis]) * grid.inverse_cell[axis];
        const int base = floor_int(x);
        const double t = x - base;
        return {base, {1 - t, t}, {-grid.inverse_cell[axis], grid.inverse_cell[axis]}};
    }

    template <int D>
    static Window<D> window(const Grid<D>& grid, const Domain<D>& p) {
        Window<D> w;
        for (int a = 0; a < D; ++a) {
            w.lower[a] = factors(grid, p, a).base;
            w.upper[a] = w.lower[a] + 1;
        }
        return w;
    }

    template <int D, int N>
    static void expand(const Grid<D>& grid, const Domain<D>& p, const Window<D>& window, Stencil<D, N>& s) {
        AxisFactors<2> f[D];
        for (int a = 0; a < D; ++a) f[a] = factors(grid, p, a);
        expand_product<D, 2>(f, window, s);
    }
};

} // namespace abut
