#pragma once
#include "shape/box_shape.h"

namespace abut {

/// Undeformed GIMP: linear grid functions averaged over the *initial* particle domain, moved to the particle's present
/// position (contact paper Eq. 2; FMPM paper §2.1). The domain may be at most one cell wide.
struct UgimpShape : BoxShape<LinearFunction, InitialBox> {
    static constexpr bool stored = false;
    template <int D>
    static constexpr int max_nodes = power(3, D);
    static constexpr int axis_nodes = 3;

    /// With a, b the ends of the domain in cells from the base node: S0 is the mean of 1-t over the part left of node
    /// 1, S2 the mean of t-1 over the part right of it, S1 the rest.
    template <int D>
    static AxisFactors<3> factors(const Grid<D>& grid, const Domain<D>& p, int axis) {
        const double h = grid.inverse_cell[axis];
        const double x = settled((p.position[axis] - grid.origin[axis]) * h);
        const double r = settled(p.half_size[axis] * h);
        const int base = floor_int(x - r);
        const double a = x - r - base;
        const double b = a + 2 * r;
        const double left = 1 - a;
        const double beyond = std::max(b - 1, 0.0); // length right of node 1
        const double gap = std::max(1 - b, 0.0);    // length left of node 1 that the domain does not cover
        const double inverse = 1 / (2 * r);
        const double w0 = 0.5 * inverse * (left * left - gap * gap);
        const double w2 = 0.5 * inverse * beyond * beyond;
        const double d0 = -h * inverse * (left - gap);
        const double d2 = h * inverse * beyond;
        return {base, {w0, 1 - w0 - w2, w2}, {d0, -d0 - d2, d2}};
    }

    template <int D>
    static Window<D> window(const Grid<D>& grid, const Domain<D>& p) {
        Window<D> w;
        for (int a = 0; a < D; ++a) {
            const double h = grid.inverse_cell[a];
            const double x = settled((p.position[a] - grid.origin[a]) * h);
            const double r = settled(p.half_size[a] * h);
            w.lower[a] = floor_int(x - r);
            // Round-off may give a domain of one cell a fourth node.
            w.upper[a] = std::max(w.lower[a] + 2, floor_int(x + r) + 1);
        }
        return w;
    }
};

} // namespace abut
