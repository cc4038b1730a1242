// Pictures of packings: four-colouring, micrographs; scenes of shapes.
#include "geometry/packing/kempe.h"
#include "geometry/packing/micrograph.h"
#include "geometry/packing/pack_scene.h"
#include "geometry/packing/polygon_packing.h"
#include "support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <set>

using namespace abut; // NOLINT(google-build-using-namespace): the room under test
using testing::HasSubstr;

namespace {

void expect_coloured(const Neighbours& neighbours, const std::vector<int>& colour, int colours) {
    std::vector<int> uses(colours, 0);
    for (std::size_t body = 0; body < neighbours.size(); ++body) {
        ASSERT_TRUE(colour[body] >= 0 && colour[body] < colours);
        ++uses[colour[body]];
        for (const int other : neighbours[body]) ASSERT_NE(colour[body], colour[other]) << body << " and " << other;
    }
    for (const int use : uses) EXPECT_GT(use, 0.5 * static_cast<double>(neighbours.size()) / colours);
}

PackedGrains tessellation(int bodies, double fraction, int side = 1000) {
    PackRequest request;
    request.kind = GrainKind::polygons;
    request.width = request.height = side;
    request.bodies = bodies;
    request.area_fraction = fraction;
    return pack_grains(request);
}

} // namespace

TEST(FourColours, PlanarGraphsOf2000Grains) {
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        PolygonRequest request{1000, 1000, 2000, {}, 1, 0, seed};
        request.sizes = parse_sizes(seed % 2 ? "uniform:0.6,1.4" : "lognormal:0.4");
        const PackedPolygons packed = pack_polygons(request);
        std::size_t links = 0;
        for (const auto& each : packed.neighbours) links += each.size();
        EXPECT_GT(links / 2, 5500U) << "nearly as many as a planar graph can have";
        Random random(seed);
        expect_coloured(packed.neighbours, choose_shades(packed.neighbours, 4, random), 4);
    }
}

/// Apollonian networks are uniquely 4-colourable: nothing can be chosen.
TEST(FourColours, ApollonianNetwork) {
    Random random(3);
    std::vector<std::array<int, 3>> faces{{0, 1, 2}, {0, 1, 2}};
    Neighbours neighbours{{1, 2}, {0, 2}, {0, 1}};
    for (int body = 3; body < 2000; ++body) {
        const int chosen = random.below(static_cast<int>(faces.size()));
        const auto [a, b, c] = faces[chosen];
        neighbours.push_back({a, b, c});
        for (const int other : {a, b, c}) neighbours[other].push_back(body);
        faces[chosen] = {a, b, body};
        faces.push_back({a, c, body});
        faces.push_back({b, c, body});
    }
    const std::vector<int> colour = choose_shades(neighbours, 4, random);
    for (std::size_t body = 0; body < neighbours.size(); ++body)
        for (const int other : neighbours[body]) ASSERT_NE(colour[body], colour[other]);
    EXPECT_THROW(choose_shades(neighbours, 3, random), std::runtime_error);
}

TEST(FourColours, PixelsThatTouchDiffer) {
    const PackedGrains packed = tessellation(2000, 1);
    DrawingStyle style;
    style.shades = 4;
    const ShadedGrains shaded = shade_grains(packed, style);
    const std::vector<int> label = shaded.labels(0);
    const Image image = draw(shaded);
    EXPECT_EQ(std::set<int>(image.pixels.begin(), image.pixels.end()).size(), 4U);
    const int reach = static_cast<int>(shaded.neighbour_distance);
    EXPECT_GE(reach, 1);
    for (int row = 0; row < 1000; ++row)
        for (int column = 0; column < 1000; ++column)
            for (int dy = 0; dy <= reach && row + dy < 1000; ++dy)
                for (int dx = -reach; dx <= reach; ++dx) {
                    if (column + dx < 0 || column + dx >= 1000 || dx * dx + dy * dy > reach * reach) continue;
                    const int here = row * 1000 + column, there = here + dy * 1000 + dx;
                    if (label[here] == label[there] || label[here] == 0 || label[there] == 0) continue;
                    ASSERT_NE(image.pixels[here], image.pixels[there]) << row << ' ' << column;
                }
}

TEST(FourColours, SaysWhatToDoWhenGrainsAreLinkedAcrossGaps) {
    const PackedGrains packed = tessellation(300, 0.9, 200);
    DrawingStyle style;
    style.shades = 4;
    style.neighbour_distance = 30;
    EXPECT_THAT(test::message_of([&] { shade_grains(packed, style); }),
                testing::AllOf(HasSubstr("ask for more shades"), HasSubstr("at most 30 pixels apart"),
                               HasSubstr("a smaller --neighbour-distance")));
}

TEST(FourColours, OddCyclesAndCliques) {
    Random random(1);
    Neighbours cycle(301), clique(5);
    for (int k = 0; k < 301; ++k) cycle[k] = {(k + 1) % 301, (k + 300) % 301};
    for (int a = 0; a < 5; ++a)
        for (int b = 0; b < 5; ++b)
            if (a != b) clique[a].push_back(b);
    EXPECT_FALSE(kempe_colouring(cycle, 2, random));
    EXPECT_FALSE(kempe_colouring(clique, 4, random));
    expect_coloured(cycle, *kempe_colouring(cycle, 3, random), 3);
    expect_coloured(clique, *kempe_colouring(clique, 5, random), 5);
    EXPECT_THAT(test::message_of([&] { choose_shades(clique, 4, random); }), HasSubstr("4 shades are too few"));
    EXPECT_FALSE(kempe_colouring(clique, 1, random));
}

/// Pixels against the shapes themselves: inside by the signs of all sides.
TEST(DrawGrains, PolygonsAsTheyAre) {
    const PackedGrains packed = tessellation(30, 0.85, 120);
    const std::vector<int> label = shade_grains(packed, {}).labels(0);
    int compared = 0;
    for (int row = 0; row < 120; ++row)
        for (int column = 0; column < 120; ++column)
            for (std::size_t k = 0; k < packed.grains.size(); ++k) {
                const auto& points = std::get<Polygon>(packed.grains[k]).points;
                double least = 1e300; // twice the area of the smallest triangle over a side
                for (std::size_t i = 0; i < points.size(); ++i) {
                    const PlanePoint &p = points[i], &q = points[(i + 1) % points.size()];
                    least =
                        std::min(least, (q[0] - p[0]) * (119.5 - row - p[1]) - (q[1] - p[1]) * (column + 0.5 - p[0]));
                }
                if (std::abs(least) < 1e-9) continue;
                EXPECT_EQ(label[row * 120 + column] == static_cast<int>(k) + 1, least > 0);
                compared += least > 0;
            }
    EXPECT_NEAR(compared / 14400.0, 0.85, 0.01);
}

TEST(DrawGrains, BallsSliceBySlice) {
    PackRequest request;
    request.kind = GrainKind::balls;
    request.width = 40, request.height = 50, request.depth = 30;
    request.area_fraction = 0.3;
    const PackedGrains packed = pack_grains(request);
    const ShadedGrains shaded = shade_grains(packed, {});
    for (int slice = 0; slice < 30; ++slice) {
        const Image image = draw(shaded, slice);
        for (int row = 0; row < 50; ++row)
            for (int column = 0; column < 40; ++column) {
                int grey = 255;
                for (std::size_t k = 0; k < packed.grains.size(); ++k) {
                    const Ball& ball = std::get<Ball>(packed.grains[k]);
                    if (std::hypot(column + 0.5 - ball.center[0], 49.5 - row - ball.center[1],
                                   slice + 0.5 - ball.center[2]) <= ball.radius)
                        grey = shaded.shade[k];
                }
                ASSERT_EQ(image.pixels[row * 40 + column], grey);
            }
    }
}

TEST(Micrograph, BlurAndNoiseAreAsWideAsAskedFor) {
    PackRequest request;
    request.kind = GrainKind::polygons;
    request.width = 200, request.height = 100;
    request.bodies = 2;
    request.area_fraction = 0.8;
    DrawingStyle plain;
    plain.shades = 1;
    plain.all_alike = true;
    const ShadedGrains shaded = shade_grains(pack_grains(request), plain);
    MicrographStyle style;
    const Image sharp = Micrograph(shaded, style).slice(0);
    for (const int grey : sharp.pixels) ASSERT_TRUE(grey == style.grain || grey == style.space);

    style.noise = 12;
    const Image noisy = Micrograph(shaded, style).slice(0);
    double sum = 0, squares = 0;
    for (std::size_t k = 0; k < noisy.pixels.size(); ++k) {
        const double difference = static_cast<double>(noisy.pixels[k]) - sharp.pixels[k];
        sum += difference;
        squares += difference * difference;
    }
    EXPECT_NEAR(sum / 20000, 0, 0.3);
    EXPECT_NEAR(std::sqrt(squares / 20000), 12, 0.3);
    EXPECT_EQ(noisy.pixels, Micrograph(shaded, style).slice(0).pixels);

    // A blurred picture against the sum over all pixels around, without separating the axes.
    style.noise = 0;
    style.blur = 2;
    const Image blurred = Micrograph(shaded, style).slice(0);
    for (int row = 10; row < 90; row += 7)
        for (int column = 10; column < 190; column += 3) {
            double grey = 0, weights = 0;
            for (int dy = -6; dy <= 6; ++dy)
                for (int dx = -6; dx <= 6; ++dx) {
                    const double weight = std::exp(-(dx * dx + dy * dy) / 8.0);
                    grey += weight * sharp.pixels[(row + dy) * 200 + column + dx];
                    weights += weight;
                }
            ASSERT_NEAR(blurred.pixels[row * 200 + column], grey / weights, 0.51);
        }
}

TEST(PackScene, NumbersReadBackExactly) {
    const double pixel = 1.7e-6;
    for (const GrainKind kind : {GrainKind::disks, GrainKind::ellipses, GrainKind::balls, GrainKind::polygons}) {
        PackRequest request;
        request.kind = kind;
        request.depth = kind == GrainKind::balls ? 280 : 0;
        request.area_fraction = 0.3;
        if (kind == GrainKind::polygons) request.area_fraction = 0.8;
        const PackedGrains packed = pack_grains(request);
        const auto scene = nlohmann::json::parse(scene_of(packed, pixel, "iron \"ore\"", "a test"));
        EXPECT_EQ(scene["analysis"], kind == GrainKind::balls ? "3d" : "plane-strain");
        EXPECT_EQ(scene["grid"]["upper"][1], 560 * pixel);
        EXPECT_TRUE(scene["materials"].contains("iron \"ore\""));
        ASSERT_EQ(scene["bodies"].size(), packed.grains.size());
        std::set<std::string> names;
        for (std::size_t k = 0; k < packed.grains.size(); ++k) {
            const auto& body = scene["bodies"][k];
            names.insert(body["name"].get<std::string>());
            EXPECT_EQ(body["material"], "iron \"ore\"");
            if (const auto* disk = std::get_if<Disk>(&packed.grains[k])) {
                EXPECT_EQ(body["disk"]["radius"].get<double>(), disk->radius * pixel);
                EXPECT_EQ(body["disk"]["center"][1].get<double>(), disk->center[1] * pixel);
                EXPECT_EQ(body["disk"]["center"].size(), 2U);
            } else if (const auto* ball = std::get_if<Ball>(&packed.grains[k])) {
                EXPECT_EQ(body["ball"]["radius"].get<double>(), ball->radius * pixel);
                EXPECT_EQ(body["ball"]["center"][2].get<double>(), ball->center[2] * pixel);
            } else if (const auto* ellipse = std::get_if<Ellipse>(&packed.grains[k])) {
                EXPECT_EQ(body["ellipse"]["semi_axes"][0].get<double>(), ellipse->semi_axes[0] * pixel);
                EXPECT_EQ(body["ellipse"]["semi_axes"][1].get<double>(), ellipse->semi_axes[1] * pixel);
                EXPECT_EQ(body["ellipse"]["angle"].get<double>(), ellipse->angle);
            } else {
                const auto& points = std::get<Polygon>(packed.grains[k]).points;
                ASSERT_EQ(body["polygon"]["points"].size(), points.size());
                for (std::size_t i = 0; i < points.size(); ++i)
                    for (std::size_t axis = 0; axis < 2; ++axis)
                        EXPECT_EQ(body["polygon"]["points"][i][axis].get<double>(), points[i][axis] * pixel);
            }
        }
        EXPECT_EQ(names.size(), packed.grains.size());
    }
}
