/// study.json and study.csv.
#include "study_support.h"

#include "io/results/read_csv.h"
#include "io/study/results.h"
#include "io/study/run_record.h"

#include <cmath>
#include <sstream>

namespace abut::study_test {
namespace {

StudyResults some_results() {
    StudyResults results;
    results.version = "1.2.3";
    results.title = "Title, with \"quotes\"";
    results.file = "study.json";
    results.checksum = "abc";
    results.repeats = 2;
    results.timing_warnings = {"a warning"};
    results.axes = {{"cell", {"2 mm", "1 mm"}, 1, "/grid/cell", "m"}, {"how, so", {"FLIP"}, 0, "", ""}};
    results.metrics = {{"loss", "energy-loss", "meaning", true, 0.01}, {"x", "history", "end of x", false, {}}};
    Cost cost;
    cost.wall_seconds = 3;
    cost.solver_seconds = 0.1 + 0.2;
    cost.solver_cpu_seconds = 0.25;
    cost.tasks = {{"find velocities", 0.1}, {"update", 0.2}};
    cost.steps = 70;
    cost.particles = 12;
    cost.particle_updates = 840;
    cost.particle_sweeps = 2520;
    cost.node_updates = 5'000'000'000;
    cost.instructions = 77;
    cost.peak_memory_bytes = 1 << 20;
    cost.threads = 2;
    cost.alone = false;
    cost.machine = "host, cpu";
    Cost other = cost;
    other.solver_seconds = 0.5;
    other.instructions.reset();
    results.variants = {{"2 mm, FLIP",
                         "runs/a",
                         {0, 0},
                         {2e-3, {}},
                         "key",
                         Status::done,
                         "",
                         {0.1, {}},
                         {"", "why"},
                         {cost, other},
                         false},
                        {"1 mm, FLIP",
                         "runs/b",
                         {1, 0},
                         {1e-3, {}},
                         "kez",
                         Status::unstable,
                         "it, \"broke\"",
                         {{}, {}},
                         {"x", "y"},
                         {},
                         true}};
    results.series = {{0, 0, {0, 1}, 1.5, {}, 0.3, "note"}};
    return results;
}

std::string text_of(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    std::stringstream text;
    text << stream.rdbuf();
    return text.str();
}

TEST(StudyResults, ComeBackFromJson) {
    const Folder folder;
    write_results(folder / "a.json", some_results());
    const StudyResults back = read_results(folder / "a.json");
    write_results(folder / "b.json", back);
    EXPECT_EQ(text_of(folder / "a.json"), text_of(folder / "b.json"));
    const StudyResults before = some_results();
    ASSERT_EQ(back.variants.size(), 2U);
    EXPECT_EQ(back.variants[0].metrics, before.variants[0].metrics);
    EXPECT_EQ(back.variants[0].sizes, before.variants[0].sizes);
    EXPECT_EQ(back.variants[0].costs[0].solver_seconds, 0.1 + 0.2);
    EXPECT_EQ(back.variants[0].costs[0].node_updates, 5'000'000'000);
    EXPECT_EQ(back.variants[0].costs[0].tasks, before.variants[0].costs[0].tasks);
    EXPECT_EQ(back.variants[0].costs[1].instructions, std::nullopt);
    EXPECT_FALSE(back.variants[0].costs[0].alone);
    EXPECT_FALSE(back.variants[0].repeats_agree);
    EXPECT_EQ(back.variants[1].status, Status::unstable);
    EXPECT_EQ(back.series[0].extrapolated, 0.3);
    EXPECT_EQ(back.axes[0].unit, "m");
    EXPECT_EQ(back.metrics[0].tolerance, 0.01);
    EXPECT_NEAR(back.variants[0].spread(&Cost::solver_seconds).median, 0.4, 1e-15);
    EXPECT_EQ(back.variants[0].task_spread("update").median, 0.2);
}

TEST(StudyResults, BrokenOnesAreRefused) {
    const Folder folder;
    const auto complaint = [&](const std::string& text) {
        try {
            read_results(folder.write("x.json", text));
        } catch (const std::runtime_error& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    EXPECT_THAT(complaint("{"), HasSubstr("x.json: not the results of a study"));
    EXPECT_THAT(complaint("{}"), HasSubstr("x.json: not the results of a study"));
    EXPECT_THROW(read_results(folder / "nowhere.json"), std::runtime_error);
}

TEST(StudyResults, AsATable) {
    const Folder folder;
    write_study_csv(folder / "study.csv", some_results());
    const CsvFile table = read_csv(folder / "study.csv", {"variant", "status", "cell", "how, so", "cause"});
    ASSERT_EQ(table.rows, 2U);
    EXPECT_EQ(table.find("variant")->words[0], "2 mm, FLIP");
    EXPECT_EQ(table.find("status")->words[1], "unstable");
    EXPECT_EQ(table.find("cause")->words[1], "it, \"broke\"");
    EXPECT_EQ(table.find("cell")->words[0], "2 mm");
    EXPECT_EQ(table.find("size of cell")->numbers[0], 2e-3);
    EXPECT_EQ(table.find("size of how, so"), nullptr);
    EXPECT_EQ(table.find("loss")->numbers[0], 0.1);
    EXPECT_TRUE(std::isnan(table.find("x")->numbers[0]));
    EXPECT_NEAR(table.find("solver_seconds")->numbers[0], 0.4, 1e-15);
    EXPECT_NEAR(table.find("solver_seconds_low")->numbers[0], 0.35, 1e-15);
    EXPECT_NEAR(table.find("solver_seconds_deviation")->numbers[0], 0.1, 1e-15);
    EXPECT_EQ(table.find("instructions")->numbers[0], 77);
    EXPECT_EQ(table.find("repeats")->numbers[0], 2);
    EXPECT_EQ(table.find("repeats")->numbers[1], 0);
    EXPECT_TRUE(std::isnan(table.find("solver_seconds")->numbers[1]));
}

TEST(StudyResults, Records) {
    const Folder folder;
    EXPECT_FALSE(read_record(folder / "none.json"));
    EXPECT_FALSE(read_record(folder.write("half.json", "{\"key\": ")));
    RunRecord record{"key", Status::done, "", some_results().variants[0].costs, "history", false};
    write_record(folder / "r.json", record);
    const auto back = read_record(folder / "r.json");
    ASSERT_TRUE(back);
    EXPECT_EQ(back->key, "key");
    EXPECT_EQ(back->status, Status::done);
    EXPECT_EQ(back->history, "history");
    EXPECT_FALSE(back->repeats_agree);
    ASSERT_EQ(back->costs.size(), 2U);
    EXPECT_EQ(back->costs[0].machine, "host, cpu");
    EXPECT_TRUE(back->complete(2));
    EXPECT_FALSE(back->complete(3));
    record.status = Status::unstable;
    EXPECT_TRUE(record.complete(3));
    record.status = Status::failed;
    EXPECT_FALSE(record.complete(1));
}

} // namespace
} // namespace abut::study_test
