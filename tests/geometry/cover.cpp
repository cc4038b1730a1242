// Solids to places: by centre and by covered fraction, and the particles that stand for parts of places.
#include "geometry/cover.h"

#include "geometry/shapes/make_solid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <numbers>

using namespace abut; // NOLINT(google-build-using-namespace): the room under test

namespace {

constexpr double pi = std::numbers::pi;

Solid solid(const ShapeSpec& shape, int dimension) {
    return make_solid(shape, {{}, dimension, {}, 0.01});
}

Lattice lattice_of(std::size_t dimension, double edge) {
    Lattice lattice{dimension, {-1.7, -2.3, -1.9}, {edge, edge, edge}};
    if (dimension == 2) lattice.lower[2] = lattice.edge[2] = 0;
    return lattice;
}

double content(const std::vector<Covered>& places, const Lattice& lattice) {
    double sum = 0;
    for (const Covered& each : places) sum += each.fraction;
    return sum * lattice.content();
}

struct Case {
    const char* name;
    ShapeSpec shape;
    int dimension;
    double exact;
};

std::vector<Case> cases() {
    Box square{{-0.5, -0.5, 0}, {0.5, 0.5, 0}, 30 * pi / 180};
    Box cube{{-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5}, 0.7, {1, 2, 3}};
    return {{"disk", Disk{{0.013, 0.021, 0}, 0.5}, 2, pi / 4},
            {"ellipse", Ellipse{{0.013, 0.021, 0}, {0.8, 0.5}, 0.4}, 2, pi * 0.4},
            {"rotated square", square, 2, 1},
            {"ball", Ball{{0.013, 0.021, 0.008}, 0.5}, 3, pi / 6},
            {"rotated cube", cube, 3, 1}};
}

} // namespace

/// Aim of issue 5: covered fractions within 0.1 % at 8 particles per body width.
TEST(Cover, AreasAndVolumesOverParticlesPerWidth) {
    std::printf(
        "error of the area or volume [%%] at 4, 8, 16 particles per width, by centre and by covered fraction\n");
    for (const Case& each : cases()) {
        const Solid body = solid(each.shape, each.dimension);
        std::printf("%-16s", each.name);
        for (const int per_width : {4, 8, 16}) {
            const Lattice lattice = lattice_of(static_cast<std::size_t>(each.dimension), 1.0 / per_width);
            const double by_centre = content(places_by_centre(body, lattice), lattice) / each.exact - 1;
            const double by_fraction = content(places_by_fraction(body, lattice), lattice) / each.exact - 1;
            std::printf("  %8.3f %9.5f", 100 * by_centre, 100 * by_fraction);
            EXPECT_LT(std::abs(by_fraction), per_width >= 8 ? 1e-3 : 1e-2) << each.name;
            EXPECT_LT(std::abs(by_centre), 0.6 / per_width) << each.name;
        }
        std::printf("\n");
    }
}

TEST(Cover, FacesAcrossTheAxesAreExact) {
    const Lattice plane = lattice_of(2, 0.13);
    const Box rectangle{{-0.512, -0.333, 0}, {0.487, 0.771, 0}};
    EXPECT_NEAR(content(places_by_fraction(solid(rectangle, 2), plane), plane), 0.999 * 1.104, 1e-12);
    const Lattice space = lattice_of(3, 0.13);
    const Box cuboid{{-0.512, -0.333, -0.2}, {0.487, 0.771, 0.45}};
    EXPECT_NEAR(content(places_by_fraction(solid(cuboid, 3), space), space), 0.999 * 1.104 * 0.65, 1e-12);
    EXPECT_NEAR(content_of(solid(cuboid, 3), 3, 0.2), 0.999 * 1.104 * 0.65, 1e-12);
}

/// First and second moments of all parts together are those of the shape.
TEST(Cover, MomentsAddUpToThoseOfTheShape) {
    const Lattice lattice = lattice_of(2, 1.0 / 8);
    const Vector center{0.013, 0.021, 0};
    const double a = 0.8, b = 0.5, angle = 0.4;
    double area = 0, first = 0, xx = 0, xy = 0;
    for (const Covered& each : places_by_fraction(solid(Ellipse{center, {a, b}, angle}, 2), lattice)) {
        const double dx = each.centre[0] - center[0], dy = each.centre[1] - center[1];
        area += each.fraction;
        first += each.fraction * dx;
        xx += each.fraction * (dx * dx + each.variance[0]);
        xy += each.fraction * (dx * dy + each.covariance);
    }
    const double c = std::cos(angle), s = std::sin(angle);
    EXPECT_NEAR(first / area, 0, 2e-5);
    EXPECT_NEAR(xx / area, (a * a * c * c + b * b * s * s) / 4, 1e-5);
    EXPECT_NEAR(xy / area, (a * a - b * b) * c * s / 4, 1e-5);
}

TEST(Cover, PlacesComeInRowsAlongX) {
    for (const Case& each : cases()) {
        const Lattice lattice = lattice_of(static_cast<std::size_t>(each.dimension), 0.2);
        for (const auto& places : {places_by_centre(solid(each.shape, each.dimension), lattice),
                                   places_by_fraction(solid(each.shape, each.dimension), lattice)})
            for (std::size_t k = 1; k < places.size(); ++k) {
                const Place& p = places[k - 1].place;
                const Place& q = places[k].place;
                EXPECT_LT((std::array{p[2], p[1], p[0]}), (std::array{q[2], q[1], q[0]}));
            }
    }
}

TEST(Cover, CentresOnTheOutlineCount) {
    // Centred on a place, radius 5 places: Gauss's circle problem, N(5) = 81, and 515 in space.
    const Lattice plane{2, {-1, -2, 0}, {0.05, 0.05, 0}};
    EXPECT_EQ(places_by_centre(solid(Disk{{0.325, 0.725, 0}, 0.25}, 2), plane).size(), 81u);
    const Lattice space{3, {-1, -2, 0}, {0.05, 0.05, 0.05}};
    EXPECT_EQ(places_by_centre(solid(Ball{{0.525, 0.475, 0.525}, 0.25}, 3), space).size(), 515u);
}

// === Particles of parts

TEST(ParticleOf, ABoxIsItself) {
    const Lattice lattice{2, {0, 0, 0}, {2, 1, 0}};
    Moments moments;
    moments.add({0.25, 0.5, 0}, {0.75, 1, 1}, 2);
    const Covered covered = moments.covered(lattice, {3, 5, 0});
    EXPECT_NEAR(covered.fraction, 0.25, 1e-15);
    for (const bool turned : {false, true}) {
        const PlacedParticle particle = particle_of(covered, lattice, turned);
        EXPECT_NEAR(particle.position[0], 7, 1e-12);
        EXPECT_NEAR(particle.position[1], 5.75, 1e-12);
        EXPECT_NEAR(particle.half_size[0], 0.5, 1e-12);
        EXPECT_NEAR(particle.half_size[1], 0.25, 1e-12);
        EXPECT_EQ(particle.angle, 0);
    }
}

TEST(ParticleOf, HalfASquareAlongItsDiagonal) {
    const Lattice lattice{2, {0, 0, 0}, {1, 1, 0}};
    // The triangle below the diagonal x + y = 1: centre 1/3, variances 1/18, covariance −1/36.
    const Covered triangle{{0, 0, 0}, 0.5, {1.0 / 3, 1.0 / 3, 0}, {1.0 / 18, 1.0 / 18, 0}, -1.0 / 36};
    const PlacedParticle upright = particle_of(triangle, lattice, false);
    EXPECT_NEAR(4 * upright.half_size[0] * upright.half_size[1], 0.5, 1e-12);
    const PlacedParticle turned = particle_of(triangle, lattice, true);
    EXPECT_NEAR(std::abs(turned.angle), pi / 4, 1e-6);
    EXPECT_NEAR(4 * turned.half_size[0] * turned.half_size[1], 0.5, 1e-12);
    // Its edge lies near the diagonal, 0.236 from its centre: within a twentieth of the place.
    const double across = std::min(turned.half_size[0], turned.half_size[1]);
    EXPECT_NEAR(across, 0.2357, 0.05);
    EXPECT_NEAR(std::max(turned.half_size[0], turned.half_size[1]) / across, std::sqrt(3), 1e-6);
}

/// Slivers join what is beside them: contents and first moments stay, nothing thinner than a tenth is left.
TEST(JoinSlivers, KeepContentAndCentre) {
    for (const Case& each : cases()) {
        const Lattice lattice = lattice_of(static_cast<std::size_t>(each.dimension), 0.11);
        std::vector<Covered> places = places_by_fraction(solid(each.shape, each.dimension), lattice);
        const auto sums = [&] {
            std::array<double, 3> sum{};
            for (const Covered& covered : places) {
                sum[0] += covered.fraction;
                sum[1] += covered.fraction * covered.centre[0];
                sum[2] += covered.fraction * (covered.variance[1] + covered.centre[1] * covered.centre[1]);
            }
            return sum;
        };
        const std::array<double, 3> before = sums();
        const std::size_t count = places.size();
        join_slivers(places);
        EXPECT_LT(places.size(), count) << each.name;
        const std::array<double, 3> after = sums();
        for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(after[i], before[i], 1e-9 * before[0]) << each.name;
        for (const Covered& covered : places) {
            EXPECT_GE(covered.fraction, 0.1) << each.name;
            const PlacedParticle particle = particle_of(covered, lattice, true);
            const double shortest =
                *std::min_element(particle.half_size.begin(), particle.half_size.begin() + each.dimension);
            EXPECT_GT(shortest, 0.02 * lattice.edge[0]) << each.name;
        }
    }
    std::vector<Covered> alone{{{0, 0, 0}, 0.05, {}, {}, 0}};
    join_slivers(alone);
    EXPECT_EQ(alone.size(), 1u);
}

/// Whatever the outline: content and centre are kept, and no particle is longer than its place's diagonal.
TEST(ParticleOf, KeepsContentAndCentre) {
    for (const Case& each : cases()) {
        const Lattice lattice = lattice_of(static_cast<std::size_t>(each.dimension), 0.11);
        for (const Covered& covered : places_by_fraction(solid(each.shape, each.dimension), lattice)) {
            const PlacedParticle particle = particle_of(covered, lattice, true);
            double size = 1, diagonal = 0;
            for (std::size_t a = 0; a < lattice.dimension; ++a) {
                size *= 2 * particle.half_size[a];
                diagonal = std::hypot(diagonal, lattice.edge[a]);
            }
            EXPECT_NEAR(size / (covered.fraction * lattice.content()), 1, 1e-9);
            for (std::size_t a = 0; a < 3; ++a) EXPECT_NEAR(particle.position[a], covered.centre[a], 1e-12);
            for (std::size_t a = 0; a < lattice.dimension; ++a)
                EXPECT_LE(particle.half_size[a], diagonal / 2 * (1 + 1e-9)) << each.name;
        }
    }
}
