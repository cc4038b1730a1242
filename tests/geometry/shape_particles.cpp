// Boxes, disks and ellipses to particles, in the plane.
#include "model_support.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>
#include <set>

using namespace abut; // NOLINT(google-build-using-namespace): the room under test
using test::shape_particles;
using test::ShapeParticles;

namespace {

const GridSpec grid{{0.1, 0.1, 0}, {-1, -2, 0}, {3, 2, 0}};

double area(const ShapeParticles& particles) {
    return 4 * particles.half_size[0] * particles.half_size[1] * static_cast<double>(particles.position.size());
}

/// Positions to 1e-6, relative to a centre.
std::set<std::pair<long, long>> rounded(const ShapeParticles& particles, const Vector& centre, double fx, double fy) {
    std::set<std::pair<long, long>> result;
    for (const Vector& p : particles.position)
        result.insert({std::lround(fx * (p[0] - centre[0]) * 1e6), std::lround(fy * (p[1] - centre[1]) * 1e6)});
    return result;
}

} // namespace

TEST(BoxParticles, AreaIsExactForAnyBox) {
    for (const auto& [width, height] : {std::pair{1.0, 0.5}, {0.123, 0.777}, {0.33, 0.01}, {2.0, 1e-4}}) {
        const ShapeParticles particles =
            shape_particles(Box{{0.05, 0.03, 0}, {0.05 + width, 0.03 + height, 0}}, 2, grid, 2);
        EXPECT_NEAR(area(particles), width * height, 1e-14);
    }
}

TEST(BoxParticles, FillTheBoxFromItsOwnCorner) {
    const ShapeParticles particles = shape_particles(Box{{0.03, 0.04, 0}, {0.18, 0.09, 0}}, 2, grid, 2);
    ASSERT_EQ(particles.position.size(), 3u);
    EXPECT_NEAR(particles.half_size[0], 0.025, 1e-15);
    EXPECT_NEAR(particles.position[0][0], 0.055, 1e-15);
    EXPECT_NEAR(particles.position[2][0], 0.155, 1e-15);
    EXPECT_NEAR(particles.position[0][1], 0.065, 1e-15);
    EXPECT_EQ(particles.position[0][2], 0);
    EXPECT_EQ(particles.half_size[2], 0);
}

TEST(BoxParticles, FollowTheCellThatDividesTheGrid) {
    const GridSpec uneven{{0.3, 0.3, 0}, {0, 0, 0}, {1, 1, 0}}; // 3 cells of 1/3
    EXPECT_EQ(shape_particles(Box{{0, 0, 0}, {1, 1, 0}}, 2, uneven, 2).position.size(), 36u);
}

TEST(BoxParticles, OfATurnedBoxLieAlongItsEdges) {
    const Box straight{{0.03, 0.04, 0}, {0.53, 0.24, 0}};
    Box box = straight;
    box.angle = 0.6;
    const ShapeParticles particles = shape_particles(box, 2, grid, 2);
    const ShapeParticles reference = shape_particles(straight, 2, grid, 2);
    EXPECT_EQ(particles.angle, 0.6);
    EXPECT_EQ(particles.half_size, reference.half_size);
    ASSERT_EQ(particles.position.size(), reference.position.size());
    // The same complex numbers times e^iφ, about the centre of the box.
    const std::complex<double> turn = std::polar(1.0, 0.6), middle(0.28, 0.14);
    for (std::size_t k = 0; k < particles.position.size(); ++k) {
        const std::complex<double> x(reference.position[k][0], reference.position[k][1]);
        const std::complex<double> expected = middle + turn * (x - middle);
        EXPECT_NEAR(particles.position[k][0], expected.real(), 1e-15);
        EXPECT_NEAR(particles.position[k][1], expected.imag(), 1e-15);
        EXPECT_EQ(particles.position[k][2], 0);
    }
}

TEST(BoxParticles, OfATurnedBoxFitCellsThatAreNoSquares) {
    const GridSpec flat{{0.2, 0.1, 0}, {-1, -2, 0}, {3, 2, 0}};
    const Box upright{{0, 0, 0}, {0.4, 0.8, 0}};
    Box turned{{-0.2, 0.2, 0}, {0.6, 0.6, 0}}; // the same place
    turned.angle = std::numbers::pi / 2;
    const ShapeParticles particles = shape_particles(turned, 2, flat, 2);
    EXPECT_NEAR(particles.half_size[0], 0.025, 1e-15); // across y now
    EXPECT_NEAR(particles.half_size[1], 0.05, 1e-15);
    EXPECT_EQ(rounded(particles, {0.2, 0.4, 0}, 1, 1),
              rounded(shape_particles(upright, 2, flat, 2), {0.2, 0.4, 0}, 1, 1));
}

TEST(DiskParticles, AreaConverges) {
    double previous = 1;
    for (const int per_cell : {2, 8, 32}) {
        const ShapeParticles particles = shape_particles(Disk{{0.513, -0.271, 0}, 0.8}, per_cell, grid, 2);
        const double error = std::abs(area(particles) / (std::numbers::pi * 0.64) - 1);
        EXPECT_LT(error, 0.02 / per_cell);
        EXPECT_LT(error, previous);
        previous = error;
    }
}

TEST(DiskParticles, SymmetricAboutLatticePointsAndMidpoints) {
    for (const double offset : {0.0, 0.025, 0.05}) // a corner of particles; a centre of one
        for (const double radius : {0.05, 0.1, 0.25, 0.4, 0.125, 0.7}) {
            const Vector centre{0.3 + offset, 0.7 + offset, 0};
            const ShapeParticles particles = shape_particles(Disk{centre, radius}, 2, grid, 2);
            const auto all = rounded(particles, centre, 1, 1);
            EXPECT_EQ(all.size(), particles.position.size());
            EXPECT_EQ(all, rounded(particles, centre, -1, 1)) << offset << " " << radius;
            EXPECT_EQ(all, rounded(particles, centre, 1, -1)) << offset << " " << radius;
        }
}

TEST(DiskParticles, TakeCentresOnTheOutline) {
    // Centred on a particle, radius 5 particles: Gauss's circle problem, N(5) = 81.
    EXPECT_EQ(shape_particles(Disk{{0.325, 0.725, 0}, 0.25}, 2, grid, 2).position.size(), 81u);
}

TEST(DiskParticles, TooSmallForAnyParticle) {
    EXPECT_TRUE(shape_particles(Disk{{0.3, 0.7, 0}, 0.01}, 2, grid, 2).position.empty());
}

TEST(EllipseParticles, ContainExactlyTheCentresInside) {
    const Ellipse ellipse{{0.4, 0.2, 0}, {0.9, 0.35}, 0.6};
    const ShapeParticles particles = shape_particles(ellipse, 2, grid, 2);
    std::size_t inside = 0;
    for (double x = -1 + 0.025; x < 3; x += 0.05)
        for (double y = -2 + 0.025; y < 2; y += 0.05) {
            // Foci: the sum of distances to them is at most twice the longer semi-axis.
            const double focus = std::sqrt(0.9 * 0.9 - 0.35 * 0.35);
            const double fx = focus * std::cos(0.6), fy = focus * std::sin(0.6);
            inside += std::hypot(x - 0.4 - fx, y - 0.2 - fy) + std::hypot(x - 0.4 + fx, y - 0.2 + fy) <= 1.8;
        }
    EXPECT_EQ(particles.position.size(), inside);
}

TEST(EllipseParticles, TurnedByAQuarterIsTheSameTheOtherWayRound) {
    const Ellipse flat{{0.4, 0.2, 0}, {0.6, 0.2}, 0}, upright{{0.4, 0.2, 0}, {0.2, 0.6}, std::numbers::pi / 2};
    EXPECT_EQ(rounded(shape_particles(flat, 2, grid, 2), flat.center, 1, 1),
              rounded(shape_particles(upright, 2, grid, 2), flat.center, 1, 1));
}
