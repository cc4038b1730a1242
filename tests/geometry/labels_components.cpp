// Connected components against filling from each pixel.
#include "geometry/labels/components.h"

#include "labels_support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

using namespace abut; // NOLINT(google-build-using-namespace): the room under test
using testing::ElementsAre;

namespace {

void expect_as_filled(const LabelVolume& volume, int connectivity, int void_connectivity) {
    const Components found = connected_components(volume, connectivity, void_connectivity);
    const std::vector<std::int32_t> expected = test::filled(volume, connectivity, void_connectivity);
    ASSERT_EQ(found.volume.label, expected)
        << connectivity << " and " << void_connectivity << " in " << testing::PrintToString(volume.size);
    EXPECT_EQ(found.volume.size, volume.size);
    EXPECT_EQ(found.count, *std::max_element(expected.begin(), expected.end()));
}

} // namespace

TEST(LabelsComponents, DiagonalsTouchWithEightNeighboursOnly) {
    const LabelVolume volume = test::plane({"1.1", //
                                            ".1.", //
                                            "2.1"});
    EXPECT_THAT(test::rows_of(connected_components(volume, 4).volume), ElementsAre("4.5", ".3.", "1.2"));
    EXPECT_THAT(test::rows_of(connected_components(volume, 8).volume), ElementsAre("2.2", ".2.", "1.2"));
}

TEST(LabelsComponents, ShapesThatMeetLateInScanning) {
    const LabelVolume volume = test::plane({"11111", //
                                            "1.1.1", //
                                            "1.1.1"});
    EXPECT_EQ(connected_components(volume, 4).count, 1);
    const LabelVolume spiral = test::plane({"1111111", //
                                            "......1", //
                                            "11111.1", //
                                            "1...1.1", //
                                            "1.1.1.1", //
                                            "1.111.1", //
                                            "1.....1", //
                                            "1111111"});
    EXPECT_EQ(connected_components(spiral, 4).count, 1);
    EXPECT_EQ(connected_components(spiral, 4, 4).count, 2);
}

TEST(LabelsComponents, EdgesAndCornersIn3D) {
    LabelVolume volume{{2, 2, 2}, {1, 0, 0, 1, 0, 0, 0, 0}}; // two that share an edge
    EXPECT_EQ(connected_components(volume, 6).count, 2);
    EXPECT_EQ(connected_components(volume, 18).count, 1);
    volume.label = {1, 0, 0, 0, 0, 0, 0, 1}; // two that share a corner
    EXPECT_EQ(connected_components(volume, 18).count, 2);
    EXPECT_EQ(connected_components(volume, 26).count, 1);
}

TEST(LabelsComponents, AgreeWithFillingInThePlane) {
    Random random(1);
    for (int round = 0; round < 300; ++round) {
        const LabelVolume volume = test::random_volume({1 + random.below(20), 1 + random.below(20), 1},
                                                       2 + random.below(3), 0.7 * random.unit(), random);
        for (const int connectivity : {4, 8})
            for (const int of_void : {0, 4, 8}) expect_as_filled(volume, connectivity, of_void);
    }
}

TEST(LabelsComponents, AgreeWithFillingIn3D) {
    Random random(2);
    for (int round = 0; round < 200; ++round) {
        const LabelVolume volume = test::random_volume({1 + random.below(9), 1 + random.below(9), 1 + random.below(9)},
                                                       2 + random.below(3), 0.7 * random.unit(), random);
        for (const int connectivity : {6, 18, 26})
            for (const int of_void : {0, 6, 26}) expect_as_filled(volume, connectivity, of_void);
    }
}

TEST(LabelsComponents, NothingAndOnlyVoid) {
    EXPECT_EQ(connected_components({{0, 0, 1}, {}}, 4).count, 0);
    EXPECT_EQ(connected_components({{2, 1, 1}, {0, 0}}, 4).count, 0);
    EXPECT_EQ(connected_components({{2, 1, 1}, {0, 0}}, 4, 8).count, 1);
    EXPECT_THROW(connected_components({{1, 1, 1}, {1}}, 5), std::invalid_argument);
}

TEST(LabelsComponents, NumberInScanningOrder) {
    LabelVolume volume{{6, 1, 1}, {7, 0, 3, 7, 9, 3}};
    EXPECT_THAT(number_in_scanning_order(volume), ElementsAre(7, 3, 9));
    EXPECT_THAT(volume.label, ElementsAre(1, 0, 2, 1, 3, 2));
}
