// Shapes as solids: spans against each shape's own inequality, areas and volumes against closed forms, boolean laws.
#include "geometry/cover.h"
#include "geometry/packing/random.h"
#include "geometry/shapes/make_solid.h"
#include "support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

using namespace abut; // NOLINT(google-build-using-namespace): the room under test
using test::message_of;
using testing::ElementsAre;
using testing::HasSubstr;

namespace {

constexpr double pi = std::numbers::pi;

const std::vector<NamedShapeSpec> named{
    {"square", Box{{-1, -1, 0}, {1, 1, 0}, 0.3}},
    {"disk", Disk{{0.4, 0.3, 0}, 0.9}},
    {"egg", Ellipse{{-0.2, 0.1, 0}, {0.9, 0.4}, 1.1}},
    {"cube", Box{{-1, -1, -1}, {1, 1, 1}, 0.8, {1, 1, 0}}},
    {"ball", Ball{{0.4, 0.3, 0.2}, 0.9}},
    {"loop", Combination{Operation::union_, {"disk", "loop"}}},
};

Solid solid(const ShapeSpec& shape, int dimension) {
    return make_solid(shape, {named, dimension, {}, 0.01});
}

bool contains(const Spans& spans, double at) {
    return std::any_of(spans.begin(), spans.end(), [&](const Span& s) { return s.from < at && at < s.to; });
}

double dot(const Vector& a, const Vector& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
Vector minus(const Vector& a, const Vector& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

/// x turned back by an angle about an axis: Rodrigues' formula with cross products.
Vector turned_back(const Vector& x, const Vector& axis, double angle) {
    const double length = std::sqrt(dot(axis, axis));
    const Vector n{axis[0] / length, axis[1] / length, axis[2] / length};
    const Vector cross{n[1] * x[2] - n[2] * x[1], n[2] * x[0] - n[0] * x[2], n[0] * x[1] - n[1] * x[0]};
    Vector y{};
    for (std::size_t a = 0; a < 3; ++a)
        y[a] = std::cos(angle) * x[a] - std::sin(angle) * cross[a] + (1 - std::cos(angle)) * dot(n, x) * n[a];
    return y;
}

struct Case {
    const char* name;
    int dimension;
    ShapeSpec shape;
    double content;
    std::function<bool(const Vector&)> inside;
};

std::vector<Case> cases() {
    const Vector axis{1, 2, -0.5};
    const auto frustum = [](Vector from, Vector to, double r, double top) {
        return [=](const Vector& x) {
            const Vector n = minus(to, from);
            const double share = dot(minus(x, from), n) / dot(n, n);
            const Vector foot{from[0] + share * n[0], from[1] + share * n[1], from[2] + share * n[2]};
            const Vector d = minus(x, foot);
            return share > 0 && share < 1 && std::sqrt(dot(d, d)) < r + share * (top - r);
        };
    };
    const double slant = std::sqrt(0.5 * 0.5 + 0.7 * 0.7 + 0.9 * 0.9);
    return {
        {"box", 2, Box{{-0.5, -0.2, 0}, {0.7, 0.6, 0}}, 1.2 * 0.8,
         [](const Vector& x) { return x[0] > -0.5 && x[0] < 0.7 && x[1] > -0.2 && x[1] < 0.6; }},
        {"turned box", 2, Box{{-0.5, -0.2, 0}, {0.7, 0.6, 0}, 0.6}, 1.2 * 0.8,
         [](const Vector& x) {
             const Vector y = turned_back({x[0] - 0.1, x[1] - 0.2, 0}, {0, 0, 1}, 0.6);
             return std::abs(y[0]) < 0.6 && std::abs(y[1]) < 0.4;
         }},
        {"disk", 2, Disk{{0.1, 0.2, 0}, 0.7}, pi * 0.49,
         [](const Vector& x) { return std::hypot(x[0] - 0.1, x[1] - 0.2) < 0.7; }},
        {"ellipse", 2, Ellipse{{0.1, 0.2, 0}, {0.8, 0.3}, 0.7}, pi * 0.24,
         [](const Vector& x) { // the sum of distances to the foci
             const double f = std::sqrt(0.64 - 0.09), fx = f * std::cos(0.7), fy = f * std::sin(0.7);
             return std::hypot(x[0] - 0.1 - fx, x[1] - 0.2 - fy) + std::hypot(x[0] - 0.1 + fx, x[1] - 0.2 + fy) < 1.6;
         }},
        {"ring", 2, Ring{{0.1, 0.2, 0}, 0.4, 0.7}, pi * 0.33,
         [](const Vector& x) {
             const double r = std::hypot(x[0] - 0.1, x[1] - 0.2);
             return r > 0.4 && r < 0.7;
         }},
        {"polygon",
         2,
         Polygon{{{-1, -1}, {1, -1}, {1, 1}, {0, 0.25}, {-1, 1}}, {{{-0.5, -0.5}, {0.5, -0.5}, {0, 0}}}},
         2 + 1.25 - 0.25,
         {}},
        {"box in space", 3, Box{{-0.5, -0.2, -0.3}, {0.7, 0.6, 0.2}}, 1.2 * 0.8 * 0.5,
         [](const Vector& x) {
             return x[0] > -0.5 && x[0] < 0.7 && x[1] > -0.2 && x[1] < 0.6 && x[2] > -0.3 && x[2] < 0.2;
         }},
        {"turned box in space", 3, Box{{-0.5, -0.2, -0.3}, {0.7, 0.6, 0.2}, 0.9, axis}, 1.2 * 0.8 * 0.5,
         [axis](const Vector& x) {
             const Vector y = turned_back(minus(x, {0.1, 0.2, -0.05}), axis, 0.9);
             return std::abs(y[0]) < 0.6 && std::abs(y[1]) < 0.4 && std::abs(y[2]) < 0.25;
         }},
        {"ball", 3, Ball{{0.1, 0.2, 0.3}, 0.7}, 4.0 / 3 * pi * 0.343,
         [](const Vector& x) { return std::hypot(x[0] - 0.1, x[1] - 0.2, x[2] - 0.3) < 0.7; }},
        {"ellipsoid", 3, Ellipsoid{{0.1, 0.2, 0.3}, {0.8, 0.3, 0.5}, axis, 1.2}, 4.0 / 3 * pi * 0.12,
         [axis](const Vector& x) {
             const Vector y = turned_back(minus(x, {0.1, 0.2, 0.3}), axis, 1.2);
             return std::hypot(y[0] / 0.8, y[1] / 0.3, y[2] / 0.5) < 1;
         }},
        {"cylinder", 3, Cylinder{{-0.2, -0.3, -0.4}, {0.3, 0.4, 0.5}, 0.3}, pi * 0.09 * slant,
         frustum({-0.2, -0.3, -0.4}, {0.3, 0.4, 0.5}, 0.3, 0.3)},
        {"upright cylinder", 3, Cylinder{{0, 0, -0.4}, {0, 0, 0.5}, 0.3}, pi * 0.09 * 0.9,
         frustum({0, 0, -0.4}, {0, 0, 0.5}, 0.3, 0.3)},
        {"lying cylinder", 3, Cylinder{{0, -0.4, 0}, {0, 0.5, 0}, 0.3}, pi * 0.09 * 0.9,
         frustum({0, -0.4, 0}, {0, 0.5, 0}, 0.3, 0.3)},
        {"cone", 3, Cone{{-0.2, -0.3, -0.4}, {0.3, 0.4, 0.5}, 0.5, 0}, pi * 0.25 * slant / 3,
         frustum({-0.2, -0.3, -0.4}, {0.3, 0.4, 0.5}, 0.5, 0)},
        {"upright cone", 3, Cone{{0, 0, -0.4}, {0, 0, 0.5}, 0.5, 0}, pi * 0.25 * 0.9 / 3,
         frustum({0, 0, -0.4}, {0, 0, 0.5}, 0.5, 0)},
        {"lying widening cone", 3, Cone{{-0.4, 0, 0}, {0.5, 0, 0}, 0.2, 0.5}, pi * 0.9 * (0.04 + 0.1 + 0.25) / 3,
         frustum({-0.4, 0, 0}, {0.5, 0, 0}, 0.2, 0.5)},
    };
}

} // namespace

TEST(Spans, SetOperationsAgreeWithPointwiseLogic) {
    Random random(5);
    const auto draw = [&] {
        Spans spans;
        double x = 0;
        for (int k = random.below(5); k > 0; --k) {
            const double from = x + 1 + random.below(3); // whole numbers: ends often coincide
            x = from + 1 + random.below(3);
            spans.push_back({from, x});
        }
        return spans;
    };
    for (int round = 0; round < 2000; ++round) {
        const Spans a = draw(), b = draw();
        for (const Spans& result : {united(a, b), intersection(a, b), difference(a, b)})
            for (std::size_t k = 0; k < result.size(); ++k) {
                EXPECT_LT(result[k].from, result[k].to);
                if (k > 0) {
                    EXPECT_LT(result[k - 1].to, result[k].from);
                }
            }
        for (double x = 0.5; x < 40; ++x) {
            EXPECT_EQ(contains(united(a, b), x), contains(a, x) || contains(b, x));
            EXPECT_EQ(contains(intersection(a, b), x), contains(a, x) && contains(b, x));
            EXPECT_EQ(contains(difference(a, b), x), contains(a, x) && !contains(b, x));
        }
    }
}

TEST(SolidShapes, PointsInsideSatisfyTheShapesOwnInequality) {
    Random random(1);
    for (const Case& each : cases()) {
        if (!each.inside) continue;
        const Solid body = solid(each.shape, each.dimension);
        int inside = 0;
        for (int k = 0; k < 20000; ++k) {
            Vector x{random.between(-1.2, 1.2), random.between(-1.2, 1.2), random.between(-1.2, 1.2)};
            if (each.dimension == 2) x[2] = 0;
            const bool expected = each.inside(x);
            inside += expected;
            const Spans spans = body.spans(x[0], each.dimension == 3 ? x[1] : 0);
            ASSERT_EQ(contains(spans, x[each.dimension == 3 ? 2 : 1]), expected)
                << each.name << " at " << x[0] << ' ' << x[1] << ' ' << x[2];
            if (!expected) continue;
            for (int a = 0; a < each.dimension; ++a) {
                EXPECT_GE(x[a], body.lower[a]) << each.name;
                EXPECT_LE(x[a], body.upper[a]) << each.name;
            }
        }
        EXPECT_GT(inside, 300) << each.name;
    }
}

TEST(SolidShapes, AreasAndVolumes) {
    for (const Case& each : cases()) {
        const Solid body = solid(each.shape, each.dimension);
        EXPECT_NEAR(content_of(body, static_cast<std::size_t>(each.dimension), 0.02) / each.content, 1,
                    each.dimension == 2 ? 1e-5 : 2e-4)
            << each.name;
    }
}

TEST(SolidShapes, BoxesThatHoldThemAreTight) {
    for (const Case& each : cases()) {
        const Solid body = solid(each.shape, each.dimension);
        const int last = each.dimension - 1;
        double lowest = 9, highest = -9, left = 9, right = -9;
        const int n = each.dimension == 3 ? 400 : 4000;
        for (int i = 0; i <= n; ++i)
            for (int j = 0; j <= (each.dimension == 3 ? n : 0); ++j) {
                const double x = body.lower[0] + (body.upper[0] - body.lower[0]) * i / n;
                const double y = body.lower[1] + (body.upper[1] - body.lower[1]) * j / n;
                for (const Span& span : body.spans(x, y)) {
                    lowest = std::min(lowest, span.from);
                    highest = std::max(highest, span.to);
                    left = std::min(left, x);
                    right = std::max(right, x);
                }
            }
        EXPECT_NEAR(lowest, body.lower[last], 0.01) << each.name;
        EXPECT_NEAR(highest, body.upper[last], 0.01) << each.name;
        EXPECT_NEAR(left, body.lower[0], 0.01) << each.name;
        EXPECT_NEAR(right, body.upper[0], 0.01) << each.name;
    }
}

TEST(SolidShapes, LinesThroughCornersAndAlongEdges) {
    const Solid diamond = solid(Polygon{{{0, -1}, {1, 0}, {0, 1}, {-1, 0}}, {}}, 2);
    EXPECT_THAT(diamond.spans(0, 0), ElementsAre(Span{-1, 1}));
    const Solid steps = solid(Polygon{{{0, 0}, {3, 0}, {3, 1}, {2, 1}, {2, 2}, {1, 2}, {1, 3}, {0, 3}}, {}}, 2);
    for (const double x : {0.0, 1.0, 2.0}) { // along vertical edges: what lies to the right of them
        EXPECT_THAT(steps.spans(x, 0), ElementsAre(Span{0, 3 - x}));
    }
    EXPECT_TRUE(steps.spans(3, 0).empty());
    const Solid star =
        solid(Polygon{{{-1, 0}, {0, 0.5}, {1, 0}, {0, 2}}, {{{-0.1, 1}, {0, 0.8}, {0.1, 1}, {0, 1.2}}}}, 2);
    EXPECT_THAT(star.spans(0, 0), ElementsAre(Span{0.5, 0.8}, Span{1.2, 2}));
}

TEST(SolidShapes, BooleanLaws) {
    Random random(9);
    for (const auto& [first, second, dimension] :
         {std::tuple{"square", "disk", 2}, {"egg", "square", 2}, {"cube", "ball", 3}}) {
        const auto make = [&, a = std::string(first), b = std::string(second), d = dimension](Operation operation,
                                                                                              bool swap) {
            return solid(Combination{operation, swap ? std::vector{b, a} : std::vector{a, b}}, d);
        };
        const Solid a = solid(NamedShape{first}, dimension), b = solid(NamedShape{second}, dimension);
        const Solid both = make(Operation::intersection, false), either = make(Operation::union_, false);
        const Solid rest = make(Operation::difference, false);
        for (int k = 0; k < 500; ++k) {
            const double x = random.between(-1.5, 1.5), y = random.between(-1.5, 1.5);
            EXPECT_EQ(either.spans(x, y), make(Operation::union_, true).spans(x, y));
            EXPECT_EQ(both.spans(x, y), make(Operation::intersection, true).spans(x, y));
            EXPECT_EQ(rest.spans(x, y), difference(a.spans(x, y), both.spans(x, y)));
        }
        const auto d = static_cast<std::size_t>(dimension);
        const auto content = [&](const Solid& s) { return content_of(s, d, 0.02); };
        EXPECT_NEAR(content(a) + content(b), content(either) + content(both), 1e-3);
        EXPECT_NEAR(content(rest), content(a) - content(both), 1e-3);
    }
}

TEST(SolidShapes, WhatCannotBe) {
    const auto error = [](const ShapeSpec& shape, int dimension = 2) {
        return message_of([&] { solid(shape, dimension); });
    };
    EXPECT_THAT(error(NamedShape{"diks"}), HasSubstr("no shape \"diks\"; did you mean \"disk\"?"));
    EXPECT_THAT(error(NamedShape{"loop"}), HasSubstr("shape \"loop\" is made from itself"));
    EXPECT_THAT(error(NamedShape{"ball"}), HasSubstr("shape \"ball\" is one in space, the scene is not"));
    EXPECT_THAT(error(NamedShape{"disk"}, 3), HasSubstr("shape \"disk\" is plane, the scene is not"));
    EXPECT_THAT(error(Combination{}), HasSubstr("combines no shapes"));
    EXPECT_THAT(error(Polygon{{{0, 0}, {2, 2}, {2, 0}, {0, 2}}, {}}),
                HasSubstr("the polygon crosses itself at (1 m, 1 m)"));
    EXPECT_THAT(error(Polygon{{{0, 0}, {1, 0}, {1, 0}, {0, 0}}, {}}), HasSubstr("has 2 different corners; it needs 3"));
    EXPECT_THAT(error(Polygon{{{0, 0}, {1, 0}, {NAN, 1}}, {}}), HasSubstr("a coordinate that is not a number"));
    EXPECT_THAT(error(Polygon{{{0, 0}, {1, 0}, {2, 0}}, {}}), HasSubstr("the polygon"));
    const std::vector<PlanePoint> square{{0, 0}, {4, 0}, {4, 4}, {0, 4}};
    EXPECT_THAT(error(Polygon{square, {{{3, 3}, {5, 3}, {3, 3.5}}}}),
                HasSubstr("the polygon crosses hole 0 at (4 m, "));
    EXPECT_THAT(error(Polygon{square, {{{5, 5}, {6, 5}, {5, 6}}}}), HasSubstr("hole 0 lies outside the polygon"));
    EXPECT_THAT(error(Polygon{square, {{{1, 1}, {3, 1}, {2, 3}}, {{1.9, 1.5}, {2.1, 1.5}, {2, 2}}}}),
                HasSubstr("hole 1 lies in hole 0"));
    EXPECT_EQ(error(Polygon{square, {{{0, 0}, {1, 2}, {2, 1}}}}), "") << "a hole may touch the outline in a point";
    EXPECT_THAT(error(Polygon{square, {{{0, 0}, {0, 2}, {2, 1}}}}), HasSubstr("crosses hole 0"))
        << "but not along an edge";
}

TEST(SolidShapes, ThinTurnedEllipses) {
    for (const double b : {1e-2, 1e-6, 1e-8}) {
        const Spans middle = solid(Ellipse{{0, 0, 0}, {1, b}, 0.7}, 2).spans(0, 0);
        ASSERT_EQ(middle.size(), 1u);
        EXPECT_NEAR((middle[0].to - middle[0].from) / (2 * b / std::hypot(std::cos(0.7), b * std::sin(0.7))), 1, 1e-12);
    }
}

TEST(SolidShapes, BothRimsOfAConeAreBreaks) {
    EXPECT_THAT(solid(Cone{{0, 0, 0}, {0, 0, 1}, 1, 0.25}, 3).breaks[0], ElementsAre(-1, -0.25, 0.25, 1));
    EXPECT_THAT(solid(Cone{{0, 0, 0}, {2, 0, 0}, 1, 0.25}, 3).breaks[1], ElementsAre(-1, -0.25, 0.25, 1));
}

TEST(SolidShapes, NamesThatMultiply) {
    std::vector<NamedShapeSpec> shapes{{"s0", Disk{{0, 0, 0}, 1}}};
    const auto name = [](int k) { return "s" + std::to_string(k); };
    for (int k = 1; k <= 60; ++k) // 2^60 disks
        shapes.push_back({name(k), Combination{Operation::union_, {name(k - 1), name(k - 1)}}});
    const auto make = [&](int k) { return make_solid(NamedShape{name(k)}, {shapes, 2, {}, 0.01}); };
    EXPECT_THAT(make(10).spans(0, 0), ElementsAre(Span{-1, 1}));
    EXPECT_THAT(message_of([&] { make(60); }), HasSubstr("more than 10000 shapes"));
    std::vector<NamedShapeSpec> chain{{"s0", Disk{{0, 0, 0}, 1}}};
    for (int k = 1; k <= 1000; ++k) chain.push_back({name(k), NamedShape{name(k - 1)}});
    EXPECT_THAT(message_of([&] {
                    make_solid(NamedShape{name(1000)}, {chain, 2, {}, 0.01});
                }),
                HasSubstr("more than 100 deep"));
}
