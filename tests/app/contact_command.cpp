/// `abut contact`, and output.contact_clouds of a run.
#include "app_support.h"

#include "io/results/pvd.h"
#include "io/results/read_frame.h"
#include "io/results/write_frame.h"
#include "results/frame.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <set>
#include <tuple>

namespace abut::app_test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

/// small_scene() and its results, run once for all tests of this file; clouds are recorded.
class ContactCommand : public testing::Test {
protected:
    static void SetUpTestSuite() {
        folder() = new Folder; // NOLINT: GoogleTest's way to share between tests
        folder()->write("scene.json", small_scene({R"({"output": {"contact_clouds": {"near": [["6 mm", "4 mm"]],
                                                   "nodes": [[6, 4]], "disagreement": "5 deg"}}})"})
                                          .dump());
        run() = folder()->abut({"run", "scene.json", "-o", "r"});
    }
    static void TearDownTestSuite() {
        delete folder(); // NOLINT
        folder() = nullptr;
    }
    static Folder*& folder() {
        static Folder* shared = nullptr;
        return shared;
    }
    static Outcome& run() {
        static Outcome shared;
        return shared;
    }
    static Outcome contact(Arguments more) {
        more.insert(more.begin(), {"contact", "r"});
        return folder()->abut(more);
    }
};

const std::vector<double>& reals(const PointFrame& frame, const std::string& name) {
    for (const Array& array : frame.arrays)
        if (array.name == name) return std::get<std::vector<double>>(array.values);
    throw std::runtime_error("no array " + name);
}

TEST_F(ContactCommand, ListsNodesInDisagreement) {
    ASSERT_EQ(run().exit_code, 0) << run().err;
    const Outcome last = contact({});
    EXPECT_EQ(last.exit_code, 0) << last.err;
    EXPECT_THAT(last.out, AllOf(HasSubstr("frame 4, 400 us"), HasSubstr("contact nodes")));
    const Outcome outcome = contact({"--frame", "1"});
    EXPECT_EQ(contact({"--step", "1"}).out, outcome.out);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    EXPECT_THAT(outcome.out, AllOf(HasSubstr("frame 1, 10"), HasSubstr("contact nodes"), HasSubstr("block / ball"),
                                   HasSubstr(" deg"), HasSubstr("--node ")));
}

/// The scene's own row is what the run wrote to contact.pvd, at every node of every frame.
TEST_F(ContactCommand, OwnRowsAreThoseOfTheRun) {
    int compared = 0;
    for (const int frame : {0, 2, 4}) {
        const std::string number = std::to_string(frame);
        const PointFrame points = read_points(*folder() / ("r/contact/contact_0000" + number + ".vtp"));
        for (std::size_t p = 0; p < points.points.size() / 3; p += 3) {
            const auto i = std::lround(points.points[3 * p] * 1000);
            const auto j = std::lround(points.points[3 * p + 1] * 1000);
            if (i < 0 || j < 0) continue;
            const std::string node = std::to_string(i) + "," + std::to_string(j);
            const Outcome outcome = contact({"--step", number, "--node", node, "-o", "apart"});
            ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
            const auto rows = table(folder()->read("apart/node_0000" + number + "_" + std::to_string(i) + "_" +
                                                   std::to_string(j) + ".csv"));
            const auto column = [&](const std::string& name) {
                return static_cast<std::size_t>(std::find(rows[0].begin(), rows[0].end(), name) - rows[0].begin());
            };
            ASSERT_EQ(rows.size(), 8U);
            const auto& row = rows[1];
            EXPECT_EQ(row[column("method")], "logistic-regression");
            EXPECT_EQ(row[column("chosen")], "1");
            EXPECT_NEAR(std::stod(row[column("normal_x")]), reals(points, "normal")[3 * p], 1e-12);
            EXPECT_NEAR(std::stod(row[column("normal_y")]), reals(points, "normal")[3 * p + 1], 1e-12);
            EXPECT_NEAR(std::stod(row[column("separation_particle_edges")]), reals(points, "separation")[p], 1e-15);
            ++compared;
        }
    }
    EXPECT_GT(compared, 5);
}

TEST_F(ContactCommand, PrintsMethodsSideBySideAndNamesItsFiles) {
    const Outcome outcome = contact({"--step", "3", "--near", "6mm,0.004", "-o", "here"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    for (const char* text :
         {"frame 3, ", "node 6,4 at 6.0000, 4.0000 mm", "block / ball", "* logistic-regression", "  linear-regression",
          "irls-regression", "average-gradient", "maximum-gradient", "maximum-volume", "own-gradient", "particle-edges",
          "critical-position", "fitted-position", "displacement", "lengths in um", "written: here/cloud_00003_6_4.vtu"})
        EXPECT_THAT(outcome.out, HasSubstr(text));
    EXPECT_THAT(outcome.out, Not(HasSubstr("specified")));
    for (const char* file : {"cloud_00003_6_4.vtu", "plane_00003_6_4.vtp", "node_00003_6_4.csv"})
        EXPECT_TRUE(std::filesystem::is_regular_file(*folder() / "here" / file)) << file;
}

/// What the run recorded is what the command finds afterwards in the files of the run.
TEST_F(ContactCommand, FindsWhatTheRunRecorded) {
    for (const char* series : {"cloud_6_4", "plane_6_4", "cloud_near_0", "plane_near_0", "cloud_disagreement"})
        EXPECT_EQ(read_pvd(*folder() / (std::string("r/clouds/") + series + ".pvd")).entries.size(), 5U) << series;
    ASSERT_EQ(contact({"--step", "2", "--node", "6,4", "-o", "again"}).exit_code, 0);
    const auto recorded = table(folder()->read("r/clouds/node_00002_6_4.csv"));
    const auto found = table(folder()->read("again/node_00002_6_4.csv"));
    ASSERT_EQ(recorded.size(), found.size());
    EXPECT_EQ(recorded[0], found[0]);
    for (std::size_t row = 1; row < found.size(); ++row)
        for (std::size_t column = 0; column < found[0].size(); ++column) {
            const std::string& text = recorded[row][column];
            char* end = nullptr;
            const double value = std::strtod(text.c_str(), &end);
            if (*end == 0 && std::isfinite(value))
                EXPECT_NEAR(std::stod(found[row][column]), value, found[0][column] == "angle" ? 1e-7 : 1e-12);
            else
                EXPECT_EQ(found[row][column], text);
        }
}

TEST_F(ContactCommand, FoldersThatCannotBeMade) {
    folder()->write("afile", "mine");
    for (const auto& [target, exit_code, message] :
         {std::tuple{"afile", 2, "abut: afile: is a file; a folder is needed (-o)\n"},
          {"/dev/full", 2, "abut: /dev/full: is a file; a folder is needed (-o)\n"},
          {"afile/below", 1, "abut: afile/below: Not a directory\n"},
          {"/proc/none", 1, "abut: /proc/none: No such file or directory\n"}}) {
        const Outcome outcome = contact({"--near", "6mm,4mm", "-o", target});
        EXPECT_EQ(outcome.exit_code, exit_code) << target;
        EXPECT_EQ(outcome.out, "") << target;
        EXPECT_EQ(outcome.err, message);
    }
    EXPECT_EQ(folder()->read("afile"), "mine");
}

TEST_F(ContactCommand, DamagedFrameIsNamed) {
    namespace fs = std::filesystem;
    const Folder other;
    fs::copy(*folder() / "r", other / "r", fs::copy_options::recursive);
    PointFrame frame = read_points(other / "r/particles/particles_00003.vtu");
    frame.points[3 * 7] = 1e3; // m
    write_particles(other / "r/particles/particles_00003.vtu", frame);
    const Outcome outcome = other.abut({"contact", "r", "--step", "3"});
    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_EQ(outcome.out, "");
    EXPECT_THAT(lines(outcome.err),
                testing::ElementsAre(testing::StartsWith("abut: r/particles/particles_00003.vtu: damaged, or of a run "
                                                         "that had diverged: ")));
}

TEST_F(ContactCommand, RecordingChangesNothingElse) {
    folder()->write("plain.json", small_scene().dump());
    ASSERT_EQ(folder()->abut({"run", "plain.json", "-o", "plain"}).exit_code, 0);
    for (const char* name :
         {"history.csv", "bodies.csv", "pairs.csv", "particles/particles_00004.vtu", "contact/contact_00004.vtp"})
        EXPECT_TRUE(folder()->read(std::string("plain/") + name) == folder()->read(std::string("r/") + name)) << name;
    EXPECT_FALSE(std::filesystem::exists(*folder() / "plain/clouds"));
}

TEST_F(ContactCommand, RefusesWhatIsNotThere) {
    folder()->write("empty/note.txt", "");
    folder()->write("half/scene.json", small_scene().dump());
    const auto before = folder()->content();
    const auto expect_error = [&](const Arguments& arguments, const std::string& message) {
        const Outcome outcome = folder()->abut(arguments);
        EXPECT_EQ(outcome.exit_code, 2) << message;
        EXPECT_THAT(outcome.err, AllOf(testing::StartsWith("abut: "), HasSubstr(message)));
    };
    expect_error({"contact", "nowhere"}, "nowhere: no such folder");
    expect_error({"contact", "empty"}, "empty: no scene.json");
    expect_error({"contact", "half"}, "half: no particles.pvd");
    expect_error({"contact", "r", "--step", "5"}, "no frame 5; there are 0 to 4");
    expect_error({"contact", "r", "--step", "-1"}, "there are 0 to 4");
    expect_error({"contact", "r", "--node", "6"}, "--node 6: 2 values are needed");
    expect_error({"contact", "r", "--node", "6,4,1"}, "2 values are needed");
    expect_error({"contact", "r", "--node", "6,b"}, "\"b\" is no whole number");
    expect_error({"contact", "r", "--node", "6,4.5"}, "\"4.5\" is no whole number");
    expect_error({"contact", "r", "--node", "99999999999,4"}, "is no whole number");
    expect_error({"contact", "r", "--node", "2000000000,4"}, "outside the grid, whose nodes are 0..12, 0..12");
    expect_error({"contact", "r", "--node", "6,10"}, "not a contact node in frame 4; the nearest contact node is ");
    expect_error({"contact", "r", "--near", "6mm,4 s"}, "a length");
    expect_error({"contact", "r", "--near", "6mm"}, "2 values are needed");
    expect_error({"contact", "r", "--near", "nan,0"}, "--near nan,0");
    expect_error({"contact", "r", "-o", "x"}, "-o needs a node");
    EXPECT_EQ(folder()->abut({"contact", "r", "--node", "6,4", "--near", "0,0"}).exit_code, 2);
    EXPECT_EQ(folder()->content(), before);
}

TEST_F(ContactCommand, OverwriteRemovesRecordedFilesOnly) {
    const Folder other;
    other.write("scene.json", small_scene({R"({"time": {"end": "20 us"}, "output": {"contact_clouds":
                                              {"nodes": [[6, 4]], "disagreement": "1 deg"}}})"})
                                  .dump());
    ASSERT_EQ(other.abut({"run", "scene.json", "-o", "r"}).exit_code, 0);
    EXPECT_TRUE(std::filesystem::exists(other / "r/clouds/node_00000_6_4.csv"));
    for (const char* mine : {"r/clouds/cloud_mine.vtu", "r/clouds/node_00000_6_4.txt", "r/clouds/plane_.vtp",
                             "r/clouds/cloud_00000_6_.vtu"})
        other.write(mine, "mine");
    other.write("r/clouds/.plane_00000_6_4.vtp.tmp", "left by a killed run");
    other.write("scene.json", small_scene({R"({"time": {"end": "20 us"}})"}).dump());
    ASSERT_EQ(other.abut({"run", "scene.json", "-o", "r", "--overwrite"}).exit_code, 0);
    std::set<std::string> left;
    for (const auto& entry : std::filesystem::directory_iterator(other / "r/clouds"))
        left.insert(entry.path().filename().string());
    EXPECT_EQ(left,
              (std::set<std::string>{"cloud_mine.vtu", "node_00000_6_4.txt", "plane_.vtp", "cloud_00000_6_.vtu"}));
}

} // namespace
} // namespace abut::app_test
