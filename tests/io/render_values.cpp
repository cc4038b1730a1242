#include "io/render/colours.h"
#include "io/render/values.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <set>

namespace abut::test {
namespace {

std::vector<std::string> labels(const ColourScale& scale) {
    std::vector<std::string> result;
    for (const auto& tick : scale.ticks) result.push_back(tick.second);
    return result;
}

TEST(RenderValues, ComponentsAndMagnitudes) {
    const Array vector{"velocity", 3, std::vector<double>{3, 0, -4, 1, 2, 2}};
    EXPECT_EQ(values_of(vector, -1), (std::vector<double>{5, 3}));
    EXPECT_EQ(values_of(vector, 2), (std::vector<double>{-4, 2}));
    const Array shear{"stress", 6, std::vector<double>{0, 0, 0, 1, 0, 0}};
    EXPECT_DOUBLE_EQ(values_of(shear, -1)[0], std::sqrt(2.0)); // xy and yx
    const Array body{"body", 1, std::vector<std::int32_t>{-1, 7}};
    EXPECT_EQ(values_of(body, -1), (std::vector<double>{-1, 7}));
}

TEST(RenderValues, RangesPassOverWhatIsNotFinite) {
    EXPECT_EQ(range_of(std::vector<double>{1, NAN, -2, INFINITY}), Range(std::pair(-2.0, 1.0)));
    EXPECT_EQ(range_of(std::vector<double>{NAN}), Range{});
    EXPECT_EQ(joined({}, std::pair(1.0, 2.0)), Range(std::pair(1.0, 2.0)));
    EXPECT_EQ(joined(std::pair(0.0, 1.5), std::pair(1.0, 2.0)), Range(std::pair(0.0, 2.0)));
}

TEST(RenderValues, PercentilesLeaveOutliersOut) {
    std::vector<double> values(100);
    for (int i = 0; i < 100; ++i) values[static_cast<std::size_t>(i)] = (i * 37) % 100 + 1; // 1 to 100, mixed
    EXPECT_EQ(range_of(values, 99), Range(std::pair(1.0, 99.0)));
    EXPECT_EQ(range_of(values, 100), Range(std::pair(1.0, 100.0)));
    EXPECT_EQ(range_of(values, 90.5), Range(std::pair(1.0, 91.0))); // nearest rank
    for (double& v : values) v -= 50;                               // both signs: from both ends
    EXPECT_EQ(range_of(values, 95), Range(std::pair(-45.0, 45.0)));
    values.push_back(NAN);
    EXPECT_EQ(range_of(values, 100), Range(std::pair(-49.0, 50.0)));
    EXPECT_EQ(range_of({7}, 99), Range(std::pair(7.0, 7.0)));
    EXPECT_EQ(range_of({-7}, 99), Range(std::pair(-7.0, -7.0)));
    EXPECT_EQ(range_of({}, 99), Range{});
}

TEST(RenderValues, ScalesReadWell) {
    const Array pressure{"pressure", 1, std::vector<double>{}}, velocity{"velocity", 3, std::vector<double>{}};
    const ColourScale positive = colour_scale(pressure, -1, std::pair(0.1e9, 7.3e9), false);
    EXPECT_EQ(positive.quantity, "pressure");
    EXPECT_EQ(positive.unit, "GPa");
    EXPECT_EQ(positive.map, ColourMap::sequential);
    EXPECT_DOUBLE_EQ(positive.lower, 0);
    EXPECT_DOUBLE_EQ(positive.upper, 8e9);
    EXPECT_EQ(labels(positive), (std::vector<std::string>{"0", "2", "4", "6", "8"}));

    const ColourScale both = colour_scale(velocity, 1, std::pair(-0.021, 0.009), false);
    EXPECT_EQ(both.quantity, "velocity y");
    EXPECT_EQ(both.unit, "mm/s");
    EXPECT_EQ(both.map, ColourMap::diverging);
    EXPECT_DOUBLE_EQ(both.lower, -both.upper);
    EXPECT_EQ(labels(both), (std::vector<std::string>{"-20", "-10", "0", "10", "20"}));

    const ColourScale exact = colour_scale(pressure, -1, std::pair(-1.5e6, 3e6), true);
    EXPECT_EQ(exact.lower, -1.5e6);
    EXPECT_EQ(exact.upper, 3e6);
    EXPECT_EQ(exact.unit, "MPa");
}

TEST(RenderValues, ScalesOfUnusualRangesAreSound) {
    const Array array{"pressure", 1, std::vector<double>{}};
    for (const Range& range :
         {Range{}, Range{std::pair(0.0, 0.0)}, Range{std::pair(5.0, 5.0)}, Range{std::pair(-2e-9, -2e-9)},
          Range{std::pair(-3.0, -1.0)}, Range{std::pair(1e300, 1.1e300)}, Range{std::pair(-1e-7, 4.0)}})
        for (const bool exact : {false, true}) {
            const ColourScale scale = colour_scale(array, -1, range, exact);
            EXPECT_LT(scale.lower, scale.upper);
            EXPECT_GE(scale.ticks.size(), 2u);
            EXPECT_LE(scale.ticks.size(), 12u);
            for (const auto& [value, label] : scale.ticks) {
                EXPECT_GE(value, scale.lower - 1e-6 * (scale.upper - scale.lower));
                EXPECT_LE(value, scale.upper + 1e-6 * (scale.upper - scale.lower));
            }
        }
}

TEST(Colours, BodiesAreToldApart) {
    for (int a = 0; a < 72; ++a)
        for (int b = a + 1; b < 72; ++b) {
            double distance = 0;
            for (std::size_t k = 0; k < 3; ++k) distance = std::hypot(distance, body_colour(a)[k] - body_colour(b)[k]);
            EXPECT_GT(distance, b < 24 ? 40 : 5) << a << ' ' << b;
            if (b == a + 1) {
                EXPECT_GT(distance, 55) << a;
            }
        }
}

TEST(Colours, MapsRunFromEndToEnd) {
    EXPECT_EQ(map_colour(ColourMap::sequential, 0), (Rgb{0x44, 0x01, 0x54}));
    EXPECT_EQ(map_colour(ColourMap::sequential, 2), (Rgb{0xfd, 0xe7, 0x25}));
    EXPECT_EQ(map_colour(ColourMap::diverging, 0.5), (Rgb{0xdd, 0xdd, 0xdd}));
    EXPECT_EQ(map_colour(ColourMap::sequential, NAN), (Rgb{255, 0, 255}));
}

} // namespace
} // namespace abut::test
