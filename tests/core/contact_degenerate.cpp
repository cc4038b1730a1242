/// Clouds that have no clear plane, or none: every regression gives a sensible unit normal or none, never NaN.

#include "clouds.h"

namespace {

using namespace test;

/// Whatever the cloud: a unit normal, or none.
template <int D>
void check_sound(const Cloud<D>& cloud, const std::string& what) {
    for (const Method<D>& method : regressions<D>) {
        const Regression<D> r = method.solve(cloud);
        EXPECT_TRUE(r.normal.allFinite()) << method.name << ": " << what;
        EXPECT_LE(r.iterations, 15) << method.name << ": " << what;
        EXPECT_NEAR(r.normal.norm(), r.found ? 1 : 0, 1e-12) << method.name << ": " << what;
    }
}
template <int D>
void check_none(const Cloud<D>& cloud, const std::string& what) {
    for (const Method<D>& method : regressions<D>) {
        EXPECT_FALSE(method.solve(cloud).found) << method.name << ": " << what;
        EXPECT_TRUE(method.solve(cloud).normal.isZero(0)) << method.name << ": " << what;
    }
}
template <int D>
void check_normal(const Cloud<D>& cloud, const Vec<D>& normal, double tolerance, const std::string& what) {
    for (const Method<D>& method : regressions<D>) {
        const Regression<D> r = method.solve(cloud);
        EXPECT_TRUE(r.found) << method.name << ": " << what;
        EXPECT_LT((r.normal - normal).norm(), tolerance) << method.name << ": " << what;
    }
}

template <int D>
std::vector<Point<D>> random_points(std::mt19937& random, int n, double scale, const Vec<D>& centre, double c) {
    std::uniform_real_distribution<double> in(-scale, scale);
    std::vector<Point<D>> points;
    for (int p = 0; p < n; ++p) {
        Vec<D> x = centre;
        for (int a = 0; a < D; ++a) x[a] += in(random);
        points.push_back({x, c});
    }
    return points;
}
template <int D>
std::vector<Point<D>> both(std::vector<Point<D>> a, const std::vector<Point<D>>& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

template <int D>
void check_two_points() {
    std::mt19937 random(1);
    for (int trial = 0; trial < 200; ++trial) {
        const auto points = both(random_points<D>(random, 1, 1.5, Vec<D>::Zero(), -1),
                                 random_points<D>(random, 1, 1.5, Vec<D>::Zero(), 1));
        const Vec<D> line = (points[1].x - points[0].x).normalized();
        for (const double spread : {0.0, 0.02}) check_normal(cloud_of(points, spread), line, 1e-5, "two points");
    }
}
TEST(DegenerateClouds, TwoPointsGiveTheLineBetweenThem) {
    check_two_points<2>();
    check_two_points<3>();
}

template <int D>
void check_collinear() {
    std::mt19937 random(2);
    std::uniform_real_distribution<double> in(0.05, 1.5);
    for (int trial = 0; trial < 200; ++trial) {
        const Vec<D> line = random_direction<D>(random);
        Cloud<D> cloud;
        cloud.spread = trial % 2 ? 0.02 : 0;
        for (int p = 0; p < 1 + trial % 5; ++p) cloud.add(-in(random)*line, -1);
        for (int p = 0; p < 1 + trial / 5 % 5; ++p) cloud.add(in(random)*line, 1);
        check_normal(cloud, line, 1e-5, "collinear");
    }
}
TEST(DegenerateClouds, CollinearPointsGiveTheirLine) {
    check_collinear<2>();
    check_collinear<3>();
}

template <int D>
void check_one_class() {
    std::mt19937 random(3);
    check_none(Cloud<D>(), "no particle");
    for (int n = 1; n < 30; ++n)
        for (const double c : {-1.0, 1.0})
            for (const double spread : {0.0, 0.02})
                check_none(cloud_of(random_points<D>(random, n, 1, Vec<D>::Zero(), c), spread), "one class");
}
TEST(DegenerateClouds, OneClassHasNoPlane) {
    check_one_class<2>();
    check_one_class<3>();
}

template <int D>
void check_coincident() {
    std::mt19937 random(4);
    for (int trial = 0; trial < 300; ++trial) {
        const double spread = trial % 2 ? 0.02 : 0;
        // Both classes in the same places: nothing to choose a side by.
        auto points = random_points<D>(random, 1 + trial % 12, 1, Vec<D>::Zero(), -1);
        const auto a = points;
        for (Point<D> point : a) points.push_back({point.x, 1});
        check_none(cloud_of(points, spread), "both classes in the same places");
        // All in one place, in any number.
        std::vector<Point<D>> heap(2 + trial % 17, {a[0].x, -1});
        for (std::size_t p = 0; p <= heap.size() / 2; ++p) heap[p].c = 1;
        check_none(cloud_of(heap, spread), "all in one place");
        // Some points twice: as good as any cloud.
        auto twice = both(random_points<D>(random, 3, 1, Vec<D>::Constant(-1), -1),
                          random_points<D>(random, 3, 1, Vec<D>::Constant(1), 1));
        twice = both(twice, twice);
        check_sound(cloud_of(twice, spread), "points twice");
        // One pair in the same place among others.
        twice.push_back({twice[0].x, 1});
        check_sound(cloud_of(twice, spread), "a coincident pair of both classes");
    }
}
TEST(DegenerateClouds, CoincidentPointsGiveNoNonsense) {
    check_coincident<2>();
    check_coincident<3>();
}

/// One side with few particles: the normal still leads from one side to the other.
template <int D>
void check_nearly_empty() {
    std::mt19937 random(5);
    for (int trial = 0; trial < 300; ++trial) {
        const Vec<D> n = random_direction<D>(random);
        const auto points = both(random_points<D>(random, 3 + trial % 30, 0.5, -0.8 * n, -1),
                                 random_points<D>(random, 1 + trial % 2, 0.1, 0.9 * n, 1));
        for (const Method<D>& method : regressions<D>) {
            const Regression<D> r = method.solve(cloud_of(points, 0.02));
            ASSERT_TRUE(r.found);
            EXPECT_GT(r.normal.dot(n), method.solve == linear_regression<D> ? 0.25 : 0.5)
                << method.name << " trial " << trial;
        }
    }
}
TEST(DegenerateClouds, OneSideNearlyEmpty) {
    check_nearly_empty<2>();
    check_nearly_empty<3>();
}

/// Separable clouds have no finite solution without the penalty; the direction converges.
template <int D>
void check_far_apart() {
    std::mt19937 random(6);
    for (const double distance : {3.0, 30.0, 300.0, 3e3}) {
        const Vec<D> n = random_direction<D>(random);
        const auto points = both(random_points<D>(random, 8, 0.5, -distance * n, -1),
                                 random_points<D>(random, 8, 0.5, distance * n, 1));
        for (const Method<D>& method : regressions<D>) {
            const Regression<D> r = method.solve(cloud_of(points, 0.02));
            ASSERT_TRUE(r.found);
            EXPECT_GT(r.normal.dot(n), std::cos(0.4)) << method.name << " " << distance;
        }
    }
}
TEST(DegenerateClouds, SeparableToInfinity) {
    check_far_apart<2>();
    check_far_apart<3>();
}

template <int D>
void check_extremes() {
    std::mt19937 random(7);
    for (const double scale : {0.0, 1e-300, 1e-160, 1e-20, 1e-9, 1e-4, 1e4, 1e9, 1e20, 1e160, 1e300})
        for (int trial = 0; trial < 60; ++trial)
            for (const double spread : {0.0, 0.02}) {
                auto points = both(random_points<D>(random, 1 + trial % 9, scale, Vec<D>::Zero(), -1),
                                   random_points<D>(random, 1 + trial % 7, scale, Vec<D>::Zero(), 1));
                check_sound(cloud_of(points, spread), "scale " + std::to_string(scale));
                points = both(points, random_points<D>(random, 4, 1, Vec<D>::Zero(), trial % 2 ? 1 : -1));
                check_sound(cloud_of(points, spread), "mixed with scale " + std::to_string(scale));
                for (Point<D>& point : points) point.x += Vec<D>::Constant(1e6);
                check_sound(cloud_of(points, spread), "far from the node, scale " + std::to_string(scale));
            }
    Cloud<D> broken = mixed<D>(random, 9);
    broken.x[0][6] = std::numeric_limits<double>::quiet_NaN();
    check_none(broken, "NaN in, nothing out");
}
TEST(DegenerateClouds, HugeAndTinyCoordinates) {
    check_extremes<2>();
    check_extremes<3>();
}

/// Sum of the angles' cosines that swapping the classes or turning the cloud leaves away from the right ones; the last
/// iteration may be one more or less when the tolerance is just met.
template <int D>
void check_symmetries() {
    std::mt19937 random(8);
    for (int trial = 0; trial < 400; ++trial) {
        const Cloud<D> cloud = trial % 2 ? mixed<D>(random, 3 + trial % 40)
                                         : separable<D>(random, 3 + trial % 40, random_direction<D>(random), 0.3);
        check_sound(cloud, "random");
        const Mat<D> Q = random_rotation<D>(random);
        const Cloud<D> swapped = changed<D>(cloud, [](Point<D> p) { return Point<D>{p.x, -p.c}; });
        const Cloud<D> turned = changed<D>(cloud, [&](Point<D> p) { return Point<D>{Q * p.x, p.c}; });
        const Cloud<D> mirrored = changed<D>(cloud, [](Point<D> p) { return Point<D>{-p.x, p.c}; });
        for (const Method<D>& method : regressions<D>) {
            const Regression<D> r = method.solve(cloud);
            EXPECT_LT((method.solve(swapped).normal + r.normal).norm(), 1e-12) << method.name << " " << trial;
            EXPECT_LT((method.solve(mirrored).normal + r.normal).norm(), 1e-12) << method.name << " " << trial;
            const Regression<D> t = method.solve(turned);
            if (t.iterations == r.iterations) {
                EXPECT_LT((t.normal - Q * r.normal).norm(), 1e-7) << method.name << " " << trial;
            }
        }
        // Least squares: φ is the covariance's inverse times the difference of the means, so it points the same way.
        Vec<D> difference = Vec<D>::Zero();
        for (int p = 0; p < cloud.size; ++p)
            difference += class_of(cloud, p) < 0 ? Vec<D>(-place(cloud, p) / (cloud.size - cloud.size_b))
                                                 : Vec<D>(place(cloud, p) / cloud.size_b);
        EXPECT_GT(linear_regression(cloud).normal.dot(difference), 0) << trial;
    }
}
TEST(Regressions, TurnWithTheCloudAndItsClasses) {
    check_symmetries<2>();
    check_symmetries<3>();
}

} // namespace
