/// What a run leaves in its folder (contract §3).
#include "app_support.h"

#include "io/results/pvd.h"
#include "io/results/read_frame.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace abut::app_test {
namespace {

using testing::ElementsAre;
using testing::ElementsAreArray;

/// small_scene() and its results, run once for all tests of this file.
class Results : public testing::Test {
protected:
    static void SetUpTestSuite() {
        folder() = new Folder; // NOLINT: GoogleTest's way to share between tests
        folder()->write("scene.json", small_scene().dump(2));
        outcome() = folder()->abut({"run", "scene.json"}); // to the default folder
    }
    static void TearDownTestSuite() {
        delete folder(); // NOLINT
        folder() = nullptr;
    }
    static Folder*& folder() {
        static Folder* shared = nullptr;
        return shared;
    }
    static Outcome& outcome() {
        static Outcome shared;
        return shared;
    }
    static std::filesystem::path path(const std::string& name) { return *folder() / ("scene-results/" + name); }
    static std::string read(const std::string& name) { return folder()->read("scene-results/" + name); }
};

TEST_F(Results, AreTheFilesOfTheContract) {
    EXPECT_EQ(outcome().exit_code, 0) << outcome().err;
    std::set<std::string> expected{"scene.json", "scene-results"};
    for (const char* name : {"particles", "particles.pvd", "grid", "grid.pvd", "contact", "contact.pvd", "history.csv",
                             "bodies.csv", "pairs.csv", "timing.json", "scene.json", "all.pvd", "checkpoint.h5"})
        expected.insert(std::string("scene-results/") + name);
    for (int frame = 0; frame < 5; ++frame)
        for (const std::string file :
             {"particles/particles_0000#.vtu", "grid/grid_0000#.vti", "contact/contact_0000#.vtp"}) {
            std::string name = file;
            name.replace(name.find('#'), 1, std::to_string(frame));
            expected.insert("scene-results/" + name);
        }
    std::set<std::string> found;
    for (const auto& [name, size] : folder()->content()) found.insert(name);
    EXPECT_EQ(found, expected);
}

TEST_F(Results, ProgressHasALineForEachOutput) {
    EXPECT_GE(lines(outcome().err).size(), 5U);
    EXPECT_EQ(outcome().out, "");
}

TEST_F(Results, HistoryHasTheColumnsOfTheContract) {
    const auto history = table(read("history.csv"));
    EXPECT_THAT(history.front(), ElementsAre("step", "time", "dt", "kinetic_energy", "strain_energy", "total_energy",
                                             "external_work", "contact_work", "momentum_x", "momentum_y", "momentum_z",
                                             "mean_stress_xx", "mean_stress_yy", "mean_stress_zz", "mean_stress_xy",
                                             "force_floor_x", "force_floor_y", "force_floor_z", "friction_work"));
    ASSERT_GT(history.size(), 30U); // 40 intervals; a step is 3 us
    EXPECT_EQ(history[1][1], "0");
    EXPECT_DOUBLE_EQ(std::stod(history.back()[1]), 0.4e-3);
    for (std::size_t i = 2; i < history.size(); ++i)
        EXPECT_LT(std::stod(history[i - 1][1]), std::stod(history[i][1])) << "row " << i;
    for (const auto& row : history) EXPECT_EQ(row.size(), history.front().size());
}

TEST_F(Results, BodiesHaveTheColumnsOfTheContract) {
    const auto bodies = table(read("bodies.csv"));
    EXPECT_THAT(bodies.front(),
                ElementsAre("step", "time", "body", "mass", "x", "y", "z", "vx", "vy", "vz", "kinetic_energy",
                            "strain_energy", "stress_xx", "stress_yy", "stress_zz", "stress_xy", "angular_velocity_z"));
    EXPECT_EQ(bodies.size() - 1, 2 * (table(read("history.csv")).size() - 1));
    EXPECT_EQ(bodies[1][2], "block");
    EXPECT_EQ(bodies[2][2], "ball");
    EXPECT_NEAR(std::stod(bodies[1][3]), 1000 * 8e-3 * 4e-3, 1e-12);
    EXPECT_NEAR(std::stod(bodies[2][8]), -5, 1e-12); // vy at the start
    const auto& ball = bodies.back();
    EXPECT_GT(std::stod(ball[8]), -5 + 9.81 * 0.4e-3); // the block has slowed it down
    EXPECT_LT(std::stod(ball[16]), -1);                // and friction has made it roll
}

TEST_F(Results, BodiesAddUpToTheHistory) {
    const auto bodies = table(read("bodies.csv")), history = table(read("history.csv"));
    for (std::size_t row = 1; row < history.size(); ++row) {
        double kinetic = 0;
        for (const std::size_t body : {2 * row - 1, 2 * row}) kinetic += std::stod(bodies[body][10]);
        EXPECT_NEAR(kinetic, std::stod(history[row][3]), 1e-12 * kinetic) << "row " << row;
    }
}

struct Shape {
    std::string name;
    int components;
    bool whole_numbers;
    bool operator==(const Shape&) const = default;
    friend void PrintTo(const Shape& shape, std::ostream* out) { *out << shape.name << " x " << shape.components; }
};

std::vector<Shape> shapes_of(const std::vector<Array>& arrays, std::size_t points) {
    std::vector<Shape> shapes;
    for (const Array& array : arrays) {
        shapes.push_back({array.name, array.components, array.values.index() == 1});
        std::visit([&](const auto& values) { EXPECT_EQ(values.size(), points * array.components) << array.name; },
                   array.values);
    }
    return shapes;
}

TEST_F(Results, ParticlesReadBack) {
    const PointFrame frame = read_points(path("particles/particles_00002.vtu"));
    const std::size_t particles = frame.points.size() / 3;
    EXPECT_THAT(shapes_of(frame.arrays, particles),
                testing::IsSupersetOf(std::vector<Shape>{{"velocity", 3, false},
                                                         {"displacement", 3, false},
                                                         {"stress", 6, false},
                                                         {"pressure", 1, false},
                                                         {"von_mises_stress", 1, false},
                                                         {"deformation_gradient", 9, false},
                                                         {"mass", 1, false},
                                                         {"volume", 1, false},
                                                         {"body", 1, true}}));
    ASSERT_EQ(frame.words.size(), 1U);
    EXPECT_EQ(frame.words[0].name, "body_names");
    EXPECT_THAT(frame.words[0].values, ElementsAre("block", "ball"));
    EXPECT_GE(frame.time, 0.2e-3);
    EXPECT_LT(frame.time, 0.21e-3); // the first step after it was due
}

TEST_F(Results, GridReadsBack) {
    const GridFrame frame = read_grid(path("grid/grid_00004.vti"));
    EXPECT_THAT(frame.nodes, ElementsAre(13, 13, 1));
    EXPECT_THAT(shapes_of(frame.arrays, 169), testing::IsSupersetOf(std::vector<Shape>{{"mass", 1, false},
                                                                                       {"velocity", 3, false},
                                                                                       {"contact_normal", 3, false},
                                                                                       {"contact_separation", 1, false},
                                                                                       {"body_count", 1, true}}));
}

TEST_F(Results, ContactReadsBack) {
    const PointFrame frame = read_points(path("contact/contact_00002.vtp"));
    const std::size_t pairs = frame.points.size() / 3;
    EXPECT_GT(pairs, 0U);
    EXPECT_THAT(shapes_of(frame.arrays, pairs), testing::IsSupersetOf(std::vector<Shape>{{"normal", 3, false},
                                                                                         {"separation", 1, false},
                                                                                         {"in_contact", 1, true},
                                                                                         {"body_a", 1, true},
                                                                                         {"body_b", 1, true},
                                                                                         {"area", 1, false},
                                                                                         {"force", 3, false},
                                                                                         {"cloud_size", 1, true},
                                                                                         {"iterations", 1, true}}));
}

TEST_F(Results, SeriesHaveStrictlyIncreasingTimes) {
    for (const char* name : {"particles.pvd", "grid.pvd", "contact.pvd"}) {
        const PvdSeries series = read_pvd(path(name));
        ASSERT_EQ(series.entries.size(), 5U) << name;
        for (std::size_t i = 0; i < 5; ++i) {
            EXPECT_TRUE(std::filesystem::exists(path(series.entries[i].file)));
            EXPECT_NEAR(series.entries[i].time, 1e-4 * static_cast<double>(i), 4e-6) << name;
            EXPECT_TRUE(i == 0 || series.entries[i].time > series.entries[i - 1].time) << name;
        }
    }
    EXPECT_EQ(read_points(path("particles/particles_00001.vtu")).time, read_pvd(path("particles.pvd")).entries[1].time);
}

TEST_F(Results, TimingHasTheKeysOfTheContract) {
    const Json timing = Json::parse(read("timing.json"));
    std::vector<std::string> keys;
    for (const auto& [key, value] : timing.items()) keys.push_back(key);
    EXPECT_THAT(keys, testing::UnorderedElementsAre("wall_seconds", "cpu_seconds", "solver_seconds", "output_seconds",
                                                    "tasks", "steps", "resumed_at_step", "particles", "nodes",
                                                    "threads", "peak_memory_bytes", "ns_per_particle_step",
                                                    "step_reductions", "abandoned_steps", "solver_cpu_seconds",
                                                    "particle_updates", "particle_sweeps", "node_updates"));
    EXPECT_EQ(std::to_string(timing["steps"].get<long>()), table(read("history.csv")).back()[0]);
    double tasks = 0;
    for (const auto& [task, seconds] : timing["tasks"].items()) tasks += seconds.get<double>();
    EXPECT_GT(tasks, 0.5 * timing["solver_seconds"].get<double>());
    EXPECT_LE(tasks, timing["solver_seconds"].get<double>());
    EXPECT_LE(timing["solver_seconds"], timing["wall_seconds"]);
}

TEST_F(Results, SceneRunsAgainToTheSameHistory) {
    const Json scene = Json::parse(read("scene.json"));
    EXPECT_EQ(scene["abut_version"].get<std::string>() + "\n", folder()->abut({"--version"}).out.substr(5));
    EXPECT_EQ(scene["time"]["cfl"], 0.4);   // a default
    EXPECT_EQ(scene["grid"]["cell"], 1e-3); // SI units
    const Folder again;
    again.write("copy.json", read("scene.json"));
    ASSERT_EQ(again.abut({"run", "copy.json", "-o", "again", "--quiet"}).exit_code, 0);
    EXPECT_EQ(again.read("again/history.csv"), read("history.csv"));
    EXPECT_EQ(again.read("again/scene.json"), read("scene.json"));
    EXPECT_EQ(again.read("again/particles/particles_00004.vtu"), read("particles/particles_00004.vtu"));
}

TEST_F(Results, OverridesAreInTheScene) {
    const Folder other;
    other.write("scene.json", small_scene().dump());
    ASSERT_EQ(other
                  .abut({"run", "scene.json", "--set", "/time/end=20 us", "--set", "/method/transfer/order=4", "--set",
                         "/title=Shorter", "-o", "deep/er/results", "--quiet"})
                  .exit_code,
              0);
    const Json scene = Json::parse(other.read("deep/er/results/scene.json"));
    EXPECT_EQ(scene["time"]["end"], 20e-6);
    EXPECT_EQ(scene["method"]["transfer"]["order"], 4);
    EXPECT_EQ(scene["title"], "Shorter");
}

TEST(Run, WithoutContactWritesNothingOfContact) {
    const Folder folder;
    folder.write("scene.json", small_scene({R"({"contact": null, "time": {"end": "20 us"}})"}).dump());
    ASSERT_EQ(folder.abut({"run", "scene.json", "-o", "results", "--quiet"}).exit_code, 0);
    EXPECT_FALSE(std::filesystem::exists(folder / "results/contact.pvd"));
    for (const Array& array : read_grid(folder / "results/grid/grid_00000.vti").arrays)
        EXPECT_THAT(array.name, testing::Not(testing::StartsWith("contact"))) << array.name;
}

TEST(Run, WritesOnlyTheSeriesThatAreWanted) {
    const Folder folder;
    folder.write("scene.json",
                 small_scene({R"({"output": {"grid": false, "contact": false}, "time": {"end": "20 us"}})"}).dump());
    const Outcome outcome = folder.abut({"run", "scene.json", "-o", "results", "--quiet"});
    ASSERT_EQ(outcome.exit_code, 0);
    EXPECT_EQ(outcome.err, "");
    EXPECT_TRUE(std::filesystem::exists(folder / "results/particles.pvd"));
    EXPECT_FALSE(std::filesystem::exists(folder / "results/grid.pvd"));
    EXPECT_FALSE(std::filesystem::exists(folder / "results/contact.pvd"));
}

TEST(Run, UntilStopsThere) {
    const Folder folder;
    folder.write("scene.json", small_scene().dump());
    ASSERT_EQ(folder.abut({"run", "scene.json", "-o", "results", "--until", "5e-5", "--quiet"}).exit_code, 0);
    EXPECT_DOUBLE_EQ(std::stod(table(folder.read("results/history.csv")).back()[1]), 50e-6);
    EXPECT_DOUBLE_EQ(read_pvd(folder / "results/particles.pvd").entries.back().time, 50e-6);
}

} // namespace
} // namespace abut::app_test
