// Outlines from CSV and SVG files.
#include "geometry/shapes/path_file.h"

#include "geometry/shapes/make_solid.h"
#include "support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

using namespace abut; // NOLINT(google-build-using-namespace): the room under test
using test::Folder;
using test::message_of;
using testing::ElementsAre;
using testing::HasSubstr;

namespace {

constexpr double pi = std::numbers::pi;

std::vector<Outline2D> read(const std::string& text) {
    const Folder folder;
    return read_path_file(folder.write("file", test::Bytes(text.begin(), text.end())));
}

std::string error(const std::string& text) {
    testing::internal::CaptureStderr();
    const std::string message = message_of([&] { read(text); });
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "") << "libraries must not print";
    return message;
}

std::string svg(const std::string& inside, const std::string& attributes = "viewBox=\"0 0 100 50\"") {
    return "<?xml version=\"1.0\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" " + attributes + ">" + inside + "</svg>";
}

double area(const std::string& inside) {
    double sum = 0;
    for (const Outline2D& outline : read(svg(inside))) sum += area_of(outline);
    return sum;
}

} // namespace

TEST(PathFile, Csv) {
    const auto outlines = read("x [mm]; y [mm]\n# a triangle\n0;0\n4;0\n0;3\n0;0\n\n\n1, 1\n+1.5,1\n1e0\t1.5\r\n");
    ASSERT_EQ(outlines.size(), 2u);
    EXPECT_THAT(outlines[0], ElementsAre(PlanePoint{0, 0}, PlanePoint{4, 0}, PlanePoint{0, 3}));
    EXPECT_THAT(outlines[1], ElementsAre(PlanePoint{1, 1}, PlanePoint{1.5, 1}, PlanePoint{1, 1.5}));
}

TEST(PathFile, CsvThatIsWrong) {
    EXPECT_THAT(error("0 0\n1 0\n1 x\n"), HasSubstr("line 3: two numbers are needed, not \"1 x\""));
    EXPECT_THAT(error("0 0\n1 0 3\n"), HasSubstr("line 2: two numbers are needed"));
    EXPECT_THAT(error("0,0\n1,0mm\n"), HasSubstr("line 2"));
    EXPECT_THAT(error("# nothing\n"), HasSubstr("has no outlines"));
    EXPECT_THAT(error(""), HasSubstr("has no outlines"));
    EXPECT_THAT(message_of([] { read_path_file("/nowhere/path.csv"); }),
                HasSubstr("path \"/nowhere/path.csv\": No such file"));
}

TEST(PathFile, SvgIsSeenAsAViewerShowsIt) {
    // From the lower left corner of the viewBox, y upwards.
    EXPECT_THAT(read(svg("<path d='M10,40 h20 v-10 z'/>"))[0],
                ElementsAre(PlanePoint{10, 10}, PlanePoint{30, 10}, PlanePoint{30, 20}));
    EXPECT_THAT(read(svg("<polygon points='10,40 30,40 30,30'/>", "viewBox='5 5 100 50'"))[0],
                ElementsAre(PlanePoint{5, 15}, PlanePoint{25, 15}, PlanePoint{25, 25}));
    EXPECT_THAT(read(svg("<polygon points='10,40 30,40 30,30'/>", "height='60px'"))[0],
                ElementsAre(PlanePoint{10, 20}, PlanePoint{30, 20}, PlanePoint{30, 30}));
}

TEST(PathFile, SvgShapesAndCurves) {
    EXPECT_NEAR(area("<circle cx='50' cy='25' r='10'/>"), pi * 100, pi * 100 * 3e-5);
    EXPECT_NEAR(area("<ellipse cx='50' cy='25' rx='20' ry='5'/>"), pi * 100, pi * 100 * 3e-5);
    EXPECT_NEAR(area("<rect x='3' y='4' width='5' height='6'/>"), 30, 1e-12);
    // Arcs: a half disk with a large arc, three quarters of a disk, radii that are too small and grow, turned ellipses.
    EXPECT_NEAR(area("<path d='M40 25 A10 10 0 0 1 60 25 Z'/>"), pi * 50, 0.01);
    EXPECT_NEAR(area("<path d='M50 25 L60 25 A10 10 0 1 1 50 15 Z'/>"), pi * 75, 0.01);
    EXPECT_NEAR(area("<path d='M40 25 A1 1 0 0 1 60 25 Z'/>"), pi * 50, 0.01);
    EXPECT_NEAR(area("<path d='M40 25a10,5 30 1,0 20,0 10,5 30 1 0 -20 0z'/>") / (pi * 50), 1, 1.0)
        << "flags and repeats";
    EXPECT_NEAR(area("<path d='M40 25a10 5 30 0110 0'/>") >= 0, true, 0) << "flags without separators";
    // ∫ of a cubic: the area between the curve (0,0) (0,1) (1,1) (1,0) and its chord is 3/5.
    EXPECT_NEAR(area("<path d='M0 0 C0 1 1 1 1 0 Z'/>"), 0.6, 1e-4);
    EXPECT_NEAR(area("<path d='M0 0 Q1 2 2 0 Z'/>"), 4.0 / 3, 1e-4) << "a parabola: 2/3 of the triangle's 2";
    EXPECT_NEAR(area("<path d='M0 0 Q1 2 2 0 T 4 0 L0 0 Z'/>"), area("<path d='M0 0 Q1 2 2 0 Q3 -2 4 0 L0 0 Z'/>"),
                1e-12);
    EXPECT_NEAR(area("<path d='M0 0 c0 1 1 1 1 0 s 1 -1 1 0 l-2 0z'/>"),
                area("<path d='M0 0 c0 1 1 1 1 0 c0 -1 1 -1 1 0 l-2 0z'/>"), 1e-12);
    EXPECT_EQ(read(svg("<path d='M0 0h1v1zM5 5h1v1z m10 10h1v1z'/>")).size(), 3u);
}

TEST(PathFile, SvgTransforms) {
    EXPECT_NEAR(area("<g transform='scale(2,3)'><g transform='translate(5) rotate(30)'>"
                     "<rect width='2' height='1' transform='skewX(20)'/></g></g>"),
                12, 1e-9);
    EXPECT_THAT(
        read(svg("<g transform='translate(10,20)'><rect width='2' height='1' transform='rotate(90)'/></g>"))[0][1],
        ElementsAre(testing::DoubleNear(10, 1e-12), testing::DoubleNear(50 - 22, 1e-12)));
    EXPECT_NEAR(area("<rect width='2' height='1' transform='matrix(1 2 3 4 5 6)'/>"), 4, 1e-12);
}

TEST(PathFile, SvgThatIsWrong) {
    EXPECT_THAT(error("<svg><path d='M0 0'"), HasSubstr("is no valid XML"));
    EXPECT_THAT(error("<html/>"), HasSubstr("is XML, but a <html>"));
    EXPECT_THAT(error(svg("<text>a</text>")), HasSubstr("has a <text>"));
    EXPECT_THAT(error(svg("<use href='#a'/>")), HasSubstr("has a <use>"));
    EXPECT_THAT(error(svg("<path d='L 3 4'/>")), HasSubstr("can't be understood"));
    EXPECT_THAT(error(svg("<path d='M 3 4 5'/>")), HasSubstr("can't be understood"));
    EXPECT_THAT(error(svg("<path d='M 0 0 X 3 4'/>")), HasSubstr("unknown path command \"X\""));
    EXPECT_THAT(error(svg("<path d='M 0 0 L inf 4'/>")), HasSubstr("can't be understood"));
    EXPECT_THAT(error(svg("<rect width='3mm' height='2'/>")), HasSubstr("width=\"3mm\""));
    EXPECT_THAT(error(svg("<rect width='3' height='2' transform='turn(3)'/>")), HasSubstr("transform \"turn(3)\""));
    EXPECT_THAT(error(svg("")), HasSubstr("has no outlines"));
    std::string nested;
    for (int k = 0; k < 300; ++k) nested += "<g>";
    for (int k = 0; k < 300; ++k) nested += "</g>";
    EXPECT_THAT(error(svg(nested)), HasSubstr("more than 100 groups"));
}

TEST(PathFile, PlacedAndFilledByTheEvenOddRule) {
    const Folder folder;
    const std::string text = svg("<rect width='40' height='40'/><rect x='10' y='10' width='20' height='20'/>");
    folder.write("frame.svg", test::Bytes(text.begin(), text.end()));
    Placement placement{1e-3, {0, 0, 1}, pi / 2, {1, 2, 0}};
    const Solid frame = make_solid(Path{"frame.svg", placement}, {{}, 2, folder.path, 0.01});
    // The frame lies at x 0 … 40, y 10 … 50 of the drawing; turned, at −50 … −10, 0 … 40.
    EXPECT_NEAR(frame.lower[0], 1 - 0.05, 1e-12);
    EXPECT_NEAR(frame.upper[1], 2.04, 1e-12);
    const Spans through = frame.spans(1 - 0.03, 0);
    ASSERT_EQ(through.size(), 2u);
    EXPECT_NEAR(through[0].to, 2.01, 1e-12);
    const std::string crossing = svg("<rect width='40' height='40'/><rect x='30' y='30' width='20' height='20'/>");
    folder.write("frame.svg", test::Bytes(crossing.begin(), crossing.end()));
    EXPECT_THAT(message_of([&] {
                    make_solid(Path{"frame.svg", {}}, {{}, 2, folder.path, 0.01});
                }),
                HasSubstr("path \"frame.svg\": outline 1 crosses outline 2 at ("));
}

TEST(PathFile, CsvKeepsItsFirstPoint) {
    const std::string square = "0,0 # a corner\n4,0\n# between\n4,4\n0,4\n";
    EXPECT_EQ(read(square)[0].size(), 4u);
    EXPECT_EQ(read("\xef\xbb\xbf" + square)[0].size(), 4u) << "a byte order mark is no header";
    EXPECT_THAT(error("0,O\n4,0\n4,4\n0,4\n"), HasSubstr("line 1: two numbers are needed, not \"0,O\""));
    EXPECT_THAT(error("0 0\n1 nan\n1 1\n"), HasSubstr("line 2"));
}

TEST(PathFile, SvgCountsWhatIsDisplayed) {
    const std::string shown = "<rect x='20' width='5' height='5'/>", hidden = "<rect width='3' height='3'";
    EXPECT_EQ(area("<g display='none'>" + hidden + "/></g>" + shown), 25);
    EXPECT_EQ(area(hidden + " style='fill:red; display : none'/>" + shown), 25);
    EXPECT_EQ(area("<g visibility='hidden'>" + hidden + "/><g visibility='visible'>" + shown + "</g></g>"), 25);
    EXPECT_THAT(error(svg(hidden + " clip-path='url(#c)'/>")), HasSubstr("has a <rect> with a clip-path"));
    EXPECT_THAT(error(svg(hidden + " style='mask:url(#c)'/>")), HasSubstr("has a <rect> with a mask"));
    EXPECT_THAT(error(svg("<svg x='50'>" + shown + "</svg>")), HasSubstr("has a <svg> inside"));
    // A viewer closes what it fills, and shows no more than a line of what it does not.
    EXPECT_EQ(area("<path d='M0 0 L10 0 L10 10'/>"), 50);
    EXPECT_EQ(area("<path fill='none' d='M0 0 L10 0 L10 10 z'/>"), 50);
    EXPECT_EQ(area("<path fill='none' d='M0 0 L10 0 L10 10 L0 0'/>"), 50);
    EXPECT_THAT(error(svg("<g fill='none'><path d='M0 0 L10 0 L10 10'/></g>")), HasSubstr("<path> is open"));
}

TEST(PathFile, SvgNumbersAreNotGuessed) {
    EXPECT_THAT(error(svg("<polygon points='0,0 1O,0 10,10'/>")), HasSubstr("\"O,0 10,10\" is no number"));
    EXPECT_THAT(error(svg("<polygon points='0,0 1e400,0 10,10 10,3'/>")), HasSubstr("is no number"));
    EXPECT_EQ(area("<polygon points='0-0+10,0 10-1e1'/>"), 50) << "signs separate numbers";
    EXPECT_THAT(error(svg("<rect width='-5' height='5'/>")), HasSubstr("<rect> has a negative width"));
    EXPECT_THAT(error(svg("<circle r='-5'/>")), HasSubstr("<circle> has a negative r"));
    EXPECT_THAT(error(svg("<rect width='5' height='5' transform='scaleX(2)'/>")), HasSubstr("scaleX(2)"));
    const std::string square = "<rect width='5' height='5'/>";
    EXPECT_NEAR(read(svg(square, "height='254mm'"))[0][0][1], 960, 1e-9); // 96 pixels an inch
    EXPECT_EQ(read(svg(square, "height='100%'"))[0][0][1], 0) << "a share of an unknown window is no height";
}

TEST(PathFile, SvgCurvesKeepTheirToleranceWhenStretched) {
    // y = 200 s (1 - s) at x = 100 s, of height 50 after the transform.
    const Outline2D arch = read(svg("<path transform='scale(1,1000)' d='M0 0 Q50 0.1 100 0z'/>"))[0];
    double worst = 0;
    for (std::size_t k = 0; k + 1 < arch.size(); ++k) {
        const double s = (arch[k][0] + arch[k + 1][0]) / 200;
        worst = std::max(worst, std::abs(50 - 200 * s * (1 - s) - (arch[k][1] + arch[k + 1][1]) / 2));
    }
    EXPECT_LT(worst, 1e-5 * 125);
    EXPECT_GT(worst, 0);
}

TEST(PathFile, SvgRelativePathsCloseInSpiteOfRoundOff) {
    // 0.1 + 0.1 + 0.7 - 0.1 - 0.7 is not 0.1.
    const auto outlines = read(svg("<path d='M0.1 0.1l0.1 0.7l0.7 0.1l-0.1-0.7l-0.7-0.1z'/>"));
    EXPECT_EQ(outlines[0].size(), 4u);
    EXPECT_NO_THROW(check_outlines(outlines));
}

TEST(PathFile, HostileSvg) {
    std::string nested;
    for (int k = 0; k < 300000; ++k) nested += "<g>"; // a tree of these could not be destroyed
    for (int k = 0; k < 300000; ++k) nested += "</g>";
    EXPECT_THAT(error(svg(nested)), HasSubstr("more than 100 groups"));
    std::string arcs = "M0 0";
    for (int k = 0; k < 600000; ++k) arcs += "a9 9 0 111 1"; // 600 points each
    EXPECT_THAT(error(svg("<path d='" + arcs + "'/>")), HasSubstr("more than ten million points"));
}
