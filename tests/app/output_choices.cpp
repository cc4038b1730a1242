// What a scene chooses of the results: cadences, arrays, bodies, precision.
#include "app_support.h"

#include "io/results/pvd.h"
#include "io/results/read_frame.h"

#include <cmath>

namespace abut::app_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::UnorderedElementsAre;

std::vector<std::string> names_of(const std::vector<Array>& arrays) {
    std::vector<std::string> names;
    for (const Array& array : arrays) names.push_back(array.name);
    return names;
}

/// small_scene() (five frames, 0.1 ms apart) with `output` merged, run to the folder "r".
Outcome run(const Folder& folder, const std::string& output) {
    folder.write("scene.json", small_scene({R"({"output": )" + output + "}"}).dump());
    return folder.abut({"run", "scene.json", "-o", "r", "--quiet"});
}

TEST(OutputChoices, EachSeriesMayHaveItsOwnCadence) {
    const Folder folder;
    ASSERT_EQ(run(folder, R"({"grid_every": "0.2 ms", "contact_every": "1 s"})").exit_code, 0);
    const PvdSeries particles = read_pvd(folder / "r/particles.pvd");
    const PvdSeries grid = read_pvd(folder / "r/grid.pvd");
    const PvdSeries contact = read_pvd(folder / "r/contact.pvd");
    ASSERT_EQ(particles.entries.size(), 5U);
    ASSERT_EQ(grid.entries.size(), 3U);
    ASSERT_EQ(contact.entries.size(), 2U) << "the first and the last";
    for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(grid.entries[i].time, particles.entries[2 * i].time);
    EXPECT_EQ(grid.entries.back().file, "grid/grid_00002.vti");
    EXPECT_EQ(contact.entries.back().time, particles.entries.back().time);
    EXPECT_EQ(read_pvd(folder / "r/all.pvd").entries.size(), 15U) << "three parts at each of five times";
}

TEST(OutputChoices, ACadenceChangesNothingInTheRun) {
    const Folder folder;
    ASSERT_EQ(run(folder, "{}").exit_code, 0);
    std::map<std::string, std::string> tables;
    for (const char* name : {"r/history.csv", "r/bodies.csv", "r/pairs.csv"}) tables[name] = folder.read(name);
    ASSERT_EQ(run(folder, R"({"grid_every": "0.03 ms", "contact_every": "7 us", "precision": "single",
                              "particle_arrays": ["id"], "live": true, "live_preset": "contact"})")
                  .exit_code,
              2)
        << "the folder holds results";
    ASSERT_EQ(folder.abut({"run", "scene.json", "-o", "r", "--quiet", "--overwrite"}).exit_code, 0);
    EXPECT_TRUE(std::filesystem::exists(folder / "r/live.png"));
    for (const auto& [name, text] : tables) EXPECT_TRUE(folder.read(name) == text) << name;
}

TEST(OutputChoices, ArraysAndBodies) {
    const Folder folder;
    const Outcome outcome = run(folder, R"({"particle_arrays": ["id", "body", "velocity"], "grid_arrays": ["mass"],
                                            "contact_arrays": ["normal"], "bodies": ["ball"]})");
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const PointFrame particles = read_points(folder / "r/particles/particles_00001.vtu");
    EXPECT_THAT(names_of(particles.arrays), UnorderedElementsAre("id", "body", "velocity"));
    EXPECT_THAT(names_of(read_grid(folder / "r/grid/grid_00001.vti").arrays), ElementsAre("mass"));
    EXPECT_THAT(names_of(read_points(folder / "r/contact/contact_00001.vtp").arrays), ElementsAre("normal"));
    ASSERT_FALSE(particles.points.empty());
    const auto& names = particles.words[0].values;
    for (const Array& array : particles.arrays) {
        if (array.name != "body") continue;
        for (const auto body : std::get<1>(array.values)) EXPECT_EQ(names[static_cast<std::size_t>(body)], "ball");
    }
}

/// Frames of contact pairs come four times as often; the interpenetration is measured with those of particles only.
TEST(OutputChoices, ProgressTellsTheInterpenetrationOfItsOwnFrame) {
    const Folder folder;
    folder.write("scene.json", small_scene({R"({"output": {"contact_every": "25 us"}})"}).dump());
    const Outcome outcome = folder.abut({"run", "scene.json", "-o", "r"});
    ASSERT_EQ(outcome.exit_code, 0);
    std::size_t notes = 0;
    for (const std::string& line : lines(outcome.err)) notes += line.find("interpenetration") != std::string::npos;
    EXPECT_EQ(notes, read_pvd(folder / "r/particles.pvd").entries.size());
}

TEST(OutputChoices, OverwriteRemovesThePicturesOfTheResultsBefore) {
    const Folder folder;
    ASSERT_EQ(run(folder, "{}").exit_code, 0);
    folder.write("r/frames/stress/frame_00004.png", "a picture");
    folder.write("r/frames/stress/mine.png", "another");
    ASSERT_EQ(folder.abut({"run", "scene.json", "-o", "r", "--quiet", "--overwrite"}).exit_code, 0);
    EXPECT_FALSE(std::filesystem::exists(folder / "r/frames/stress/frame_00004.png"));
    EXPECT_TRUE(std::filesystem::exists(folder / "r/frames/stress/mine.png"));
}

TEST(OutputChoices, FramesTellStepAndUnits) {
    const Folder folder;
    ASSERT_EQ(run(folder, "{}").exit_code, 0);
    const auto history = table(folder.read("r/history.csv"));
    const PointFrame last = read_points(folder / "r/particles/particles_00004.vtu");
    bool found = false;
    for (const Array& array : last.globals)
        if (array.name == "step") {
            found = true;
            EXPECT_EQ(std::to_string(std::get<1>(array.values)[0]), history.back()[0]);
        }
    EXPECT_TRUE(found);
}

TEST(OutputChoices, WrongNamesAreRefusedWithTheNearest) {
    const Folder folder;
    const Outcome outcome = run(folder, R"({"particle_arrays": ["velocty"], "grid_arrays": [], "bodies": ["bal"],
                                            "precision": "half", "contact_every": 0})");
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_THAT(outcome.err, HasSubstr("/output/particle_arrays/0: "));
    EXPECT_THAT(outcome.err, HasSubstr("did you mean \"velocity\"?"));
    EXPECT_THAT(outcome.err, HasSubstr("/output/grid_arrays: "));
    EXPECT_THAT(outcome.err, HasSubstr("/output/precision: "));
    EXPECT_THAT(outcome.err, HasSubstr("/output/contact_every: "));
    const Outcome bodies = run(folder, R"({"bodies": ["bal"]})");
    EXPECT_EQ(bodies.exit_code, 2);
    EXPECT_THAT(bodies.err, HasSubstr("/output/bodies/0: no body \"bal\"; did you mean \"ball\"?"));
    EXPECT_FALSE(std::filesystem::exists(folder / "r"));
}

} // namespace
} // namespace abut::app_test
