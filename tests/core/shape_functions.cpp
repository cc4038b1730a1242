#include "dense.h"

#include "shape/dispatch.h"

namespace {

using namespace test;

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

    Particle(std::mt19937& random, const Grid<D>& grid, double deformation) {
        std::uniform_real_distribution<double> in(0, 1);
        for (int a = 0; a < D; ++a) {
            position[a] = grid.origin[a] + grid.cell[a] * (10 + 4 * in(random));
            half_size[a] = grid.cell[a] * (0.05 + 0.45 * in(random));
        }
        F = random_deformation<D>(random, deformation);
    }
    Domain<D> domain() const { return {position, F, half_size}; }
};

/// Stencil of a particle in its own window, summed by node.
template <int D, class Shape>
struct Expanded {
    Window<D> window;
    std::vector<double> S;
    std::vector<Vec<D>> G;

    Expanded(Shape shape, const Grid<D>& grid, const Domain<D>& p) : window(shape.window(grid, p)) {
        Stencil<D, Shape::template max_nodes<D>> s;
        Shape::expand(grid, p, window, s);
        S.assign(window.size(), 0);
        G.assign(window.size(), Vec<D>::Zero());
        for (int k = 0; k < s.count; ++k) {
            EXPECT_GE(s.node[k], 0);
            EXPECT_LT(s.node[k], window.size()); // else the table of slots is read outside
            S.at(s.node[k]) += s.S[k];
            for (int a = 0; a < D; ++a) G.at(s.node[k])[a] += s.G[a][k];
        }
    }
    Index<D> node(int place) const {
        Index<D> n;
        for (int a = 0; a < D; ++a) {
            n[a] = window.lower[a] + place % window.extent(a);
            place /= window.extent(a);
        }
        return n;
    }
};

/// Σ S = 1, Σ S x_i = X, Σ G = 0, Σ x_i ⊗ G = I: linear fields and their gradients are reproduced.
template <int D, class Shape>
void check_linear_fields(Shape shape, double deformation, int seed) {
    std::mt19937 random(seed);
    const Grid<D> grid = some_grid<D>();
    for (int trial = 0; trial < 300; ++trial) {
        const Particle<D> p(random, grid, deformation);
        const Expanded<D, Shape> e(shape, grid, p.domain());
        double sum = 0;
        Vec<D> x = Vec<D>::Zero();
        Vec<D> g = Vec<D>::Zero();
        Mat<D> gradient = Mat<D>::Zero();
        double scale = 1;
        for (int k = 0; k < e.window.size(); ++k) {
            const Vec<D> node = grid.node_position(e.node(k));
            EXPECT_GE(e.S[k], -1e-15);
            sum += e.S[k];
            x += e.S[k] * node;
            g += e.G[k];
            gradient += node * e.G[k].transpose();
            scale += e.G[k].norm() * node.norm();
        }
        EXPECT_NEAR(sum, 1, 1e-13);
        EXPECT_LT((x - p.position).norm(), 1e-13);
        EXPECT_LT(g.norm(), 1e-14 * scale * 10);
        EXPECT_LT((gradient - Mat<D>::Identity()).norm(), 1e-14 * scale * 10);
    }
}

TEST(Shapes, ReproduceLinearFieldsIn2D) {
    check_linear_fields<2>(LinearShape{}, 0, 1);
    check_linear_fields<2>(UgimpShape{}, 0, 2);
    check_linear_fields<2>(CpdiShape{}, 0.3, 3);
    check_linear_fields<2>(CpdiShape{}, 2.5, 4);
}

TEST(Shapes, ReproduceLinearFieldsIn3D) {
    check_linear_fields<3>(LinearShape{}, 0, 5);
    check_linear_fields<3>(UgimpShape{}, 0, 6);
    check_linear_fields<3>(CpdiShape{}, 0.3, 7);
    check_linear_fields<3>(CpdiShape{}, 1.5, 8);
}

/// S and G at every node around against the definition; outside the window the definition must give nothing.
template <class Shape>
int check_against_definition(Shape shape, ShapeKind kind, double deformation, int seed) {
    std::mt19937 random(seed);
    const Grid<2> grid = some_grid<2>();
    int largest = 0;
    for (int trial = 0; trial < 300; ++trial) {
        const Particle<2> p(random, grid, deformation);
        const Expanded<2, Shape> e(shape, grid, p.domain());
        largest = std::max(largest, e.window.size());
        double scale = 1;
        for (const Vec<2>& G : e.G) scale = std::max(scale, G.norm());
        for (int j = 0; j < 28; ++j)
            for (int i = 0; i < 28; ++i) {
                const Weight w = reference_weight(kind, grid, p.domain(), {i, j});
                const bool inside = i >= e.window.lower[0] && i <= e.window.upper[0] && j >= e.window.lower[1] &&
                                    j <= e.window.upper[1];
                const double S = inside ? e.S[e.window.local({i, j})] : 0;
                const Vec<2> G = inside ? e.G[e.window.local({i, j})] : Vec<2>::Zero();
                EXPECT_NEAR(S, w.S, 2e-14) << i << " " << j;
                EXPECT_LT((G - w.G).norm(), 1e-12 * scale) << i << " " << j;
            }
    }
    return largest;
}

TEST(Shapes, LinearIsTheHatFunction) {
    check_against_definition(LinearShape{}, ShapeKind::linear, 0, 11);
}

TEST(Shapes, UgimpIsTheMeanOverTheUndeformedDomain) {
    check_against_definition(UgimpShape{}, ShapeKind::ugimp, 0.5, 12); // F must not matter
}

TEST(Shapes, CpdiIsTheMeanOverTheCorners) {
    check_against_definition(CpdiShape{}, ShapeKind::cpdi, 0, 13);
    check_against_definition(CpdiShape{}, ShapeKind::cpdi, 0.4, 14);
    // Stretched and turned so far that the box around the domain has more nodes than the corners have.
    EXPECT_GT(check_against_definition(CpdiShape{}, ShapeKind::cpdi, 3, 15), 16);
}

/// G = ∂S/∂X where the shape is averaged over a domain that moves with the particle.
template <class Shape>
void check_gradient_by_differences(Shape shape, int seed) {
    std::mt19937 random(seed);
    const Grid<2> grid = some_grid<2>();
    const double h = 1e-6;
    for (int trial = 0; trial < 200; ++trial) {
        Particle<2> p(random, grid, 0);
        const Expanded<2, Shape> e(shape, grid, p.domain());
        for (int a = 0; a < 2; ++a) {
            Particle<2> up = p;
            Particle<2> down = p;
            up.position[a] += h;
            down.position[a] -= h;
            const Expanded<2, Shape> after(shape, grid, up.domain());
            const Expanded<2, Shape> before(shape, grid, down.domain());
            if (!(after.window == e.window) || !(before.window == e.window)) continue; // across a kink
            for (int k = 0; k < e.window.size(); ++k)
                EXPECT_NEAR(e.G[k][a], (after.S[k] - before.S[k]) / (2 * h), 5e-5);
        }
    }
}

TEST(Shapes, GradientsAreDerivativesOfTheShapeFunctions) {
    check_gradient_by_differences(LinearShape{}, 21);
    check_gradient_by_differences(UgimpShape{}, 22);
}

TEST(Shapes, UndeformedCpdiIsLinearInterpolationOfUgimpsDomain) {
    // A domain that no grid line cuts: both are the mean of one bilinear function.
    const Grid<2> grid = some_grid<2>();
    const Vec<2> x = grid.node_position({11, 12}) + Vec<2>(0.2, 0.15);
    const Mat<2> F = Mat<2>::Identity();
    const Vec<2> half(0.1, 0.12);
    const Expanded<2, CpdiShape> c(CpdiShape{}, grid, {x, F, half});
    const Expanded<2, UgimpShape> u(UgimpShape{}, grid, {x, F, half});
    ASSERT_EQ(c.window.size(), 4);
    for (int k = 0; k < 4; ++k) {
        const int same = u.window.local(c.node(k));
        EXPECT_NEAR(c.S[k], u.S[same], 1e-15);
        EXPECT_LT((c.G[k] - u.G[same]).norm(), 1e-13);
    }
}

TEST(Shapes, CornersExactlyOnGridLinesStayInTheWindow) {
    const Grid<2> grid = some_grid<2>();
    for (int i = 0; i < 200; ++i) {
        // Quarter cells: corners on lines up to round-off.
        const Vec<2> x = grid.origin + Vec<2>((40 + i) * 0.125 * 0.5, (40 + i % 17) * 0.125 * 0.4);
        const Mat<2> F = Mat<2>::Identity();
        const Vec<2> half(0.125, 0.1);
        const Expanded<2, CpdiShape> c(CpdiShape{}, grid, {x, F, half});
        const Expanded<2, UgimpShape> u(UgimpShape{}, grid, {x, F, half});
        double sum_c = 0, sum_u = 0;
        for (const double S : c.S) sum_c += S;
        for (const double S : u.S) sum_u += S;
        EXPECT_NEAR(sum_c, 1, 1e-14);
        EXPECT_NEAR(sum_u, 1, 1e-14);
        for (const double S : u.S) EXPECT_GE(S, -1e-15);
    }
}

} // namespace
