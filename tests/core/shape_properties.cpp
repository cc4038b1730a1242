/// What every shape must do, whatever its definition, in 2D and 3D.

#include "shapes.h"

namespace {

using namespace test;

class Shapes : public testing::TestWithParam<ShapeKind> {};

/// Σ S = 1, Σ S x_i = X, Σ G = 0, Σ x_i ⊗ G = I: linear fields and their gradients are reproduced. S ≥ 0.
template <int D>
void expect_linear_fields(const Grid<D>& grid, const Vec<D>& position, const Filled<D>& f, double round_off = 1e-13) {
    double sum = 0;
    Vec<D> x = Vec<D>::Zero();
    Vec<D> g = Vec<D>::Zero();
    Mat<D> gradient = Mat<D>::Zero();
    double scale = 1;
    double smallest = 0;
    for (int k = 0; k < f.window.size(); ++k) {
        const Vec<D> node = grid.node_position(f.node(k));
        smallest = std::min(smallest, f.S[k]);
        sum += f.S[k];
        x += f.S[k] * node;
        g += f.G[k];
        gradient += node * f.G[k].transpose();
        scale += f.G[k].norm() * (1 + node.norm());
    }
    EXPECT_GE(smallest, -1e-15);
    EXPECT_NEAR(sum, 1, round_off);
    EXPECT_LT((x - position).norm(), 10 * round_off);
    EXPECT_LT(g.norm(), round_off * scale);
    EXPECT_LT((gradient - Mat<D>::Identity()).norm(), round_off * scale);
}

template <int D>
void check_linear_fields(ShapeKind kind, double smallest_stretch, double largest_stretch, int trials) {
    std::mt19937 random(D);
    const Grid<D> grid = some_grid<D>();
    with_shape(kind, [&](auto shape) {
        for (int trial = 0; trial < trials; ++trial) {
            Particle<D> p(random, grid);
            if (largest_stretch > 1) p.F = stretched_and_turned<D>(random, smallest_stretch, largest_stretch);
            // Averages over a box are differences over its size.
            const double round_off = 1e-13 * (kind == ShapeKind::gimp && smallest_stretch < 0.5 ? 10 : 1);
            expect_linear_fields<D>(grid, p.position, filled<false>(shape, grid, p.domain()), round_off);
            if constexpr (!decltype(shape)::stored)
                expect_linear_fields<D>(grid, p.position, expanded(shape, grid, p.domain()));
        }
    });
}

TEST_P(Shapes, ReproduceLinearFieldsIn2D) {
    check_linear_fields<2>(GetParam(), 1, 1, 300);
    check_linear_fields<2>(GetParam(), 0.7, 1.4, 300);
}

TEST_P(Shapes, ReproduceLinearFieldsIn3D) {
    check_linear_fields<3>(GetParam(), 1, 1, 100);
    check_linear_fields<3>(GetParam(), 0.7, 1.4, 100);
}

TEST_P(Shapes, ReproduceLinearFieldsWhenStretchedFromATenthToEightTimesAndTurned) {
    check_linear_fields<2>(GetParam(), 0.1, 8, 300);
    check_linear_fields<3>(GetParam(), 0.1, 8, 60);
}

template <int D>
void check_expand_is_fill(ShapeKind kind) {
    std::mt19937 random(10 + D);
    const Grid<D> grid = some_grid<D>();
    with_shape(kind, [&](auto shape) {
        if constexpr (!decltype(shape)::stored)
            for (int trial = 0; trial < 200; ++trial) {
                const Particle<D> p(random, grid);
                const Filled<D> a = filled<false>(shape, grid, p.domain());
                const Filled<D> b = expanded(shape, grid, p.domain());
                ASSERT_LE(a.entries, b.entries);
                for (int k = 0; k < a.window.size(); ++k) {
                    ASSERT_TRUE(b.contains(a.node(k)));
                    const int same = b.window.local(a.node(k));
                    EXPECT_NEAR(a.S[k], b.S[same], 2e-14);
                    // Differences of values near 1 over twice the half size.
                    EXPECT_LT((a.G[k] - b.G[same]).norm(), 1e-14 / p.half_size.minCoeff());
                }
            }
    });
}

TEST_P(Shapes, ExpandOnTheSpotAsTheyFillTheStore) {
    check_expand_is_fill<2>(GetParam());
    check_expand_is_fill<3>(GetParam());
}

/// G = ∂S/∂X where the shape is averaged over a domain that moves with the particle.
template <int D>
void check_gradient_by_differences(ShapeKind kind) {
    std::mt19937 random(20 + D);
    const Grid<D> grid = some_grid<D>();
    const double h = 1e-5;
    int compared = 0;
    with_shape(kind, [&](auto shape) {
        for (int trial = 0; trial < 100; ++trial) {
            Particle<D> p(random, grid);
            p.F = stretched_and_turned<D>(random, 0.6, 1.6);
            const Filled<D> here = filled<false>(shape, grid, p.domain());
            for (int a = 0; a < D; ++a) {
                Particle<D> up = p;
                Particle<D> down = p;
                up.position[a] += h;
                down.position[a] -= h;
                const Filled<D> after = filled<false>(shape, grid, up.domain());
                const Filled<D> before = filled<false>(shape, grid, down.domain());
                if (!(after.window == here.window) || !(before.window == here.window)) continue; // across a kink
                ++compared;
                // A kink of the slope inside the domain moves by h: an error of h over the (smallest) domain.
                const double tolerance = is_point(kind) ? 1e-9 : 40 * h / p.half_size.minCoeff();
                for (int k = 0; k < here.window.size(); ++k)
                    EXPECT_NEAR(here.G[k][a], (after.S[k] - before.S[k]) / (2 * h), tolerance);
            }
        }
    });
    EXPECT_GT(compared, 90 * D);
}

/// Not of CPDI, whose gradients are those of the interpolated functions (see shape_definitions.cpp).
TEST(ShapesButCpdi, GradientsAreDerivativesOfTheShapeFunctions) {
    for (const ShapeKind kind : all_shapes) {
        if (is_convected(kind)) continue;
        SCOPED_TRACE(name_of(kind));
        check_gradient_by_differences<2>(kind);
        check_gradient_by_differences<3>(kind);
    }
}

/// Domains at the faces and corners of the scene's box, deformed: the margin holds all nodes that they see.
template <int D>
void check_edges_of_the_grid(ShapeKind kind) {
    std::mt19937 random(30 + D);
    std::uniform_int_distribution<int> face(0, 2);
    const Grid<D> grid = some_grid<D>();
    with_shape(kind, [&](auto shape) {
        for (int trial = 0; trial < 300; ++trial) {
            Particle<D> p(random, grid);
            for (int a = 0; a < D; ++a) {
                const int side = face(random);
                if (side < 2) p.position[a] = side == 0 ? grid.lower()[a] : grid.upper()[a];
                p.half_size[a] = 0.25 * grid.length();
            }
            p.F = stretched_and_turned<D>(random, 0.3, 2.5);
            const Filled<D> f = filled<false>(shape, grid, p.domain());
            for (int a = 0; a < D; ++a) {
                EXPECT_GE(f.window.lower[a], 0);
                EXPECT_LE(f.window.upper[a], grid.cells[a] + 2 * grid_margin);
            }
            expect_linear_fields<D>(grid, p.position, f);
        }
    });
}

TEST_P(Shapes, StayInTheGridAtTheFacesOfTheBox) {
    check_edges_of_the_grid<2>(GetParam());
    check_edges_of_the_grid<3>(GetParam());
}

TEST_P(Shapes, StayInTheWindowWithCornersExactlyOnGridLines) {
    // Cells of all sizes, quarters of cells: corners on lines up to round-off.
    std::mt19937 random(40);
    std::uniform_real_distribution<double> in(0.1, 1);
    with_shape(GetParam(), [&](auto shape) {
        for (int i = 0; i < 3000; ++i) {
            Grid<2> grid = some_grid<2>();
            for (int a = 0; a < 2; ++a) {
                grid.cell[a] = in(random);
                grid.inverse_cell[a] = 1 / grid.cell[a];
                grid.origin[a] = in(random)-0.5;
            }
            const Vec<2> x =
                grid.origin + Vec<2>((40 + i % 61) * 0.125 * grid.cell[0], (40 + i % 17) * 0.125 * grid.cell[1]);
            const Mat<2> F = Mat<2>::Identity();
            const Vec<2> half = 0.125 * (1 + i % 4) * grid.cell;
            expect_linear_fields<2>(grid, x, filled<false>(shape, grid, Domain<2>{x, F, half}));
            if constexpr (!decltype(shape)::stored)
                expect_linear_fields<2>(grid, x, expanded(shape, grid, Domain<2>{x, F, half}));
        }
    });
}

INSTANTIATE_TEST_SUITE_P(All, Shapes, testing::ValuesIn(all_shapes),
                         [](const auto& shape) { return std::string(name_of(shape.param)); });

TEST(ShapesTogether, SmallDomainsBecomePoints) {
    // A domain of 1e-4 cells: averaged, convected and point shapes of one grid function agree to its square.
    std::mt19937 random(50);
    const Grid<3> grid = some_grid<3>();
    const auto check = [&](auto point, auto average, auto convected) {
        for (int trial = 0; trial < 50; ++trial) {
            Particle<3> p(random, grid);
            p.half_size = 1e-4 * grid.cell;
            const Filled<3> a = filled<false>(point, grid, p.domain());
            for (const Filled<3>& b :
                 {filled<false>(average, grid, p.domain()), filled<false>(convected, grid, p.domain())}) {
                if (!(a.window == b.window)) continue;
                for (int k = 0; k < a.window.size(); ++k) {
                    EXPECT_NEAR(a.S[k], b.S[k], 1e-7);
                    EXPECT_LT((a.G[k] - b.G[k]).norm(), 1e-6);
                }
            }
        }
    };
    check(LinearShape{}, GimpShape{}, CpdiShape{});
    check(B2splineShape{}, B2gimpShape{}, B2cpdiShape{});
}

TEST(ShapesTogether, GimpOfAnUndeformedOrTurnedSquareParticleIsUgimp) {
    std::mt19937 random(51);
    const Grid<2> grid = some_grid<2>();
    for (int trial = 0; trial < 100; ++trial) {
        Particle<2> p(random, grid);
        p.half_size.setConstant(0.2 * grid.length());
        if (trial > 50) p.F = random_rotation<2>(random); // the variance of a square is that of a disk
        const Filled<2> a = filled<false>(GimpShape{}, grid, p.domain());
        const Filled<2> b = filled<false>(UgimpShape{}, grid, p.domain());
        for (int k = 0; k < a.window.size(); ++k) {
            if (!b.contains(a.node(k))) {
                EXPECT_NEAR(a.S[k], 0, 1e-14);
                continue;
            }
            EXPECT_NEAR(a.S[k], b.S[b.window.local(a.node(k))], 1e-14);
            EXPECT_LT((a.G[k] - b.G[b.window.local(a.node(k))]).norm(), 1e-12);
        }
    }
}

} // namespace
