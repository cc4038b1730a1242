// What label_image() refuses, and stacks of files.
#include "geometry/labels/label_image.h"

#include "labels_stack.h"
#include "labels_support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

using namespace abut; // NOLINT(google-build-using-namespace): the room under test
using test::grey;
using test::label;
using test::slice;
using test::spec_of;
using test::Stack;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

namespace {

std::string error_of(const ImageSpec& spec, const Stack& stack, int dimension = 2) {
    return test::message_of([&] { label(spec, stack, dimension); });
}

} // namespace

TEST(LabelsRefused, WhatIsNotThere) {
    const ImageSpec spec = spec_of({grey(1, "a")});
    const Stack two{{slice({"11", "11", "11"}), slice({"11", "11", "11"})}}, one{{slice({"11"})}};
    const auto with = [&](auto change) {
        ImageSpec other = spec;
        change(other);
        return other;
    };
    EXPECT_EQ(error_of(spec, two), "is a stack of 2 slices; name the one to use: \"slice\" from 0 to 1");
    EXPECT_EQ(error_of(with([](auto& s) { s.slice = 2; }), two), "has slices 0 to 1; \"slice\" is 2");
    EXPECT_EQ(error_of(with([](auto& s) { s.slice = -1; }), one), "has one slice, 0; \"slice\" is -1");
    EXPECT_THAT(error_of(with([](auto& s) { s.slice = 0; }), two, 3), HasSubstr("needs no \"slice\" in a 3D scene"));
    EXPECT_EQ(error_of(with([](auto& s) {
                           s.crop = {{{{0, 2}}, {{0, 0}}, {{0, 0}}}};
                       }),
                       one),
              "cannot be cropped to columns 0 to 2: it has 2 x 1 pixels, so columns go from 0 to 1");
    EXPECT_EQ(error_of(with([](auto& s) {
                           s.crop = {{{{0, 1}}, {{-1, 2}}, {{0, 0}}}};
                       }),
                       two, 3),
              "cannot be cropped to rows -1 to 2: it has 2 x 3 pixels in 2 slices, so rows go from 0 to 2");
    EXPECT_THAT(error_of(with([](auto& s) {
                             s.crop = {{{{0, 1}}, {{0, 2}}, {{1, 2}}}};
                         }),
                         two, 3),
                StartsWith("cannot be cropped to slices 1 to 2: "));
    EXPECT_THAT(error_of(with([](auto& s) {
                             s.crop = {{{{1, 0}}, {{0, 0}}, {{0, 0}}}};
                         }),
                         one),
                HasSubstr("columns 1 to 0: the last comes before the first"));
}

TEST(LabelsRefused, WhatDoesNotFit) {
    const Stack one{{slice({"11"})}};
    ImageSpec spec = spec_of({grey(1, "a")});
    spec.connectivity = 6;
    EXPECT_EQ(error_of(spec, one), "has pixels with 4 or 8 neighbours in a plane; connectivity is 6");
    spec.connectivity = 8;
    EXPECT_EQ(error_of(spec, one, 3), "has pixels with 6, 18 or 26 neighbours in 3D; connectivity is 8");
    spec.connectivity = 0;
    spec.split = 1;
    EXPECT_THAT(error_of(spec, one), HasSubstr("only where bodies go by \"component\""));
    spec.bodies = BodiesBy::component;
    spec.split = 0;
    EXPECT_THAT(error_of(spec, one), HasSubstr("larger than 0 pixels, not 0"));
    spec.split.reset();
    spec.turn_axis = 0;
    EXPECT_EQ(error_of(spec, one), "");
    spec.quarter_turns = 1;
    EXPECT_THAT(error_of(spec, one), HasSubstr("about z only in a plane scene"));
    Stack odd{{slice({"11"}), slice({"1"})}};
    spec.turn_axis = 2;
    EXPECT_EQ(error_of(spec, odd, 3), "has 1 x 1 pixels in slice 1, but 2 x 1 elsewhere");
}

TEST(LabelsRefused, MoreThanCanBeCountedBeforeItReads) {
    const StackInfo info{1 << 14, 1 << 14, 8, 8, {}};
    const auto never = [](int, int, const auto&) { FAIL() << "reads"; };
    EXPECT_THAT(test::message_of([&] { label_stack(spec_of({grey(1, "a")}), 3, info, never); }),
                HasSubstr("has 16384 x 16384 pixels in 8 slices: more than the 2147483647 pixels"));
}

TEST(LabelsRefused, Noise) {
    std::vector<std::vector<int>> board(700, std::vector<int>(700, 0));
    for (std::size_t j = 0; j < 700; ++j)
        for (std::size_t i = 0; i < 700; ++i) board[j][i] = (i + j) % 2;
    ImageSpec spec = spec_of({grey(0, ""), grey(1, "a")}, BodiesBy::component);
    const Stack stack{{test::picture(board)}};
    EXPECT_EQ(error_of(spec, stack), "has 245000 components that would each be a body, more than 100000: probably "
                                     "noise; raise \"speckle\", or smooth the image");
    spec.connectivity = 8;
    EXPECT_EQ(error_of(spec, stack), "");
    Image colours{400, 400, 3, {}};
    for (int p = 0; p < 400 * 400; ++p)
        for (const int channel : {p & 255, (p >> 8) & 255, p >> 16})
            colours.pixels.push_back(static_cast<std::uint16_t>(channel));
    spec = spec_of({grey(128, "a")}, BodiesBy::colour);
    spec.legend[0].tolerance = 128;
    EXPECT_THAT(error_of(spec, Stack{{colours}}), HasSubstr("has 160000 colours that would each be a body"));
}

// === From files

TEST(LabelsRefused, NothingInStacksOfNumberedFiles) {
    const test::Folder folder;
    folder.write("ct_9.png", test::png(2, 8, 0, {{1, 0}, {2, 1}}));
    folder.write("ct_10.png", test::png(2, 8, 0, {{0, 0}, {2, 2}}));
    const ImageSpec spec = spec_of({grey(0, ""), grey(1, "a"), grey(2, "b")}, BodiesBy::component);
    const LabelledImage image = label_image(spec, 3, folder.path / "ct_*.png");
    EXPECT_THAT(image.volume.label, ElementsAre(1, 2, 3, 0, 1, 1, 0, 0));
    EXPECT_THAT(test::message_of([&] { label_image(spec, 2, folder.path / "ct_*.png"); }),
                StartsWith("is a stack of 2 slices"));
    EXPECT_THAT(test::message_of([&] { label_image(spec, 2, folder.path / "none.png"); }), HasSubstr("does not exist"));
}
