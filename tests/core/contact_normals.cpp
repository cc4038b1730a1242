#include "support.h"

#include "contact/normal/logistic_regression.h"

#include <Eigen/Dense>

namespace {

using namespace test;

/// Eq. (20), (21) and the appendix of the contact paper in plain dense algebra, with the damping that the comment of
/// iterate() describes.
template <int D>
Regression<D> scalar_twin(const Cloud<D>& cloud) {
    constexpr int N = D + 1;
    using Row = Eigen::Matrix<double, 1, N>;
    Eigen::MatrixXd X(cloud.size, N);
    Eigen::VectorXd c(cloud.size);
    for (int p = 0; p < cloud.size; ++p) {
        for (int a = 0; a < D; ++a) X(p, a) = cloud.x[a][p / 4][p % 4];
        X(p, D) = 1;
        c[p] = cloud.c[p / 4][p % 4];
    }
    Eigen::Matrix<double, N, 1> phi = Eigen::Matrix<double, N, 1>::Zero();
    Regression<D> result;
    for (int k = 0; k < 15; ++k) {
        Eigen::MatrixXd J(cloud.size, N);
        Eigen::VectorXd f(cloud.size);
        double psi_squares = 0;
        for (int p = 0; p < cloud.size; ++p) {
            const double e = std::exp(-X.row(p).dot(phi.transpose()));
            f[p] = 2 / (1 + e) - 1;
            const double psi = 2 * e / ((1 + e) * (1 + e));
            J.row(p) = psi * Row(X.row(p));
            psi_squares += psi * psi;
        }
        Eigen::Matrix<double, N, N> Lambda = Eigen::Matrix<double, N, N>::Zero();
        Eigen::Matrix<double, N, N> damping = Lambda;
        for (int a = 0; a < D; ++a) {
            Lambda(a, a) = 1e-7;
            damping(a, a) = cloud.spread * psi_squares;
        }
        phi += (J.transpose() * J + Lambda + damping).ldlt().solve(J.transpose() * (c - f) - Lambda * phi);
        const Vec<D> previous = result.normal;
        result.normal = phi.template head<D>().normalized();
        ++result.iterations;
        if (k > 0 && 1 - result.normal.dot(previous) < 1e-5) break;
    }
    result.found = true;
    return result;
}

/// Points of two classes on both sides of a plane, at least `gap`/2 from it.
template <int D>
Cloud<D> separable(std::mt19937& random, int n, const Vec<D>& normal, double gap) {
    std::uniform_real_distribution<double> in(-1.2, 1.2);
    Cloud<D> cloud;
    cloud.spread = 0.25 * 0.25 / 3;
    for (int p = 0; p < n; ++p) {
        const double side = p % 2 ? 1 : -1;
        Vec<D> x;
        do
            for (int a = 0; a < D; ++a) x[a] = in(random);
        while (side * x.dot(normal) < gap / 2);
        cloud.add(x, side, p);
    }
    return cloud;
}

template <int D>
Vec<D> random_direction(std::mt19937& random) {
    std::normal_distribution<double> in;
    Vec<D> n;
    for (int a = 0; a < D; ++a) n[a] = in(random);
    return n.normalized();
}

template <int D>
void compare_with_twin(int seed) {
    std::mt19937 random(seed);
    for (int trial = 0; trial < 300; ++trial) {
        const Cloud<D> cloud = separable<D>(random, 6 + trial % 35, random_direction<D>(random), 0.01 * (trial % 50));
        const Regression<D> fast = logistic_regression(cloud);
        const Regression<D> plain = scalar_twin(cloud);
        ASSERT_TRUE(fast.found);
        EXPECT_EQ(fast.iterations, plain.iterations);
        EXPECT_LT((fast.normal - plain.normal).norm(), 1e-9) << "trial " << trial;
    }
}

TEST(LogisticRegression, EqualsItsScalarTwin) {
    compare_with_twin<2>(1);
    compare_with_twin<3>(2);
}

/// Smallest distance along n from a point of class -1 to one of class +1; positive: a plane across n separates them.
double gap_along(const Cloud<2>& cloud, const Vec<2>& n) {
    double below = -1e9;
    double above = 1e9;
    for (int p = 0; p < cloud.size; ++p) {
        const double x = Vec<2>(cloud.x[0][p / 4][p % 4], cloud.x[1][p / 4][p % 4]).dot(n);
        if (cloud.c[p / 4][p % 4] < 0)
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
    int p = 0;
    for (int i = 0; i < columns; ++i) {
        const double x = 0.5 * (i - 0.5 * (columns - 1));
        for (int j = 0; j < rows_below; ++j) cloud.add(Q * Vec<2>(x, height - 0.25 - 0.5 * j), -1, p++);
        for (int j = 0; j < rows_above; ++j) cloud.add(Q * Vec<2>(x, height + 0.25 + 0.5 * j), 1, p++);
    }
    return cloud;
}

TEST(LogisticRegression, IsExactForSymmetricClouds) {
    for (const double angle : {0.0, 0.3, M_PI / 4, M_PI / 2, 2.0, M_PI, -1.0})
        for (const double height : {0.0, 0.2, -0.4})
            for (const int above : {1, 2, 4}) {
                const Regression<2> r = logistic_regression(lattice(angle, height, 4, 3, above));
                ASSERT_TRUE(r.found);
                EXPECT_LT((r.normal - Vec<2>(-std::sin(angle), std::cos(angle))).norm(), 1e-13)
                    << angle << " " << height << " " << above;
            }
}

TEST(LogisticRegression, TurnsRoundWithTheClasses) {
    std::mt19937 random(4);
    const Cloud<2> cloud = separable<2>(random, 17, random_direction<2>(random), 0.3);
    Cloud<2> swapped;
    swapped.spread = cloud.spread;
    for (int p = 0; p < cloud.size; ++p)
        swapped.add({cloud.x[0][p / 4][p % 4], cloud.x[1][p / 4][p % 4]}, -cloud.c[p / 4][p % 4], p);
    EXPECT_LT((logistic_regression(cloud).normal + logistic_regression(swapped).normal).norm(), 1e-13);
}

/// Nodes beside the free sides of two bodies see one column of particles, nearly in line: the comment of iterate().
TEST(LogisticRegression, OfANearlyCollinearColumnIsAcrossTheGap) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> noise(-0.02, 0.02);
    for (int trial = 0; trial < 200; ++trial) {
        Cloud<2> cloud;
        cloud.spread = 0.25 * 0.25 / 3;
        for (int j = 0; j < 3; ++j) cloud.add(Vec<2>(0.8 + noise(random), -0.25 - 0.5 * j + noise(random)), -1, j);
        for (int j = 0; j < 3; ++j) cloud.add(Vec<2>(0.8 + noise(random), 0.25 + 0.5 * j + noise(random)), 1, 3 + j);
        const Regression<2> r = logistic_regression(cloud);
        ASSERT_TRUE(r.found);
        EXPECT_GT(r.normal[1], std::cos(0.15)) << "trial " << trial;
    }
}

/// Whatever the cloud: a unit normal, or none.
template <int D>
void check_sound(const Cloud<D>& cloud, const char* what) {
    const Regression<D> r = logistic_regression(cloud);
    EXPECT_TRUE(r.normal.allFinite()) << what;
    EXPECT_LE(r.iterations, 15) << what;
    const double length = r.normal.norm();
    EXPECT_NEAR(length, r.found || length > 0 ? 1 : 0, 1e-12) << what;
}

TEST(LogisticRegression, NeverGivesNonsense) {
    std::mt19937 random(6);
    std::uniform_real_distribution<double> in(-1, 1);
    std::bernoulli_distribution coin;
    const auto cloud_of = [](std::initializer_list<std::array<double, 3>> points, double spread) {
        Cloud<2> cloud;
        cloud.spread = spread;
        int p = 0;
        for (const auto& [x, y, c] : points) cloud.add(Vec<2>(x, y), c, p++);
        return cloud;
    };
    for (const double spread : {0.0, 0.02}) {
        check_sound(cloud_of({{0, -0.3, -1}, {0.1, 0.4, 1}}, spread), "one particle a class");
        check_sound(cloud_of({{0.3, 0.3, -1}, {0.3, 0.3, 1}}, spread), "two in one place");
        check_sound(cloud_of({{0, 0, -1}, {0, 0, 1}}, spread), "two at the node");
        check_sound(cloud_of({{0, -1, -1}, {0, -0.5, -1}, {0, 0.5, 1}, {0, 1, 1}}, spread), "collinear");
        check_sound(cloud_of({{-1, 0, -1}, {-0.5, 0, 1}, {0.5, 0, -1}, {1, 0, 1}}, spread), "collinear, mixed");
        check_sound(cloud_of({{0.1, -1, -1}, {0.2, -0.5, -1}, {0.3, 0.2, -1}, {0.4, 1, 1}}, spread), "one single");
        check_sound(cloud_of({{0.1, -1, -1}, {0.2, -0.5, -1}, {0.3, 0.2, -1}}, spread), "one class");
        check_sound(cloud_of({{0.1, -1, -1}}, spread), "one particle");
        check_sound(cloud_of({}, spread), "none");
        check_sound(cloud_of({{0, -900, -1}, {1, -901, -1}, {0, 900, 1}, {1, 901, 1}}, spread), "far apart");
        check_sound(cloud_of({{1e-9, 0, -1}, {0, 1e-9, 1}, {-1e-9, 0, 1}}, spread), "very near");
        check_sound(cloud_of({{1, 1, -1}, {1, 1, -1}, {1, 1, 1}, {1, 1, 1}, {1, 1, 1}}, spread), "all in one place");
    }
    for (int trial = 0; trial < 4000; ++trial) {
        Cloud<2> plane;
        Cloud<3> space;
        plane.spread = space.spread = trial % 3 ? 0.02 : 0;
        for (int p = 0, n = 2 + trial % 39; p < n; ++p) {
            const double c = coin(random) ? 1 : -1;
            plane.add(Vec<2>(in(random), in(random)), c, p);
            space.add(Vec<3>(in(random), in(random), in(random)), c, p);
        }
        check_sound(plane, "random in the plane");
        check_sound(space, "random in space");
    }
}

TEST(LogisticRegression, OfOneParticleAClassPointsFromOneToTheOther) {
    Cloud<2> cloud;
    cloud.spread = 0.02;
    cloud.add(Vec<2>(0.1, -0.3), -1, 0);
    cloud.add(Vec<2>(0.4, 0.5), 1, 1);
    const Regression<2> r = logistic_regression(cloud);
    ASSERT_TRUE(r.found);
    EXPECT_LT((r.normal - Vec<2>(0.3, 0.8).normalized()).norm(), 1e-6);
}

} // namespace
