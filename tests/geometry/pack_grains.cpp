// Packings: no overlaps, the wanted fraction, the wanted sizes, the same for the same seed.
#include "geometry/packing/ellipse_contact.h"
#include "geometry/packing/pack.h"
#include "support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

using namespace abut; // NOLINT(google-build-using-namespace): the room under test
using testing::HasSubstr;

namespace {

PackRequest request_of(GrainKind kind, int bodies, double fraction, std::uint64_t seed = 1) {
    PackRequest request;
    request.kind = kind;
    request.width = kind == GrainKind::balls ? 90 : 700;
    request.height = kind == GrainKind::balls ? 110 : 500;
    request.depth = kind == GrainKind::balls ? 100 : 0;
    request.bodies = bodies;
    request.area_fraction = fraction;
    request.seed = seed;
    return request;
}

double distance(const Vector& a, const Vector& b) {
    return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

double shoelace(const Polygon& polygon) {
    double twice = 0;
    for (std::size_t k = 0; k < polygon.points.size(); ++k) {
        const PlanePoint &p = polygon.points[k], &q = polygon.points[(k + 1) % polygon.points.size()];
        twice += p[0] * q[1] - q[0] * p[1];
    }
    return twice / 2;
}

/// Whether a side of either of two convex polygons separates them (up to round-off).
bool are_apart(const Polygon& a, const Polygon& b) {
    for (const auto& [one, other] : {std::pair{&a, &b}, std::pair{&b, &a}}) {
        const auto& points = one->points;
        for (std::size_t k = 0; k < points.size(); ++k) {
            const PlanePoint &p = points[k], &q = points[(k + 1) % points.size()];
            const double length = std::hypot(q[0] - p[0], q[1] - p[1]);
            if (length < 1e-9) continue;
            if (std::all_of(other->points.begin(), other->points.end(), [&](const PlanePoint& x) {
                    return ((x[0] - p[0]) * (q[1] - p[1]) - (x[1] - p[1]) * (q[0] - p[0])) / length > -1e-9;
                }))
                return true;
        }
    }
    return false;
}

/// Least distance between the outlines of two polygons that are apart: from a corner of one to a side of the other.
double outline_distance(const Polygon& a, const Polygon& b) {
    double least = 1e300;
    for (const auto& [one, other] : {std::pair{&a, &b}, std::pair{&b, &a}})
        for (const PlanePoint& x : one->points)
            for (std::size_t k = 0; k < other->points.size(); ++k) {
                const PlanePoint &p = other->points[k], &q = other->points[(k + 1) % other->points.size()];
                const double dx = q[0] - p[0], dy = q[1] - p[1], square = dx * dx + dy * dy;
                const double t =
                    square > 0 ? std::clamp(((x[0] - p[0]) * dx + (x[1] - p[1]) * dy) / square, 0.0, 1.0) : 0;
                least = std::min(least, std::hypot(p[0] + t * dx - x[0], p[1] + t * dy - x[1]));
            }
    return least;
}

std::vector<double> sizes_of(const PackedGrains& packed) {
    std::vector<double> sizes;
    for (const ShapeSpec& grain : packed.grains) {
        if (const auto* disk = std::get_if<Disk>(&grain)) sizes.push_back(disk->radius);
        if (const auto* ball = std::get_if<Ball>(&grain)) sizes.push_back(ball->radius);
        if (const auto* polygon = std::get_if<Polygon>(&grain)) sizes.push_back(std::sqrt(shoelace(*polygon)));
        if (const auto* ellipse = std::get_if<Ellipse>(&grain))
            sizes.push_back(std::sqrt(ellipse->semi_axes[0] * ellipse->semi_axes[1]));
    }
    return sizes;
}

/// Mean and deviation.
std::pair<double, double> moments(const std::vector<double>& values) {
    const auto count = static_cast<double>(values.size());
    const double mean = std::accumulate(values.begin(), values.end(), 0.0) / count;
    double squares = 0;
    for (const double value : values) squares += (value - mean) * (value - mean);
    return {mean, std::sqrt(squares / count)};
}

/// Everything in a packing as numbers.
std::vector<double> all_numbers(const PackedGrains& packed) {
    std::vector<double> all = sizes_of(packed);
    for (const ShapeSpec& grain : packed.grains) {
        if (const auto* disk = std::get_if<Disk>(&grain))
            all.insert(all.end(), disk->center.begin(), disk->center.end());
        if (const auto* ball = std::get_if<Ball>(&grain))
            all.insert(all.end(), ball->center.begin(), ball->center.end());
        if (const auto* ellipse = std::get_if<Ellipse>(&grain)) {
            all.insert(all.end(), ellipse->center.begin(), ellipse->center.end());
            all.push_back(ellipse->angle);
        }
        if (const auto* polygon = std::get_if<Polygon>(&grain))
            for (const PlanePoint& p : polygon->points) all.insert(all.end(), p.begin(), p.end());
    }
    return all;
}

} // namespace

TEST(PackDisks, ApartInsideAndOfTheWantedArea) {
    for (const auto& [bodies, fraction, gap] :
         {std::tuple{1, 0.3, 0.0}, std::tuple{20, 0.6, 5.0}, std::tuple{200, 0.75, 0.0}, std::tuple{2000, 0.6, 1.0}}) {
        PackRequest request = request_of(GrainKind::disks, bodies, fraction);
        request.gap = gap;
        const PackedGrains packed = pack_grains(request);
        ASSERT_EQ(packed.grains.size(), static_cast<std::size_t>(bodies));
        double area = 0;
        std::size_t contacts = 0;
        const double mean_diameter = 2 * moments(sizes_of(packed)).first;
        for (std::size_t a = 0; a < packed.grains.size(); ++a) {
            const Disk& one = std::get<Disk>(packed.grains[a]);
            area += std::numbers::pi * one.radius * one.radius;
            EXPECT_GE(one.center[0] - one.radius, -1e-9);
            EXPECT_GE(one.center[1] - one.radius, -1e-9);
            EXPECT_LE(one.center[0] + one.radius, 700 + 1e-9);
            EXPECT_LE(one.center[1] + one.radius, 500 + 1e-9);
            EXPECT_EQ(one.center[2], 0);
            for (std::size_t b = 0; b < a; ++b) {
                const Disk& other = std::get<Disk>(packed.grains[b]);
                const double between = distance(one.center, other.center) - one.radius - other.radius;
                ASSERT_GE(between, gap - 1e-9) << a << " and " << b << " of " << bodies;
                if (between < gap + 0.01 * mean_diameter) ++contacts;
            }
        }
        EXPECT_NEAR(area / (700 * 500), fraction, 1e-9);
        EXPECT_NEAR(packed.fraction, fraction, 1e-9);
        EXPECT_EQ(packed.contacts, contacts);
    }
}

TEST(PackBalls, ApartInsideAndOfTheWantedVolume) {
    for (const auto& [bodies, fraction] : {std::pair{1, 0.2}, std::pair{100, 0.45}, std::pair{500, 0.55}}) {
        const PackedGrains packed = pack_grains(request_of(GrainKind::balls, bodies, fraction));
        const Vector box{90, 110, 100};
        double volume = 0;
        for (std::size_t a = 0; a < packed.grains.size(); ++a) {
            const Ball& one = std::get<Ball>(packed.grains[a]);
            volume += 4.0 / 3 * std::numbers::pi * one.radius * one.radius * one.radius;
            for (std::size_t axis = 0; axis < 3; ++axis) {
                EXPECT_GE(one.center[axis] - one.radius, -1e-9);
                EXPECT_LE(one.center[axis] + one.radius, box[axis] + 1e-9);
            }
            for (std::size_t b = 0; b < a; ++b) {
                const Ball& other = std::get<Ball>(packed.grains[b]);
                ASSERT_GE(distance(one.center, other.center), one.radius + other.radius - 1e-9);
            }
        }
        EXPECT_NEAR(volume / (90 * 110 * 100), fraction, 1e-9);
    }
}

TEST(PackEllipses, ManyAreApartInsideAndOfTheWantedArea) {
    PackRequest request = request_of(GrainKind::ellipses, 400, 0.75);
    request.max_aspect = 4;
    request.gap = 1;
    const PackedGrains packed = pack_grains(request);
    double area = 0;
    // Points on the outline, and whether they lie in another ellipse or within the gap of one.
    const auto form = [](const Ellipse& e, double x, double y) {
        const double c = std::cos(e.angle), s = std::sin(e.angle), dx = x - e.center[0], dy = y - e.center[1];
        return std::pow((c * dx + s * dy) / e.semi_axes[0], 2) + std::pow((c * dy - s * dx) / e.semi_axes[1], 2);
    };
    const auto outline_of = [](const Ellipse& e) {
        std::vector<Vector> points;
        for (int k = 0; k < 180; ++k) {
            const double t = std::numbers::pi * k / 90, u = e.semi_axes[0] * std::cos(t),
                         v = e.semi_axes[1] * std::sin(t);
            points.push_back({e.center[0] + std::cos(e.angle) * u - std::sin(e.angle) * v,
                              e.center[1] + std::sin(e.angle) * u + std::cos(e.angle) * v, 0});
        }
        return points;
    };
    std::vector<std::vector<Vector>> outlines;
    for (const ShapeSpec& grain : packed.grains) outlines.push_back(outline_of(std::get<Ellipse>(grain)));
    int near = 0;
    for (std::size_t a = 0; a < packed.grains.size(); ++a) {
        const Ellipse& one = std::get<Ellipse>(packed.grains[a]);
        area += std::numbers::pi * one.semi_axes[0] * one.semi_axes[1];
        EXPECT_GE(one.semi_axes[0] / one.semi_axes[1], 1 - 1e-12);
        EXPECT_LE(one.semi_axes[0] / one.semi_axes[1], 4 + 1e-12);
        for (const Vector& p : outlines[a])
            EXPECT_TRUE(p[0] >= 0 && p[0] <= 700 && p[1] >= 0 && p[1] <= 500) << p[0] << ' ' << p[1];
        for (std::size_t b = 0; b < packed.grains.size(); ++b) {
            const Ellipse& other = std::get<Ellipse>(packed.grains[b]);
            if (a == b || distance(one.center, other.center) > one.semi_axes[0] + other.semi_axes[0] + 1) continue;
            ++near;
            for (const Vector& p : outlines[a]) {
                ASSERT_GT(form(other, p[0], p[1]), 1) << a << " and " << b;
                for (const Vector& q : outlines[b]) ASSERT_GE(distance(p, q), 1) << a << " and " << b;
            }
        }
    }
    EXPECT_GT(near, 800) << "or nothing was tested";
    EXPECT_NEAR(area / (700 * 500), 0.75, 1e-9);
}

TEST(PackPolygons, ApartConvexAndOfTheWantedArea) {
    for (const auto& [bodies, fraction] :
         {std::pair{2, 0.9}, std::pair{20, 1.0}, std::pair{200, 0.85}, std::pair{2000, 0.9}}) {
        const PackedGrains packed = pack_grains(request_of(GrainKind::polygons, bodies, fraction));
        ASSERT_EQ(packed.grains.size(), static_cast<std::size_t>(bodies));
        double area = 0, nearest = 1e300;
        std::vector<std::array<double, 3>> around; // centre and reach
        for (const ShapeSpec& grain : packed.grains) {
            const Polygon& polygon = std::get<Polygon>(grain);
            ASSERT_GE(polygon.points.size(), 3U);
            EXPECT_TRUE(polygon.holes.empty());
            area += shoelace(polygon);
            EXPECT_GT(shoelace(polygon), 0) << "counter-clockwise";
            std::array<double, 3> circle{};
            for (const PlanePoint& p : polygon.points) {
                EXPECT_TRUE(p[0] > -1e-9 && p[0] < 700 + 1e-9 && p[1] > -1e-9 && p[1] < 500 + 1e-9);
                circle[0] += p[0] / static_cast<double>(polygon.points.size());
                circle[1] += p[1] / static_cast<double>(polygon.points.size());
            }
            for (const PlanePoint& p : polygon.points)
                circle[2] = std::max(circle[2], std::hypot(p[0] - circle[0], p[1] - circle[1]));
            around.push_back(circle);
        }
        for (std::size_t a = 0; a < packed.grains.size(); ++a)
            for (std::size_t b = 0; b < a; ++b) {
                if (std::hypot(around[a][0] - around[b][0], around[a][1] - around[b][1]) > around[a][2] + around[b][2])
                    continue;
                const Polygon& one = std::get<Polygon>(packed.grains[a]);
                const Polygon& other = std::get<Polygon>(packed.grains[b]);
                ASSERT_TRUE(are_apart(one, other)) << a << " and " << b << " of " << bodies;
                const double between = outline_distance(one, other);
                ASSERT_GE(between, packed.polygon_gap - 1e-6) << a << " and " << b << " of " << bodies;
                nearest = std::min(nearest, between);
            }
        EXPECT_NEAR(area / (700 * 500), fraction, 1e-6) << bodies;
        EXPECT_NEAR(nearest, packed.polygon_gap, 1e-6) << "gaps are as wide as said";
        EXPECT_EQ(packed.polygon_gap == 0, fraction == 1);
    }
}

TEST(PackSizes, AreDistributedAsAskedFor) {
    for (const GrainKind kind : {GrainKind::disks, GrainKind::ellipses, GrainKind::balls, GrainKind::polygons}) {
        PackRequest request = request_of(kind, 1000, kind == GrainKind::polygons ? 1.0 : 0.3);
        request.sizes = parse_sizes("equal");
        const std::vector<double> equal = sizes_of(pack_grains(request));
        const double tolerance = kind == GrainKind::polygons ? 1e-3 : 1e-9; // the sides' weights are iterated
        const double mean = moments(equal).first;
        for (const double size : equal) EXPECT_NEAR(size / mean, 1, tolerance);

        request.sizes = parse_sizes("uniform:0.5,1.5"); // deviation 1/√12 of the mean
        const std::vector<double> uniform = sizes_of(pack_grains(request));
        EXPECT_NEAR(moments(uniform).second / moments(uniform).first, 1 / std::sqrt(12), 0.015);
        EXPECT_NEAR(*std::max_element(uniform.begin(), uniform.end()) /
                        *std::min_element(uniform.begin(), uniform.end()),
                    3, 0.05);

        request.sizes = parse_sizes("lognormal:0.3");
        std::vector<double> logarithms = sizes_of(pack_grains(request));
        for (double& size : logarithms) size = std::log(size);
        EXPECT_NEAR(moments(logarithms).second, 0.3, 0.02);
        std::sort(logarithms.begin(), logarithms.end());
        const double quartile = logarithms[750] - logarithms[500]; // 0.6745 σ
        EXPECT_NEAR(quartile, 0.6745 * 0.3, 0.03);
    }
}

TEST(PackSizes, Words) {
    EXPECT_EQ(parse_sizes("uniform:0.25,2e0").max, 2);
    for (const char* bad : {"", "unifrm:1,2", "uniform", "uniform:1,2,3", "uniform:1,", "uniform:0,1", "uniform:a,b",
                            "uniform:1,inf", "lognormal", "lognormal:-1", "lognormal:nan", "lognormal:2", "equal:1"})
        EXPECT_THROW(parse_sizes(bad), std::invalid_argument) << bad;
    EXPECT_THAT(test::message_of([] { parse_sizes("unifrm:1,2"); }), HasSubstr("did you mean \"uniform\"?"));
    EXPECT_THAT(test::message_of([] { parse_grain_kind("Bals"); }), HasSubstr("did you mean \"balls\"?"));
}

TEST(Pack, SameSeedSamePackingOtherSeedOtherPacking) {
    for (const GrainKind kind : {GrainKind::disks, GrainKind::ellipses, GrainKind::balls, GrainKind::polygons}) {
        const auto numbers = [&](std::uint64_t seed) {
            return all_numbers(pack_grains(request_of(kind, 100, 0.5, seed)));
        };
        EXPECT_EQ(numbers(1), numbers(1));
        EXPECT_NE(numbers(1), numbers(2));
    }
}

TEST(Pack, RefusesWhatCannotBe) {
    const auto error = [](GrainKind kind, int bodies, double fraction, double gap = 0) {
        PackRequest request = request_of(kind, bodies, fraction);
        request.gap = gap;
        return test::message_of([&] { pack_grains(request); });
    };
    EXPECT_THAT(error(GrainKind::disks, 100, 0.92), HasSubstr("of the box at most, not 0.920"));
    EXPECT_THAT(error(GrainKind::balls, 200, 0.75), HasSubstr("of the box at most, not 0.750"));
    EXPECT_THAT(error(GrainKind::ellipses, 100, 0.99), HasSubstr("of the box at most, not 0.990"));
    EXPECT_THAT(error(GrainKind::disks, 1, 0.9), HasSubstr("larger than the box"));
    EXPECT_THAT(error(GrainKind::disks, 100, 0.2, 400), HasSubstr("no room for 100 disks"));
    EXPECT_THAT(error(GrainKind::polygons, 100, 0.9, 20), HasSubstr("of the area to the polygons, not 0.900"));
    EXPECT_THAT(error(GrainKind::polygons, 100, 0.01), HasSubstr("smallest polygon is gone"));
    EXPECT_THAT(error(GrainKind::polygons, 1, 0.9), HasSubstr("at least 2 polygons"));
    EXPECT_THAT(error(GrainKind::polygons, 10, 1.1), HasSubstr("between 0 and 1"));
    EXPECT_THAT(error(GrainKind::disks, most_grains + 1, 0.5), HasSubstr("100000"));
}
