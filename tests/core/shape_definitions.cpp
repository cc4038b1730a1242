/// Shapes against their definitions by quadrature (FMPM paper §2.1; see dense.h), and the grid functions.

#include "shapes.h"

namespace {

using namespace test;

/// S, G and T at every node around against the definition; outside the window the definition must give nothing.
/// \return the largest number of entries
template <int D, bool Ring>
int check_against_definition(ShapeKind kind, double smallest_stretch, double largest_stretch, int trials) {
    std::mt19937 random(100 + D + Ring);
    Grid<D> grid = some_grid<D>();
    if (Ring) grid.origin[0] = 0;
    int largest = 0;
    with_shape(kind, [&](auto shape) {
        for (int trial = 0; trial < trials; ++trial) {
            Particle<D> p(random, grid);
            if (deforms(kind))
                p.F = stretched_and_turned<D>(random, smallest_stretch, largest_stretch);
            else
                p.F = random_deformation<D>(random, 0.5); // must not matter
            const Filled<D> f = filled<Ring>(shape, grid, p.domain());
            largest = std::max(largest, f.entries);
            double scale = 1;
            for (const Vec<D>& G : f.G) scale = std::max(scale, G.norm());
            Window<D> around = f.window;
            for (int a = 0; a < D; ++a) {
                --around.lower[a];
                ++around.upper[a];
            }
            for_each_node(around, [&](const Index<D>& node) {
                const Weight<D> w = reference_weight<D>(kind, grid, p.domain(), node, Ring);
                const bool inside = f.contains(node);
                const int k = inside ? f.window.local(node) : 0;
                EXPECT_NEAR(inside ? f.S[k] : 0, w.S, 5e-14);
                EXPECT_LT(((inside ? f.G[k] : Vec<D>::Zero().eval()) - w.G).norm(), 2e-12 * scale);
                if (Ring) {
                    EXPECT_NEAR(inside ? f.T[k] : 0, w.T, 5e-14);
                }
            });
        }
    });
    return largest;
}

class ShapeDefinitions : public testing::TestWithParam<ShapeKind> {};

TEST_P(ShapeDefinitions, HoldInThePlane) {
    check_against_definition<2, false>(GetParam(), 0.7, 1.5, 100);
    const int entries = check_against_definition<2, false>(GetParam(), 0.2, 5, 100);
    // Stretched so far that the box around the domain has more nodes than the corners have.
    if (GetParam() == ShapeKind::cpdi) {
        EXPECT_EQ(entries, 16);
    }
    if (GetParam() == ShapeKind::b2cpdi) {
        EXPECT_EQ(entries, 36);
    }
}

TEST_P(ShapeDefinitions, HoldInSpace) {
    check_against_definition<3, false>(GetParam(), 0.7, 1.5, 20);
    const int entries = check_against_definition<3, false>(GetParam(), 0.4, 3, 10);
    if (GetParam() == ShapeKind::cpdi) {
        EXPECT_EQ(entries, 64);
    }
}

TEST_P(ShapeDefinitions, HoldForRings) {
    check_against_definition<2, true>(GetParam(), 0.7, 1.5, 100);
    check_against_definition<2, true>(GetParam(), 0.2, 5, 100);
}

INSTANTIATE_TEST_SUITE_P(All, ShapeDefinitions, testing::ValuesIn(all_shapes),
                         [](const auto& shape) { return std::string(name_of(shape.param)); });

/// CPDI once more, by what its gradient means: 1/V ∮ N n dl with N linear along the edges of the domain.
TEST(Convected, GradientIsABoundaryIntegral) {
    std::mt19937 random(110);
    const Grid<2> grid = some_grid<2>();
    const auto check = [&](auto shape, int degree) {
        for (int trial = 0; trial < 200; ++trial) {
            Particle<2> p(random, grid);
            p.F = stretched_and_turned<2>(random, 0.1, 8);
            const Mat<2> A = p.F * Mat<2>(p.half_size.asDiagonal());
            const Vec<2> corner[4] = {p.position - A.col(0) - A.col(1), p.position + A.col(0) - A.col(1),
                                      p.position + A.col(0) + A.col(1), p.position - A.col(0) + A.col(1)};
            const Filled<2> f = filled<false>(shape, grid, p.domain());
            for_each_node(f.window, [&](const Index<2>& node) {
                const auto N = [&](const Vec<2>& x) {
                    const Vec<2> t = grid.lattice_position(x);
                    return b_spline(degree, t[0] - node[0]) * b_spline(degree, t[1] - node[1]);
                };
                Vec<2> G = Vec<2>::Zero();
                double area = 0;
                double S = 0;
                for (int c = 0; c < 4; ++c) {
                    const Vec<2> a = corner[c];
                    const Vec<2> b = corner[(c + 1) % 4];
                    S += 0.25 * N(a);
                    G += 0.5 * (N(a) + N(b)) * Vec<2>(b[1] - a[1], a[0] - b[0]); // outward normal times length
                    area += 0.5 * (a - p.position).x() * (b - p.position).y() -
                            0.5 * (a - p.position).y() * (b - p.position).x();
                }
                EXPECT_NEAR(f.S[f.window.local(node)], S, 1e-14);
                EXPECT_LT((f.G[f.window.local(node)] - G / area).norm(), 1e-12 / A.norm() * 30);
            });
        }
    };
    check(CpdiShape{}, 1);
    check(B2cpdiShape{}, 2);
}

/// The box of finite GIMP has the variance of the deformed domain along each axis.
TEST(CurrentBoxOfGimp, HasTheVarianceOfTheDeformedDomain) {
    std::mt19937 random(111);
    const Grid<3> grid = some_grid<3>();
    std::uniform_real_distribution<double> in(-1, 1);
    Particle<3> p(random, grid);
    p.F = stretched_and_turned<3>(random, 0.3, 3);
    Vec<3> variance = Vec<3>::Zero();
    constexpr int samples = 400000;
    for (int i = 0; i < samples; ++i)
        variance += (p.F * p.half_size.cwiseProduct(Vec<3>(in(random), in(random), in(random)))).cwiseAbs2() / samples;
    const Vec<3> half = CurrentBox::of(p.domain());
    for (int a = 0; a < 3; ++a) EXPECT_NEAR(half[a] * half[a] / 3, variance[a], 0.01 * variance[a]);
    p.F = Vec<3>(0.5, 2, 3).asDiagonal();
    EXPECT_LT((CurrentBox::of(p.domain()) - p.F * p.half_size).norm(), 1e-15) << "pure stretch: the domain itself";
}

template <class Function>
void check_grid_function(int degree) {
    const double h = 1e-3;
    for (double t = -2.5; t <= 2.5; t += 0.0137) {
        EXPECT_NEAR(Function::value(t), b_spline(degree, t), 1e-15) << t;
        EXPECT_NEAR(Function::value(t), Function::value(-t), 1e-15);
        // ∫ over [t, t+h] by quadrature.
        double mean = 0;
        double mean_integral = 0;
        for (const auto& [x, weight] : quadrature(t, t + h)) {
            mean += weight * b_spline(degree, x);
            mean_integral += weight * Function::integral(x);
        }
        EXPECT_NEAR(Function::integral(t + h) - Function::integral(t), h * mean, 1e-15) << t;
        EXPECT_NEAR(Function::second_integral(t + h) - Function::second_integral(t), h * mean_integral, 2e-15) << t;
        // Partition of unity and nodes seen.
        const double x = t + 7.3;
        double w[Function::nodes];
        double dw[Function::nodes];
        Function::evaluate(x, w, dw);
        double sum = 0;
        double slope = 0;
        for (int i = 0; i < Function::nodes; ++i) {
            const double s = x - (Function::first_node(x) + i);
            EXPECT_NEAR(w[i], b_spline(degree, s), 1e-14);
            EXPECT_NEAR(dw[i], b_spline_slope(degree, s), 1e-13);
            sum += w[i];
            slope += dw[i];
        }
        EXPECT_NEAR(sum, 1, 1e-15);
        EXPECT_NEAR(slope, 0, 1e-14);
        EXPECT_NEAR(Function::value(x - (Function::first_node(x) - 1)), 0, 1e-15);
        EXPECT_NEAR(Function::value(x - (Function::first_node(x) + Function::nodes)), 0, 1e-15);
    }
    EXPECT_EQ(Function::integral(-3), 0);
    EXPECT_EQ(Function::second_integral(-3), 0);
    EXPECT_EQ(Function::integral(3), 1);
    EXPECT_NEAR(Function::second_integral(3), 3, 1e-15);
}

TEST(GridFunctions, ValueIntegralAndSecondIntegralBelongTogether) {
    check_grid_function<LinearFunction>(1);
    check_grid_function<SplineFunction>(2);
}

} // namespace
