/// Study files: what is read, and what is said of bad ones.
#include "study_support.h"

#include "io/study/specification_study.h"

namespace abut::study_test {
namespace {

TEST(StudyRead, ReadsAll) {
    const Folder folder;
    const Study study = read_study(folder.write("study.json", study_json().dump()));
    EXPECT_EQ(study.title, "A falling block");
    EXPECT_EQ(study.repeats, 2);
    EXPECT_EQ(study.threads, 1);
    ASSERT_EQ(study.axes.size(), 3U);
    EXPECT_EQ(study.axes[0].name, "cell");
    EXPECT_EQ(study.axes[0].center, 1U);
    ASSERT_TRUE(study.axes[0].size);
    EXPECT_EQ(study.axes[0].size->pointer, "/grid/cell");
    ASSERT_EQ(study.axes[0].levels.size(), 3U);
    EXPECT_EQ(study.axes[0].levels[2].name, "0.5 mm");
    EXPECT_FALSE(study.axes[1].size);
    EXPECT_EQ(study.axes[1].levels[1].name, "FMPM 4");
    EXPECT_EQ(study.axes[1].levels[1].settings[0].pointer, "/method/transfer/order");
    EXPECT_EQ(study.axes[2].levels[0].name, "0.4");
    ASSERT_EQ(study.metrics.size(), 2U);
    EXPECT_EQ(study.metrics[0].type, MetricType::energy_loss);
    EXPECT_EQ(study.metrics[0].tolerance, 0.01);
    EXPECT_EQ(study.metrics[1].reduce, Reduction::rms);
    EXPECT_EQ(study.metrics[1].exact, std::vector<std::string>{"first_block.y - v*t - g*t^2/2"});
}

TEST(StudyRead, ATextIsAHistoryMetric) {
    const Folder folder;
    const Study study = read_study(folder.write("study.json", patched(R"({"metrics": {"energy": "total_energy"}})")));
    ASSERT_EQ(study.metrics.size(), 3U);
    EXPECT_EQ(study.metrics[2].type, MetricType::history);
    EXPECT_EQ(study.metrics[2].value, std::vector<std::string>{"total_energy"});
    EXPECT_EQ(study.metrics[2].reduce, Reduction::end);
}

struct Bad {
    const char* patch;
    const char* pointer;
    const char* message;
};

TEST(StudyRead, SaysWhatIsWrong) {
    const std::vector<Bad> all{
        {R"({"base": null})", "/base", "required"},
        {R"({"base": "nowhere.json"})", "/base", "nowhere.json: No such file"},
        {R"({"base": 3})", "/base", "a path of a scene"},
        {R"({"axes": null})", "/axes", "required"},
        {R"({"axes": {"cell": null, "transfer": null, "cfl": null}})", "/axes", "nothing varies"},
        {R"({"axes": {"cell": {"values": []}}})", "/axes/cell/values", "at least 1"},
        {R"({"axes": {"cell": {"values": ["1 mm", "1 mm"]}}})", "/axes/cell", "is there twice"},
        {R"({"axes": {"cell": {"pointer": null}}})", "/axes/cell", "\"pointer\", which is missing"},
        {R"({"axes": {"cell": {"pointer": "/grid/cel"}}})", "/axes/cell/pointer", "did you mean \"/grid/cell\""},
        {R"({"axes": {"cell": {"pointer": "grid"}}})", "/axes/cell/pointer", "no JSON pointer"},
        {R"({"axes": {"cell": {"threads": [1]}}})", "/axes/cell", "exactly one of"},
        {R"({"axes": {"cell": {"center": "3 mm"}}})", "/axes/cell/center", "no level \"3 mm\""},
        {R"({"axes": {"transfer": {"variants": {"FLIP": {"/method/transfr": 1}}}}})",
         "/axes/transfer/variants/FLIP/~1method~1transfr", "did you mean \"/method/transfer\""},
        {R"({"axes": {"transfer": {"size": "/method/nothing"}}})", "/axes/transfer/size", "has no \"/method/nothing\""},
        {R"({"set": {"/time/edn": 1}})", "/set/~1time~1edn", "did you mean \"/time/end\""},
        {R"({"end": "3 mm"})", "/end", "a time"},
        {R"({"combine": "produkt"})", "/combine", "did you mean \"product\""},
        {R"({"combine": []})", "/combine", "no variants"},
        {R"({"combine": [{"cel": "1 mm"}]})", "/combine/0/cel", "did you mean \"cell\""},
        {R"({"combine": [{"cell": ["1 mm", "7 mm"]}]})", "/combine/0/cell/1", "no level \"7 mm\""},
        {R"({"except": [{}]})", "/except", "all are excepted"},
        {R"({"metrics": null})", "/metrics", "required"},
        {R"({"metrics": {"loss": {"type": "energy-los"}}})", "/metrics/loss/type", "did you mean \"energy-loss\""},
        {R"({"metrics": {"loss": {"value": "3"}}})", "/metrics/loss/value", "only goes with \"type\""},
        {R"({"metrics": {"height": {"exact": ["1", "2"]}}})", "/metrics/height/exact", "2 expressions for 1"},
        {R"({"metrics": {"height": {"reference": {"cell": "1 mm"}}}})", "/metrics/height", "at most one of"},
        {R"({"metrics": {"height": {"exact": null, "relative": true}}})", "/metrics/height/relative", "to what?"},
        {R"({"metrics": {"height": {"exact": null, "reference": {"transfer": "finest"}}}})",
         "/metrics/height/reference/transfer", "has no sizes"},
        {R"({"metrics": {"height": {"exact": null, "results": "nowhere"}}})", "/metrics/height/results", "history.csv"},
        {R"({"metrics": {"height": {"from": 2, "to": 1}}})", "/metrics/height/to", "later than"},
        {R"({"metrics": {"height": {"at": 1}}})", "/metrics/height/at", "one time"},
        {R"({"metrics": {"c": {"type": "convergence", "of": "hight", "axis": "cell"}}})", "/metrics/c/of",
         "did you mean \"height\""},
        {R"({"metrics": {"c": {"type": "convergence", "of": "loss", "axis": "transfer"}}})", "/metrics/c/axis",
         "has no sizes"},
        {R"({"metrics": {"c": {"type": "convergence", "of": "loss", "axis": "cfl"}}})", "/metrics/c/axis", "2 levels"},
        {R"({"metrics": {"cell": "total_energy"}})", "/metrics/cell", "an axis, too"},
        {R"({"metrics": {"status": "total_energy"}})", "/metrics/status", "another name"},
        {R"({"tolerances": {"lss": 1}})", "/tolerances/lss", "did you mean \"loss\""},
        {R"({"tolerances": {"loss": -1}})", "/tolerances/loss", "greater than 0"},
        {R"({"parameters": {"a b": 1}})", "/parameters/a b", "write a_b"},
        {R"({"parameters": {"h": "/grid/cll"}})", "/parameters/h", "did you mean \"cell\""},
        {R"({"parameters": {"twice": "2*hh"}})", "/parameters/twice", "unknown name \"hh\""},
        {R"({"axes": {"cell": {"pointer": null, "values": null, "center": null, "threads": [1, 0.5]}}})",
         "/axes/cell/threads/1", "whole number"},
        {R"({"metrics": {"loss": {"type": 3}}})", "/metrics/loss/type", "is needed"},
        {R"({"axes": {"cell": 3}})", "/axes/cell", "an object"},
        {R"({"axes": {"cell": {"pointer": 3}}})", "/axes/cell/pointer", "a text"},
        {R"({"metrics": {"height": {"value": [3, {}]}}})", "/metrics/height/value", "an expression as a text"},
        {R"({"except": [3]})", "/except/0", "an object"},
        {R"({"combine": [3]})", "/combine/0", "an object"},
        {R"({"metrics": {"p": {"type": "particles", "value": "x", "frames": "max", "at": 0}}})", "/metrics/p/at",
         "one time"},
        {R"({"repeats": 0})", "/repeats", "between 1 and 1000"},
        {R"({"repaets": 3})", "/repaets", "did you mean \"repeats\""},
        {R"({"time_limit": "3 m"})", "/time_limit", "a time"},
    };
    for (const Bad& bad : all) {
        const std::string said = complaint(patched(bad.patch));
        EXPECT_THAT(said, HasSubstr("study.json: "));
        EXPECT_THAT(said, HasSubstr(bad.pointer)) << bad.patch;
        EXPECT_THAT(said, HasSubstr(bad.message)) << bad.patch;
    }
    EXPECT_EQ(complaint(study_json().dump()), "");
    EXPECT_THAT(complaint("{ \"base\": "), HasSubstr("study.json"));
}

TEST(StudyRead, TheReferenceIsUpToDate) {
    std::ifstream file(ABUT_SOURCE_DIR "/io/study/REFERENCE.md");
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    EXPECT_EQ(text, study_reference()) << "run: abut reference --study > io/study/REFERENCE.md";
    for (const char* type : {"history", "symmetry-error"}) EXPECT_THAT(text, HasSubstr(type));
}

TEST(StudyRead, TellsProblemsOfTheSceneOnce) {
    EXPECT_THAT(complaint(patched(R"({"base": {"bodies": [{"name": "block", "material": "ruber",
                            "box": {"lower": ["4 mm", "4 mm"], "upper": ["6 mm", "6 mm"]}}]}})")),
                testing::AllOf(HasSubstr("study.json: /base: /bodies/0/material: no material \"ruber\"; did you mean"),
                               testing::Not(HasSubstr("variant"))));
    // Only some variants are wrong.
    const std::string said = complaint(patched(R"({"axes": {"cfl": {"values": [0.4, 7]}}})"));
    EXPECT_THAT(said, HasSubstr("variant \"2 mm, FLIP, cfl 7\" and 5 others: /time/cfl: "));
    EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 0) << said;
}

} // namespace
} // namespace abut::study_test
