#include "results/interpenetration.h"

#include "support.h"

#include <Eigen/Dense>

namespace {

using namespace test;

struct Piece {
    int body;
    Vec<2> x;
    Mat<2> F = Mat<2>::Identity();
    Vec<2> half = {0.5, 0.5};
};

Particles<2> particles_of(const std::vector<Piece>& pieces) {
    Particles<2> particles;
    for (const Piece& p : pieces) {
        particles.position.push_back(p.x);
        particles.deformation_gradient.push_back(p.F);
        particles.half_size.push_back(p.half);
        particles.body.push_back(p.body);
        particles.id.push_back(static_cast<int>(particles.id.size()));
    }
    return particles;
}

Mat<2> turn(double angle) {
    Mat<2> Q;
    Q << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
    return Q;
}

TEST(Interpenetration, OfSquares) {
    const Vec<2> o(0, 0);
    EXPECT_NEAR(interpenetration(particles_of({{0, o}, {1, {0.75, 0.5}}})).overlap, 0.125, 1e-15);
    EXPECT_NEAR(interpenetration(particles_of({{0, o}, {1, {0.75, 0.5}}})).total, 2, 1e-15);
    EXPECT_NEAR(interpenetration(particles_of({{0, o}, {1, {0.75, 0.5}}})).fraction(), 0.0625, 1e-15);
    EXPECT_EQ(interpenetration(particles_of({{0, o}, {1, {1, 0}}})).overlap, 0) << "edges only touch";
    EXPECT_EQ(interpenetration(particles_of({{0, o}, {1, {3, 0}}})).overlap, 0);
    EXPECT_EQ(interpenetration(particles_of({{0, o}, {0, {0.5, 0}}})).overlap, 0) << "of one body";
    EXPECT_NEAR(interpenetration(particles_of({{0, o}, {1, o}})).overlap, 1, 1e-15) << "the same square";
    EXPECT_NEAR(interpenetration(particles_of({{0, o}, {1, o, Mat<2>::Identity() * 0.5}})).overlap, 0.25, 1e-15);
    EXPECT_EQ(interpenetration(Particles<2>{}).fraction(), 0);
    // Three bodies: pairs add up.
    EXPECT_NEAR(interpenetration(particles_of({{0, o}, {1, {0.5, 0}}, {2, {0, 0.5}}})).overlap, 0.5 + 0.5 + 0.25,
                1e-15);
}

TEST(Interpenetration, OfTurnedSquares) {
    // A unit square and the same turned by 45°: a regular octagon of in-radius 1/2.
    const double octagon = 2 * (std::sqrt(2.0) - 1);
    EXPECT_NEAR(interpenetration(particles_of({{0, {0, 0}}, {1, {0, 0}, turn(M_PI / 4)}})).overlap, octagon, 1e-14);
    // The corner of a turned square in the middle of an edge: a right isosceles triangle of height 0.2.
    const Vec<2> x(0.5 - 0.2 + std::sqrt(0.5), 0.1);
    EXPECT_NEAR(interpenetration(particles_of({{0, {0, 0}}, {1, x, turn(M_PI / 4)}})).overlap, 0.04, 1e-14);
}

/// Points on a lattice inside both parallelograms.
double overlap_by_counting(const Piece& a, const Piece& b, int n) {
    const auto inside = [](const Piece& p, const Vec<2>& x) {
        const Vec<2> local = (p.F * Mat<2>(p.half.asDiagonal())).inverse() * (x - p.x);
        return std::abs(local[0]) < 1 && std::abs(local[1]) < 1;
    };
    int count = 0;
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
            const Vec<2> local((2 * i + 1.0) / n - 1, (2 * j + 1.0) / n - 1);
            count += inside(b, a.x + a.F * local.cwiseProduct(a.half));
        }
    return 4 * a.half.prod() * a.F.determinant() * count / (double(n) * n);
}

TEST(Interpenetration, OfParallelograms) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> in(-1, 1);
    double sum = 0;
    for (int trial = 0; trial < 40; ++trial) {
        const Piece a{0, {in(random), in(random)}, random_deformation<2>(random, 0.8), {0.6, 0.4}};
        const Piece b{1, {in(random), in(random)}, random_deformation<2>(random, 0.8), {0.5, 0.7}};
        const auto found = interpenetration(particles_of({a, b}));
        EXPECT_NEAR(found.overlap, overlap_by_counting(a, b, 600), 3e-3) << trial;
        EXPECT_NEAR(found.total, 0.96 * a.F.determinant() + 1.4 * b.F.determinant(), 1e-13);
        sum += found.overlap;
    }
    EXPECT_GT(sum, 3) << "most pairs were meant to overlap";
}

TEST(Interpenetration, OfManyParticlesEqualsAllPairs) {
    std::mt19937 random(2);
    std::uniform_real_distribution<double> in(0, 6);
    std::vector<Piece> pieces;
    for (int i = 0; i < 60; ++i)
        pieces.push_back({i % 3, {in(random), in(random)}, random_deformation<2>(random, 0.5), {0.3, 0.3}});
    double pairs = 0;
    for (int i = 0; i < 60; ++i)
        for (int j = 0; j < i; ++j) pairs += interpenetration(particles_of({pieces[i], pieces[j]})).overlap;
    EXPECT_GT(pairs, 1);
    EXPECT_NEAR(interpenetration(particles_of(pieces)).overlap, pairs, 1e-12);
}

} // namespace
