// Flips and turns against coordinates that are mirrored and turned about the picture's centre.
#include "geometry/labels/pixel_order.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>

using namespace abut; // NOLINT(google-build-using-namespace): the room under test
using testing::ElementsAre;

namespace {

using Point = std::array<double, 3>;

/// Rodrigues' rotation about a coordinate axis.
Point turned(const Point& x, int axis, double angle) {
    Point n{};
    n[static_cast<std::size_t>(axis)] = 1;
    const double c = std::cos(angle), s = std::sin(angle), along = n[0] * x[0] + n[1] * x[1] + n[2] * x[2];
    const Point cross{n[1] * x[2] - n[2] * x[1], n[2] * x[0] - n[0] * x[2], n[0] * x[1] - n[1] * x[0]};
    Point y{};
    for (std::size_t a = 0; a < 3; ++a) y[a] = c * x[a] + s * cross[a] + (1 - c) * along * n[a];
    return y;
}

void expect_as_turned(const ImageSpec& spec, const std::array<int, 3>& size) {
    const PixelOrder order = pixel_order(spec, size);
    const double angle = spec.quarter_turns * std::numbers::pi / 2;
    const Point half = turned({size[0] / 2.0, size[1] / 2.0, size[2] / 2.0}, spec.turn_axis, angle);
    for (std::size_t a = 0; a < 3; ++a) ASSERT_NEAR(order.size[a], 2 * std::abs(half[a]), 1e-9);
    std::set<std::ptrdiff_t> places;
    for (int slice = 0; slice < size[2]; ++slice)
        for (int row = 0; row < size[1]; ++row)
            for (int column = 0; column < size[0]; ++column) {
                Point x{column + 0.5 - size[0] / 2.0, row + 0.5 - size[1] / 2.0, slice + 0.5 - size[2] / 2.0};
                if (spec.first_row_is_up) x[1] = -x[1];
                for (std::size_t a = 0; a < 3; ++a)
                    if (spec.flip[a]) x[a] = -x[a];
                x = turned(x, spec.turn_axis, angle);
                const double i = x[0] + order.size[0] / 2.0 - 0.5, j = x[1] + order.size[1] / 2.0 - 0.5,
                             k = x[2] + order.size[2] / 2.0 - 0.5;
                const std::ptrdiff_t place =
                    order.first + column * order.step[0] + row * order.step[1] + slice * order.step[2];
                ASSERT_EQ(place, std::lround((k * order.size[1] + j) * order.size[0] + i));
                places.insert(place);
            }
    EXPECT_EQ(places.size(), static_cast<std::size_t>(size[0]) * size[1] * size[2]);
    EXPECT_EQ(*places.begin(), 0);
}

} // namespace

TEST(LabelsOrder, EveryFlipAndTurn) {
    for (int flips = 0; flips < 16; ++flips)
        for (int turns = 0; turns < 4; ++turns)
            for (int axis = 0; axis < 3; ++axis) {
                ImageSpec spec;
                spec.first_row_is_up = (flips & 8) == 0;
                spec.flip = {(flips & 1) != 0, (flips & 2) != 0, (flips & 4) != 0};
                spec.quarter_turns = turns;
                spec.turn_axis = axis;
                expect_as_turned(spec, {2, 3, 4});
                expect_as_turned(spec, {5, 1, 2});
            }
}

TEST(LabelsOrder, AxesOfTheFile) {
    ImageSpec spec;
    spec.quarter_turns = 1;
    EXPECT_THAT(pixel_order(spec, {2, 3, 4}).axis, ElementsAre(1, 0, 2));
    spec.turn_axis = 0;
    EXPECT_THAT(pixel_order(spec, {2, 3, 4}).axis, ElementsAre(0, 2, 1));
    EXPECT_THAT(pixel_order(spec, {2, 3, 4}).size, ElementsAre(2, 4, 3));
    spec.turn_axis = 1;
    spec.quarter_turns = 2;
    EXPECT_THAT(pixel_order(spec, {2, 3, 4}).axis, ElementsAre(0, 1, 2));
}
