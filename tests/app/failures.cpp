/// Runs that do not come to their end: what is left can be read, and the message says what happened.
#include "app_support.h"

#include "io/results/pvd.h"
#include "io/results/read_frame.h"

#include <csignal>

#include <chrono>
#include <cmath>
#include <fstream>
#include <thread>

namespace abut::app_test {
namespace {

using testing::AllOf;
using testing::HasSubstr;

/// Waits until a file exists, at most 20 s.
bool appears(const std::filesystem::path& file) {
    for (int i = 0; i < 2000; ++i) {
        if (std::filesystem::exists(file)) return true;
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    return false;
}

TEST(Interrupt, SavesTheStateAndExitsWith130) {
    for (const int signal : {SIGINT, SIGTERM}) {
        const Folder folder;
        folder.write("scene.json", small_scene({R"({"time": {"end": "10 s"}})"}).dump());
        const pid_t process = folder.start({"run", "scene.json", "-o", "results"});
        ASSERT_TRUE(appears(folder / "results/particles/particles_00001.vtu"));
        ::kill(process, signal);
        const Outcome outcome = folder.end_of(process);
        EXPECT_EQ(outcome.exit_code, 130);
        EXPECT_THAT(outcome.err, AllOf(HasSubstr("interrupted at "), HasSubstr("the state is written in results")));

        const double last_row = std::stod(table(folder.read("results/history.csv")).back()[1]);
        const PvdSeries series = read_pvd(folder / "results/particles.pvd");
        ASSERT_GE(series.entries.size(), 2U);
        EXPECT_EQ(series.entries.back().time, last_row);
        const PointFrame frame = read_points(folder / ("results/" + series.entries.back().file));
        EXPECT_EQ(frame.time, last_row);
        EXPECT_FALSE(frame.points.empty());
        EXPECT_EQ(Json::parse(folder.read("results/timing.json"))["steps"].get<double>(),
                  std::stod(table(folder.read("results/history.csv")).back()[0]));
    }
}

TEST(Kill, LeavesAReadableSeries) {
    const Folder folder;
    folder.write("scene.json", small_scene({R"({"time": {"end": "10 s"}, "output": {"every": "5 us"}})"}).dump());
    const pid_t process = folder.start({"run", "scene.json", "-o", "results", "--quiet"});
    ASSERT_TRUE(appears(folder / "results/particles/particles_00020.vtu"));
    ::kill(process, SIGKILL);
    EXPECT_EQ(folder.end_of(process).exit_code, 128 + SIGKILL);
    const PvdSeries series = read_pvd(folder / "results/particles.pvd");
    ASSERT_GE(series.entries.size(), 20U);
    for (const PvdEntry& entry : series.entries)
        EXPECT_EQ(read_points(folder / ("results/" + entry.file)).time, entry.time);
    const auto history = table(folder.read("results/history.csv"));
    for (const auto& row : history) EXPECT_EQ(row.size(), history.front().size());
}

/// A run that goes wrong must say when and where, and leave that state as particles/failed.vtu.
void expect_failure(const std::vector<std::string>& patches, const std::string& words) {
    const Folder folder;
    folder.write("scene.json", small_scene(patches).dump());
    const Outcome outcome = folder.abut({"run", "scene.json", "-o", "results", "--quiet"});
    EXPECT_EQ(outcome.exit_code, 1);
    const std::vector<std::string> said = lines(outcome.err);
    ASSERT_GT(said.size(), 1U);
    EXPECT_THAT(said[0], AllOf(testing::StartsWith("abut: step "), HasSubstr(words)));
    for (std::size_t i = 1; i < said.size(); ++i) EXPECT_THAT(said[i], testing::StartsWith("  "));
    EXPECT_FALSE(read_points(folder / "results/particles/failed.vtu").points.empty());
    EXPECT_EQ(read_pvd(folder / "results/particles.pvd").entries.size(), 1U);
    EXPECT_TRUE(std::filesystem::exists(folder / "results/timing.json"));
    EXPECT_TRUE(Json::parse(folder.read("results/scene.json")).is_object());
}

TEST(Failure, ParticleLeavesTheGrid) {
    expect_failure({R"({"contact": null, "gravity": null, "boundaries": null, "output": {"every": 0},
                        "bodies": [{"name": "ball", "material": "rubber", "velocity": ["50 m/s", 0],
                                    "disk": {"center": ["9 mm", "6 mm"], "radius": "2 mm"}}]})"},
                   "of body \"ball\" at (");
}

TEST(Failure, FixedStepBecomesUnstable) {
    // A piston compresses the block; it stiffens, and the step that was just stable no longer is.
    expect_failure({R"({"contact": null, "gravity": null, "output": {"every": 0}, "time": {"step": "7.5 us"},
                        "bodies": [{"name": "block", "material": "rubber",
                                    "box": {"lower": ["2 mm", 0], "upper": ["10 mm", "8 mm"]}}],
                        "boundaries": [
                          {"name": "floor", "wall": {"axis": "y", "side": "lower", "position": 0}},
                          {"name": "piston", "wall": {"axis": "y", "side": "upper", "position": "8 mm",
                                                      "velocity": "-18 m/s"}}]})"},
                   "is above the stable one of ");
}

TEST(Failure, Divergence) {
    // Halves of one body fly apart and into each other far faster than sound.
    expect_failure({R"({"contact": null, "gravity": null, "boundaries": null, "output": {"every": 0},
                        "time": {"step": "7.9 us"}, "method": {"transfer": {"scheme": "flip"}},
                        "bodies": [{"name": "left", "material": "rubber", "velocity": ["900 m/s", 0],
                                    "box": {"lower": ["3 mm", "3 mm"], "upper": ["6 mm", "9 mm"]}},
                                   {"name": "right", "material": "rubber", "velocity": ["-900 m/s", 0],
                                    "box": {"lower": ["6 mm", "3 mm"], "upper": ["9 mm", "9 mm"]}}]})",
                    R"({"method": {"transfer": {"order": null}}})"},
                   " m/s");
}

TEST(DiskFull, IsReportedAsSuch) {
    const Folder folder;
    folder.write("scene.json", small_scene().dump());
    for (const std::size_t limit : {500U, 3000U, 20000U}) {
        const Outcome outcome = folder.abut({"run", "scene.json", "-o", "results", "--overwrite", "--quiet"}, limit);
        EXPECT_EQ(outcome.exit_code, 1) << limit;
        EXPECT_THAT(lines(outcome.err),
                    testing::ElementsAre(AllOf(testing::StartsWith("abut: results/"), HasSubstr("File too large"))))
            << limit;
        for (const auto& [name, size] : folder.content()) EXPECT_THAT(name, testing::Not(testing::EndsWith(".tmp")));
        if (!std::filesystem::exists(folder / "results/particles.pvd")) continue;
        for (const PvdEntry& entry : read_pvd(folder / "results/particles.pvd").entries)
            EXPECT_EQ(read_points(folder / ("results/" + entry.file)).time, entry.time);
    }
}

} // namespace
} // namespace abut::app_test
