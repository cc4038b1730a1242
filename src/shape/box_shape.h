#pragma once
#include "shape/product.h"

namespace abut {

/// Grid functions averaged over a box along the axes (GIMP). `HalfSize::of(domain)` gives the box's half edges [m].
template <class Function, class HalfSize>
struct BoxShape {
    using GridFunction = Function;
    static constexpr FaceRule face_rule = FaceRule::simpson;
    /// Half edges of the box [m].
    template <int D>
    static Vec<D> box(const Domain<D>& p) {
        return HalfSize::of(p);
    }
    template <int D>
    static int count(const Window<D>& own) {
        return own.size();
    }

    template <int D>
    static Window<D> window(const Grid<D>& grid, const Domain<D>& p) {
        const Vec<D> r = HalfSize::of(p).cwiseProduct(grid.inverse_cell).cwiseMin(farthest);
        const Vec<D> x = grid.lattice_position(p.position);
        Window<D> w;
        for (int a = 0; a < D; ++a) {
            w.lower[a] = Function::first_node(x[a] - r[a]);
            w.upper[a] = Function::first_node(x[a] + r[a]) + Function::nodes - 1;
        }
        return w;
    }

    template <bool Ring, int D>
    static void fill(const Grid<D>& grid, const Domain<D>& p, const Window<D>& own, const Window<D>& window,
                     const StencilEntries<D>& s) {
        const Vec<D> r = HalfSize::of(p).cwiseProduct(grid.inverse_cell);
        const Vec<D> x = grid.lattice_position(p.position);
        AxisTable f[D];
        for (int a = 0; a < D; ++a)
            average<Function, Ring>(x[a], r[a], grid.inverse_cell[a], own.lower[a], own.extent(a), f[a]);
        fill_product<Ring, D>(f, window, p.position[0], s);
    }
};

/// The undeformed domain.
struct InitialBox {
    template <int D>
    static Vec<D> of(const Domain<D>& p) {
        return p.half_size;
    }
};

/// The box with the extent of the deformed domain along each axis: a parallelogram spanned by the columns r_b of
/// F diag(half size) has the variance Σ_b (r_b·e_a)² / 3 along axis a, a box of half edge R that of R² / 3. For pure
/// stretch along the axes it is the deformed domain itself; turned by a right angle its edges change places.
struct CurrentBox {
    template <int D>
    static Vec<D> of(const Domain<D>& p) {
        Vec<D> r;
        for (int a = 0; a < D; ++a) {
            double squares = 0;
            for (int b = 0; b < D; ++b) {
                const double reach = p.deformation_gradient(a, b) * p.half_size[b];
                squares += reach * reach;
            }
            r[a] = std::sqrt(squares);
        }
        return r;
    }
};

} // namespace abut
