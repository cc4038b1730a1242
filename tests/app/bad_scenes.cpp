/// Scenes that cannot be used: a message that names file, place and cause, exit code 2, and nothing written.
#include "app_support.h"

#include "geometry/support.h" // of the tests: pictures byte by byte

namespace abut::app_test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

/// Runs the scene; every one of `messages` must be a line of its own, and all lines must be messages.
void expect_refused(const Folder& folder, const Json& scene, const std::vector<std::string>& messages) {
    folder.write("bad.json", scene.dump(2));
    const auto before = folder.content();
    const Outcome outcome = folder.abut({"run", "bad.json", "-o", "results", "--quiet"});
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_EQ(outcome.out, "");
    std::vector<std::string> expected;
    for (const std::string& message : messages) expected.push_back("bad.json: " + message);
    EXPECT_THAT(lines(outcome.err), testing::UnorderedElementsAreArray(expected));
    EXPECT_EQ(folder.content(), before) << "something was written";
    EXPECT_EQ(folder.abut({"check", "bad.json"}).err, outcome.err);
}

void expect_refused(const std::vector<std::string>& patches, const std::vector<std::string>& messages) {
    const Folder folder;
    expect_refused(folder, small_scene(patches), messages);
}

TEST(BadScene, BodyOutsideTheGrid) {
    expect_refused({R"({"bodies": [{"name": "block", "material": "rubber",
                        "box": {"lower": ["8 mm", 0], "upper": ["14 mm", "4 mm"]}}]})"},
                   {"/bodies/0/box: reaches out of the grid: up to x = 0.014 m, the grid ends at 0.012 m"});
}

TEST(BadScene, NoParticles) {
    expect_refused({R"({"bodies": []})"},
                   {R"(/bodies: the scene is empty; it needs an entry in "bodies" or "images")"});
}

TEST(BadScene, NegativeDensity) {
    expect_refused({R"({"materials": {"rubber": {"density": "-1 g/cm^3"}}})"},
                   {"/materials/rubber/density: must be greater than 0 kg/m^3, not -1 g/cm^3"});
}

TEST(BadScene, IncompressibleMaterial) {
    expect_refused({R"({"materials": {"rubber": {"poissons_ratio": 0.5}}})"},
                   {"/materials/rubber/poissons_ratio: must be between -1 and 0.5 (both excluded), not 0.5; at 0.5 a "
                    "solid is incompressible and has an infinite bulk modulus; use e.g. 0.49"});
}

TEST(BadScene, CellLargerThanABody) {
    expect_refused({R"({"grid": {"cell": ["1 mm", "6 mm"]}})"},
                   {"/bodies/0/box: cell larger than the body: its edge along y is 0.004 m, a cell 0.006 m",
                    "/bodies/1/disk: cell larger than the body: its diameter is 0.005 m, a cell 0.006 m"});
}

TEST(BadScene, WallOutsideTheGrid) {
    expect_refused(
        {R"({"boundaries": [{"name": "roof", "wall": {"axis": "y", "side": "upper", "position": "13 mm"}}]})"},
        {"/boundaries/0/wall/position: outside the grid at 0.013 m; the grid reaches from 0 m to 0.012 m"});
}

TEST(BadScene, WallThatLeavesTheGrid) {
    expect_refused({R"({"boundaries": [{"name": "roof", "wall": {"axis": "y", "side": "upper", "position": "12 mm",
                                                                "velocity": "-40 m/s"}}]})"},
                   {"/boundaries/0/wall/velocity: the wall moves out of the grid at t = 0.0003 s, before the end; the "
                    "grid reaches from 0 m to 0.012 m"});
}

TEST(BadScene, TimeStepAboveTheStableOne) {
    const Folder folder;
    folder.write("bad.json", small_scene({R"({"time": {"step": "100 us"}})"}).dump());
    const auto before = folder.content();
    for (const char* command : {"run", "check"}) {
        const Outcome outcome = folder.abut({command, "bad.json"});
        EXPECT_EQ(outcome.exit_code, 2);
        EXPECT_THAT(outcome.err, AllOf(StartsWith("bad.json: /time/step: 0.0001 s is above the stable step, "),
                                       HasSubstr("cell / wave speed)")));
        EXPECT_EQ(folder.content(), before);
    }
}

TEST(BadScene, AllProblemsAtOnce) {
    expect_refused(
        {R"({"bodies": [{"name": "block", "material": "ruber", "velocty": [0, 0],
                                    "box": {"lower": [0, 0], "upper": ["3 mm", "4 s"]}}],
                        "contact": {"law": {"type": "friction"}}, "ttle": "x"})",
         R"({"contact": {"law": {"coefficient": null}}})"},
        {R"(/bodies/0/velocty: unknown key "velocty"; did you mean "velocity"?)",
         R"(/bodies/0/material: no material "ruber"; did you mean "rubber"?)",
         "/bodies/0/box/upper/1: 4 s is a time; a length (m) is needed",
         "/contact/law/coefficient: this key is required and missing. Coefficient of friction µ while sliding; of "
         "`adhesion` under pressure, and when it has failed.",
         R"(/ttle: unknown key "ttle"; did you mean "title"?)"});
}

TEST(BadScene, MissingFile) {
    const Folder folder;
    const Outcome outcome = folder.abut({"run", "nowhere.json"});
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_EQ(outcome.err, "nowhere.json: cannot read the scene file: No such file or directory\n");
    EXPECT_TRUE(folder.content().empty());
}

TEST(BadScene, BrokenJson) {
    const Folder folder;
    folder.write("bad.json", "{\n  \"title\": \"x\",\n  \"grid\": { oops }\n}\n");
    const Outcome outcome = folder.abut({"check", "bad.json"});
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_THAT(outcome.err, AllOf(StartsWith("bad.json: "), HasSubstr("line 3")));
}

// === Images

/// small_scene() with bodies from `picture.png` alone: grey 0 is a block, and what `more` adds to the legend.
Json image_scene(const std::string& more = R"(, {"grey": 255, "void": true})") {
    return small_scene({R"({"bodies": null, "images": [{"file": "picture.png", "size": ["4 mm", "4 mm"],
        "lower": ["2 mm", 0], "legend": [{"grey": 0, "body": "block", "material": "rubber"})" +
                        more + "]}]}"});
}

/// A grey PNG of 4 × 4 pixels.
std::string grey_png(int bits, const test::Bytes& row, int colour_type = 0) {
    const test::Bytes file = test::png(4, bits, colour_type, {row, row, row, row});
    return {file.begin(), file.end()};
}

const test::Bytes black_and_white{0, 0, 255, 255};

TEST(BadImage, Missing) {
    const Folder folder;
    expect_refused(folder, image_scene(),
                   {"/images/0/file: image \"" + (folder / "picture.png").string() + "\" does not exist"});
}

TEST(BadImage, NotAPicture) {
    const Folder folder;
    folder.write("picture.png", "this is text");
    expect_refused(folder, image_scene(),
                   {"/images/0/file: image \"" + (folder / "picture.png").string() +
                    "\" is not a PNG, BMP, TIFF, JPEG or VTI picture"});
}

TEST(BadImage, CutOff) {
    const Folder folder;
    folder.write("picture.png", grey_png(8, black_and_white).substr(0, 50));
    folder.write("bad.json", image_scene().dump());
    const Outcome outcome = folder.abut({"run", "bad.json"});
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_THAT(outcome.err, AllOf(StartsWith("bad.json: /images/0/file: image \""), HasSubstr("picture.png")));
    EXPECT_EQ(lines(outcome.err).size(), 1U);
}

TEST(BadImage, Transparent) {
    const Folder folder;
    folder.write("picture.png", grey_png(8, {0, 255, 0, 255, 255, 255, 255, 9}, 4));
    expect_refused(folder, image_scene(),
                   {"/images/0/file: image \"" + (folder / "picture.png").string() +
                    "\" has transparency at 4 pixels; flatten it (remove its alpha channel)"});
}

TEST(BadImage, OpaqueAlphaIsFine) {
    const Folder folder;
    folder.write("picture.png", grey_png(8, {0, 255, 0, 255, 255, 255, 255, 255}, 4));
    folder.write("good.json", image_scene().dump());
    EXPECT_EQ(folder.abut({"check", "good.json"}).exit_code, 0);
}

TEST(BadImage, AnimatedOrOfNoKnownKind) {
    const Folder folder;
    folder.write("picture.png", "GIF89a and more");
    folder.write("bad.json", image_scene().dump());
    const Outcome outcome = folder.abut({"run", "bad.json"});
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_THAT(outcome.err, AllOf(StartsWith("bad.json: /images/0/file: image \""), HasSubstr("GIF")));
}

TEST(BadImage, ColourThatTheLegendLacks) {
    const Folder folder;
    folder.write("picture.png", grey_png(8, {0, 0, 255, 7}));
    expect_refused(folder, image_scene(),
                   {"/images/0/legend: no entry covers grey 7 (4 pixels); add entries, a tolerance to the ones there, "
                    "or a \"grey_range\""});
}

TEST(BadImage, LegendWithoutVoid) {
    const Folder folder;
    folder.write("picture.png", grey_png(8, black_and_white));
    expect_refused(folder, image_scene(""),
                   {"/images/0/legend: no entry covers grey 255 (8 pixels); add entries, a tolerance to the ones "
                    "there, or a \"grey_range\""});
    // A picture that bodies cover completely needs none.
    folder.write("picture.png", grey_png(8, {0, 0, 0, 0}));
    EXPECT_EQ(folder.abut({"check", "bad.json"}).exit_code, 0);
}

TEST(BadImage, OutsideTheGrid) {
    const Folder folder;
    folder.write("picture.png", grey_png(8, black_and_white));
    Json scene = image_scene();
    scene["images"][0].erase("size");
    scene["images"][0]["pixel"] = "4 mm"; // how many pixels there are shows only when the image is read
    expect_refused(
        folder, scene,
        {"/images/0: the image reaches beyond the grid along x: it goes from 2 mm to 18 mm, the grid from 0 "
         "m to 12 mm",
         "/images/0: the image reaches beyond the grid along y: it goes from 0 m to 16 mm, the grid from 0 m "
         "to 12 mm"});
}

TEST(BadImage, BodyWithoutParticles) {
    const Folder folder;
    folder.write("picture.png", grey_png(8, black_and_white));
    expect_refused(folder, image_scene(R"(, {"grey": 255, "void": true}, {"rgb": "#ff0000", "body": "red",
                                           "material": "rubber"})"),
                   {"/images/0/legend/2: body \"red\" got no particles: no pixel of the image has its colour #ff0000"});
}

} // namespace
} // namespace abut::app_test
