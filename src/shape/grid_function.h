#pragma once
/// \file grid_function.h
/// The grid's own shape functions along one axis, N(t) with t in cells from the node: what the shapes average over
/// particle domains. `integral` is P(t) = ∫ N from -∞ to t, `second_integral` ∫ P.

#include "shape/stencil.h"

namespace abut {

/// The hat function of linear elements.
struct LinearFunction {
    static constexpr int nodes = 2; ///< that see a point
    static int first_node(double x) { return floor_int(x); }
    static double value(double t) { return std::max(0.0, 1 - std::abs(t)); }
    static double integral(double t) { return t > 0 ? 1 - integral(-t) : 0.5 * square(std::max(0.0, 1 + t)); }
    static double second_integral(double t) { return t > 0 ? t + second_integral(-t) : cube(std::max(0.0, 1 + t)) / 6; }
    /// N and dN/dt of the `nodes` nodes from first_node(x) on.
    static void evaluate(double x, double (&w)[2], double (&dw)[2]) {
        const double t = x - first_node(x);
        w[0] = 1 - t;
        w[1] = t;
        dw[0] = -1;
        dw[1] = 1;
    }
    static double square(double x) { return x * x; }
    static double cube(double x) { return x * x * x; }
};

/// The quadratic B-spline (FMPM paper §2.1; Steffen et al., CMES 31 (2008)): 3/4 − t² within half a cell, then
/// ½ (3/2 − |t|)².
struct SplineFunction {
    static constexpr int nodes = 3;
    static int first_node(double x) { return floor_int(x - 0.5); }
    // As sums of truncated powers, taken on the side where all terms are small.
    static double value(double t) {
        const double s = -std::abs(t);
        return 0.5 * (square(above(s + 1.5)) - 3 * square(above(s + 0.5)));
    }
    static double integral(double t) {
        if (t > 0) return 1 - integral(-t);
        return (cube(above(t + 1.5)) - 3 * cube(above(t + 0.5))) / 6;
    }
    static double second_integral(double t) {
        if (t > 0) return t + second_integral(-t);
        return (square(square(above(t + 1.5))) - 3 * square(square(above(t + 0.5)))) / 24;
    }
    static void evaluate(double x, double (&w)[3], double (&dw)[3]) {
        const double t = x - (first_node(x) + 1); // from the middle node, in [-1/2, 1/2)
        w[0] = 0.5 * square(0.5 - t);
        w[1] = 0.75 - t * t;
        w[2] = 0.5 * square(0.5 + t);
        dw[0] = t - 0.5;
        dw[1] = -2 * t;
        dw[2] = t + 0.5;
    }

private:
    static double above(double x) { return std::max(0.0, x); }
    static double square(double x) { return x * x; }
    static double cube(double x) { return x * x * x; }
};

/// The nodes whose grid functions are not zero at a point.
template <class Function, int D>
Window<D> point_window(const Grid<D>& grid, const Vec<D>& x) {
    const Vec<D> lattice = grid.lattice_position(x);
    Window<D> w;
    for (int a = 0; a < D; ++a) {
        w.lower[a] = Function::first_node(settled(lattice[a]));
        w.upper[a] = w.lower[a] + Function::nodes - 1;
    }
    return w;
}

} // namespace abut
