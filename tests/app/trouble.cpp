/// Runs that go wrong: the diagnosis, what is left, and going back with half the time step.
#include "app_support.h"

#include "io/results/pvd.h"
#include "io/results/read_frame.h"

#include <set>

namespace abut::app_test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

/// A piston compresses a block, which stiffens: the fixed step that was just stable no longer is.
const char* const piston = R"({
    "contact": null, "gravity": null,
    "time": {"step": "7.5 us", "end": "0.25 ms"}, "output": {"every": "20 us", "history_every": "1 us"},
    "bodies": [{"name": "block", "material": "rubber", "box": {"lower": ["2 mm", 0], "upper": ["10 mm", "8 mm"]}}],
    "boundaries": [{"name": "floor", "wall": {"axis": "y", "side": "lower", "position": 0}},
                   {"name": "piston", "wall": {"axis": "y", "side": "upper", "position": "8 mm",
                                               "velocity": "-18 m/s"}}]})";
/// A piston that rests at first and then pushes so fast that the step gives energy out of nothing: nearly three times
/// what the piston does, and a ten thousandth with a step of 1 us.
const char* const late_piston = R"({
    "grid": {"cell": "0.25 mm"}, "time": {"step": "1.4 us", "end": "0.4 ms"},
    "boundaries": [{"name": "floor", "wall": {"axis": "y", "side": "lower", "position": 0}},
                   {"name": "piston", "wall": {"axis": "y", "side": "upper", "position": "8 mm",
                                               "velocity": {"times": [0, "0.3 ms", "0.55 ms"],
                                                            "values": [0, 0, "-30 m/s"]}}}]})";
const char* const shrink = R"({"time": {"on_trouble": "shrink-step"}})";

/// A ball that falls so fast that a limit is passed, whatever the step.
const char* const fall = R"({
    "contact": null, "boundaries": null, "gravity": [0, "-1e5 m/s^2"],
    "time": {"end": "0.1 ms", "limits": {"speed": "3 m/s"}}, "output": {"every": "5 us", "history_every": "2 us"},
    "bodies": [{"name": "ball", "material": "rubber", "disk": {"center": ["6 mm", "8 mm"], "radius": "2 mm"}}]})";

/// A ball that flies out of the grid.
const char* const flight = R"({
    "contact": null, "boundaries": null, "gravity": null,
    "time": {"end": "0.4 ms"}, "output": {"every": "20 us", "history_every": "2 us"},
    "bodies": [{"name": "ball", "material": "rubber", "disk": {"center": ["6 mm", "4 mm"], "radius": "2 mm"},
                "velocity": [0, "-20 m/s"]}]})";

/// A load that sets in suddenly: with fmpm of order 4 it gives energy that the ledger misses, whatever the step.
const char* const sudden_load = R"({
    "contact": null, "gravity": null, "method": {"transfer": {"scheme": "fmpm", "order": 4}},
    "time": {"end": "0.02 ms", "limits": {"energy_growth": 1e-4}}, "output": {"every": "5 us", "history_every": "1 us"},
    "bodies": [{"name": "block", "material": "rubber", "box": {"lower": ["2 mm", 0], "upper": ["10 mm", "8 mm"]}}],
    "boundaries": [{"name": "floor", "wall": {"axis": "y", "side": "lower", "position": 0}},
                   {"name": "load", "traction": {"body": "block", "axis": "y", "side": "upper",
                                                 "pressure": "0.5 MPa"}}]})";

/// The tables go forward in time without repeats; the series list each time once, and frames with these times.
void expect_consistent(const Folder& folder, const std::string& results) {
    const auto rows = table(folder.read(results + "/history.csv"));
    ASSERT_GT(rows.size(), 2U);
    for (std::size_t i = 2; i < rows.size(); ++i) {
        EXPECT_GT(std::stod(rows[i][1]), std::stod(rows[i - 1][1]));
        EXPECT_GT(std::stol(rows[i][0]), std::stol(rows[i - 1][0]));
    }
    const auto bodies = table(folder.read(results + "/bodies.csv"));
    EXPECT_EQ(bodies.size(), rows.size()) << "one body";
    for (const char* name : {"particles", "grid"}) {
        const PvdSeries series = read_pvd(folder / (results + "/" + name + ".pvd"));
        std::set<std::string> files;
        for (std::size_t i = 0; i < series.entries.size(); ++i) {
            EXPECT_TRUE(i == 0 || series.entries[i].time > series.entries[i - 1].time);
            EXPECT_TRUE(std::filesystem::exists(folder / (results + "/" + series.entries[i].file)));
            files.insert(series.entries[i].file);
        }
        EXPECT_EQ(files.size(), series.entries.size());
        for (const auto& entry : std::filesystem::directory_iterator(folder / (results + "/" + name))) {
            const std::string file = name + ("/" + entry.path().filename().string());
            EXPECT_TRUE(files.count(file) == 1 || file == "particles/failed.vtu" || file == "particles/last_good.vtu")
                << file << " is of steps given up";
        }
    }
    for (const PvdEntry& entry : read_pvd(folder / (results + "/particles.pvd")).entries)
        EXPECT_EQ(read_points(folder / (results + "/" + entry.file)).time, entry.time);
    EXPECT_THAT(folder.read(results + "/all.pvd"),
                HasSubstr(read_pvd(folder / (results + "/grid.pvd")).entries.back().file));
}

Outcome run(const Folder& folder, const std::string& results, const Arguments& more = {}) {
    Arguments arguments{"run", "scene.json", "-o", results, "--quiet"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return folder.abut(arguments);
}

TEST(Trouble, StopsWithADiagnosisThatNamesFilesAndSettings) {
    const Folder folder;
    folder.write("scene.json", small_scene({piston, R"({"output": {"checkpoint_every_steps": 10}})"}).dump());
    const Outcome outcome = run(folder, "r");
    EXPECT_EQ(outcome.exit_code, 1);
    const auto said = lines(outcome.err);
    ASSERT_GE(said.size(), 5U) << outcome.err;
    EXPECT_THAT(said[0],
                AllOf(testing::StartsWith("abut: step "), HasSubstr("particle "), HasSubstr("of body \"block\" at ("),
                      HasSubstr("the time step of 7.5e-06 s is above the stable one of ")));
    EXPECT_THAT(said[1], testing::StrEq("  the state gone wrong: r/particles/failed.vtu"));
    EXPECT_THAT(said[2], AllOf(HasSubstr("the last frame before: r/particles/particles_000"), HasSubstr(" s)")));
    EXPECT_THAT(said[3], AllOf(HasSubstr("the last checkpoint before: r/checkpoint.h5 (step "), HasSubstr("0, ")));
    EXPECT_THAT(said[4], HasSubstr("try a smaller time step: --set \"/time/step=3.75e-06 s\" (it is 7.5e-06 s)"));
    EXPECT_THAT(said.back(), HasSubstr("--resume --set /time/on_trouble=shrink-step"));
    expect_consistent(folder, "r");

    // The advice works as it stands.
    const Outcome rescued = run(folder, "r", {"--resume", "--set", "/time/on_trouble=shrink-step"});
    EXPECT_EQ(rescued.exit_code, 0) << rescued.err;
    EXPECT_FALSE(std::filesystem::exists(folder / "r/particles/failed.vtu"));
    expect_consistent(folder, "r");
}

TEST(ShrinkStep, RescuesARun) {
    const Folder folder;
    folder.write("scene.json", small_scene({piston, shrink}).dump());
    const Outcome outcome = run(folder, "r", {"--threads", "1"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_THAT(outcome.err,
                AllOf(HasSubstr("is above the stable one of "), HasSubstr("  going back to step 0, time 0 s"),
                      HasSubstr("(reduction 1 of at most 5)")));
    expect_consistent(folder, "r");
    const Json timing = Json::parse(folder.read("r/timing.json"));
    EXPECT_GE(timing["step_reductions"].get<int>(), 1);
    EXPECT_GT(timing["abandoned_steps"].get<int>(), 0);
    const auto rows = table(folder.read("r/history.csv"));
    EXPECT_EQ(std::stod(rows[2][2]), 3.75e-6) << "dt since the start, to which it went back";
    EXPECT_EQ(std::stod(rows.back()[1]), 0.25e-3);

    const Outcome other = run(folder, "two", {"--threads", "2"});
    EXPECT_EQ(other.exit_code, 0);
    expect_same_results(folder, "r", "two", "two threads");
}

TEST(ShrinkStep, ResumesBitIdentically) {
    // Good states come and go before the trouble and after it.
    const Folder folder;
    folder.write("scene.json", small_scene({piston, late_piston, shrink}).dump());
    const Outcome whole = run(folder, "whole", {"--threads", "2"});
    ASSERT_EQ(whole.exit_code, 0) << whole.err;
    EXPECT_THAT(whole.err, HasSubstr("going back to step 100,"));
    std::string said;
    for (const Arguments& part : {Arguments{"--steps", "90"}, Arguments{"--steps", "150", "--resume"},
                                  Arguments{"--steps", "330", "--resume"}, Arguments{"--resume"}}) {
        const Outcome outcome = run(folder, "parts", part);
        EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
        said += outcome.err;
    }
    EXPECT_THAT(said, HasSubstr("going back to step "));
    expect_same_results(folder, "whole", "parts", "resumed");
    EXPECT_EQ(Json::parse(folder.read("whole/timing.json"))["step_reductions"],
              Json::parse(folder.read("parts/timing.json"))["step_reductions"]);
}

TEST(ShrinkStep, StopsWhenTheTroubleComesWhateverTheStep) {
    const Folder folder;
    folder.write("scene.json", small_scene({fall, shrink}).dump());
    const Outcome outcome = run(folder, "whole");
    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_THAT(outcome.err,
                AllOf(HasSubstr("(reduction 2 of at most 5)"), Not(HasSubstr("(reduction 3 of at most 5)")),
                      HasSubstr("it came back at the same time and place though the time step was halved twice"),
                      Not(HasSubstr("a smaller time step")),
                      HasSubstr("try if such speeds are meant, a higher /time/limits/speed"),
                      HasSubstr("the last good state, step ")));
    expect_consistent(folder, "whole");

    // A run that is interrupted in between knows what has come back.
    std::string said;
    for (const Arguments& part :
         {Arguments{"--until", "28 us"}, Arguments{"--resume", "--steps", "40"}, Arguments{"--resume"}})
        said += run(folder, "parts", part).err;
    EXPECT_THAT(said, HasSubstr("it came back at the same time and place"));
    EXPECT_EQ(Json::parse(folder.read("parts/timing.json"))["step_reductions"], 2);

    // The checkpoint is of the good state, and the limit may be raised.
    const Outcome on = run(folder, "whole", {"--resume", "--set", "/time/limits/speed=300 m/s"});
    EXPECT_EQ(on.exit_code, 0) << on.err;
    expect_consistent(folder, "whole");
}

TEST(ShrinkStep, StopsWhenABodyFliesOutOfTheGrid) {
    const Folder folder;
    folder.write("scene.json", small_scene({flight, shrink}).dump());
    const Outcome outcome = run(folder, "r");
    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_THAT(outcome.err, AllOf(HasSubstr("the particle left the grid"), HasSubstr("(reduction 2 of at most 5)"),
                                   Not(HasSubstr("(reduction 3 of at most 5)")),
                                   HasSubstr("it came back at the same time and place"),
                                   HasSubstr("a larger grid: /grid/lower"), Not(HasSubstr("a smaller time step"))));
    expect_consistent(folder, "r");
}

TEST(ShrinkStep, GivesUpAfterFiveReductions) {
    const Folder folder;
    folder.write("scene.json", small_scene({sudden_load, shrink}).dump());
    const Outcome outcome = run(folder, "r");
    EXPECT_EQ(outcome.exit_code, 1);
    for (int i = 1; i <= 5; ++i)
        EXPECT_THAT(outcome.err, HasSubstr("(reduction " + std::to_string(i) + " of at most 5)"));
    EXPECT_THAT(outcome.err, AllOf(HasSubstr("above /time/limits/energy_growth of 0.0001"),
                                   HasSubstr("the time step was halved 5 times in vain"),
                                   HasSubstr("the state gone wrong: r/particles/failed.vtu"),
                                   HasSubstr("the last good state, step "), HasSubstr(": r/particles/last_good.vtu"),
                                   HasSubstr("the last checkpoint before: r/checkpoint.h5 (step "),
                                   HasSubstr("halved 5 times since"), Not(HasSubstr("on_trouble=shrink-step"))));
    expect_consistent(folder, "r");
    const auto step_in = [&](const std::string& words) {
        return std::stol(outcome.err.substr(outcome.err.find(words) + words.size()));
    };
    EXPECT_EQ(step_in("the last good state, step "), step_in("r/checkpoint.h5 (step "));
    EXPECT_LT(read_points(folder / "r/particles/last_good.vtu").time,
              read_points(folder / "r/particles/failed.vtu").time);
    EXPECT_EQ(Json::parse(folder.read("r/timing.json"))["step_reductions"], 5);

    // The checkpoint is of the good state, and the limit may be raised.
    const Outcome on = run(folder, "r", {"--resume", "--set", "/time/limits/energy_growth=10"});
    EXPECT_EQ(on.exit_code, 0) << on.err;
    expect_consistent(folder, "r");
}

TEST(Trouble, EnergyOutOfNothing) {
    const Folder folder;
    folder.write("scene.json", small_scene({piston, late_piston}).dump());
    const Outcome outcome = run(folder, "r");
    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_THAT(outcome.err,
                AllOf(HasSubstr(" J has appeared out of nothing"), HasSubstr("of body \"block\" at ("),
                      HasSubstr("try a smaller time step: --set \"/time/step=7e-07 s\""),
                      HasSubstr("shape functions of higher order: --set /method/shape=b2cpdi (it is ugimp)")));
    expect_consistent(folder, "r");
    const Outcome small = run(folder, "small", {"--set", "/time/step=1 us"});
    EXPECT_EQ(small.exit_code, 0) << small.err;
}

/// The energy is looked at every 50 steps, however seldom rows are written, and at the end of a run.
TEST(Trouble, EnergyIsWatchedBetweenRowsAndAtTheEnd) {
    const Folder folder;
    const char* const seldom = R"({"time": {"limits": {"energy_growth": 0.3}}, "output": {"history_every": "0.1 ms"}})";
    folder.write("scene.json", small_scene({piston, late_piston, seldom}).dump());
    const Outcome outcome = run(folder, "r");
    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_THAT(outcome.err, AllOf(testing::StartsWith("abut: step 250, "), HasSubstr("appeared out of nothing")));
    EXPECT_LT(table(folder.read("r/history.csv")).size(), 6U) << "no row was near";
    // Runs that end before: where it has just come, and where it has not yet.
    const Outcome shorter = run(folder, "shorter", {"--steps", "232"});
    EXPECT_EQ(shorter.exit_code, 1);
    EXPECT_THAT(shorter.err, AllOf(testing::StartsWith("abut: step 232, "), HasSubstr("appeared out of nothing")));
    EXPECT_EQ(run(folder, "sound", {"--steps", "226"}).exit_code, 0);
    // What a run sees at its end is not kept: one that goes on is as if there had been no end.
    const Outcome on = run(folder, "sound", {"--resume"});
    EXPECT_EQ(on.exit_code, 1);
    EXPECT_EQ(lines(on.err).at(0), lines(outcome.err).at(0));
}

TEST(Trouble, SpeedAboveTheLimit) {
    const Folder folder;
    folder.write("scene.json", small_scene({fall}).dump());
    const Outcome outcome = run(folder, "r");
    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_THAT(outcome.err,
                AllOf(HasSubstr("of body \"ball\" at ("), HasSubstr("the particle moves at 3."),
                      HasSubstr("no checkpoint was written before"), HasSubstr("a higher /time/limits/speed"),
                      HasSubstr("it is 0.4"), HasSubstr("--set /time/on_trouble=shrink-step")));
}

TEST(Trouble, ADiagnosisIsNotLostWhenItsFilesCantBeWritten) {
    const Folder folder;
    folder.write(
        "scene.json",
        small_scene({fall, R"({"output": {"checkpoint": false, "grid": false, "particle_arrays": ["velocity"]}})"})
            .dump());
    const Outcome whole = run(folder, "whole");
    const auto large = std::filesystem::file_size(folder / "whole/particles/failed.vtu");
    const auto small = std::filesystem::file_size(folder / "whole/particles/particles_00000.vtu");
    ASSERT_GT(large, small + 1000);
    const Outcome outcome = folder.abut({"run", "scene.json", "-o", "r", "--quiet", "--threads", "1"}, large - 500);
    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_THAT(outcome.err, AllOf(testing::StartsWith("abut: step "), HasSubstr("/time/limits/speed of 3 m/s"),
                                   HasSubstr("the state gone wrong: not written: r/particles/failed.vtu"),
                                   HasSubstr("File too large"), HasSubstr("try a smaller time step")));
    EXPECT_FALSE(std::filesystem::exists(folder / "r/particles/failed.vtu"));
}

} // namespace
} // namespace abut::app_test
