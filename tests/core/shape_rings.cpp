/// Stencils of axisymmetric particles: weighed by the radius (Nairn, Guilkey, IJNME 101 (2015)). Their definitions are
/// in shape_definitions.cpp.

#include "shapes.h"

namespace {

using namespace test;

class Rings : public testing::TestWithParam<ShapeKind> {};

/// A grid whose r = 0 is its node 4, as the scenes' margin makes it, and particles from next to the axis to far out.
Grid<2> ring_grid() {
    Grid<2> grid = some_grid<2>();
    grid.origin[0] = -grid_margin * grid.cell[0];
    return grid;
}

template <class Work>
void for_some_rings(ShapeKind kind, int seed, Work&& work) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> in(0, 1);
    const Grid<2> grid = ring_grid();
    with_shape(kind, [&](auto shape) {
        for (int trial = 0; trial < 300; ++trial) {
            Particle<2> p(random, grid);
            if (deforms(kind)) p.F = stretched_and_turned<2>(random, 0.5, 2);
            Vec<2> reach = p.half_size;
            if (kind == ShapeKind::gimp) reach = CurrentBox::of(p.domain());
            if (is_convected(kind)) reach = p.F.cwiseAbs() * p.half_size;
            // Every third one touches the axis.
            p.position[0] = reach[0] + (trial % 3 ? 5 * in(random) : 0);
            work(grid, p, filled<true>(shape, grid, p.domain()));
        }
    });
}

TEST_P(Rings, HoopStrainOfAUniformExpansionIsExact) {
    for_some_rings(GetParam(), 1, [](const Grid<2>& grid, const Particle<2>& p, const Filled<2>& f) {
        double S = 0, T = 0, hoop = 0;
        Vec<2> G(0, 0);
        Mat<2> gradient = Mat<2>::Zero();
        double scale = 1;
        for (int k = 0; k < f.window.size(); ++k) {
            const Vec<2> x = grid.node_position(f.node(k)); // r, z
            S += f.S[k];
            T += f.T[k];
            hoop += f.T[k] * x[0];
            G += f.G[k];
            gradient += x * f.G[k].transpose();
            scale += f.G[k].norm() * (1 + x.norm());
            EXPECT_GE(f.S[k], -1e-14);
            EXPECT_GE(f.T[k], -1e-14);
        }
        EXPECT_NEAR(S, 1, 1e-12);
        EXPECT_NEAR(T, 1 / p.position[0], 1e-12 / p.position[0]);
        EXPECT_NEAR(hoop, 1, 1e-12) << "v_r = c r stretches rings by c";
        EXPECT_LT(G.norm(), 1e-13 * scale);
        EXPECT_LT((gradient - Mat<2>::Identity()).norm(), 1e-13 * scale);
    });
}

TEST_P(Rings, MassIsCentredWhereTheRingsAre) {
    // Σ S r_i = ∫ r² / ∫ r: R for points, R + variance / R for domains.
    for_some_rings(GetParam(), 2, [&](const Grid<2>& grid, const Particle<2>& p, const Filled<2>& f) {
        const Mat<2> A = p.F * Mat<2>(p.half_size.asDiagonal());
        double variance = current_box<2>(A)[0];
        if (!deforms(GetParam())) variance = p.half_size[0];
        if (is_point(GetParam())) variance = 0;
        variance *= variance / 3;
        double r = 0;
        for (int k = 0; k < f.window.size(); ++k) r += f.S[k] * grid.node_position(f.node(k))[0];
        EXPECT_NEAR(r, p.position[0] + variance / p.position[0], 1e-12);
    });
}

TEST_P(Rings, FarFromTheAxisTheyArePlaneParticles) {
    Grid<2> grid = some_grid<2>();
    grid.origin[0] = 1e6;
    std::mt19937 random(3);
    with_shape(GetParam(), [&](auto shape) {
        for (int trial = 0; trial < 50; ++trial) {
            Particle<2> p(random, grid);
            p.F = stretched_and_turned<2>(random, 0.5, 2);
            const Filled<2> plane = filled<false>(shape, grid, p.domain());
            const Filled<2> ring = filled<true>(shape, grid, p.domain());
            for (int k = 0; k < plane.window.size(); ++k) {
                EXPECT_NEAR(ring.S[k], plane.S[k], 1e-6);
                EXPECT_LT((ring.G[k] - plane.G[k]).norm(), 1e-5);
                EXPECT_NEAR(ring.T[k], 0, 2e-6);
            }
        }
    });
}

/// Σ_p V_p (G_r + T) = 2π ∫ ∂(N r)/∂r dA: uniform pressure in a region pushes only at its boundary. Points have no
/// domains that would fill it.
void check_filled_tube(ShapeKind kind) {
    const Grid<2> grid = ring_grid();
    const int first = grid_margin + 2; // tube between nodes 2 and 8 from the axis
    with_shape(kind, [&](auto shape) {
        std::vector<Vec<2>> force(32 * 32, Vec<2>::Zero());
        double largest = 0;
        for (int j = 0; j < 12; ++j)
            for (int i = 0; i < 12; ++i) {
                const Vec<2> half = 0.25 * grid.cell;
                const Vec<2> x =
                    grid.node_position({first, first}) + Vec<2>((2 * i + 1) * half[0], (2 * j + 1) * half[1]);
                const Mat<2> F = Mat<2>::Identity();
                const Filled<2> f = filled<true>(shape, grid, Domain<2>{x, F, half});
                for (int k = 0; k < f.window.size(); ++k) {
                    const Vec<2> push = x[0] * (f.G[k] + Vec<2>(f.T[k], 0));
                    force[f.node(k)[1] * 32 + f.node(k)[0]] += push;
                    largest = std::max(largest, push.norm());
                }
            }
        double inside = 0;
        double edge = 0;
        for (int j = 0; j < 32; ++j)
            for (int i = 0; i < 32; ++i) {
                const bool interior = i > first + 1 && i < first + 5 && j > first + 1 && j < first + 5;
                (interior ? inside : edge) = std::max(interior ? inside : edge, force[j * 32 + i].norm());
            }
        EXPECT_LT(inside, 1e-13 * largest);
        EXPECT_GT(edge, 0.1 * largest);
    });
}

TEST(FilledRings, UniformPressureInATubePushesNoNodeInside) {
    for (const ShapeKind kind : all_shapes) {
        if (is_point(kind)) continue;
        SCOPED_TRACE(name_of(kind));
        check_filled_tube(kind);
    }
}

INSTANTIATE_TEST_SUITE_P(All, Rings, testing::ValuesIn(all_shapes),
                         [](const auto& shape) { return std::string(name_of(shape.param)); });

} // namespace
