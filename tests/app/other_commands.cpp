/// check, particles, pack, render; the generated documents; the example.
#include "app_support.h"

#include "geometry/images/image.h"
#include "io/results/read_frame.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <set>

namespace abut::app_test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

const std::filesystem::path source = ABUT_SOURCE_DIR;

std::string text_of(const std::filesystem::path& file) {
    return Folder().read(file.string()); // an absolute path stays as it is
}

TEST(Check, ListsTasksAndFieldsWithReasons) {
    const Folder folder;
    folder.write("scene.json", small_scene().dump());
    const auto before = folder.content();
    const Outcome outcome = folder.abut({"check", "scene.json"});
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_EQ(outcome.err, "");
    EXPECT_EQ(folder.content(), before);
    EXPECT_THAT(outcome.out, AllOf(HasSubstr("A disk hits a block"), HasSubstr("2 bodies, "),
                                   HasSubstr("12 x 12 cells"), HasSubstr("steps to 400 us")));
    const std::vector<std::string> plan = lines(outcome.out);
    const auto expect_line = [&](const std::string& name, const std::string& reason) {
        EXPECT_THAT(plan, testing::Contains(AllOf(HasSubstr(name), HasSubstr(reason))));
    };
    expect_line("  find contact groups ", "the scene has contact");
    expect_line("  gather point clouds ", "normals by regression");
    expect_line("  filter velocities ", "xpic of order 2 or more");
    expect_line("  impose conditions ", "the scene sets velocities of nodes");
    expect_line("bytes a contact node  point cloud", "(normals by regression)");
    expect_line("bytes a particle", "(always)");
    expect_line(" MB together", "");
}

TEST(Check, KnowsNothingOfContactWithoutIt) {
    const Folder folder;
    folder.write("scene.json", small_scene({R"({"contact": null, "method": {"transfer": {"scheme": "flip"}}})",
                                            R"({"method": {"transfer": {"order": null}}})"})
                                   .dump());
    const Outcome outcome = folder.abut({"check", "scene.json"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const std::string plan = outcome.out.substr(outcome.out.find("A step:"));
    for (const char* word : {"contact", "normal", "cloud", "filter", "delta"}) EXPECT_THAT(plan, Not(HasSubstr(word)));
}

TEST(Check, AppliesOverrides) {
    const Folder folder;
    folder.write("scene.json", small_scene().dump());
    EXPECT_THAT(folder.abut({"check", "scene.json", "--set", "/grid/cell=0.5 mm"}).out, HasSubstr("24 x 24 cells"));
}

TEST(Particles, WritesTheModel) {
    const Folder folder;
    folder.write("scene.json", small_scene().dump());
    const Outcome outcome = folder.abut({"particles", "scene.json"});
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_THAT(outcome.out, AllOf(HasSubstr("block"), HasSubstr("3.2e-05"), HasSubstr("scene-particles.vtu")));
    const PointFrame frame = read_points(folder / "scene-particles.vtu");
    EXPECT_GT(frame.points.size() / 3, 16U * 8U);
    EXPECT_EQ(frame.time, 0);
    const Image preview = read_image(folder / "scene-particles.png");
    EXPECT_EQ(preview.width, 1000);
    EXPECT_EQ(folder.content().size(), 3U);
    EXPECT_EQ(folder.abut({"particles", "scene.json", "-o", "nowhere/x.vtu"}).exit_code, 1);
    EXPECT_EQ(folder.abut({"particles", "scene.json", "-o", "y.vtu", "--array", "presure"}).exit_code, 2);
    EXPECT_EQ(folder.abut({"particles", "scene.json", "-o", "z.vtu", "--no-png"}).exit_code, 0);
    EXPECT_FALSE(std::filesystem::exists(folder / "z.png"));
}

TEST(Particles, WritesBoundariesAndGridIfAsked) {
    const Folder folder;
    folder.write("scene.json", small_scene().dump());
    const Outcome outcome =
        folder.abut({"particles", "scene.json", "-o", "p.vtu", "--boundaries", "b.vtp", "--grid", "g.vti", "--no-png"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_THAT(outcome.out, HasSubstr("written: p.vtu, b.vtp, g.vti"));
    const PointFrame boundaries = read_points(folder / "b.vtp");
    EXPECT_EQ(boundaries.points, (std::vector<double>{0, 0, 0, 0.012, 0, 0}));
    ASSERT_EQ(boundaries.words.size(), 1U);
    EXPECT_THAT(boundaries.words[0].values, testing::ElementsAre("floor"));
    const GridFrame grid = read_grid(folder / "g.vti");
    EXPECT_EQ(grid.nodes, (std::array<int, 3>{13, 13, 1}));
    EXPECT_EQ(grid.time, 0);

    const auto before = folder.content();
    const Outcome wrong = folder.abut({"particles", "scene.json", "-o", "q.vtu", "--boundaries", "b.vtu"});
    EXPECT_EQ(wrong.exit_code, 2);
    EXPECT_THAT(wrong.err, HasSubstr("--boundaries b.vtu: the name must end in .vtp"));
    EXPECT_EQ(folder.abut({"particles", "scene.json", "-o", "q.vtu", "--grid", "scene.json"}).exit_code, 2);
    EXPECT_EQ(folder.content(), before);
    EXPECT_EQ(folder.abut({"particles", "scene.json", "-o", "q.vtu", "--grid", "nowhere/g.vti"}).exit_code, 1);
}

TEST(Check, DrawsTheBodies) {
    const Folder folder;
    folder.write("scene.json", small_scene().dump());
    const Outcome outcome = folder.abut({"check", "scene.json", "--png", "bodies.png"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_THAT(outcome.out, HasSubstr("written: bodies.png"));
    EXPECT_EQ(read_image(folder / "bodies.png").channels, 3);
}

TEST(Pack, MakesAPictureAndItsLegend) {
    const Folder folder;
    const Arguments command{"pack", "bed.png",         "--width", "60",     "--height", "80",         "--bodies",
                            "6",    "--area-fraction", "0.5",     "--seed", "3",        "--material", "rubber"};
    const Outcome outcome = folder.abut(command);
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const Image image = read_image(folder / "bed.png");
    EXPECT_EQ(image.width, 60);
    EXPECT_EQ(image.height, 80);

    // The printed legend makes a scene of the picture.
    const std::size_t begin = outcome.out.find('\n') + 1;
    Json scene = small_scene({R"({"bodies": null, "contact": {}, "images": [{"file": "bed.png", "lower": [0, 0],
                                  "pixel": "0.15 mm"}]})"});
    const Json legend = Json::parse("{" + outcome.out.substr(begin) + "}");
    scene["images"][0]["legend"] = legend["legend"];
    folder.write("scene.json", scene.dump());
    const Outcome check = folder.abut({"check", "scene.json"});
    EXPECT_EQ(check.exit_code, 0) << check.err;
    EXPECT_THAT(check.out, HasSubstr("6 bodies, "));

    const std::string first = folder.read("bed.png");
    ASSERT_EQ(folder.abut(command).exit_code, 0);
    EXPECT_TRUE(folder.read("bed.png") == first) << "the same seed, another picture";
}

TEST(Pack, MakesASceneOfShapes) {
    const Folder folder;
    for (const char* grains : {"disks", "ellipses", "balls"}) {
        const Outcome outcome = folder.abut(
            {"pack", "bed.json", "--grains", grains, "--bodies", "5", "--area-fraction", "0.2", "--pixel", "1e-5"});
        ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
        const Outcome check = folder.abut({"check", "bed.json"});
        EXPECT_EQ(check.exit_code, 0) << grains << check.err;
        EXPECT_THAT(check.out, HasSubstr("5 bodies, "));
    }
}

TEST(Render, DrawsEveryFrame) {
    const Folder folder;
    folder.write("scene.json", small_scene({R"({"time": {"end": "0.2 ms"}})"}).dump());
    ASSERT_EQ(folder.abut({"run", "scene.json", "-o", "results", "--quiet"}).exit_code, 0);
    const Outcome outcome = folder.abut({"render", "results", "--width", "300"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_THAT(outcome.out, HasSubstr("3 pictures"));
    const Image picture = read_image(folder / "results/frames/bodies/frame_00002.png");
    EXPECT_EQ(picture.width, 300);
    std::set<std::array<int, 3>> colours;
    for (int row = 0; row < picture.height; ++row)
        for (int column = 0; column < picture.width; ++column) colours.insert(picture.rgb(column, row));
    EXPECT_GT(colours.size(), 10U);

    ASSERT_EQ(folder.abut({"render", "results", "--preset", "normals", "--last", "-o", "pictures"}).exit_code, 0);
    EXPECT_TRUE(std::filesystem::exists(folder / "pictures/frame_00002.png"));
    EXPECT_FALSE(std::filesystem::exists(folder / "pictures/frame_00001.png"));
}

TEST(Documents, AreThoseOfTheProgram) {
    const Folder folder;
    const Outcome schema = folder.abut({"schema"}), reference = folder.abut({"reference"});
    EXPECT_EQ(schema.exit_code, 0);
    EXPECT_EQ(reference.exit_code, 0);
    EXPECT_TRUE(Json::parse(schema.out).contains("properties"));
    EXPECT_TRUE(schema.out == text_of(source / "io/scene/scene.schema.json"))
        << "out of date; run: abut schema > io/scene/scene.schema.json";
    EXPECT_TRUE(reference.out == text_of(source / "io/scene/REFERENCE.md"))
        << "out of date; run: abut reference > io/scene/REFERENCE.md";
}

/// The first scene that a document shows.
std::string scene_in(const std::filesystem::path& document) {
    const std::string text = text_of(document), opening = "```jsonc\n";
    const std::size_t begin = text.find(opening) + opening.size();
    return text.substr(begin, text.find("```", begin) - begin);
}

TEST(Documents, ScenesInThemCanBeRun) {
    const Folder folder;
    Image picture{200, 200, 3, std::vector<std::uint16_t>(3 * 200 * 200, 255)};
    const auto draw = [&](int first_row, int last_row, const std::array<std::uint8_t, 3>& rgb) {
        for (int row = first_row; row < last_row; ++row)
            for (int column = 60; column < 140; ++column)
                std::copy(rgb.begin(), rgb.end(), picture.pixels.begin() + 3 * (200 * row + column));
    };
    draw(20, 100, {0xd0, 0x40, 0x20});
    draw(120, 200, {0x30, 0x60, 0xc0});
    write_image(picture, folder / "drop.png");
    for (const char* document : {"README.md", "io/scene/REFERENCE.md"}) {
        folder.write("drop.json", scene_in(source / document));
        const Outcome outcome = folder.abut({"check", "drop.json"});
        EXPECT_EQ(outcome.exit_code, 0) << document << "\n" << outcome.err;
        EXPECT_THAT(outcome.out, HasSubstr("2 bodies, ")) << document;
    }
}

TEST(Documents, AreNotLostOnAFullDisk) {
    for (const char* command : {"schema", "reference"}) {
        const std::string line = std::string(ABUT_PROGRAM) + " " + command + " > /dev/full 2> /dev/null";
        EXPECT_EQ(std::system(line.c_str()) / 256, 1) << command; // NOLINT: a fixed command
    }
}

TEST(Examples, CanBeRun) {
    int scenes = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(source / "examples")) {
        if (entry.path().filename() != "scene.json") continue;
        const Outcome outcome = Folder().abut({"check", entry.path().string()});
        EXPECT_EQ(outcome.exit_code, 0) << entry.path() << "\n" << outcome.err;
        ++scenes;
    }
    EXPECT_GT(scenes, 0);
}

TEST(Examples, EllipsesAreThePublishedSize) {
    const Outcome outcome = Folder().abut({"check", (source / "examples/ellipses/scene.json").string()});
    EXPECT_THAT(outcome.out, AllOf(HasSubstr("20 bodies, "), HasSubstr("70 x 140 cells")));
}

TEST(Examples, EllipsesStartToRun) {
    const Folder folder;
    const Outcome outcome = folder.abut({"run", (source / "examples/ellipses/scene.json").string(), "-o", "results",
                                         "--quiet", "--until", "0.1 us", "--set", "/grid/cell=28.6 um"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
}

} // namespace
} // namespace abut::app_test
