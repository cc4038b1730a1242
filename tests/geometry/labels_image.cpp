// From slices to bodies: order of the steps, names and counts.
#include "geometry/labels/label_image.h"

#include "labels_stack.h"
#include "labels_support.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

using namespace abut; // NOLINT(google-build-using-namespace): the room under test
using test::grey;
using test::label;
using test::range;
using test::slice;
using test::spec_of;
using test::Stack;
using testing::ElementsAre;

namespace {

std::vector<std::string> names(const LabelledImage& image) {
    std::vector<std::string> result;
    for (const LabelledBody& body : image.bodies)
        result.push_back(fmt::format("{} {} {}", body.name, body.entry, body.pixels));
    return result;
}

} // namespace

// === Bodies and their names

TEST(LabelsImage, ByLegendInOrderOfFirstAppearanceAlsoWithoutPixels) {
    const ImageSpec spec = spec_of({grey(0, ""), grey(3, "late"), grey(7, "none"), grey(1, "early"), grey(2, "late")});
    const LabelledImage image = label(spec, {"123", //
                                             ".11"});
    EXPECT_THAT(names(image), ElementsAre("late 1 2", "none 2 0", "early 3 3"));
    EXPECT_THAT(test::rows_of(image.volume), ElementsAre("311", ".33"));
    EXPECT_THAT(image.pixels_of_entry, ElementsAre(1, 1, 0, 3, 1));
    EXPECT_TRUE(image.unmatched.empty());
}

TEST(LabelsImage, ByColourInAscendingOrderWithDigitsOfTheLargest) {
    Stack stack{{test::picture({{5, 17, 240}, {5, 30, 0}})}};
    LabelledImage image =
        label(spec_of({range(1, 99, "grain"), range(200, 255, "rock"), grey(0, "")}, BodiesBy::colour), stack);
    EXPECT_THAT(names(image), ElementsAre("grain-05 0 2", "grain-17 0 1", "grain-30 0 1", "rock-240 1 1"));
    EXPECT_THAT(test::rows_of(image.volume), ElementsAre("124", "13."));
    EXPECT_THAT(image.pixels_of_entry, ElementsAre(4, 1, 1));

    stack.slices[0] = Image{3, 1, 3, {0xd0, 0x40, 0x20, 9, 9, 9, 1, 2, 3}};
    LegendEntry any = grey(128, "c");
    any.tolerance = 128;
    image = label(spec_of({any}, BodiesBy::colour), stack);
    EXPECT_THAT(names(image), ElementsAre("c-010203 0 1", "c-090909 0 1", "c-d04020 0 1"));
    EXPECT_THAT(image.volume.label, ElementsAre(3, 2, 1));

    stack.slices[0] = Image{2, 1, 3, {0xd0ff, 0x40, 0x20, 1, 2, 3}, 16};
    any = grey(0, "c");
    any.tolerance = 65535;
    EXPECT_THAT(names(label(spec_of({any}, BodiesBy::colour), stack)),
                ElementsAre("c-000100020003 0 1", "c-d0ff00400020 0 1"));
}

TEST(LabelsImage, ByColourThoseWhoseLastPixelsWereSpecklesVanish) {
    ImageSpec spec = spec_of({range(1, 200, "a"), grey(0, "")}, BodiesBy::colour);
    spec.speckle = 2;
    const LabelledImage image = label(spec, Stack{{test::picture({{7, 7, 120}, {7, 7, 7}, {9, 9, 0}})}});
    EXPECT_THAT(names(image), ElementsAre("a-7 0 7", "a-9 0 2")) << "120 is gone, and its digits";
    EXPECT_THAT(test::rows_of(image.volume), ElementsAre("111", "111", "221"));
    EXPECT_EQ(image.speckles, 2);
    EXPECT_EQ(image.speckle_pixels, 2);
    EXPECT_THAT(image.pixels_of_entry, ElementsAre(8, 1)) << "before";
}

TEST(LabelsImage, ByComponentNumberedPerNameInScanningOrder) {
    const LabelledImage image =
        label(spec_of({grey(0, ""), grey(1, "a"), grey(2, "b"), grey(3, "a")}, BodiesBy::component),
              {"1.1.1.1.1.1", //
               "...........", //
               "13.2.1.1.11"});
    EXPECT_THAT(names(image), ElementsAre("a-01 1 1", "a-02 3 1", "b-1 2 1", "a-03 1 1", "a-04 1 1", "a-05 1 2",
                                          "a-06 1 1", "a-07 1 1", "a-08 1 1", "a-09 1 1", "a-10 1 1", "a-11 1 1"));
    EXPECT_THAT(test::rows_of(image.volume), ElementsAre("7.8.9.a.b.c", "...........", "12.3.4.5.66"));
}

TEST(LabelsImage, ConnectivityOfComponents) {
    ImageSpec spec = spec_of({grey(0, ""), grey(1, "a")}, BodiesBy::component);
    const std::vector<std::string> rows{"1.", //
                                        ".1"};
    EXPECT_THAT(names(label(spec, rows)), ElementsAre("a-1 1 1", "a-2 1 1"));
    spec.connectivity = 8;
    EXPECT_THAT(names(label(spec, rows)), ElementsAre("a-1 1 2"));
    const Stack stack{{slice(rows), slice({".1", "1."})}};
    spec.connectivity = 0;
    EXPECT_EQ(label(spec, stack, 3).bodies.size(), 4u);
    spec.connectivity = 18;
    EXPECT_EQ(label(spec, stack, 3).bodies.size(), 1u);
}

TEST(LabelsImage, SpecklesAreOfBodiesNotOfEntries) {
    ImageSpec spec = spec_of({grey(1, "a"), grey(2, "a"), grey(0, "")});
    spec.speckle = 2;
    const std::vector<std::string> rows{"111.", //
                                        "121.", //
                                        ".11."};
    LabelledImage image = label(spec, rows);
    EXPECT_THAT(test::rows_of(image.volume), ElementsAre("111.", "111.", "111.")) << "the one of void is, the 2 is not";
    EXPECT_EQ(image.speckles, 1);
    spec.bodies = BodiesBy::component;
    image = label(spec, rows);
    EXPECT_EQ(image.speckles, 2);
    EXPECT_THAT(names(image), ElementsAre("a-1 0 9"));
}

TEST(LabelsImage, SplitDividesAtNecks) {
    ImageSpec spec = spec_of({grey(0, ""), grey(1, "a")}, BodiesBy::component);
    const std::vector<std::string> rows{".............", //
                                        ".11111.11111.", //
                                        ".11111.11111.", //
                                        ".11111111111.", //
                                        ".11111.11111.", //
                                        ".11111.11111.", //
                                        "............."};
    EXPECT_THAT(names(label(spec, rows)), ElementsAre("a-1 1 51"));
    spec.split = 1.5;
    const LabelledImage image = label(spec, rows);
    ASSERT_EQ(image.bodies.size(), 2u);
    EXPECT_EQ(image.bodies[0].pixels + image.bodies[1].pixels, 51);
    EXPECT_GE(std::min(image.bodies[0].pixels, image.bodies[1].pixels), 25);
    spec.split = 2.5;
    EXPECT_EQ(label(spec, rows).bodies.size(), 1u);
    spec.split = 1.5;
    spec.pixel = {1e-3, 2e-3, 0}; // the neck is then as thin, 2, but the bodies are no thicker than 3
    EXPECT_EQ(label(spec, rows).bodies.size(), 1u);
}

TEST(LabelsImage, UnmatchedColoursAreVoidAndCounted) {
    const LabelledImage image = label(spec_of({grey(1, "a")}), {"123", //
                                                                "331"});
    ASSERT_EQ(image.unmatched.size(), 2u);
    EXPECT_EQ(image.unmatched[0].rgb[0], 3);
    EXPECT_EQ(image.unmatched[0].pixels, 3);
    EXPECT_EQ(image.unmatched[1].pixels, 1);
    EXPECT_THAT(test::rows_of(image.volume), ElementsAre("1..", "..1"));
}

// === Which pixels, and where they lie

TEST(LabelsImage, CropThenFlipThenTurn) {
    ImageSpec spec = spec_of({grey(0, ""), range(1, 9, "a")}, BodiesBy::colour);
    const std::vector<std::string> rows{"....", //
                                        ".123", //
                                        ".456"};
    EXPECT_THAT(test::rows_of(label(spec, rows).volume), ElementsAre("....", ".123", ".456"));
    spec.crop = {{{{1, 3}}, {{1, 2}}, {{0, 0}}}};
    const auto after = [&] { return test::rows_of(label(spec, rows).volume); };
    EXPECT_THAT(after(), ElementsAre("123", "456"));
    spec.first_row_is_up = false;
    EXPECT_THAT(after(), ElementsAre("456", "123"));
    spec.first_row_is_up = true;
    spec.flip = {true, false, false};
    EXPECT_THAT(after(), ElementsAre("321", "654"));
    spec.quarter_turns = 1;
    EXPECT_THAT(after(), ElementsAre("14", "25", "36"));
    spec.flip = {false, true, false};
    EXPECT_THAT(after(), ElementsAre("63", "52", "41"));
    spec.flip = {};
    EXPECT_THAT(after(), ElementsAre("36", "25", "14"));
    spec.quarter_turns = 2;
    EXPECT_THAT(after(), ElementsAre("654", "321"));
    spec.quarter_turns = 3;
    EXPECT_THAT(after(), ElementsAre("41", "52", "63"));
    EXPECT_THAT(label(spec, rows).pixels_of_entry, ElementsAre(0, 6)) << "of the part that is used";
}

TEST(LabelsImage, SlicesGoUpAndTurnAboutX) {
    ImageSpec spec = spec_of({grey(0, ""), range(1, 9, "a")}, BodiesBy::colour);
    const Stack stack{{slice({"12", "34"}), slice({"..", "56"}), slice({"78", "9."})}};
    LabelVolume volume = label(spec, stack, 3).volume;
    EXPECT_THAT(volume.size, ElementsAre(2, 2, 3));
    EXPECT_THAT(volume.label, ElementsAre(3, 4, 1, 2, 5, 6, 0, 0, 9, 0, 7, 8));
    spec.crop = {{{{0, 1}}, {{0, 1}}, {{1, 2}}}};
    spec.turn_axis = 0;
    spec.quarter_turns = 1; // y goes to z, z to -y
    volume = label(spec, stack, 3).volume;
    EXPECT_THAT(volume.label, ElementsAre(5, 0, 1, 2, 3, 4, 0, 0))
        << "9. and 56 below, 78 and .. above; five colours less four";
}

TEST(LabelsImage, OneSliceOfAStackInThePlane) {
    ImageSpec spec = spec_of({range(1, 9, "a")}, BodiesBy::colour);
    const Stack stack{{slice({"12"}), slice({"34"})}};
    spec.slice = 1;
    EXPECT_THAT(names(label(spec, stack)), ElementsAre("a-3 0 1", "a-4 0 1"));
    EXPECT_EQ(label(spec, stack).volume.size[2], 1);
}

TEST(LabelsImage, SizeOfPixelsTurnsWithThem) {
    ImageSpec spec = spec_of({grey(1, "a")});
    const Stack stack{{slice({"11"})}};
    StackInfo info = stack.info();
    EXPECT_THAT(label_stack(spec, 2, info, stack.read()).spacing, ElementsAre(0, 0, 0));
    info.spacing = {{1, 2, 3}};
    EXPECT_THAT(label_stack(spec, 2, info, stack.read()).spacing, ElementsAre(1, 2, 3));
    spec.quarter_turns = 3;
    EXPECT_THAT(label_stack(spec, 2, info, stack.read()).spacing, ElementsAre(2, 1, 3));
    EXPECT_THAT(label_stack(spec, 2, info, stack.read()).volume.size, ElementsAre(1, 2, 1));
}
