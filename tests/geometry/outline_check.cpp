// Which outlines cross or touch themselves or each other: against CGAL's sweep and against points beside the edges, on
// small whole numbers, where corners meet edges and corners all the time.
#include "geometry/packing/random.h"
#include "geometry/shapes/make_solid.h"
#include "geometry/shapes/outline.h"
#include "support.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_2.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace abut; // NOLINT(google-build-using-namespace): the room under test
using test::message_of;
using testing::HasSubstr;

namespace {

std::string error(const std::vector<Outline2D>& outlines) {
    return message_of([&] { check_outlines(outlines); });
}

Outline2D random_outline(Random& random, int corners, int size) {
    Outline2D outline;
    for (int k = 0; k < corners; ++k)
        outline.push_back({std::floor(random.between(0, size)), std::floor(random.between(0, size))});
    return without_repeats(outline);
}

/// Of a small triangle or quadrangle of whole numbers: -1 outside, 0 on it, 1 inside.
int place(const Outline2D& outline, double x, double y) {
    bool inside = false;
    for (std::size_t k = 0; k < outline.size(); ++k) {
        const PlanePoint &p = outline[k], &q = outline[(k + 1) % outline.size()];
        const double across = (q[0] - p[0]) * (y - p[1]) - (q[1] - p[1]) * (x - p[0]);
        const double along = (q[0] - p[0]) * (x - p[0]) + (q[1] - p[1]) * (y - p[1]);
        const double square = std::pow(q[0] - p[0], 2) + std::pow(q[1] - p[1], 2);
        if (std::abs(across) < 1e-9 && along > -1e-9 && along < square + 1e-9) return 0;
        if ((p[1] <= y) != (q[1] <= y) && x < p[0] + (y - p[1]) / (q[1] - p[1]) * (q[0] - p[0])) inside = !inside;
    }
    return inside ? 1 : -1;
}

/// Whether `a` leads through `b` or runs along it, by many points of its edges: all that two edges of whole numbers
/// below 6 can share are fractions with denominators up to 72.
bool leads_through_or_along(const Outline2D& a, const Outline2D& b) {
    bool in = false, out = false;
    for (std::size_t k = 0; k < a.size(); ++k) {
        const PlanePoint &p = a[k], &q = a[(k + 1) % a.size()];
        int on = 0;
        for (int step = 0; step < 400; ++step) {
            const double t = (step + 0.5) / 400;
            const int where = place(b, p[0] + t * (q[0] - p[0]), p[1] + t * (q[1] - p[1]));
            in = in || where > 0;
            out = out || where < 0;
            on = where == 0 ? on + 1 : 0;
            if (on == 2) return true;
        }
    }
    return in && out;
}

} // namespace

TEST(OutlineCheck, OneOutlineAsCgalsSweepSeesIt) {
    using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
    Random random(3);
    int simple = 0, other = 0;
    for (int k = 0; k < 20000; ++k) {
        const Outline2D outline = random_outline(random, 3 + k % 5, 5);
        if (outline.size() < 3) continue;
        CGAL::Polygon_2<Kernel> polygon;
        for (const PlanePoint& p : outline) polygon.push_back({p[0], p[1]});
        const bool is_simple = polygon.is_simple();
        (is_simple ? simple : other)++;
        EXPECT_EQ(error({outline}).empty(), is_simple) << testing::PrintToString(outline) << error({outline});
    }
    EXPECT_GT(simple, 1000);
    EXPECT_GT(other, 1000);
}

TEST(OutlineCheck, TwoOutlinesAsPointsOfTheirEdgesSeeIt) {
    Random random(4);
    int apart = 0, crossing = 0;
    for (int k = 0; k < 20000; ++k) {
        const Outline2D a = random_outline(random, 3 + k % 2, 6), b = random_outline(random, 3 + k / 2 % 2, 6);
        if (a.size() < 3 || b.size() < 3 || !error({a}).empty() || !error({b}).empty()) continue;
        const bool cross = leads_through_or_along(a, b) || leads_through_or_along(b, a);
        (cross ? crossing : apart)++;
        EXPECT_EQ(!error({a, b}).empty(), cross)
            << testing::PrintToString(a) << testing::PrintToString(b) << error({a, b});
    }
    EXPECT_GT(apart, 300);
    EXPECT_GT(crossing, 300);
}

TEST(OutlineCheck, SaysWhatAndWhere) {
    EXPECT_THAT(error({{{0, 0}, {4, 0}, {4, 2}, {2, 0}, {0, 2}}}), HasSubstr("outline 1 touches itself at (2 m, 0 m)"));
    // Through a corner that both branches have: its area is not 0.
    EXPECT_THAT(error({{{0, 0}, {1, 1}, {3, 3}, {3, 0}, {1, 1}, {0, 2}}}), HasSubstr("itself at (1 m, 1 m)"));
    const ShapeContext context{{}, 2, {}, 0.01};
    EXPECT_THAT(message_of([&] { // leaves the square through corners that lie on its edge
                    make_solid(Polygon{{{0, 0}, {2, 0}, {2, 2}, {0, 2}},
                                       {{{0.2, 0.5}, {2, 0.5}, {2.3, 1}, {2, 1.5}, {0.2, 1.5}}}},
                               context);
                }),
                HasSubstr("the polygon crosses hole 0 at (2 m, "));
}

TEST(OutlineCheck, LongEdgesAboveEachOther) {
    // 100 000 teeth along x: lists per strip of x would take the square of that.
    constexpr int teeth = 100000;
    Outline2D comb;
    for (int k = 0; k < teeth; ++k)
        for (const PlanePoint& p : {PlanePoint{k ? 0.25 : 0, 0}, {1, 0}, {1, 1}, {0.25, 1}})
            comb.push_back({p[0], p[1] + 2 * k});
    comb.push_back({0, 2 * teeth - 1});
    EXPECT_EQ(error({comb}), "");
    const Solid solid = solid_of_outlines({comb});
    const Spans spans = solid.spans(0.5, 0);
    ASSERT_EQ(spans.size(), static_cast<std::size_t>(teeth));
    EXPECT_EQ(spans[777], (Span{1554, 1555}));
    EXPECT_EQ(solid.spans(0.125, 0).size(), 1u);
}
