/// abut study: families of runs.
#include "app_support.h"

#include "io/results/read_csv.h"

#include <cmath>
#include <csignal>
#include <thread>

namespace abut::app_test {
namespace {

using testing::HasSubstr;
using testing::Not;

/// Two transfers by two CFL factors of small_scene(), ended early: four runs of a few hundredths of a second.
Json small_study() {
    Json study = Json::parse(R"({
      "title": "A disk hits a block",
      "end": "0.1 ms",
      "axes": {
        "transfer": { "variants": { "FLIP": { "/method/transfer": { "scheme": "flip" } }, "XPIC 2": {} } },
        "CFL": { "pointer": "/time/cfl", "values": [0.4, 0.2] }
      },
      "metrics": { "loss": { "type": "energy-loss" },
                   "balance": { "type": "balance-error" },
                   "momentum": { "type": "momentum-error" },
                   "overlap": { "type": "interpenetration" },
                   "force": { "value": "ball.block.force_y", "reduce": "max" },
                   "drop": { "value": "ball.y", "reference": { "CFL": 0.2, "transfer": "XPIC 2" }, "reduce": "rms" },
                   "speed": { "type": "particles", "value": ["velocity_x", "velocity_y"], "bodies": ["ball"],
                              "at": 0 } }
    })");
    study["base"] = small_scene();
    return study;
}

Json small_study(const std::string& patch) {
    Json study = small_study();
    study.merge_patch(Json::parse(patch));
    return study;
}

/// The metrics of all variants, text by text: the columns of study.csv that tell of no time.
std::vector<std::vector<std::string>> errors_in(const Folder& folder, const std::string& results) {
    std::vector<std::vector<std::string>> rows;
    const Json study = Json::parse(folder.read(results + "/study.json"));
    for (const Json& variant : study["variants"]) {
        std::vector<std::string>& row = rows.emplace_back();
        row.push_back(variant["name"]);
        row.push_back(variant["status"]);
        for (const Json& metric : variant["metrics"]) row.push_back(metric.dump());
    }
    return rows;
}

TEST(Study, RunsAFamilyAndTabulatesIt) {
    const Folder folder;
    folder.write("study.json", small_study(R"({"repeats": 2})").dump());
    const Outcome outcome = folder.abut({"study", "study.json", "-o", "s", "--quiet"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    EXPECT_THAT(outcome.out, HasSubstr("4 of 4 variants done\n"));
    const CsvFile table = read_csv(folder / "s/study.csv", {"variant", "status", "transfer", "CFL", "cause"});
    ASSERT_EQ(table.rows, 4U);
    EXPECT_EQ(table.find("variant")->words,
              (std::vector<std::string>{"CFL 0.4, FLIP", "CFL 0.4, XPIC 2", "CFL 0.2, FLIP", "CFL 0.2, XPIC 2"}));
    for (std::size_t v = 0; v < 4; ++v) {
        const auto number = [&](const char* column) { return table.find(column)->numbers[v]; };
        EXPECT_EQ(table.find("status")->words[v], "done");
        EXPECT_LT(number("momentum"), 1e-10); // the floor's and gravity's impulses account for all
        EXPECT_GT(number("momentum"), 0);
        EXPECT_LE(std::abs(number("loss")), number("balance"));
        EXPECT_GE(number("overlap"), 0);
        EXPECT_GT(number("force"), 0);
        EXPECT_NEAR(number("speed"), std::hypot(1, 5), 1e-14); // at the start
        EXPECT_EQ(std::isnan(number("drop")), v == 3) << "the reference itself has no error";
        EXPECT_EQ(number("repeats"), 2);
        EXPECT_EQ(number("particle_updates"), number("particles") * number("steps"));
        EXPECT_EQ(number("particle_sweeps"), number("particle_updates") * (v % 2 == 0 ? 2 : 3)); // FLIP, XPIC 2
        EXPECT_GT(number("node_updates"), number("steps"));
        EXPECT_LE(number("solver_seconds"), number("wall_seconds"));
        EXPECT_LE(number("solver_seconds_low"), number("solver_seconds"));
        EXPECT_GT(number("solver_cpu_seconds"), 0);
        EXPECT_GT(number("peak_memory_bytes"), 1e6);
        EXPECT_LT(number("peak_memory_bytes"), 1e9);
    }
    EXPECT_GT(table.find("steps")->numbers[2], 1.9 * table.find("steps")->numbers[0]);
    const Json study = Json::parse(folder.read("s/study.json"));
    EXPECT_THAT(study["timing_warnings"].dump(), Not(HasSubstr("--jobs")));
    for (const Json& variant : study["variants"]) EXPECT_TRUE(variant["repeats_agree"].get<bool>());
    // The measures are those of the results that lie there.
    const Json& first = study["variants"][0];
    const CsvFile history = read_csv(folder / ("s/" + first["folder"].get<std::string>() + "/history.csv"));
    const auto column = [&](const char* name) { return history.find(name)->numbers; };
    double most = 0;
    for (const double energy : column("total_energy")) most = std::max(most, energy);
    EXPECT_EQ(first["metrics"][3].get<double>(), -(column("total_energy").back() - column("total_energy").front() -
                                                   column("external_work").back() - column("contact_work").back()) /
                                                     most);
    EXPECT_FALSE(std::filesystem::exists(folder / "s/repeats"));
}

TEST(Study, AgreesWithItselfBitForBit) {
    const Folder folder;
    folder.write("study.json", small_study().dump());
    ASSERT_EQ(folder.abut({"study", "study.json", "-o", "a", "--quiet"}).exit_code, 0);
    const Outcome parallel = folder.abut({"study", "study.json", "-o", "b", "--quiet", "--jobs", "3"});
    ASSERT_EQ(parallel.exit_code, 0);
    EXPECT_THAT(parallel.out, HasSubstr("times are not reliable: 4 runs shared the machine"));
    EXPECT_EQ(errors_in(folder, "a"), errors_in(folder, "b"));
}

TEST(Study, SkipsWhatIsDone) {
    const Folder folder;
    folder.write("study.json", small_study().dump());
    ASSERT_EQ(folder.abut({"study", "study.json", "-o", "s", "--quiet"}).exit_code, 0);
    const auto records = [&] {
        std::map<std::string, std::string> texts;
        for (const auto& entry : std::filesystem::directory_iterator(folder / "s/records"))
            texts[entry.path().filename().string()] = folder.read("s/records/" + entry.path().filename().string());
        return texts;
    };
    const auto before = records();
    ASSERT_EQ(before.size(), 4U);
    ASSERT_EQ(folder.abut({"study", "study.json", "-o", "s", "--quiet"}).exit_code, 0);
    EXPECT_EQ(records(), before);
    // A record that is lost, and a variant that is new.
    std::filesystem::remove(folder / "s/records/CFL_0.2_FLIP.json");
    folder.write("study.json", small_study(R"({"axes": {"CFL": {"values": [0.4, 0.2, 0.3]}}})").dump());
    const Outcome more = folder.abut({"study", "study.json", "-o", "s"});
    EXPECT_THAT(more.err, HasSubstr("[3/3]")); // one of them was lost
    EXPECT_THAT(more.out, HasSubstr("6 of 6 variants done"));
    auto after = records();
    EXPECT_EQ(after.size(), 6U);
    for (const auto& [name, text] : before) EXPECT_EQ(after[name] == text, name != "CFL_0.2_FLIP.json") << name;
    // Another end makes other runs of all.
    folder.write("study.json", small_study(R"({"end": "0.05 ms"})").dump());
    EXPECT_THAT(folder.abut({"study", "study.json", "-o", "s"}).err, HasSubstr("[4/4]"));
}

TEST(Study, SurvivesVariantsThatFail) {
    const Folder folder;
    folder.write("study.json", small_study(R"({"repeats": 2, "axes": {
        "transfer": null,
        "CFL": null,
        "ball": { "variants": { "good": {}, "out of the grid": { "/bodies/1/velocity": ["80 m/s", 0] } } } },
        "metrics": { "drop": null, "loss": null, "balance": null } })")
                                   .dump());
    const Outcome outcome = folder.abut({"study", "study.json", "-o", "s"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_THAT(outcome.out, HasSubstr("1 of 2 variants done, 1 unstable"));
    EXPECT_THAT(outcome.out, HasSubstr("out of the grid: unstable: step "));
    EXPECT_THAT(outcome.out, HasSubstr("of body \"ball\""));
    const Json study = Json::parse(folder.read("s/study.json"));
    EXPECT_EQ(study["variants"][1]["status"], "unstable");
    EXPECT_EQ(study["variants"][1]["metrics"][0], nullptr);
    EXPECT_EQ(study["variants"][0]["costs"].size(), 2U);
    EXPECT_THAT(folder.abut({"study", "study.json", "-o", "s"}).err, Not(HasSubstr("[1/"))) << "it is run again";
}

TEST(Study, EndsRunsThatTakeTooLong) {
    const Folder folder;
    // Steps so small that the ball never reaches the ground.
    folder.write("study.json", small_study(R"({"end": "1000 s", "time_limit": "0.3 s", "combine": [{}],
                                               "axes": {"CFL": {"values": [1e-6]}},
                                               "metrics": {"drop": null}})")
                                   .dump());
    const Outcome outcome = folder.abut({"study", "study.json", "-o", "s", "--quiet"});
    EXPECT_EQ(outcome.exit_code, 1) << "none is done: " << outcome.err;
    EXPECT_THAT(outcome.out, HasSubstr("failed: over its time limit of 0.3 s"));
}

TEST(Study, GoesOnAfterAnInterruption) {
    const Folder folder;
    folder.write("study.json", small_study(R"({"end": "0.4 ms", "repeats": 20})").dump());
    const pid_t process = folder.start({"study", "study.json", "-o", "s", "--quiet"});
    for (int i = 0; i < 2000 && !std::filesystem::exists(folder / "s/records/CFL_0.4_FLIP.json"); ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    ::kill(process, SIGINT);
    const Outcome outcome = folder.end_of(process);
    EXPECT_EQ(outcome.exit_code, 130) << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr("the same command goes on"));
    const std::string kept = folder.read("s/records/CFL_0.4_FLIP.json");
    folder.write("study.json", small_study(R"({"end": "0.4 ms"})").dump());
    EXPECT_THAT(folder.abut({"study", "study.json", "-o", "s"}).out, HasSubstr("4 of 4 variants done"));
    EXPECT_EQ(folder.read("s/records/CFL_0.4_FLIP.json"), kept);
    folder.write("study.json", small_study(R"({"end": "0.4 ms", "repeats": 1})").dump());
    ASSERT_EQ(folder.abut({"study", "study.json", "-o", "whole", "--quiet"}).exit_code, 0);
    EXPECT_EQ(errors_in(folder, "s"), errors_in(folder, "whole"));
}

TEST(Study, ShardsMakeAWhole) {
    const Folder folder;
    folder.write("study.json", small_study().dump());
    ASSERT_EQ(folder.abut({"study", "study.json", "-o", "whole", "--quiet"}).exit_code, 0);
    const Outcome half = folder.abut({"study", "study.json", "-o", "a", "--quiet", "--shard", "1/2"});
    EXPECT_EQ(half.exit_code, 0) << half.err;
    EXPECT_THAT(half.out, HasSubstr("2 of 4 variants done, 2 missing"));
    ASSERT_EQ(folder.abut({"study", "study.json", "-o", "b", "--quiet", "--shard", "2/2"}).exit_code, 0);
    const Outcome merged = folder.abut({"study", "study.json", "-o", "all", "--merge", "a", "b"});
    EXPECT_EQ(merged.exit_code, 0) << merged.err;
    EXPECT_THAT(merged.out, HasSubstr("4 of 4 variants done"));
    EXPECT_EQ(errors_in(folder, "all"), errors_in(folder, "whole"));
    folder.write("other.json", small_study(R"({"end": "0.05 ms"})").dump());
    const Outcome other = folder.abut({"study", "other.json", "-o", "x", "--merge", "a"});
    EXPECT_EQ(other.exit_code, 2);
    EXPECT_FALSE(std::filesystem::exists(folder / "x"));
    EXPECT_THAT(other.err, HasSubstr("none of its runs is one of this study"));
}

TEST(Study, RefusesBadInputBeforeAnythingRuns) {
    const Folder folder;
    folder.write("taken/file.txt", "mine");
    const auto refused = [&](const Json& study, const std::string& message, const Arguments& more = {"-o", "s"}) {
        folder.write("study.json", study.dump());
        Arguments arguments{"study", "study.json"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const Outcome outcome = folder.abut(arguments);
        EXPECT_EQ(outcome.exit_code, 2) << message;
        EXPECT_EQ(outcome.out, "");
        EXPECT_THAT(outcome.err, HasSubstr(message));
        EXPECT_FALSE(std::filesystem::exists(folder / "s")) << message;
    };
    refused(small_study(R"({"axes": {"CFL": {"pointer": "/time/cfk"}}})"),
            "study.json: /axes/CFL/pointer: the scene format has no key \"/time/cfk\"; did you mean \"/time/cfl\"?");
    refused(small_study(R"({"metrics": {"loss": "total_enrgy"}})"),
            "study.json: /metrics/loss/value: \"total_enrgy\", character 1: unknown name \"total_enrgy\"; did you mean "
            "\"total_energy\"?");
    refused(small_study(R"({"metrics": {"loss": {"type": "history", "value": "force_flor_y"}}})"),
            "did you mean \"force_floor_y\"");
    refused(small_study(R"({"metrics": {"loss": {"type": "history", "value": "2*(t"}}})"), "/metrics/loss/value: ");
    refused(small_study(R"({"combine": []})"), "no variants");
    refused(small_study(R"({"base": {"bodies": null}})"), "study.json: /base: /bodies: ");
    refused(small_study(R"({"axes": {"CFL": {"values": [0.4, "fast"]}}, "metrics": {"drop": null}})"),
            "variant \"fast, FLIP\" and another one: /time/cfl: ");
    // What only shows once the particles are there.
    refused(small_study(R"({"axes": {"CFL": {"pointer": "/bodies/1/disk/radius", "values": ["2.5 mm", "9 mm"]}},
                            "metrics": {"drop": null}})"),
            "variant \"9 mm, FLIP\"");
    refused(small_study(), "--shard 3/2", {"-o", "s", "--shard", "3/2"});
    refused(small_study(), "not that of a study", {"-o", "taken"});
    refused(small_study(), "--merge nowhere: not the folder of a study", {"-o", "s", "--merge", "nowhere"});
    EXPECT_EQ(folder.read("taken/file.txt"), "mine");
    const Outcome missing = folder.abut({"study", "nowhere.json"});
    EXPECT_EQ(missing.exit_code, 2);
    EXPECT_THAT(missing.err, HasSubstr("nowhere.json: cannot read the study file: No such file"));
}

TEST(Study, ListsWhatItWouldRun) {
    const Folder folder;
    folder.write("study.json", small_study().dump());
    const Outcome outcome = folder.abut({"study", "study.json", "--list"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_THAT(outcome.out, HasSubstr("CFL 0.2, XPIC 2"));
    EXPECT_THAT(outcome.out, HasSubstr("4 variants, 1 repeats each"));
    EXPECT_FALSE(std::filesystem::exists(folder / "study-results"));
}

} // namespace
} // namespace abut::app_test
