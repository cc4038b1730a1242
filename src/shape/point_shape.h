#pragma once
#include "shape/product.h"

namespace abut {

/// A particle without extent: S_i = N_i(X) with the grid functions of `Function`.
template <class Function>
struct PointShape {
    static constexpr bool stored = false;
    static constexpr FaceRule face_rule = FaceRule::center;
    template <int D>
    static constexpr int max_nodes = power(Function::nodes, D);

    using GridFunction = Function;
    template <int D>
    static int count(const Window<D>& own) {
        return own.size();
    }

    template <int D>
    static Window<D> window(const Grid<D>& grid, const Domain<D>& p) {
        return point_window<Function>(grid, p.position);
    }

    static constexpr int axis_nodes = Function::nodes;

    template <int D>
    static AxisFactors<axis_nodes> factors(const Grid<D>& grid, const Domain<D>& p, int axis) {
        const double x = settled((p.position[axis] - grid.origin[axis]) * grid.inverse_cell[axis]);
        AxisFactors<axis_nodes> f;
        f.base = Function::first_node(x);
        Function::evaluate(x, f.w, f.dw);
        for (double& slope : f.dw) slope *= grid.inverse_cell[axis];
        return f;
    }

    template <bool Ring, int D>
    static void fill(const Grid<D>& grid, const Domain<D>& p, const Window<D>&, const Window<D>& window,
                     const StencilEntries<D>& s) {
        const Vec<D> x = grid.lattice_position(p.position);
        AxisTable f[D];
        for (int a = 0; a < D; ++a) evaluate<Function>(settled(x[a]), grid.inverse_cell[a], f[a]);
        fill_product<Ring, D>(f, window, p.position[0], s);
    }
};

} // namespace abut
