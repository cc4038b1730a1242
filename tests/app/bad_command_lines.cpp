/// Command lines that cannot be carried out: exit code 2, and nothing written.
#include "app_support.h"

namespace abut::app_test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

void expect_refused(const Folder& folder, const Arguments& arguments, const std::string& words) {
    const auto before = folder.content();
    const Outcome outcome = folder.abut(arguments);
    EXPECT_EQ(outcome.exit_code, 2) << outcome.out << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr(words));
    EXPECT_EQ(folder.content(), before) << "something was written";
}

TEST(BadCommandLine, Words) {
    const Folder folder;
    folder.write("scene.json", small_scene().dump());
    expect_refused(folder, {}, "A subcommand is required");
    expect_refused(folder, {"rum", "scene.json"}, R"(abut: no command "rum"; did you mean "run"?)");
    expect_refused(folder, {"run"}, "SCENE is required");
    expect_refused(folder, {"run", "scene.json", "--fast"}, "--fast");
    expect_refused(folder, {"run", "scene.json", "--threads", "0"}, "--threads");
    expect_refused(folder, {"run", "scene.json", "--threads", "two"}, "--threads");
    expect_refused(folder, {"run", "scene.json", "-o"}, "--output");
}

TEST(BadCommandLine, Until) {
    const Folder folder;
    folder.write("scene.json", small_scene().dump());
    expect_refused(folder, {"run", "scene.json", "--until", "soon"}, "abut: --until: ");
    expect_refused(folder, {"run", "scene.json", "--until", "3 mm"}, "abut: --until: ");
    expect_refused(folder, {"run", "scene.json", "--until", "0"}, "abut: --until: 0 is not a time after the start");
}

TEST(BadCommandLine, Set) {
    const Folder folder;
    folder.write("scene.json", small_scene().dump());
    expect_refused(folder, {"run", "scene.json", "--set", "/method/transfer/oder=4"},
                   R"(did you mean "/method/transfer/order"?)");
    expect_refused(folder, {"run", "scene.json", "--set", "/bodies/7/name=x"}, "/bodies/7");
    expect_refused(folder, {"run", "scene.json", "--set", "order"}, "order");
    expect_refused(folder, {"run", "scene.json", "--set", "/grid/cell=3 s"}, "scene.json: /grid/cell: ");
}

TEST(BadCommandLine, ExistingResults) {
    const Folder folder;
    folder.write("scene.json", small_scene({R"({"time": {"end": "20 us"}})"}).dump());
    ASSERT_EQ(folder.abut({"run", "scene.json", "-o", "results"}).exit_code, 0);
    const std::string history = folder.read("results/history.csv");
    expect_refused(folder, {"run", "scene.json", "-o", "results"},
                   "abut: results: holds results already; use --overwrite to replace them\n");
    EXPECT_EQ(folder.read("results/history.csv"), history);

    folder.write("mine/notes.txt", "mine");
    expect_refused(folder, {"run", "scene.json", "-o", "mine"}, "abut: mine: is not empty; ");
    expect_refused(folder, {"run", "scene.json", "-o", "scene.json"}, "abut: scene.json: is a file; ");
}

TEST(BadCommandLine, OverwriteLeavesWhatIsNotOurs) {
    const Folder folder;
    folder.write("scene.json", small_scene({R"({"time": {"end": "0.3 ms"}})"}).dump());
    folder.write("results/notes.txt", "mine");
    ASSERT_EQ(folder.abut({"run", "scene.json", "-o", "results", "--overwrite"}).exit_code, 0);
    EXPECT_TRUE(std::filesystem::exists(folder / "results/particles/particles_00003.vtu"));
    folder.write("results/particles/failed.vtu", "of an earlier run that went wrong");
    ASSERT_EQ(folder.abut({"run", "scene.json", "-o", "results", "--overwrite", "--until", "0.1 ms"}).exit_code, 0);
    EXPECT_FALSE(std::filesystem::exists(folder / "results/particles/particles_00003.vtu"));
    EXPECT_FALSE(std::filesystem::exists(folder / "results/particles/failed.vtu"));
    EXPECT_EQ(folder.read("results/notes.txt"), "mine");
}

TEST(BadCommandLine, OverwriteOfItsOwnScene) {
    const Folder folder;
    folder.write("results/scene.json", small_scene({R"({"time": {"end": "20 us"}})"}).dump());
    expect_refused(folder, {"run", "results/scene.json", "-o", "results", "--overwrite"},
                   "choose another folder for the results");
}

TEST(BadCommandLine, FolderThatCannotBeWrittenTo) {
    const Folder folder;
    folder.write("scene.json", small_scene().dump());
    folder.write("file", "");
    expect_refused(folder, {"run", "scene.json", "-o", "file/results"}, "Not a directory");
    expect_refused(folder, {"run", "scene.json", "-o", "/proc/results"}, "abut: /proc/results: ");
}

TEST(BadCommandLine, Render) {
    const Folder folder;
    folder.write("scene.json", small_scene({R"({"time": {"end": "20 us"}, "contact": null})"}).dump());
    ASSERT_EQ(folder.abut({"run", "scene.json", "-o", "results"}).exit_code, 0);
    expect_refused(folder, {"render", "nowhere"}, "abut: nowhere: no such folder");
    expect_refused(folder, {"render", "."}, "no particles.pvd; is it the result folder of a run?");
    expect_refused(folder, {"render", "results", "--preset", "presure"}, R"(did you mean "pressure"?)");
    expect_refused(folder, {"render", "results", "--array", "presure"}, R"(did you mean "pressure"?)");
    expect_refused(folder, {"render", "results", "--preset", "normals"}, "no contact.pvd");
    expect_refused(folder, {"render", "results", "--frames", "9"}, "no frame 9; there are 0 to 1");
    expect_refused(folder, {"render", "results", "--width", "9"}, "--width");
}

TEST(BadCommandLine, Pack) {
    const Folder folder;
    expect_refused(folder, {"pack", "bed.gif"}, "must end in .png, .bmp or .tif");
    expect_refused(folder, {"pack", "bed.png", "--bodies", "0"}, "abut: ");
    expect_refused(folder, {"pack", "bed.png", "--width", "40", "--height", "40", "--area-fraction", "0.99"},
                   "at most");
    expect_refused(folder, {"pack", "bed.png", "--grains", "disk"}, R"(did you mean "disks"?)");
    expect_refused(folder, {"pack", "bed.png", "--grains", "balls"}, ".tif stack");
    expect_refused(folder, {"pack", "bed.png", "--sizes", "lognorm:0.2"}, R"(did you mean "lognormal"?)");
    expect_refused(folder, {"pack", "bed.png", "--sizes", "uniform:1"}, "write uniform:MIN,MAX");
    expect_refused(folder, {"pack", "bed.png", "--sizes", "uniform:2,1"}, "the largest not below the smallest");
    expect_refused(folder, {"pack", "bed.json", "--shades", "4"}, "are for bitmaps");
    expect_refused(folder, {"pack", "bed.png", "--grains", "disks", "--max-aspect", "2"}, "for ellipses only");
    expect_refused(folder, {"pack", "bed.png", "--depth", "9"}, "--depth is for balls only");
    expect_refused(folder, {"pack", "bed.png", "--blur", "1", "--shades", "4"}, "leave out --shades");
    expect_refused(folder, {"pack", "bed.png", "--blur", "99"}, "blur must be 0 to 20");
    expect_refused(folder, {"pack", "bed.png", "--seed", "-1"}, "--seed");
    expect_refused(folder, {"pack", "bed.json", "--pixel", "0"}, "--pixel");
    expect_refused(folder, {"pack", "bed.json", "--material", "a\"b"}, "--material");
    expect_refused(folder, {"pack", "bed.png", "--grains", "polygons", "--gap", "30"}, "leave 0.");
    expect_refused(folder, {"pack", "bed.png", "--shades", "1"}, "ask for more shades");
}

TEST(CommandLine, VersionAndHelp) {
    const Folder folder;
    const Outcome version = folder.abut({"--version"});
    EXPECT_EQ(version.exit_code, 0);
    EXPECT_THAT(version.out, testing::MatchesRegex("abut [0-9]+\\.[0-9]+\\.[0-9]+\n"));

    const Outcome help = folder.abut({"--help"});
    EXPECT_EQ(help.exit_code, 0);
    for (const char* command : {"run", "check", "particles", "render", "pack", "schema", "reference"}) {
        EXPECT_THAT(help.out, HasSubstr(command));
        const Outcome own = folder.abut({command, "--help"});
        EXPECT_EQ(own.exit_code, 0) << command;
        EXPECT_THAT(own.out, HasSubstr(command));
    }
    EXPECT_TRUE(folder.content().empty());
}

} // namespace
} // namespace abut::app_test
