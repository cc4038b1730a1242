#include "clouds.h"

namespace {

using namespace test;

template <int D>
void compare_with_twin(int seed, const Method<D>& method, PlainTerms (*terms)(double, double), int most_iterations) {
    std::mt19937 random(seed);
    for (int trial = 0; trial < 600; ++trial) {
        const Cloud<D> cloud =
            trial % 2 ? mixed<D>(random, 4 + trial % 35)
                      : separable<D>(random, 6 + trial % 35, random_direction<D>(random), 0.01 * (trial % 50));
        const Regression<D> fast = method.solve(cloud);
        const Regression<D> plain = scalar_twin(cloud, terms, most_iterations);
        ASSERT_TRUE(fast.found);
        EXPECT_EQ(fast.iterations, plain.iterations);
        EXPECT_LT((fast.normal - plain.normal).norm(), 1e-9) << method.name << " trial " << trial;
    }
}

template <int D>
void compare_all_with_twins() {
    compare_with_twin<D>(1, regressions<D>[0], plain_logistic, 15);
    compare_with_twin<D>(2, regressions<D>[1], plain_logistic, 1); // φ = 0: linear
    compare_with_twin<D>(3, regressions<D>[2], plain_irls, 15);
}

TEST(Regressions, EqualTheirScalarTwins) {
    compare_all_with_twins<2>();
    compare_all_with_twins<3>();
}

/// Smallest distance along n from a point of class -1 to one of class +1; positive: a plane across n separates them.
double gap_along(const Cloud<2>& cloud, const Vec<2>& n) {
    double below = -1e9;
    double above = 1e9;
    for (int p = 0; p < cloud.size; ++p) {
        const double x = place(cloud, p).dot(n);
        if (class_of(cloud, p) < 0)
            below = std::max(below, x);
        else
            above = std::min(above, x);
    }
    return above - below;
}

TEST(LogisticRegression, FindsAPlaneBetweenTheClasses) {
    std::mt19937 random(3);
    for (int trial = 0; trial < 500; ++trial) {
        const Cloud<2> cloud = separable<2>(random, 4 + trial % 37, random_direction<2>(random), 0.5);
        const Regression<2> r = logistic_regression(cloud);
        ASSERT_TRUE(r.found);
        EXPECT_NEAR(r.normal.norm(), 1, 1e-14);
        EXPECT_GT(gap_along(cloud, r.normal), 0) << "trial " << trial;
    }
}

/// The regular cloud of an undeformed lattice on both sides of y = height, turned by an angle.
Cloud<2> lattice(double angle, double height, int columns, int rows_below, int rows_above) {
    Mat<2> Q;
    Q << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
    Cloud<2> cloud;
    cloud.spread = 0.25 * 0.25 / 3;
    for (int i = 0; i < columns; ++i) {
        const double x = 0.5 * (i - 0.5 * (columns - 1));
        for (int j = 0; j < rows_below; ++j) cloud.add(Q * Vec<2>(x, height - 0.25 - 0.5 * j), -1);
        for (int j = 0; j < rows_above; ++j) cloud.add(Q * Vec<2>(x, height + 0.25 + 0.5 * j), 1);
    }
    return cloud;
}

TEST(Regressions, AreExactForSymmetricClouds) {
    for (const double angle : {0.0, 0.3, M_PI / 4, M_PI / 2, 2.0, M_PI, -1.0})
        for (const double height : {0.0, 0.2, -0.4})
            for (const int above : {1, 2, 4}) {
                for (const Method<2>& method : regressions<2>) {
                    const Regression<2> r = method.solve(lattice(angle, height, 4, 3, above));
                    ASSERT_TRUE(r.found);
                    EXPECT_LT((r.normal - Vec<2>(-std::sin(angle), std::cos(angle))).norm(), 1e-13)
                        << method.name << angle << " " << height << " " << above;
                }
            }
}

/// Nodes beside the free sides of two bodies see one column of particles, nearly in line: the comment of iterate().
TEST(Regressions, OfANearlyCollinearColumnAreAcrossTheGap) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> noise(-0.02, 0.02);
    for (int trial = 0; trial < 200; ++trial) {
        Cloud<2> cloud;
        cloud.spread = 0.25 * 0.25 / 3;
        for (int j = 0; j < 3; ++j) cloud.add(Vec<2>(0.8 + noise(random), -0.25 - 0.5 * j + noise(random)), -1);
        for (int j = 0; j < 3; ++j) cloud.add(Vec<2>(0.8 + noise(random), 0.25 + 0.5 * j + noise(random)), 1);
        for (const Method<2>& method : regressions<2>) {
            const Regression<2> r = method.solve(cloud);
            ASSERT_TRUE(r.found);
            // The others tilt more: the reason for logistic regression by least squares.
            const double angle = method.solve == logistic_regression<2> ? 0.15 : 0.4;
            EXPECT_GT(r.normal[1], std::cos(angle)) << method.name << " trial " << trial;
        }
    }
}

} // namespace
