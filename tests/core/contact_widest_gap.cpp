/// The largest separation near a normal against a search of all directions.

#include "support.h"

#include "contact/separation/particle_edges.h"
#include "contact/separation/widest_gap.h"

#include <Eigen/Geometry>

namespace {

using namespace test;

template <int D>
struct Ellipsoid {
    Vec<D> x;
    Mat<D> F;
    Vec<D> half;
    bool side_a;
};

template <int D>
Gap<D> gap_along(const std::vector<Ellipsoid<D>>& all, const Vec<D>& n) {
    Edges edges;
    for (std::size_t p = 0; p < all.size(); ++p)
        edges.add(all[p].side_a, all[p].x.dot(n), edge_distance<D>(all[p].F, all[p].half, n), static_cast<int>(p));
    const Ellipsoid<D>& a = all[edges.last_a];
    const Ellipsoid<D>& b = all[edges.first_b];
    return {edges.b - edges.a, edge_point<D>(b.x, b.F, b.half, -n) - edge_point<D>(a.x, a.F, a.half, n)};
}

/// Two clouds of deformed particles on both sides of a plane, shifted so that the gap along its normal is `gap`.
template <int D>
std::vector<Ellipsoid<D>> clouds(std::mt19937& random, const Vec<D>& normal, double gap) {
    std::uniform_real_distribution<double> in(-1, 1);
    std::vector<Ellipsoid<D>> all;
    for (int p = 0; p < 24; ++p) {
        const bool side_a = p % 2 == 0;
        Vec<D> x;
        for (int a = 0; a < D; ++a) x[a] = in(random);
        x += ((side_a ? -1 : 1) * std::abs(in(random)) - x.dot(normal)) * normal;
        all.push_back({x, random_deformation<D>(random, 0.2), Vec<D>::Constant(0.2), side_a});
    }
    const double shift = gap - gap_along(all, normal).width;
    for (Ellipsoid<D>& e : all)
        if (!e.side_a) e.x += shift * normal;
    return all;
}

/// Largest over many normals that are turned by at most the tangent `turn` along each axis.
double by_search(const std::vector<Ellipsoid<2>>& all, const Vec<2>& n, double turn) {
    double best = -1e9;
    for (int i = -20000; i <= 20000; ++i) {
        const Vec<2> turned = (n + turn * i / 20000 * Vec<2>(-n[1], n[0])).normalized();
        best = std::max(best, gap_along(all, turned).width);
    }
    return best;
}
double by_search(const std::vector<Ellipsoid<3>>& all, const Vec<3>& n, double turn) {
    const Vec<3> t = n.unitOrthogonal();
    const Vec<3> s = n.cross(t);
    double best = -1e9;
    for (int i = -90; i <= 90; ++i)
        for (int j = -90; j <= 90; ++j)
            best = std::max(best, gap_along(all, Vec<3>((n + turn / 90 * (i * t + j * s)).normalized())).width);
    return best;
}

template <int D>
void compare(int trials, double share) {
    std::mt19937 random(1);
    int close = 0;
    for (int trial = 0; trial < trials; ++trial) {
        const Vec<D> n = random_rotation<D>(random).col(0);
        const auto all = clouds<D>(random, n, 0.04 * (trial % 3 - 1));
        const auto at = [&](const Vec<D>& m) { return gap_along(all, m); };
        const double first = at(n).width;
        const double found = widest_gap<D>(n, at(n), 1e-4, 10, at);
        EXPECT_GE(found, first) << "no worse than along the normal";
        // In the plane one line of tangent 0.1; in space up to three, one after the other.
        const double reach = D == 2 ? 0.1 : 0.3;
        EXPECT_LT(found, by_search(all, n, reach) + reach / 50) << "a gap that is there";
        const double best = by_search(all, n, 0.1);
        close += best < 0 ? found < 0 : found > best - 2e-3;
    }
    EXPECT_GE(close, share * trials);
}
TEST(WidestGap, EqualsASearchOfAllDirections) {
    compare<2>(60, 0.98);
    compare<3>(12, 0.5); // some lines along the steepest direction come close, not always to the end
}

TEST(WidestGap, StopsWhereBodiesAreApart) {
    std::mt19937 random(2);
    const Vec<2> n(0, 1);
    const auto all = clouds<2>(random, n, 0.3);
    int looks = 0;
    const auto at = [&](const Vec<2>& m) { return ++looks, gap_along(all, m); };
    EXPECT_NEAR(widest_gap<2>(n, gap_along(all, n), 1e-3, 0.05, at), 0.3, 1e-12);
    EXPECT_EQ(looks, 0);
}

TEST(WidestGap, EdgePointsAreOnTheEdge) {
    std::mt19937 random(3);
    for (int trial = 0; trial < 200; ++trial) {
        const Mat<3> F = random_deformation<3>(random, 0.5);
        const Vec<3> half(0.2, 0.3, 0.4);
        const Vec<3> n = random_rotation<3>(random).col(0);
        const Vec<3> place = edge_point<3>(Vec<3>::Zero(), F, half, n);
        EXPECT_NEAR(place.dot(n), edge_distance<3>(F, half, n), 1e-12);
        EXPECT_NEAR((F.inverse() * place).cwiseQuotient(half).norm(), 1, 1e-12);
    }
}

} // namespace
