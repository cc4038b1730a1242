// Three-dimensional scenes to particles and models.
#include "geometry/build_model.h"
#include "model_support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <numbers>
#include <set>

using namespace abut; // NOLINT(google-build-using-namespace): the room under test
using test::box;
using test::problems;
using test::shape_particles;
using test::ShapeParticles;
using test::unit_scene;
using testing::Each;
using testing::ElementsAre;

namespace {

const GridSpec grid{{0.1, 0.2, 0.125}, {-1, -2, 0.5}, {3, 2, 3}};

double volume(const ShapeParticles& particles) {
    const Vector& r = particles.half_size;
    return 8 * r[0] * r[1] * r[2] * static_cast<double>(particles.position.size());
}

/// Positions to 1e-6, relative to a centre, one axis turned round.
std::set<std::array<long, 3>> rounded(const ShapeParticles& particles, const Vector& centre, std::size_t mirrored = 3) {
    std::set<std::array<long, 3>> result;
    for (const Vector& p : particles.position) {
        std::array<long, 3> place{};
        for (std::size_t axis = 0; axis < 3; ++axis)
            place[axis] = std::lround((axis == mirrored ? -1e6 : 1e6) * (p[axis] - centre[axis]));
        result.insert(place);
    }
    return result;
}

} // namespace

TEST(BoxInSpace, VolumeIsExactForAnyBox) {
    for (const Vector& size : {Vector{1, 0.5, 0.75}, {0.123, 0.777, 0.3}, {0.33, 0.01, 1e-4}}) {
        const Vector lower{0.05, 0.03, 0.61};
        const ShapeParticles particles =
            shape_particles(Box{lower, {lower[0] + size[0], lower[1] + size[1], lower[2] + size[2]}}, 2, grid, 3);
        EXPECT_NEAR(volume(particles), size[0] * size[1] * size[2], 1e-14);
    }
}

TEST(BoxInSpace, FillsTheBoxFromItsOwnCornerWithXFastest) {
    const ShapeParticles particles = shape_particles(Box{{0.03, 0.04, 0.7}, {0.13, 0.14, 0.95}}, 2, grid, 3);
    ASSERT_EQ(particles.position.size(), 2u * 1 * 4);
    EXPECT_NEAR(particles.half_size[0], 0.025, 1e-15);
    EXPECT_NEAR(particles.half_size[1], 0.05, 1e-15);
    EXPECT_NEAR(particles.half_size[2], 0.03125, 1e-15);
    EXPECT_NEAR(particles.position[1][0], 0.105, 1e-15);
    EXPECT_NEAR(particles.position[1][2], 0.73125, 1e-15);
    EXPECT_NEAR(particles.position[2][0], 0.055, 1e-15);
    EXPECT_NEAR(particles.position[7][2], 0.91875, 1e-15);
}

TEST(BallParticles, VolumeConverges) {
    double previous = 1;
    for (const int per_cell : {1, 4, 16}) {
        const ShapeParticles particles = shape_particles(Ball{{0.513, -0.271, 1.707}, 0.8}, per_cell, grid, 3);
        const double error = std::abs(volume(particles) / (4.0 / 3 * std::numbers::pi * 0.512) - 1);
        EXPECT_LT(error, 0.02 / per_cell);
        EXPECT_LT(error, previous);
        previous = error;
    }
}

TEST(BallParticles, SymmetricAboutLatticePointsAndMidpoints) {
    const GridSpec cubes{{0.1, 0.1, 0.1}, {-1, -2, -1}, {3, 2, 2}};
    for (const double offset : {0.0, 0.025, 0.05}) // a corner of particles; a centre of one
        for (const double radius : {0.1, 0.25, 0.4, 0.125}) {
            const Vector centre{0.3 + offset, 0.7 + offset, 0.2 + offset};
            const ShapeParticles particles = shape_particles(Ball{centre, radius}, 2, cubes, 3);
            const auto all = rounded(particles, centre);
            EXPECT_EQ(all.size(), particles.position.size());
            for (std::size_t axis = 0; axis < 3; ++axis)
                EXPECT_EQ(all, rounded(particles, centre, axis)) << offset << ' ' << radius << ' ' << axis;
        }
}

TEST(BallParticles, TakeCentresOnTheOutline) {
    // Centred on a particle, radius 5 particles: the sphere problem of Gauss, N(5) = 515.
    const GridSpec cubes{{0.1, 0.1, 0.1}, {0, 0, 0}, {1, 1, 1}};
    EXPECT_EQ(shape_particles(Ball{{0.525, 0.475, 0.525}, 0.25}, 2, cubes, 3).position.size(), 515u);
}

TEST(BallParticles, LieOnTheLatticeOfTheGrid) {
    const ShapeParticles particles = shape_particles(Ball{{1, 0.1, 1.6}, 0.5}, 1, grid, 3);
    ASSERT_FALSE(particles.position.empty());
    for (const Vector& p : particles.position)
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const double places = (p[axis] - grid.lower[axis]) / grid.cell[axis] - 0.5;
            EXPECT_NEAR(places, std::round(places), 1e-9);
        }
}

TEST(ModelInSpace, BoxAndBall) {
    Scene scene = unit_scene(8, 3);
    scene.bodies = {box("block", {0, 0, 0}, {8, 8, 2}), {"ball", "glass", {}, Ball{{4, 4, 5}, 3}, {}, 2}};
    scene.bodies[1].velocity.value = {0, 0, -3};
    const Model model = build_model(scene, "scene.json");
    ASSERT_EQ(model.bodies.size(), 2u);
    EXPECT_THAT(model.bodies[1].velocity.value, ElementsAre(0, 0, -3));
    const auto in_block = std::count(model.body.begin(), model.body.end(), 0);
    EXPECT_EQ(in_block, 16 * 16 * 4);
    EXPECT_NEAR(static_cast<double>(model.size()) - static_cast<double>(in_block), 8 * 4.0 / 3 * std::numbers::pi * 27,
                30);
    EXPECT_THAT(model.half_size, Each(ElementsAre(0.25, 0.25, 0.25)));
    for (const Vector& p : model.position)
        for (const double x : p) {
            EXPECT_GT(x, 0);
            EXPECT_LT(x, 8);
        }
}

TEST(ModelInSpace, ProblemsNameThreeEdgesAndTheThirdAxis) {
    Scene scene = unit_scene(4, 3);
    scene.bodies = {{"dot", "steel", {}, Ball{{1, 1, 1}, 0.1}, {}, 2}, box("out", {2, 2, 3}, {3, 3, 5})};
    EXPECT_THAT(problems(scene), ElementsAre("/bodies/0: body \"dot\" got no particles: it is too small for "
                                             "particles of 500 mm × 500 mm × 500 mm",
                                             "/bodies/1: body \"out\" lies partly outside the grid: 8 of its 16 "
                                             "particles"));
    scene.grid.upper[2] = 0;
    EXPECT_THAT(problems(scene), ElementsAre(testing::HasSubstr("/grid: needs cells larger than 0")));
}

TEST(ModelInSpace, ShapesOfTheOtherDimension) {
    Scene scene = unit_scene(4, 3);
    scene.bodies = {{"disk", "steel", {}, Disk{{1, 1, 0}, 1}, {}, 2}};
    EXPECT_THAT(problems(scene), ElementsAre("/bodies/0: body \"disk\" has a plane shape in a 3d analysis"));
    scene = unit_scene(4);
    scene.bodies = {{"ball", "steel", {}, Ball{{1, 1, 0}, 1}, {}, 2}};
    EXPECT_THAT(problems(scene), ElementsAre("/bodies/0: body \"ball\" has a 3d shape in a plane analysis"));
}

TEST(ModelInSpace, MentionsOfABodyAgreeInAllOfItsVelocity) {
    Scene scene = unit_scene(4, 3);
    scene.bodies = {box("a", {0, 0, 0}, {1, 1, 1}), box("a", {2, 0, 0}, {3, 1, 1})};
    for (BodySpec& body : scene.bodies) body.velocity = {{1, 0, 0}, {{{0, 2, 0}, {}, {}}}, {0, 0, 1}};
    EXPECT_EQ(build_model(scene, "scene.json").bodies.at(0).velocity, scene.bodies[0].velocity);
    scene.bodies[1].velocity.gradient[2][0] = 1;
    EXPECT_THAT(problems(scene), ElementsAre("/bodies/1/velocity: body \"a\" exists already, with another velocity"));
}

/// Two boxes that touch, of a million particles together: the checks must not search long.
TEST(ModelInSpace, AMillionParticlesAreQuick) {
    Scene scene = unit_scene(50, 3);
    scene.bodies = {box("lower", {0, 0, 0}, {50, 50, 20.1}), box("upper", {0, 0, 20.1}, {50, 50, 50})};
    const auto start = std::chrono::steady_clock::now();
    const Model model = build_model(scene, "scene.json");
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    EXPECT_EQ(model.size(), 1'000'000u);
    RecordProperty("milliseconds", static_cast<int>(1e3 * seconds.count()));
    EXPECT_LT(seconds.count(), 60) << "not a benchmark: the limit also holds for sanitizers on a busy machine";
}
