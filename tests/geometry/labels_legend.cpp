// Colours to legend entries.
#include "geometry/labels/legend.h"

#include "support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

using namespace abut; // NOLINT(google-build-using-namespace): the room under test
using test::grey;
using testing::ElementsAre;

namespace {

LegendEntry colour(const std::array<int, 3>& rgb, int tolerance = 0) {
    LegendEntry entry = grey(0, "a");
    entry.rgb = rgb;
    entry.grey = false;
    entry.tolerance = tolerance;
    return entry;
}
LegendEntry range(int lowest, int highest) {
    LegendEntry entry = grey(0, "a");
    entry.grey_range = {{lowest, highest}};
    return entry;
}
int entry_of(int value, const std::vector<LegendEntry>& legend) {
    return matching_entry({value, value, value}, legend);
}

} // namespace

TEST(LabelsLegend, NearestColourWithinToleranceAndTheFirstOfEquals) {
    const std::vector<LegendEntry> legend{colour({10, 10, 10}, 5), colour({20, 20, 20}, 5), colour({200, 0, 0}),
                                          colour({10, 10, 10}, 9)};
    EXPECT_EQ(entry_of(5, legend), 0);
    EXPECT_EQ(entry_of(4, legend), 3);
    EXPECT_EQ(entry_of(0, legend), no_entry);
    EXPECT_EQ(entry_of(15, legend), 0) << "as far from 10 as from 20";
    EXPECT_EQ(entry_of(16, legend), 1);
    EXPECT_EQ(matching_entry({200, 0, 0}, legend), 2);
    EXPECT_EQ(matching_entry({200, 0, 1}, legend), no_entry);
    EXPECT_EQ(matching_entry({13, 8, 12}, legend), 0);
    EXPECT_EQ(matching_entry({10, 10, 20}, legend), no_entry) << "the largest difference counts";
}

TEST(LabelsLegend, RangesIncludeBothEndsAndTheNarrowestWins) {
    const std::vector<LegendEntry> legend{range(0, 255), range(100, 150), range(120, 170), range(0, 20)};
    EXPECT_EQ(entry_of(0, legend), 3);
    EXPECT_EQ(entry_of(20, legend), 3);
    EXPECT_EQ(entry_of(21, legend), 0);
    EXPECT_EQ(entry_of(130, legend), 1) << "of equals the first";
    EXPECT_EQ(entry_of(151, legend), 2);
    EXPECT_EQ(entry_of(256, legend), no_entry);
    EXPECT_EQ(matching_entry({130, 130, 131}, legend), no_entry) << "no grey";
}

TEST(LabelsLegend, ColoursWinOverRangesAndRangesAreNoColours) {
    std::vector<LegendEntry> legend{range(100, 101), colour({100, 100, 100}, 40)};
    EXPECT_EQ(entry_of(100, legend), 1);
    EXPECT_EQ(entry_of(140, legend), 1);
    EXPECT_EQ(entry_of(0, legend), no_entry) << "the rgb of a range is unused";
    legend[0].tolerance = 255;
    EXPECT_EQ(entry_of(0, legend), no_entry) << "and its tolerance";
}

TEST(LabelsLegend, SixteenBits) {
    const std::vector<LegendEntry> legend{colour({40000, 40000, 40000}, 10000), colour({0, 0, 0}), range(0, 65535)};
    EXPECT_EQ(entry_of(30000, legend), 0);
    EXPECT_EQ(entry_of(29999, legend), 2);
    EXPECT_EQ(entry_of(65535, legend), 2);
}

TEST(LabelsLegend, ColourNames) {
    EXPECT_EQ(colour_name({17, 17, 17}), "grey 17");
    EXPECT_EQ(colour_name({40000, 40000, 40000}), "grey 40000");
    EXPECT_EQ(colour_name({0xd0, 0x40, 0x20}), "#d04020");
    EXPECT_EQ(colour_name({0xd040, 1, 0x20}), "#d04000010020");
}

TEST(LabelsLegend, TableCountsTheUsedPartOfGreyAndColouredPictures) {
    ColourTable table;
    EXPECT_THAT(table.count(test::picture({{7, 7, 9}, {9, 8, 8}}), {1, 2}, {0, 1}), ElementsAre(0, 1, 2, 2));
    Image rgb{3, 1, 3, {9, 9, 9, 1, 2, 3, 3, 2, 1}};
    EXPECT_THAT(table.count(rgb, {0, 2}, {0, 0}), ElementsAre(1, 3, 4)) << "grey is grey in either";
    Image deep{3, 1, 1, {9, 65535, 256}, 16};
    EXPECT_THAT(table.count(deep, {0, 2}, {0, 0}), ElementsAre(1, 5, 6));
    std::vector<std::int64_t> pixels;
    for (const ColourTable::Colour& each : table.colours()) pixels.push_back(each.pixels);
    EXPECT_THAT(pixels, ElementsAre(1, 3, 2, 1, 1, 1, 1));
    EXPECT_EQ(table.colours()[3].rgb, (std::array<int, 3>{1, 2, 3}));
}

TEST(LabelsLegend, CountsPerEntryAndWhatIsUnmatched) {
    const MatchedColours matched =
        match_colours({{{5, 5, 5}, 3}, {{9, 9, 9}, 4}, {{1, 1, 1}, 7}, {{8, 8, 8}, 4}, {{6, 6, 6}, 2}},
                      {range(5, 6), range(50, 60), colour({1, 1, 1})});
    EXPECT_THAT(matched.entry, ElementsAre(0, no_entry, 2, no_entry, 0));
    EXPECT_THAT(matched.pixels_of_entry, ElementsAre(5, 0, 7));
    ASSERT_EQ(matched.unmatched.size(), 2u);
    EXPECT_EQ(matched.unmatched[0].rgb[0], 8);
    EXPECT_EQ(matched.unmatched[1].rgb[0], 9);
    EXPECT_EQ(matched.unmatched[1].pixels, 4);
}
