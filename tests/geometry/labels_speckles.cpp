// Speckles against giving them away one at a time, with all components found anew each time.
#include "geometry/labels/speckles.h"

#include "geometry/labels/components.h"
#include "labels_support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>

using namespace abut; // NOLINT(google-build-using-namespace): the room under test
using test::plane;
using testing::ElementsAre;

namespace {

std::vector<std::string> without(const std::vector<std::string>& rows, int smallest, int connectivity = 4) {
    LabelVolume volume = plane(rows);
    remove_speckles(volume, connectivity, smallest);
    return test::rows_of(volume);
}

/// The documented rule, one component at a time.
void by_definition(LabelVolume& volume, int connectivity, std::int64_t smallest) {
    const int of_void = complementary_connectivity(connectivity);
    while (true) {
        const std::vector<std::int32_t> number = test::filled(volume, connectivity, of_void);
        std::map<std::int32_t, std::int64_t> pixels;
        for (const std::int32_t each : number) ++pixels[each];
        if (pixels.size() < 2) return;
        auto least = pixels.begin();
        for (auto each = pixels.begin(); each != pixels.end(); ++each)
            if (each->second < least->second) least = each;
        if (least->second >= smallest) return;
        std::map<std::int32_t, std::int64_t> faces;
        for (std::size_t p = 0; p < number.size(); ++p)
            for (std::size_t q = 0; q < number.size(); ++q)
                if (number[p] == least->first && number[q] != least->first &&
                    test::are_neighbours(test::pixel_at(volume, p), test::pixel_at(volume, q), 6))
                    ++faces[volume.label[q]];
        auto most = faces.begin();
        for (auto each = faces.begin(); each != faces.end(); ++each)
            if (each->second > most->second) most = each;
        for (std::size_t p = 0; p < number.size(); ++p)
            if (number[p] == least->first) volume.label[p] = most->first;
    }
}

} // namespace

TEST(LabelsSpeckles, GoToWhatSurroundsThem) {
    EXPECT_THAT(without({".....", //
                         ".111.", //
                         ".1.1.", //
                         ".111.", //
                         "2...."},
                        2),
                ElementsAre(".....", ".111.", ".111.", ".111.", "....."));
}

TEST(LabelsSpeckles, TheMostFacesWinAndTheSmallerLabelOfEquals) {
    EXPECT_THAT(without({"1122", //
                         "1322", //
                         "1122"},
                        2),
                ElementsAre("1122", "1122", "1122"))
        << "three faces of 1, one of 2";
    EXPECT_THAT(without({"2222", //
                         "2311", //
                         "1111"},
                        2),
                ElementsAre("2222", "2111", "1111"))
        << "two faces of each";
    EXPECT_THAT(without({"111", "...", "112"}, 2), ElementsAre("111", "...", "11.")) << "void is the smallest";
}

TEST(LabelsSpeckles, JustAsLargeAsAskedForStays) {
    const std::vector<std::string> rows{"......", ".11.2.", "......"};
    EXPECT_THAT(without(rows, 1), testing::ElementsAreArray(rows));
    EXPECT_THAT(without(rows, 2), ElementsAre("......", ".11...", "......"));
    EXPECT_THAT(without(rows, 3), ElementsAre("......", "......", "......"));
}

TEST(LabelsSpeckles, NestedOnesGrowTogetherUntilTheyAreLargeOrGone) {
    const std::vector<std::string> onion{".......", //
                                         ".11111.", //
                                         ".1...1.", //
                                         ".1.2.1.", //
                                         ".1...1.", //
                                         ".11111.", //
                                         "......."};
    EXPECT_THAT(without(onion, 2),
                ElementsAre(".......", ".11111.", ".1...1.", ".1...1.", ".1...1.", ".11111.", "......."));
    EXPECT_THAT(without(onion, 10),
                ElementsAre(".......", ".11111.", ".11111.", ".11111.", ".11111.", ".11111.", "......."))
        << "the 2, then the hole of 9; the ring is then 25 pixels";
    EXPECT_THAT(without(onion, 24)[3], ".11111.") << "24 of void around are enough";
    EXPECT_THAT(without(onion, 25)[3], "1111111") << "the ring with its hole has 25 and stays";
}

TEST(LabelsSpeckles, HolesAreClosedByTheBodysOwnConnectivity) {
    const std::vector<std::string> rows{"11111", //
                                        "111.1", //
                                        "11.11", //
                                        "1.111"};
    EXPECT_THAT(without(rows, 2, 4), testing::ElementsAreArray(rows)) << "a chain of three by corners";
    EXPECT_THAT(without(rows, 2, 8), ElementsAre("11111", "11111", "11111", "11111")) << "three holes";
}

TEST(LabelsSpeckles, CountsWhatChangedHands) {
    LabelVolume volume = plane({"1111", //
                                "1.21", //
                                "1111", //
                                "3333"});
    const RemovedSpeckles removed = remove_speckles(volume, 4, 4);
    EXPECT_EQ(removed.pixels, 2);
    EXPECT_EQ(removed.components, 2);
    volume = plane({"1112", "1112", "1112", "1112"});
    EXPECT_EQ(remove_speckles(volume, 4, 3).pixels, 0);
}

TEST(LabelsSpeckles, OneLeftOverIsTheWholeImage) {
    EXPECT_THAT(without({"12"}, 100), ElementsAre("22")) << "the first went to the second";
    EXPECT_THAT(without({"3"}, 100), ElementsAre("3"));
    LabelVolume nothing{{0, 0, 1}, {}};
    EXPECT_EQ(remove_speckles(nothing, 4, 5).pixels, 0);
}

TEST(LabelsSpeckles, AgreeWithTheDefinitionInThePlaneAndIn3D) {
    Random random(6);
    int changed = 0;
    for (int round = 0; round < 400; ++round) {
        const bool flat = round % 2 == 0;
        const LabelVolume volume =
            test::random_volume({1 + random.below(7), 1 + random.below(7), flat ? 1 : 1 + random.below(4)},
                                1 + random.below(4), random.unit(), random);
        const std::array<int, 5> ways{4, 8, 6, 18, 26};
        const int connectivity = ways[static_cast<std::size_t>(flat ? random.below(2) : 2 + random.below(3))];
        const int smallest = 1 + random.below(12);
        LabelVolume expected = volume, found = volume;
        by_definition(expected, connectivity, smallest);
        const RemovedSpeckles removed = remove_speckles(found, connectivity, smallest);
        ASSERT_EQ(found.label, expected.label) << connectivity << ", " << smallest;
        std::int64_t differing = 0;
        for (std::size_t p = 0; p < volume.label.size(); ++p) differing += volume.label[p] != found.label[p] ? 1 : 0;
        ASSERT_EQ(removed.pixels, differing);
        changed += differing > 0 ? 1 : 0;
    }
    EXPECT_GT(changed, 200);
}
