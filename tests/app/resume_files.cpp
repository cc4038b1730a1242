/// What a resumed run finds in its folder: series switched off and on, files that were changed, moved or are in use.
#include "app_support.h"

#include "geometry/images/image.h"
#include "io/results/pvd.h"

#include <csignal>
#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <cstring>
#include <limits>
#include <thread>

namespace abut::app_test {
namespace {

using testing::AllOf;
using testing::HasSubstr;

Outcome run(const Folder& folder, const std::string& results, const Arguments& more = {}) {
    Arguments arguments{"run", "scene.json", "-o", results, "--quiet"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return folder.abut(arguments);
}

/// With checkpoints behind the last frame and before it.
const char* const often = R"({"output": {"checkpoint_every_steps": 10}})";

void write_scene(const Folder& folder, const std::vector<std::string>& patches = {often}) {
    folder.write("scene.json", small_scene(patches).dump());
}

/// All files of a result folder with what is in them.
std::map<std::string, std::string> everything_in(const Folder& folder, const std::string& results) {
    std::map<std::string, std::string> files;
    for (const auto& [name, size] : folder.content())
        if (name.starts_with(results + "/") && std::filesystem::is_regular_file(folder / name))
            files[name] = folder.read(name);
    return files;
}

std::vector<double> times_of(const PvdSeries& series) {
    std::vector<double> times;
    for (const PvdEntry& entry : series.entries) times.push_back(entry.time);
    return times;
}

TEST(ResumeFiles, ASeriesThatWasOffForAWhileKeepsItsFrames) {
    const Folder folder;
    write_scene(folder);
    ASSERT_EQ(run(folder, "whole").exit_code, 0);
    ASSERT_EQ(run(folder, "r", {"--until", "0.15 ms"}).exit_code, 0);
    ASSERT_EQ(run(folder, "r", {"--resume", "--until", "0.25 ms", "--set", "/output/particles=false"}).exit_code, 0);
    const PvdSeries off = read_pvd(folder / "r/particles.pvd");
    EXPECT_EQ(off.entries.size(), 2U) << "that of the end at 0.15 ms is gone";
    EXPECT_EQ(run(folder, "r", {"--resume"}).exit_code, 0);
    const PvdSeries on = read_pvd(folder / "r/particles.pvd"), whole = read_pvd(folder / "whole/particles.pvd");
    std::vector<double> expected = times_of(whole);
    expected.erase(expected.begin() + 2); // at 0.2 ms the series was off
    EXPECT_EQ(times_of(on), expected);
    EXPECT_TRUE(folder.read("r/particles/particles_00000.vtu") == folder.read("whole/particles/particles_00000.vtu"));
    EXPECT_TRUE(folder.read("r/particles/particles_00003.vtu") == folder.read("whole/particles/particles_00004.vtu"));
    EXPECT_FALSE(std::filesystem::exists(folder / "r/particles/particles_00004.vtu"));
}

TEST(ResumeFiles, CloudsAreResumedToo) {
    const Folder folder;
    write_scene(folder, {R"({"output": {"every": "30 us", "checkpoint_every_steps": 20,
                                        "contact_clouds": {"near": [["6 mm", "4 mm"]], "disagreement": "1 deg"}}})"});
    ASSERT_EQ(run(folder, "whole").exit_code, 0);
    ASSERT_EQ(run(folder, "parts", {"--until", "0.22 ms"}).exit_code, 0);
    ASSERT_EQ(run(folder, "parts", {"--resume"}).exit_code, 0);
    expect_same_results(folder, "whole", "parts", "clouds");
    EXPECT_GT(read_pvd(folder / "whole/clouds/cloud_near_0.pvd").entries.size(), 10U);

    // Without one more frame of contact to come: what was after the checkpoint goes all the same.
    ASSERT_EQ(run(folder, "cut", {"--until", "0.22 ms"}).exit_code, 0);
    const auto written = read_pvd(folder / "cut/clouds/cloud_near_0.pvd");
    ASSERT_EQ(run(folder, "cut", {"--resume", "--steps", "1", "--set", "/output/contact_clouds=null"}).exit_code, 0);
    const auto kept = read_pvd(folder / "cut/clouds/cloud_near_0.pvd");
    ASSERT_EQ(kept.entries.size(), written.entries.size() - 1);
    const std::string gone = written.entries.back().file;
    EXPECT_FALSE(std::filesystem::exists(folder / ("cut/clouds/" + gone)));
    EXPECT_TRUE(std::filesystem::exists(folder / ("cut/clouds/" + kept.entries.back().file)));
}

TEST(ResumeFiles, AFolderInUseIsRefused) {
    const Folder folder;
    write_scene(folder);
    ASSERT_EQ(run(folder, "r", {"--steps", "20"}).exit_code, 0);
    const int other = ::open((folder / "r").c_str(), O_RDONLY | O_DIRECTORY);
    ASSERT_EQ(::flock(other, LOCK_EX | LOCK_NB), 0);
    const auto before = everything_in(folder, "r");
    for (const char* how : {"--resume", "--overwrite"}) {
        const Outcome refused = run(folder, "r", {how});
        EXPECT_EQ(refused.exit_code, 2) << how;
        EXPECT_THAT(refused.err, HasSubstr("r: another run writes to this folder")) << how;
    }
    EXPECT_EQ(everything_in(folder, "r"), before);
    ::close(other);
    EXPECT_EQ(run(folder, "r", {"--resume"}).exit_code, 0);
}

TEST(ResumeFiles, ARunKeepsItsFolderToItself) {
    const Folder folder;
    write_scene(folder, {R"({"time": {"end": "10 s"}, "contact": null, "gravity": null, "output": {"every": "1 ms"},
        "bodies": [{"name": "block", "material": "rubber", "box": {"lower": ["2 mm", 0], "upper": ["10 mm", "4 mm"]}}]})"});
    const pid_t process = folder.start({"run", "scene.json", "-o", "r", "--quiet"});
    for (int i = 0; i < 600 && !std::filesystem::exists(folder / "r/history.csv"); ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
    const int second = ::open((folder / "r").c_str(), O_RDONLY | O_DIRECTORY);
    ASSERT_GE(second, 0);
    EXPECT_NE(::flock(second, LOCK_EX | LOCK_NB), 0) << "the run has it";
    ::close(second);
    // A lost terminal is as good as an interrupt.
    ::kill(process, SIGHUP);
    const Outcome ended = folder.end_of(process);
    EXPECT_EQ(ended.exit_code, 130);
    EXPECT_THAT(ended.err, HasSubstr("go on with --resume"));
    EXPECT_TRUE(std::filesystem::exists(folder / "r/checkpoint.h5"));
}

TEST(ResumeFiles, TheCheckpointBeforeIsTakenIfTheLastHasAValueThatCannotBe) {
    const Folder folder;
    write_scene(folder);
    ASSERT_EQ(run(folder, "whole").exit_code, 0);
    ASSERT_EQ(run(folder, "r", {"--steps", "55"}).exit_code, 0);
    // The interval of the tables, 10 us, stands in the checkpoint: found by its bytes and made a NaN.
    std::string bytes = folder.read("r/checkpoint.h5");
    const double interval = 10e-6, nan = std::numeric_limits<double>::quiet_NaN();
    char wanted[sizeof interval], wrong[sizeof nan];
    std::memcpy(wanted, &interval, sizeof interval);
    std::memcpy(wrong, &nan, sizeof nan);
    const std::size_t place = bytes.find(std::string(wanted, sizeof wanted));
    ASSERT_NE(place, std::string::npos);
    bytes.replace(place, sizeof wrong, wrong, sizeof wrong);
    folder.write("r/checkpoint.h5", bytes);
    const Outcome outcome = run(folder, "r", {"--resume"});
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_THAT(outcome.err, AllOf(HasSubstr("r/checkpoint.h5: output/times: "),
                                   HasSubstr("going on from r/checkpoint-previous.h5, step 50")));
    expect_same_results(folder, "whole", "r", "the one before");
}

TEST(ResumeFiles, ARefusalChangesNothing) {
    const Folder folder;
    write_scene(folder);
    ASSERT_EQ(run(folder, "r", {"--steps", "55"}).exit_code, 0); // rows and frames after the checkpoint
    const auto rows = folder.read("r/history.csv");
    const auto refused = [&](const std::string& file, const std::string& change, const std::string& why) {
        const std::string sound = folder.read(file);
        if (change.empty())
            std::filesystem::remove(folder / file);
        else
            folder.write(file, change);
        const auto before = everything_in(folder, "r");
        const Outcome outcome = run(folder, "r", {"--resume"});
        EXPECT_EQ(outcome.exit_code, 2) << file << why;
        EXPECT_THAT(outcome.err, AllOf(HasSubstr("abut: " + file + ": "), HasSubstr(why), HasSubstr("put back the ")));
        EXPECT_TRUE(everything_in(folder, "r") == before) << file << why;
        folder.write(file, sound);
    };
    refused("r/grid.pvd", "", "no such file");
    refused("r/contact.pvd", "<VTKFile><Collection/></VTKFile>", "has 0 frames instead of at least 2");
    refused("r/history.csv", "", "no such file");
    refused("r/pairs.csv", folder.read("r/pairs.csv").substr(0, 90), "instead of at least");
    refused("r/history.csv", "new," + rows, "has other columns");
    refused("r/history.csv", std::string(rows).insert(rows.find('\n') + 1, "1,2,3\n"), "no row ends after ");
    EXPECT_EQ(run(folder, "r", {"--resume"}).exit_code, 0);
}

TEST(ResumeFiles, AFrameThatNeverGotIntoItsSeriesIsRemoved) {
    const Folder folder;
    write_scene(folder);
    ASSERT_EQ(run(folder, "r", {"--until", "0.15 ms"}).exit_code, 0);
    // As of runs that were killed between the file and its entry.
    folder.write("r/particles/particles_00003.vtu", "x");
    folder.write("r/particles/particles_00004.vtu", "x");
    ASSERT_EQ(run(folder, "r", {"--resume", "--until", "0.16 ms"}).exit_code, 0);
    EXPECT_EQ(read_pvd(folder / "r/particles.pvd").entries.size(), 3U);
    EXPECT_FALSE(std::filesystem::exists(folder / "r/particles/particles_00003.vtu"));
    EXPECT_FALSE(std::filesystem::exists(folder / "r/particles/particles_00004.vtu"));
}

TEST(ResumeFiles, AProjectMayMove) {
    const Folder folder;
    Image picture{40, 40, 3, std::vector<std::uint16_t>(3 * 40 * 40, 255)};
    std::fill_n(picture.pixels.begin() + 3 * 40 * 20, 3 * 40 * 12, std::uint16_t{0});
    std::filesystem::create_directories(folder / "one");
    write_image(picture, folder / "one/a.png");
    folder.write("one/scene.json", small_scene({R"({"bodies": [], "images": [{"file": "a.png", "pixel": "0.25 mm",
        "lower": ["1 mm", "1 mm"], "legend": [{"grey": 0, "body": "bar", "material": "rubber"},
                                              {"grey": 255, "void": true}]}]})"})
                                       .dump());
    ASSERT_EQ(folder.abut({"run", "one/scene.json", "-o", "one/r", "--quiet", "--steps", "5"}).exit_code, 0);
    std::filesystem::rename(folder / "one", folder / "two");
    const Outcome moved = folder.abut({"run", "two/scene.json", "-o", "two/r", "--quiet", "--resume"});
    EXPECT_EQ(moved.exit_code, 0) << moved.err;
}

TEST(ResumeFiles, TimingIsOfTheStepsMadeThisTime) {
    const Folder folder;
    write_scene(folder);
    ASSERT_EQ(run(folder, "r", {"--steps", "100", "--threads", "1"}).exit_code, 0);
    ASSERT_EQ(run(folder, "r", {"--resume", "--threads", "1"}).exit_code, 0);
    const Json timing = Json::parse(folder.read("r/timing.json"));
    EXPECT_EQ(timing["resumed_at_step"], 100);
    const double particle_steps = (timing["steps"].get<double>() - 100) * timing["particles"].get<double>();
    EXPECT_DOUBLE_EQ(timing["ns_per_particle_step"].get<double>(),
                     1e9 * timing["solver_seconds"].get<double>() / particle_steps);
}

TEST(Steps, TheLastRowOfPairsHasItsArea) {
    const Folder folder;
    write_scene(folder);
    ASSERT_EQ(run(folder, "short", {"--steps", "100"}).exit_code, 0);
    ASSERT_EQ(run(folder, "rows", {"--steps", "100", "--set", "/output/history_every=1e-30"}).exit_code, 0);
    const auto last = table(folder.read("short/pairs.csv")).back(), known = table(folder.read("rows/pairs.csv")).back();
    EXPECT_EQ(last[1], known[1]);
    EXPECT_GT(std::stod(known[7]), 0);
    EXPECT_EQ(last[7], known[7]);
}

TEST(Resume, SaysIfThereIsNothingToDo) {
    const Folder folder;
    write_scene(folder);
    ASSERT_EQ(run(folder, "r", {"--steps", "55"}).exit_code, 0);
    const Outcome outcome = folder.abut({"run", "scene.json", "-o", "r", "--resume", "--steps", "20"});
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_THAT(outcome.err, AllOf(HasSubstr("nothing to do: "), HasSubstr("(step 55)"), HasSubstr("  step 55  ")));
}

TEST(Resume, AFolderInPlaceOfTheCheckpointIsNamedPlainly) {
    const Folder folder;
    write_scene(folder);
    ASSERT_EQ(run(folder, "r", {"--steps", "55"}).exit_code, 0);
    std::filesystem::remove(folder / "r/checkpoint.h5");
    folder.write("r/checkpoint.h5/x", "x");
    const Outcome outcome = run(folder, "r", {"--resume"});
    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_THAT(outcome.err, HasSubstr("abut: r/checkpoint.h5: Is a directory\n"));
}

TEST(Trouble, AdviceOnTheGridKeepsTheShapeOfItsCells) {
    const Folder folder;
    folder.write("scene.json", small_scene({R"({"analysis": "axisymmetric", "contact": null, "gravity": null,
        "boundaries": null, "grid": {"cell": ["1 mm", "0.5 mm"]},
        "bodies": [{"name": "ball", "material": "rubber", "velocity": ["-300 m/s", 0],
                    "disk": {"center": ["3 mm", "8 mm"], "radius": "2 mm"}}]})"})
                                   .dump());
    const Outcome outcome = run(folder, "r");
    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_THAT(outcome.err, AllOf(HasSubstr("crossed the axis"),
                                   HasSubstr("--set \"/grid/cell=[0.0005, 0.00025]\" (it is [0.001, 0.0005] m)")));
    EXPECT_NE(run(folder, "half", {"--steps", "1", "--set", "/grid/cell=[0.0005, 0.00025]"}).exit_code, 2);
}

TEST(Resume, AnotherStepIsRefusedWithAWord) {
    const Folder folder;
    write_scene(folder);
    ASSERT_EQ(run(folder, "r", {"--steps", "5"}).exit_code, 0);
    const Outcome outcome = run(folder, "r", {"--resume", "--set", "/time/cfl=0.2"});
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_THAT(outcome.err, AllOf(HasSubstr("/time/cfl: was 0.4, is 0.2"), HasSubstr("on_trouble=shrink-step")));
}

} // namespace
} // namespace abut::app_test
