// How particles are drawn: ellipses within domains; the parts of a scene that are left.
#include "io/render/compose.h"
#include "io/render/select.h"
#include "io/render/view.h"
#include "results_support.h"

#include <cmath>
#include <gmock/gmock.h>
#include <random>

namespace abut::test {
namespace {

using testing::HasSubstr;

const View view{{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, {300, 200}, 100};

PointFrame one_particle(const std::array<double, 4>& F, double rx, double ry) {
    PointFrame frame;
    frame.points = {0.5, -0.25, 0};
    frame.arrays = {{"half_size", 3, std::vector<double>{rx, ry, 0}},
                    {"deformation_gradient", 9, std::vector<double>{F[0], F[1], 0, F[2], F[3], 0, 0, 0, 1}},
                    {"body", 1, std::vector<std::int32_t>{0}}};
    return frame;
}

double area(const Quads& quads) { // of quadrilaterals by the shoelace formula
    double sum = 0;
    for (std::size_t q = 0; q < quads.corners.size(); q += 4)
        for (std::size_t i = 0; i < 4; ++i) {
            const Pixel &a = quads.corners[q + i], &b = quads.corners[q + (i + 1) % 4];
            sum += 0.5 * (a[0] * b[1] - a[1] * b[0]);
        }
    return std::abs(sum);
}

TEST(RenderParticles, EllipsesAreTheDeformedOnesInscribedInTheDomain) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> any(-1, 1);
    for (int i = 0; i < 200; ++i) {
        const std::array<double, 4> F{1 + 0.6 * any(random), any(random), any(random), 1 + 0.6 * any(random)};
        const double rx = std::pow(10, any(random)), ry = std::pow(10, any(random));
        const double J = F[0] * F[3] - F[1] * F[2];
        if (std::abs(J) < 0.05) continue;
        Quads quads;
        ASSERT_TRUE(add_ellipses(quads, one_particle(F, rx, ry), view, {body_colour(3)}, {0}));
        // Each corner, taken back to the undeformed particle, lies on X^2/rx^2 + Y^2/ry^2 = 1.
        for (const Pixel& corner : quads.corners) {
            const double x = (corner[0] - 300) / 100 - 0.5, y = (corner[1] - 200) / 100 + 0.25;
            const double X = (F[3] * x - F[1] * y) / J, Y = (F[0] * y - F[2] * x) / J;
            EXPECT_NEAR(std::pow(X / rx, 2) + std::pow(Y / ry, 2), 1, 1e-9);
        }
        // A polygon of n corners has sin(2 pi/n)/(2 pi/n) of the area; as many as needed, not a triangle.
        const double exact = M_PI * std::abs(J) * rx * ry * 1e4;
        EXPECT_LT(area(quads), exact);
        EXPECT_GT(area(quads), exact > 1000 ? 0.98 * exact : 0.82 * exact);
        for (const Rgb& colour : quads.colours) EXPECT_EQ(colour, body_colour(3));
    }
}

TEST(RenderParticles, DegenerateEllipsesAreDrawnWithoutHarm) {
    for (const auto& F : {std::array<double, 4>{0, 0, 0, 0}, std::array<double, 4>{1, 1, 1, 1},
                          std::array<double, 4>{NAN, 0, 0, 1}, std::array<double, 4>{1e30, 0, 0, 1}}) {
        Quads quads;
        EXPECT_TRUE(add_ellipses(quads, one_particle(F, 0.1, 0.1), view, {body_colour(0)}, {0}));
        EXPECT_LE(quads.colours.size(), 60u);
        EXPECT_EQ(quads.corners.size(), 4 * quads.colours.size());
    }
    PointFrame frame = one_particle({1, 0, 0, 1}, 1, 1);
    frame.arrays.erase(frame.arrays.begin());
    Quads quads;
    EXPECT_FALSE(add_ellipses(quads, frame, view, {body_colour(0)}, {0}));
}

/// Particles at x = 0, 1, 2, 3 of bodies 0, 0, 1, 2, half a unit large.
PointFrame row() {
    PointFrame frame;
    frame.arrays = {{"half_size", 3, std::vector<double>{}},
                    {"body", 1, std::vector<std::int32_t>{0, 0, 1, 2}},
                    {"id", 1, std::vector<std::int32_t>{10, 11, 12, 13}}};
    for (int i = 0; i < 4; ++i) {
        frame.points.insert(frame.points.end(), {double(i), 0, 0});
        auto& half = std::get<0>(frame.arrays[0].values);
        half.insert(half.end(), {0.5, 0.5, 0});
    }
    frame.words = {{"body_names", {"floor", "left grain", "right grain"}}};
    return frame;
}

std::vector<std::int32_t> ids(const PointFrame& frame) {
    return std::get<1>(frame.arrays.at(2).values);
}

TEST(RenderSelection, ParticlesOfBodiesAndRegions) {
    PointFrame frame = row();
    select_particles(frame, {std::set<int>{0, 2}, {}});
    EXPECT_EQ(ids(frame), (std::vector<std::int32_t>{10, 11, 13}));
    EXPECT_EQ(frame.points.size(), 9u);
    EXPECT_EQ(frame.points[6], 3);
    EXPECT_EQ(std::get<0>(frame.arrays[0].values).size(), 9u);

    frame = row(); // 0.6 to 1.4: within particle 1; 0.6 is outside 0, which ends at 0.5
    select_particles(frame, {{}, Bounds{{0.6, -9, 0}, {1.4, 9, 0}}});
    EXPECT_EQ(ids(frame), (std::vector<std::int32_t>{11}));
    frame = row();
    select_particles(frame, {{}, Bounds{{0.4, 0.4, 0}, {1.6, 9, 0}}}); // their parts
    EXPECT_EQ(ids(frame), (std::vector<std::int32_t>{10, 11, 12}));
    frame = row(); // in space by centres
    select_particles(frame, {{}, Bounds{{0.4, -1, -1}, {2, 1, 1}}});
    EXPECT_EQ(ids(frame), (std::vector<std::int32_t>{11, 12}));
    frame = row();
    select_particles(frame, {std::set<int>{}, {}});
    EXPECT_TRUE(frame.points.empty());
}

TEST(RenderSelection, ContactsOfABodyAreThoseWithAnyOther) {
    PointFrame contact;
    contact.points = {0, 0, 0, 1, 0, 0, 2, 0, 0};
    contact.arrays = {{"body_a", 1, std::vector<std::int32_t>{0, 1, 0}},
                      {"body_b", 1, std::vector<std::int32_t>{1, 2, 2}}};
    PointFrame of_first = contact;
    select_contacts(of_first, {std::set<int>{0}, {}});
    EXPECT_EQ(std::get<1>(of_first.arrays[1].values), (std::vector<std::int32_t>{1, 2}));
    PointFrame right = contact;
    select_contacts(right, {{}, Bounds{{1.5, -1, 0}, {3, 1, 0}}});
    EXPECT_EQ(right.points, (std::vector<double>{2, 0, 0}));
}

TEST(RenderSelection, AGroupStandsForItsBodies) {
    PointFrame frame = row();
    frame.words = {{"body_names", {"grain-1", "floor", "grain-02", "grain-", "grain-2x", "grains-3", "floor-1"}}};
    EXPECT_EQ(body_numbers(frame, {"grain"}, ""), (std::set<int>{0, 2}));
    EXPECT_EQ(body_numbers(frame, {"grain-1", "grain"}, ""), (std::set<int>{0, 2}));
    EXPECT_EQ(body_numbers(frame, {"floor"}, ""), (std::set<int>{1})); // a body's own name stands for it alone
    EXPECT_THAT(error_of([&] { body_numbers(frame, {"grai"}, ""); }), HasSubstr("no body \"grai\""));
}

TEST(RenderSelection, RegionsInWhichNothingIsSeenAreRefused) {
    const Bounds plane{{0, 0, 0}, {2, 1, 0}}, space{{0, 0, 0}, {2, 1, 1}};
    EXPECT_NO_THROW(check_region({{1.9, 0.9, 0}, {3, 3, 0}}, plane, true));
    EXPECT_NO_THROW(check_region({{-9, -9, 0}, {9, 9, 0}}, plane, true));
    EXPECT_THAT(error_of([&] {
                    check_region({{2.1, 0, 0}, {3, 1, 0}}, plane, true);
                }),
                HasSubstr("outside the grid: x from 2.1 m to 3 m, the grid from 0 m to 2 m"));
    EXPECT_NO_THROW(check_region({{2.1, 0, 0}, {3, 1, 0}}, plane, false));
    EXPECT_THAT(error_of([&] {
                    check_region({{0, 0, -2}, {1, 1, -1}}, space, true);
                }),
                HasSubstr("outside the grid: z"));
    for (const bool all_there_is : {true, false})
        EXPECT_THAT(error_of([&] {
                        check_region({{0, 0, 0}, {1, 1e300, 0}}, plane, all_there_is);
                    }),
                    HasSubstr("so large, y from"));
    EXPECT_NO_THROW(check_region({{0, 0, 0}, {1, 1, 0}}, {{0, 0, 0}, {0, 0, 0}}, false)); // a single point
}

TEST(RenderSelection, ErrorsOfferWhatThereIs) {
    const PointFrame frame = row();
    EXPECT_EQ(body_numbers(frame, {"right grain", "floor"}, "here"), (std::set<int>{0, 2}));
    EXPECT_THAT(error_of([&] { body_numbers(frame, {"left gran"}, "here"); }),
                HasSubstr("here: no body \"left gran\"; did you mean \"left grain\"?"));
    EXPECT_THAT(error_of([&] { body_numbers(frame, {"left"}, "here"); }), HasSubstr("no body \"left\""));
    PointFrame nameless = frame;
    nameless.words.clear();
    EXPECT_THAT(error_of([&] { body_numbers(nameless, {"floor"}, "here"); }), HasSubstr("don't tell the bodies"));
    EXPECT_THAT(error_of([&] { region_of({0, 0, 0, 1, 1, 1}, true); }), HasSubstr("4 numbers"));
    EXPECT_THAT(error_of([&] { region_of({0, 0, 1, 1}, false); }), HasSubstr("6 numbers"));
    const Bounds region = region_of({1, 2, 3, 4, 5, 6}, false);
    EXPECT_EQ(region.lower, (std::array<double, 3>{1, 2, 3}));
    EXPECT_EQ(region.upper, (std::array<double, 3>{4, 5, 6}));
}

} // namespace
} // namespace abut::test
