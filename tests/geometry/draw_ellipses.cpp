// The picture of packed ellipses.
#include "geometry/packing/draw_ellipses.h"

#include "geometry/build_model.h"
#include "geometry/packing/ellipse_contact.h"
#include "geometry/packing/random.h"
#include "geometry/packing/shades.h"
#include "support.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <numbers>
#include <set>

using namespace abut; // NOLINT(google-build-using-namespace): the room under test
using testing::HasSubstr;

namespace {

std::vector<Vector> outline_points(const Ellipse& ellipse, int count) {
    std::vector<Vector> points;
    for (int k = 0; k < count; ++k) {
        const double t = 2 * std::numbers::pi * k / count, c = std::cos(ellipse.angle), s = std::sin(ellipse.angle);
        const double u = ellipse.semi_axes[0] * std::cos(t), v = ellipse.semi_axes[1] * std::sin(t);
        points.push_back({ellipse.center[0] + c * u - s * v, ellipse.center[1] + s * u + c * v, 0});
    }
    return points;
}

double least_distance(const Ellipse& a, const Ellipse& b) {
    double least = 1e300;
    const std::vector<Vector> of_a = outline_points(a, 200), of_b = outline_points(b, 200);
    for (const Vector& p : of_a)
        for (const Vector& q : of_b) least = std::min(least, std::hypot(p[0] - q[0], p[1] - q[1]));
    return least;
}

/// Value of the ellipse's quadratic form, ≤ 1 inside.
double form(const Ellipse& ellipse, double x, double y) {
    const double c = std::cos(ellipse.angle), s = std::sin(ellipse.angle);
    const double u = c * (x - ellipse.center[0]) + s * (y - ellipse.center[1]);
    const double v = c * (y - ellipse.center[1]) - s * (x - ellipse.center[0]);
    return std::pow(u / ellipse.semi_axes[0], 2) + std::pow(v / ellipse.semi_axes[1], 2);
}

/// Shades of bodies with pixels at most `distance` apart, checked over all pairs of pixels near each other.
void expect_neighbours_differ(const DrawnImage& drawn, double distance) {
    const int width = drawn.image.width, height = drawn.image.height, reach = static_cast<int>(distance);
    std::vector<int> owner(drawn.image.pixels.size(), -1);
    for (int row = 0; row < height; ++row)
        for (int column = 0; column < width; ++column)
            for (std::size_t k = 0; k < drawn.ellipses.size(); ++k)
                if (form(drawn.ellipses[k], column + 0.5, height - row - 0.5) <= 1) {
                    EXPECT_EQ(owner[row * width + column], -1) << "a pixel in two ellipses";
                    owner[row * width + column] = static_cast<int>(k);
                    EXPECT_EQ(drawn.image.pixels[row * width + column], drawn.shade[k]);
                }
    for (int row = 0; row < height; ++row)
        for (int column = 0; column < width; ++column) {
            const int own = owner[row * width + column];
            if (own < 0) {
                EXPECT_EQ(drawn.image.pixels[row * width + column], drawn.background);
                continue;
            }
            for (int y = std::max(0, row - reach); y <= std::min(height - 1, row + reach); ++y)
                for (int x = std::max(0, column - reach); x <= std::min(width - 1, column + reach); ++x) {
                    const int other = owner[y * width + x];
                    if (other < 0 || other == own || std::hypot(x - column, y - row) > distance) continue;
                    ASSERT_NE(drawn.shade[own], drawn.shade[other]) << own << " and " << other;
                }
        }
}

} // namespace

TEST(EllipseContact, CirclesInClosedForm) {
    const Ellipse a{{0, 0, 0}, {2, 2}, 0.3}, b{{3, 4, 0}, {1, 1}, 1.1};
    EXPECT_NEAR(contact_function(outline(a), outline(b), 1e300), std::pow(5.0 / 3.0, 2), 1e-10);
}

TEST(EllipseContact, AgreesWithPolygons) {
    Random random(5);
    int apart = 0, over = 0;
    for (int round = 0; round < 400; ++round) {
        const auto any = [&] {
            return Ellipse{{random.between(0, 4), random.between(0, 4), 0},
                           {random.between(0.3, 2), random.between(0.3, 2)},
                           random.between(0, 3.2)};
        };
        const Ellipse a = any(), b = any();
        bool overlap = form(a, b.center[0], b.center[1]) <= 1 || form(b, a.center[0], a.center[1]) <= 1;
        for (const Vector& p : outline_points(a, 2000)) overlap = overlap || form(b, p[0], p[1]) <= 1;
        const double value = contact_function(outline(a), outline(b), 1e300);
        if (std::abs(value - 1) < 1e-3) continue; // finer than the polygon
        EXPECT_EQ(value < 1, overlap);
        EXPECT_EQ(contact_function(outline(a), outline(b), 1) < 1, overlap) << "stopping early";
        ++(overlap ? over : apart);
    }
    EXPECT_GT(apart, 50);
    EXPECT_GT(over, 50);
}

TEST(DrawEllipses, DefaultPictureIsAsAskedFor) {
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        EllipseDrawing drawing;
        drawing.seed = seed;
        const DrawnImage drawn = draw_ellipses(drawing);
        EXPECT_EQ(drawn.image.width, 280);
        EXPECT_EQ(drawn.image.height, 560);
        EXPECT_EQ(drawn.image.channels, 1);
        EXPECT_EQ(drawn.ellipses.size(), 20u);
        EXPECT_NEAR(drawn.area_fraction, 0.55, 0.003);
        EXPECT_EQ(std::set<int>(drawn.shade.begin(), drawn.shade.end()).size(), 20u);
        for (const Ellipse& ellipse : drawn.ellipses) {
            const double aspect = ellipse.semi_axes[0] / ellipse.semi_axes[1];
            EXPECT_GE(aspect, 1);
            EXPECT_LE(aspect, 2.5);
            for (const Vector& p : outline_points(ellipse, 100)) {
                EXPECT_TRUE(p[0] >= 0 && p[0] <= 280 && p[1] >= 0 && p[1] <= 560) << "inside the picture";
            }
        }
        for (std::size_t a = 0; a < 20; ++a)
            for (std::size_t b = 0; b < a; ++b)
                EXPECT_GE(contact_function(outline(drawn.ellipses[a]), outline(drawn.ellipses[b]), 1), 1);
        expect_neighbours_differ(drawn, 8);
    }
}

TEST(DrawEllipses, SameSeedSamePictureOtherSeedOtherPicture) {
    EllipseDrawing drawing;
    const DrawnImage first = draw_ellipses(drawing), again = draw_ellipses(drawing);
    EXPECT_EQ(first.image.pixels, again.image.pixels);
    drawing.seed = 2;
    EXPECT_NE(first.image.pixels, draw_ellipses(drawing).image.pixels);
}

TEST(DrawEllipses, TheExampleIsWhatTheDefaultsDraw) {
    const Image example = read_image(std::filesystem::path(ABUT_SOURCE_DIR) / "examples/ellipses/ellipses.png");
    EXPECT_TRUE(example.pixels == draw_ellipses({}).image.pixels) << "on this machine too";
}

TEST(DrawEllipses, FewShadesManyBodies) {
    EllipseDrawing drawing;
    drawing.bodies = 60;
    drawing.shades = 5;
    drawing.area_fraction = 0.6;
    const DrawnImage drawn = draw_ellipses(drawing);
    EXPECT_EQ(std::set<int>(drawn.shade.begin(), drawn.shade.end()).size(), 5u);
    expect_neighbours_differ(drawn, drawing.neighbour_distance);
    drawing.shades = 1;
    EXPECT_THAT(test::message_of([&] { draw_ellipses(drawing); }), HasSubstr("1 shades are too few"));
}

TEST(DrawEllipses, GapIsKept) {
    EllipseDrawing drawing;
    drawing.gap = 12;
    drawing.area_fraction = 0.45;
    drawing.min_aspect = drawing.max_aspect = 5;
    const DrawnImage drawn = draw_ellipses(drawing);
    for (std::size_t a = 0; a < drawn.ellipses.size(); ++a)
        for (std::size_t b = 0; b < a; ++b) EXPECT_GE(least_distance(drawn.ellipses[a], drawn.ellipses[b]), 12);
}

TEST(DrawEllipses, RefusesWhatCannotBe) {
    const auto error = [](auto change) {
        EllipseDrawing drawing;
        change(drawing);
        return test::message_of([&] { draw_ellipses(drawing); });
    };
    EXPECT_THAT(error([](auto& d) { d.width = 0; }), HasSubstr("width and height"));
    EXPECT_THAT(error([](auto& d) { d.bodies = 0; }), HasSubstr("at least 1 body"));
    EXPECT_THAT(error([](auto& d) { d.shades = 0; }), HasSubstr("shades must be"));
    EXPECT_THAT(error([](auto& d) { d.min_aspect = 0.5; }), HasSubstr("aspects"));
    EXPECT_THAT(error([](auto& d) { d.sizes.max = 0.1; }), HasSubstr("sizes"));
    EXPECT_THAT(error([](auto& d) { d.area_fraction = 1; }), HasSubstr("area fraction"));
    EXPECT_THAT(error([](auto& d) { d.gap = -1; }), HasSubstr("gap"));
    EXPECT_THAT(error([](auto& d) { d.background = 240; }), HasSubstr("is also the grey of a body"));
    EXPECT_THAT(error([](auto& d) { d.background = 300; }), HasSubstr("a grey from 0 to 255"));
    EXPECT_THAT(error([](auto& d) { d.area_fraction = 0.95; }), HasSubstr("of the picture at most, not 0.950"));
    EXPECT_THAT(error([](auto& d) { d.width = d.height = 8, d.bodies = 200; }), HasSubstr("smaller than a pixel"));
}

TEST(Shades, HardGraphs) {
    Random random(1);
    const auto cycle = [](int count) {
        Neighbours neighbours(count);
        for (int k = 0; k < count; ++k) neighbours[k] = {(k + 1) % count, (k + count - 1) % count};
        return neighbours;
    };
    EXPECT_NO_THROW(choose_shades(cycle(20), 2, random));
    EXPECT_THROW(choose_shades(cycle(21), 2, random), std::runtime_error);
    const std::vector<int> three = choose_shades(cycle(21), 3, random);
    for (int k = 0; k < 21; ++k) EXPECT_NE(three[k], three[(k + 1) % 21]);
}

TEST(LegendJson, IsALegendOfTheScene) {
    const PackedGrains packed = pack_grains({});
    DrawingStyle style;
    const auto json = nlohmann::json::parse("{" + legend_json(shade_grains(packed, style), "aluminium") + "}");
    EXPECT_FALSE(json.contains("bodies"));
    ASSERT_EQ(json["legend"].size(), 21u);
    EXPECT_EQ(json["legend"][0]["grey"], 10);
    EXPECT_EQ(json["legend"][0]["body"], "grain-01");
    EXPECT_EQ(json["legend"][0]["material"], "aluminium");
    EXPECT_EQ(json["legend"][19]["grey"], 240);
    EXPECT_EQ(json["legend"][19]["body"], "grain-20");
    EXPECT_EQ(json["legend"][20]["grey"], 255);
    EXPECT_EQ(json["legend"][20]["void"], true);

    style.shades = 6; // fewer than bodies: the legend alone can't tell them apart
    const auto shared = nlohmann::json::parse("{" + legend_json(shade_grains(packed, style), "aluminium") + "}");
    EXPECT_EQ(shared["bodies"], "by-component");
    ASSERT_EQ(shared["legend"].size(), 7u);
    for (int k = 0; k < 6; ++k) EXPECT_EQ(shared["legend"][k]["body"], "grain");
}

/// The published case's model: 2 × 2 pixels a particle, 20 bodies.
TEST(ExampleEllipses, BecomesAModelOf20Bodies) {
    Scene scene = test::unit_scene(1);
    scene.grid = {{14.3e-6, 14.3e-6, 0}, {0, 0, 0}, {1e-3, 2e-3, 0}};
    ImageSpec image;
    image.file = std::filesystem::path(ABUT_SOURCE_DIR) / "examples/ellipses/ellipses.png";
    image.size = {1e-3, 2e-3};
    const DrawnImage drawn = draw_ellipses({});
    for (std::size_t k = 0; k < 20; ++k)
        image.legend.push_back(test::grey(drawn.shades[k], fmt::format("grain-{:02}", k + 1)));
    image.legend.push_back(test::grey(255, ""));
    scene.images = {image};
    const Model model = build_model(scene, "scene.json");
    EXPECT_EQ(model.bodies.size(), 20u);
    const double fraction = static_cast<double>(model.size()) / (140 * 280);
    EXPECT_NEAR(fraction, drawn.area_fraction, 0.01);
    std::printf("picture %.6f, particles %zu of 39200 = %.6f\n", drawn.area_fraction, model.size(), fraction);
}
