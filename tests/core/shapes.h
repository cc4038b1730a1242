#pragma once
/// What the tests of shape functions share: a grid, random particles, and stencils summed by node.

#include "dense.h"

#include "shape/dispatch.h"

namespace test {

template <int D>
Grid<D> some_grid() {
    Grid<D> grid;
    for (int a = 0; a < D; ++a) {
        grid.cell[a] = 0.5 - 0.1 * a; // 0.5, 0.4, 0.3
        grid.inverse_cell[a] = 1 / grid.cell[a];
        grid.origin[a] = -1.0 + 0.3 * a;
        grid.cells[a] = 16;
        grid.blocks[a] = 7;
    }
    return grid;
}

/// A particle somewhere in the middle of the grid; domains of at most a cell as uGIMP wants, before deformation.
template <int D>
struct Particle {
    Vec<D> position;
    Mat<D> F = Mat<D>::Identity();
    Vec<D> half_size;

    Particle(std::mt19937& random, const Grid<D>& grid) {
        std::uniform_real_distribution<double> in(0, 1);
        for (int a = 0; a < D; ++a) {
            position[a] = grid.origin[a] + grid.cell[a] * (10 + 4 * in(random));
            half_size[a] = grid.cell[a] * (0.05 + 0.45 * in(random));
        }
    }
    Domain<D> domain() const { return {position, F, half_size}; }
};

/// Stencil of a particle in its own window, summed by node.
template <int D>
struct Filled {
    Window<D> window;
    std::vector<double> S;
    std::vector<Vec<D>> G;
    std::vector<double> T;
    int entries = 0;

    Index<D> node(int place) const {
        Index<D> n;
        for (int a = 0; a < D; ++a) {
            n[a] = window.lower[a] + place % window.extent(a);
            place /= window.extent(a);
        }
        return n;
    }
    bool contains(const Index<D>& n) const {
        for (int a = 0; a < D; ++a)
            if (n[a] < window.lower[a] || n[a] > window.upper[a]) return false;
        return true;
    }

    void reset(const Window<D>& w) {
        window = w;
        S.assign(w.size(), 0);
        T.assign(w.size(), 0);
        G.assign(w.size(), Vec<D>::Zero());
    }
    /// \return false if the node lies outside the window: kernels would read the table of slots outside
    bool add(int place, double s, const Vec<D>& g, double t) {
        if (place < 0 || place >= window.size()) return false;
        S[place] += s;
        G[place] += g;
        T[place] += t;
        return true;
    }
};

/// By fill(), as stored stencils are made.
template <bool Ring, int D, class Shape>
Filled<D> filled(Shape, const Grid<D>& grid, const Domain<D>& p) {
    Filled<D> f;
    f.reset(Shape::window(grid, p));
    f.entries = Shape::count(f.window);
    std::vector<std::int32_t> node(f.entries, -1);
    std::vector<double> S(f.entries, NAN), T(f.entries, NAN), G[D];
    StencilEntries<D> s{node.data(), S.data(), {}, T.data()};
    for (int a = 0; a < D; ++a) {
        G[a].assign(f.entries, NAN); // an entry that is left out shows
        s.G[a] = G[a].data();
    }
    Shape::template fill<Ring>(grid, p, f.window, f.window, s);
    for (int k = 0; k < f.entries; ++k) {
        Vec<D> g;
        for (int a = 0; a < D; ++a) g[a] = G[a][k];
        EXPECT_TRUE(f.add(node[k], S[k], g, Ring ? T[k] : 0)) << "outside the window: " << node[k];
    }
    return f;
}

/// By expand(), on the spot.
template <int D, class Shape>
Filled<D> expanded(Shape, const Grid<D>& grid, const Domain<D>& p) {
    Filled<D> f;
    f.reset(Shape::window(grid, p));
    Stencil<D, Shape::template max_nodes<D>> s;
    expand_product<D, Shape::axis_nodes>(factors_of<Shape>(grid, p), f.window, s);
    f.entries = Shape::template max_nodes<D>;
    for (int k = 0; k < f.entries; ++k) {
        Vec<D> g;
        for (int a = 0; a < D; ++a) g[a] = s.G[a][k];
        EXPECT_TRUE(f.add(s.node[k], s.S[k], g, 0)) << "outside the window: " << s.node[k];
    }
    return f;
}

/// The deformed domain matters to these shapes.
inline bool deforms(ShapeKind kind) {
    return kind == ShapeKind::gimp || is_convected(kind);
}

} // namespace test
