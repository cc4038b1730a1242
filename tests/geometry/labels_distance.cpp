// Distances against the nearest of all other pixels.
#include "geometry/labels/distance.h"

#include "labels_support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace abut; // NOLINT(google-build-using-namespace): the room under test

namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

/// Squared distance by looking at every pixel, and at every place beyond the border.
double brute_force(const LabelVolume& volume, std::size_t p, const std::array<double, 3>& spacing,
                   const std::array<bool, 3>& border) {
    if (volume.label[p] == 0) return 0;
    const test::PixelAt a = test::pixel_at(volume, p);
    double least = infinity;
    for (std::size_t q = 0; q < volume.label.size(); ++q) {
        if (volume.label[q] == volume.label[p]) continue;
        const test::PixelAt b = test::pixel_at(volume, q);
        const double dx = (a.x - b.x) * spacing[0], dy = (a.y - b.y) * spacing[1], dz = (a.z - b.z) * spacing[2];
        least = std::min(least, dx * dx + dy * dy + dz * dz);
    }
    const std::array<int, 3> at{a.x, a.y, a.z};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (!border[axis]) continue;
        const double nearest = std::min(at[axis] + 1, volume.size[axis] - at[axis]) * spacing[axis];
        least = std::min(least, nearest * nearest);
    }
    return least;
}

LabelVolume random_labels(int labels, Random& random) {
    const double sameness = 0.9 + 0.099 * random.unit(); // long runs: large distances
    return test::random_volume({1 + random.below(14), 1 + random.below(14), 1 + random.below(8)}, labels, sameness,
                               random);
}

} // namespace

TEST(LabelsDistance, ExactForUnitSpacing) {
    Random random(3);
    for (int round = 0; round < 200; ++round) {
        const LabelVolume volume = random_labels(2 + random.below(3), random);
        const std::array<bool, 3> border{random.below(2) == 1, random.below(2) == 1, random.below(2) == 1};
        const std::vector<float> found = squared_distance_to_others(volume, {1, 1, 1}, border);
        for (std::size_t p = 0; p < found.size(); ++p)
            ASSERT_EQ(found[p], static_cast<float>(brute_force(volume, p, {1, 1, 1}, border)));
    }
}

TEST(LabelsDistance, PixelsThatAreNotSquare) {
    Random random(4);
    for (int round = 0; round < 200; ++round) {
        const LabelVolume volume = random_labels(2 + random.below(3), random);
        const std::array<double, 3> spacing{random.between(0.1, 3), random.between(0.1, 3), random.between(0.1, 3)};
        const std::array<bool, 3> border{false, random.below(2) == 1, random.below(2) == 1};
        const std::vector<float> found = squared_distance_to_others(volume, spacing, border);
        for (std::size_t p = 0; p < found.size(); ++p) {
            const double expected = brute_force(volume, p, spacing, border);
            if (std::isinf(expected))
                ASSERT_EQ(found[p], infinity);
            else
                ASSERT_NEAR(found[p], expected, 4e-7 * expected); // the squares of spacings are rounded to floats
        }
    }
}

TEST(LabelsDistance, RasterOfInsideAndOutside) {
    Random random(5);
    for (int round = 0; round < 100; ++round) {
        const LabelVolume volume = random_labels(2, random);
        const std::vector<bool> inside(volume.label.begin(), volume.label.end());
        const std::array<bool, 3> border{true, random.below(2) == 1, false};
        EXPECT_EQ(squared_distance_to_outside(inside, volume.size, {1, 0.5, 2}, border),
                  squared_distance_to_others(volume, {1, 0.5, 2}, border));
    }
}

TEST(LabelsDistance, BorderAndNothingOutside) {
    const LabelVolume full{{5, 3, 1}, std::vector<std::int32_t>(15, 1)};
    EXPECT_THAT(squared_distance_to_others(full, {1, 1, 1}), testing::Each(infinity));
    EXPECT_THAT(squared_distance_to_others(full, {1, 1, 1}, {true, true, false}),
                testing::ElementsAre(1, 1, 1, 1, 1, 1, 4, 4, 4, 1, 1, 1, 1, 1, 1));
    EXPECT_THAT(squared_distance_to_others(full, {1e-6, 1e-6, 1e-6}, {false, false, true}),
                testing::Each(testing::FloatNear(1e-12F, 1e-18F)));
    EXPECT_TRUE(squared_distance_to_others({{0, 0, 0}, {}}, {1, 1, 1}).empty());
}

/// A disk's distance map is its radius minus the distance from the centre, to within a pixel.
TEST(LabelsDistance, DiskInClosedForm) {
    const int n = 201;
    const double radius = 90.5;
    LabelVolume disk{{n, n, 1}, {}};
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) disk.label.push_back(std::hypot(i - 100, j - 100) < radius ? 1 : 0);
    const std::vector<float> squared = squared_distance_to_others(disk, {1, 1, 1});
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) {
            const double expected = std::max(0.0, radius - std::hypot(i - 100, j - 100));
            ASSERT_NEAR(std::sqrt(squared[disk.index(i, j, 0)]), expected, 1);
        }
}
