// Bodies that claim the same place.
#include "geometry/packing/random.h"
#include "model_support.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

using namespace abut; // NOLINT(google-build-using-namespace): the room under test
using test::box;
using test::problems;
using test::unit_scene;
using testing::ElementsAre;
using testing::HasSubstr;

TEST(Overlap, OfShapes) {
    Scene scene = unit_scene(4);
    scene.bodies = {box("a", {0, 0, 0}, {2, 2, 0}),
                    box("b", {1, 0, 0}, {3, 2, 0}),
                    {"c", "steel", {}, Disk{{1, 3, 0}, 0.5}, {}, 2}};
    EXPECT_THAT(problems(scene), ElementsAre("/bodies/1: body \"b\" claims a place that body \"a\" has already "
                                             "(/bodies/0): 8 of its 16 particles coincide"));
    scene.bodies[1] = box("a", {1, 0, 0}, {3, 2, 0}); // the mass of one body twice in one place
    EXPECT_EQ(problems(scene).size(), 1u);
}

TEST(Overlap, OfDifferentParticleSizesIsFoundBothWays) {
    Scene scene = unit_scene(4);
    scene.bodies = {box("coarse", {0, 0, 0}, {2, 2, 0}), box("fine", {0.05, 0.05, 0}, {0.15, 0.15, 0})};
    scene.bodies[0].particles_per_cell = 1;
    EXPECT_THAT(problems(scene), ElementsAre("/bodies/1: body \"fine\" claims a place that body \"coarse\" has already "
                                             "(/bodies/0): 1 of its 1 particle coincides"));
    std::swap(scene.bodies[0], scene.bodies[1]);
    EXPECT_THAT(problems(scene), ElementsAre(HasSubstr("1 of its 4 particles coincides")));
}

/// Two random shapes, against comparing every particle with every other.
TEST(Overlap, AgreesWithBruteForce) {
    Random random(2);
    int overlapping = 0;
    for (int round = 0; round < 100; ++round) {
        Scene scene = unit_scene(8);
        for (int k = 0; k < 2; ++k) {
            const Vector lower{random.between(0, 5), random.between(0, 5), 0};
            const Vector upper{lower[0] + random.between(0.3, 3), lower[1] + random.between(0.3, 3), 0};
            scene.bodies.push_back(box(k == 0 ? "a" : "b", lower, upper));
            scene.bodies.back().particles_per_cell = 1 + random.below(4);
        }
        std::array<test::ShapeParticles, 2> shape;
        for (std::size_t k = 0; k < 2; ++k)
            shape[k] = test::shape_particles(scene.bodies[k].shape, scene.bodies[k].particles_per_cell, scene.grid, 2);
        std::size_t expected = 0;
        for (const Vector& later : shape[1].position)
            expected += std::any_of(shape[0].position.begin(), shape[0].position.end(), [&](const Vector& earlier) {
                const double x = std::abs(later[0] - earlier[0]), y = std::abs(later[1] - earlier[1]);
                return (x < shape[0].half_size[0] && y < shape[0].half_size[1]) ||
                       (x < shape[1].half_size[0] && y < shape[1].half_size[1]);
            });
        const std::vector<std::string> found = problems(scene);
        ASSERT_EQ(found.size(), expected > 0 ? 1u : 0u);
        if (expected == 0) continue;
        ++overlapping;
        EXPECT_THAT(found[0],
                    HasSubstr(fmt::format("(/bodies/0): {} of its {} particle", expected, shape[1].position.size())));
    }
    EXPECT_GT(overlapping, 20);
}

TEST(Overlap, TouchingBodiesAreFine) {
    Scene scene = unit_scene(3);
    scene.bodies = {box("a", {0, 0, 0}, {1.1, 3, 0}), box("b", {1.1, 0, 0}, {2.3, 3, 0}),
                    box("c", {2.3, 0, 0}, {3, 3, 0})};
    EXPECT_THAT(problems(scene), ElementsAre());
}

/// The next body lies flush on the edge of a turned one; a little farther in, a row of particles coincides.
TEST(Overlap, OfTurnedBoxes) {
    for (const double angle : {0.3, std::numbers::pi / 4, 1.9}) {
        Scene scene = unit_scene(4);
        const double c = std::cos(angle), s = std::sin(angle);
        const auto turned_box = [&](const char* name, double x, double y) { // of 1 × 0.5 about a centre
            BodySpec body = box(name, {x - 0.5, y - 0.25, 0}, {x + 0.5, y + 0.25, 0});
            std::get<Box>(body.shape).angle = angle;
            body.particles_per_cell = 8;
            return body;
        };
        scene.bodies = {turned_box("a", 2, 2), turned_box("b", 2 - 0.5 * s, 2 + 0.5 * c)};
        EXPECT_THAT(problems(scene), ElementsAre()) << angle;
        const double closer = 0.5 - 0.07; // of particles that are 1/16 high
        scene.bodies[1] = turned_box("b", 2 - closer * s, 2 + closer * c);
        EXPECT_THAT(problems(scene), ElementsAre(HasSubstr("8 of its 32 particles coincide"))) << angle;
        // A box along the axes in a corner that only the bounding box of the turned one covers.
        scene.bodies[1] = box("b", {2 + 0.5 * c - 0.2, 2 + 0.5 * s + 0.3, 0}, {2 + 0.5 * c, 2 + 0.5 * s + 0.5, 0});
        EXPECT_THAT(problems(scene), ElementsAre()) << angle;
    }
}

TEST(Overlap, InSpace) {
    Scene scene = unit_scene(4, 3);
    scene.bodies = {box("a", {0, 0, 0}, {2, 2, 2}),
                    box("b", {0, 0, 1}, {2, 2, 3}),
                    box("c", {2, 0, 0}, {4, 2, 2}), // a's neighbour
                    {"d", "steel", {}, Ball{{2, 2, 3}, 1}, {}, 2}};
    EXPECT_THAT(problems(scene), ElementsAre("/bodies/1: body \"b\" claims a place that body \"a\" has already "
                                             "(/bodies/0): 32 of its 64 particles coincide",
                                             HasSubstr("body \"d\" claims a place that body \"b\" has already "
                                                       "(/bodies/1): 4 of its 32 particles")));
}

/// Boxes of several particle sizes, against comparing every particle with every other.
TEST(Overlap, InSpaceAgreesWithBruteForce) {
    Random random(5);
    int overlapping = 0;
    for (int round = 0; round < 60; ++round) {
        Scene scene = unit_scene(6, 3);
        std::array<test::ShapeParticles, 2> shape;
        for (std::size_t k = 0; k < 2; ++k) {
            Vector lower{}, upper{};
            for (std::size_t axis = 0; axis < 3; ++axis) {
                lower[axis] = random.between(0, 3);
                upper[axis] = lower[axis] + random.between(0.3, 3);
            }
            scene.bodies.push_back(box(k == 0 ? "a" : "b", lower, upper));
            scene.bodies[k].particles_per_cell = 1 + random.below(3);
            shape[k] = test::shape_particles(scene.bodies[k].shape, scene.bodies[k].particles_per_cell, scene.grid, 3);
        }
        const auto within = [](const Vector& a, const Vector& b, const Vector& size) {
            bool all = true;
            for (std::size_t axis = 0; axis < 3; ++axis) all = all && std::abs(a[axis] - b[axis]) < size[axis];
            return all;
        };
        std::size_t expected = 0;
        for (const Vector& later : shape[1].position)
            expected += std::any_of(shape[0].position.begin(), shape[0].position.end(), [&](const Vector& earlier) {
                return within(later, earlier, shape[0].half_size) || within(later, earlier, shape[1].half_size);
            });
        const std::vector<std::string> found = problems(scene);
        ASSERT_EQ(found.size(), expected > 0 ? 1u : 0u);
        if (expected == 0) continue;
        ++overlapping;
        EXPECT_THAT(found[0],
                    HasSubstr(fmt::format("(/bodies/0): {} of its {} particle", expected, shape[1].position.size())));
    }
    EXPECT_GT(overlapping, 15);
}
