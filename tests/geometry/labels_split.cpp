// Bodies divided at necks: against the definition of the markers, and shapes whose necks are known.
#include "geometry/labels/split.h"

#include "geometry/labels/distance.h"
#include "labels_support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <set>

using namespace abut; // NOLINT(google-build-using-namespace): the room under test

namespace {

/// Markers by definition: a pixel without a higher one (or an equal and earlier one) in reach at a level above its own
/// less the depth.
std::vector<std::size_t> markers_by_definition(const Components& components, int connectivity,
                                               const std::array<double, 3>& spacing, double depth) {
    const std::vector<float> squared = squared_distance_to_others(components.volume, spacing);
    std::vector<std::size_t> markers;
    for (std::size_t p = 0; p < squared.size(); ++p) {
        if (components.volume.label[p] == 0) continue;
        LabelVolume island = components.volume; // what is in reach without going as deep as `depth`
        for (std::size_t q = 0; q < squared.size(); ++q)
            if (std::sqrt(double{squared[p]}) - std::sqrt(double{squared[q]}) >= depth ||
                components.volume.label[q] != components.volume.label[p])
                island.label[q] = 0;
        const std::vector<std::int32_t> number = test::filled(island, connectivity, 0);
        bool is_highest = true;
        for (std::size_t q = 0; q < squared.size(); ++q)
            if (number[q] == number[p] && (squared[q] > squared[p] || (squared[q] == squared[p] && q < p)))
                is_highest = false;
        if (is_highest) markers.push_back(p);
    }
    return markers;
}

/// Labels 1 where inside(x, y, z) at the centres of pixels.
LabelVolume drawn(const std::array<int, 3>& size, const std::function<bool(double, double, double)>& inside) {
    LabelVolume volume{size, {}};
    for (int k = 0; k < size[2]; ++k)
        for (int j = 0; j < size[1]; ++j)
            for (int i = 0; i < size[0]; ++i) volume.label.push_back(inside(i + 0.5, j + 0.5, k + 0.5) ? 1 : 0);
    return volume;
}

std::int32_t parts(const LabelVolume& volume, int connectivity, double depth,
                   const std::array<double, 3>& spacing = {1, 1, 1}) {
    Components found = connected_components(volume, connectivity);
    split_at_necks(found, connectivity, spacing, depth);
    return found.count;
}

/// Two disks of radius 30 with centres 48 apart: the neck is 18 to either side, so its depth is 12.
LabelVolume two_disks() {
    return drawn({120, 70, 1}, [](double x, double y, double) {
        return std::hypot(x - 35, y - 35) < 30 || std::hypot(x - 83, y - 35) < 30;
    });
}

} // namespace

TEST(LabelsSplit, PartsAreAsTheDefinitionSays) {
    Random random(7);
    std::int32_t divided = 0;
    for (int round = 0; round < 300; ++round) {
        const bool flat = round % 2 == 0;
        const LabelVolume volume =
            test::random_volume({4 + random.below(14), 4 + random.below(10), flat ? 1 : 2 + random.below(4)}, 2,
                                0.6 + 0.4 * random.unit(), random);
        const std::array<int, 5> ways{4, 8, 6, 18, 26};
        const int connectivity = ways[static_cast<std::size_t>(flat ? random.below(2) : 2 + random.below(3))];
        std::array<double, 3> spacing{1, 1, 1};
        if (round % 3 == 0) spacing = {1, random.between(1, 3), random.between(1, 3)};
        const double depth = random.between(0.05, 1.5);
        const Components whole = connected_components(volume, connectivity);
        Components found = whole;
        const std::vector<std::int32_t> component_of = split_at_necks(found, connectivity, spacing, depth);
        ASSERT_EQ(component_of.size(), static_cast<std::size_t>(found.count));
        if (std::isinf(squared_distance_to_others(volume, spacing)[0])) {
            EXPECT_EQ(found.volume.label, whole.volume.label);
            continue;
        }
        const std::vector<std::size_t> markers = markers_by_definition(whole, connectivity, spacing, depth);
        ASSERT_EQ(found.count, static_cast<std::int32_t>(markers.size()));
        std::set<std::int32_t> marked;
        for (const std::size_t p : markers) marked.insert(found.volume.label[p]);
        EXPECT_EQ(marked.size(), markers.size()) << "each part has a marker";

        for (std::size_t p = 0; p < volume.label.size(); ++p) {
            const std::int32_t part = found.volume.label[p];
            ASSERT_EQ(part == 0 ? 0 : component_of[static_cast<std::size_t>(part - 1)], whole.volume.label[p])
                << "a part lies in one component, void in void";
        }
        EXPECT_EQ(test::filled(found.volume, connectivity, 0), found.volume.label)
            << "parts are connected, and numbered in scanning order";
        divided += found.count - whole.count;
    }
    EXPECT_GT(divided, 150);
}

TEST(LabelsSplit, DepthIsMeasuredAgainstTheNeck) {
    // By hand: the farthest pixel has its nearest outside one at (28, 9), the one in the neck at (0, 19).
    const double depth = std::hypot(28, 9) - 19;
    EXPECT_NEAR(depth, 12, 2) << "as of smooth disks, but for the pixels";
    for (const int connectivity : {4, 8}) {
        EXPECT_EQ(parts(two_disks(), connectivity, depth - 1e-6), 2);
        EXPECT_EQ(parts(two_disks(), connectivity, depth + 1e-6), 1);
    }
}

TEST(LabelsSplit, TheDivisionLiesInTheNeck) {
    Components found = connected_components(two_disks(), 4);
    split_at_necks(found, 4, {1, 1, 1}, 5);
    ASSERT_EQ(found.count, 2);
    for (int j = 0; j < 70; ++j)
        for (int i = 0; i < 120; ++i) {
            const std::int32_t part = found.volume.at(i, j, 0);
            if (part == 0) continue;
            if (std::abs(i + 0.5 - 59) < 2) continue; // the neck is at 59
            EXPECT_EQ(part == found.volume.at(35, 35, 0), i < 59) << i << ", " << j;
        }
}

TEST(LabelsSplit, SlenderAndCutOffBodiesStayWhole) {
    const LabelVolume ellipse = drawn({160, 60, 1}, [](double x, double y, double) {
        const double u = 0.9 * (x - 80) + 0.2 * (y - 30), v = -0.2 * (x - 80) + 0.9 * (y - 30);
        return std::pow(u / 65, 2) + std::pow(v / 9, 2) < 1;
    });
    EXPECT_EQ(parts(ellipse, 4, 1), 1);
    const LabelVolume half = drawn({60, 30, 1}, [](double x, double y, double) { return std::hypot(x - 30, y) < 25; });
    EXPECT_EQ(parts(half, 4, 0.5), 1);
    EXPECT_EQ(parts(drawn({5, 4, 3}, [](double, double, double) { return true; }), 6, 0.1), 1) << "no outside at all";
    EXPECT_EQ(parts(drawn({5, 4, 1}, [](double, double, double) { return false; }), 4, 0.1), 0);
}

TEST(LabelsSplit, BodiesThatTouchOtherLabelsHaveTheirOutsideThere) {
    // Three disks of two labels: 1 and 1 necked, 2 between them and the right edge.
    LabelVolume volume = two_disks();
    for (int j = 0; j < 70; ++j)
        for (int i = 0; i < 120; ++i)
            if (volume.at(i, j, 0) == 1 && i > 83) volume.label[volume.index(i, j, 0)] = 2;
    EXPECT_EQ(parts(volume, 4, 100), 2);
}

TEST(LabelsSplit, BallsInARowWithPixelsThatAreNotCubes) {
    // Three balls of radius 12, 20 apart: necks of sqrt(12² − 10²) = 6.6, depth 5.4, in units of the smallest edge.
    const std::array<double, 3> spacing{1, 1, 2.5};
    const LabelVolume row = drawn({28, 28, 28}, [&](double x, double y, double z) {
        for (const double centre : {14.0, 34.0, 54.0})
            if (std::hypot(x - 14, y - 14, spacing[2] * z - centre) < 12) return true;
        return false;
    });
    EXPECT_EQ(parts(row, 6, 3.5, spacing), 3);
    EXPECT_EQ(parts(row, 26, 3.5, spacing), 3);
    EXPECT_EQ(parts(row, 6, 7, spacing), 1);
    EXPECT_EQ(parts(row, 6, 3.5, {1e-5, 1e-5, 2.5e-5}), 3) << "ratios only";
}
