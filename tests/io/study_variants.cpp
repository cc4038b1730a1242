/// Which runs a study has.
#include "study_support.h"

#include <algorithm>
#include <set>

namespace abut::study_test {
namespace {

std::vector<Variant> variants_of(const std::string& text) {
    const Folder folder;
    return make_variants(read_study(folder.write("study.json", text)));
}

std::vector<std::string> names_of(const std::string& patch) {
    std::vector<std::string> names;
    for (const Variant& variant : variants_of(patched(patch))) names.push_back(variant.name);
    return names;
}

using Names = std::vector<std::string>;

TEST(StudyVariants, ProductRunsTheLastAxisFastest) {
    const Names names = names_of("{}");
    ASSERT_EQ(names.size(), 12U);
    EXPECT_EQ(names[0], "2 mm, FLIP, cfl 0.4");
    EXPECT_EQ(names[1], "2 mm, FLIP, cfl 0.2");
    EXPECT_EQ(names[2], "2 mm, FMPM 4, cfl 0.4");
    EXPECT_EQ(names[11], "0.5 mm, FMPM 4, cfl 0.2");
    EXPECT_EQ(std::set<std::string>(names.begin(), names.end()).size(), 12U);
}

TEST(StudyVariants, OneAtATimeVariesAroundTheCenters) {
    EXPECT_EQ(names_of(R"({"combine": "one-at-a-time"})"),
              (Names{"1 mm, FLIP, cfl 0.4", "2 mm, FLIP, cfl 0.4", "0.5 mm, FLIP, cfl 0.4", "1 mm, FMPM 4, cfl 0.4",
                     "1 mm, FLIP, cfl 0.2"}));
}

TEST(StudyVariants, ChosenOnes) {
    EXPECT_EQ(names_of(R"({"combine": [{"cell": "*", "cfl": 0.2}, {"transfer": ["FLIP", "FMPM 4"], "cfl": "0.2"}]
})"),
              (Names{"2 mm, FLIP, cfl 0.2", "1 mm, FLIP, cfl 0.2", "0.5 mm, FLIP, cfl 0.2", "1 mm, FMPM 4, cfl 0.2"}));
}

TEST(StudyVariants, Exceptions) {
    const Names names = names_of(R"({"except": [{"cell": ["2 mm", "1 mm"], "transfer": "FLIP"}, {"cfl": 0.4}]})");
    EXPECT_EQ(names, (Names{"2 mm, FMPM 4, cfl 0.2", "1 mm, FMPM 4, cfl 0.2", "0.5 mm, FLIP, cfl 0.2",
                            "0.5 mm, FMPM 4, cfl 0.2"}));
}

TEST(StudyVariants, SetWhatTheStudySays) {
    const std::vector<Variant> variants = variants_of(
        patched(R"({"end": "50 us", "set": {"/bodies/0/velocity": [0, "-2 m/s"]}, "combine": [{"cell": "0.5 mm",
                    "transfer": "FMPM 4", "cfl": 0.2}]
})"));
    ASSERT_EQ(variants.size(), 1U);
    const Scene& scene = variants[0].scene.scene;
    EXPECT_EQ(scene.time.end, 50e-6);
    EXPECT_EQ(scene.time.cfl, 0.2);
    EXPECT_EQ(scene.grid.cell[0], 0.5e-3);
    EXPECT_EQ(scene.bodies[0].velocity.value[1], -2);
    EXPECT_EQ(scene.method.transfer.order, 4);
    EXPECT_EQ(scene.method.transfer.scheme, TransferScheme::fmpm);
    ASSERT_EQ(variants[0].sizes.size(), 3U);
    EXPECT_EQ(variants[0].sizes[0], 0.5e-3);
    EXPECT_EQ(variants[0].sizes[1], std::nullopt);
    EXPECT_EQ(variants[0].sizes[2], 0.2);
    ASSERT_EQ(variants[0].parameters.size(), 4U);
    EXPECT_EQ(variants[0].parameters[0].value, 1);
    EXPECT_EQ(variants[0].parameters[2].value, 0.5e-3);
    EXPECT_EQ(variants[0].parameters[3].value, 1e-3);
}

TEST(StudyVariants, WriteWhatTheMetricsNeed) {
    const auto output = [](const std::string& patch) { return variants_of(patched(patch))[0].scene.scene.output; };
    const std::string rows = R"("base": {"output": {"every": "10 us"}})";
    const OutputSpec plain = output("{" + rows + "}");
    EXPECT_EQ(plain.every, 0);
    EXPECT_DOUBLE_EQ(plain.history_every.value_or(0),
                     1e-7); // a hundredth of what the scene has, as a run of it would have
    EXPECT_FALSE(plain.grid.write);
    EXPECT_FALSE(plain.checkpoint);
    EXPECT_FALSE(plain.pairs);
    EXPECT_TRUE(plain.particles.write);
    EXPECT_EQ(output(R"({"base": {"output": {"every": "10 us", "history_every": "3 us"}}})").history_every, 3e-6);
    const std::string symmetry = R"("metrics": {"s": {"type": "symmetry-error", "mirror": "x"}})";
    EXPECT_EQ(output("{" + rows + "," + symmetry + "}").every, 10e-6);
    EXPECT_TRUE(output(R"({"set": {"/output/grid": true}})").grid.write);
}

TEST(StudyVariants, KeysTellWhatARunDependsOn) {
    const auto keys = [](const std::string& patch) {
        std::set<std::string> result;
        for (const Variant& variant : variants_of(patched(patch))) result.insert(variant.key);
        return result;
    };
    EXPECT_EQ(keys("{}").size(), 12U);
    EXPECT_EQ(keys("{}"), keys(R"({"repeats": 7, "title": "Another", "tolerances": {"loss": 0.5}})"));
    EXPECT_NE(keys("{}"), keys(R"({"threads": 2})"));
    EXPECT_NE(keys("{}"), keys(R"({"end": "99 us"})"));
    // Files count by what is in them, not by where they lie.
    const auto key_with_outline = [](const std::string& points) {
        const Folder folder;
        folder.write("outline.csv", points);
        Json study = study_json();
        study["base"]["bodies"][0].erase("box");
        study["base"]["bodies"][0]["path"] = Json::parse(R"({"file": "outline.csv", "scale": "1 mm"})");
        return make_variants(read_study(folder.write("study.json", study.dump())))[0].key;
    };
    EXPECT_EQ(key_with_outline("4,4\n6,4\n6,6\n"), key_with_outline("4,4\n6,4\n6,6\n"));
    EXPECT_NE(key_with_outline("4,4\n6,4\n6,6\n"), key_with_outline("4,4\n6,4\n6,7\n"));
}

TEST(StudyVariants, FoldersDiffer) {
    Json study = study_json();
    study["axes"] = Json::parse(R"({"long": {"variants": {}}})");
    for (const char* name : {"a/b", "a:b", "A:B", "..", "", "ä"})
        study["axes"]["long"]["variants"][name] = Json::object();
    study["axes"]["long"]["variants"][std::string(300, 'x')] = Json::object();
    study["axes"]["long"]["variants"][std::string(299, 'x') + "y"] = Json::object();
    study["metrics"] = Json::parse(R"({"loss": {"type": "energy-loss"}})");
    std::set<std::string> folders;
    for (const Variant& variant : variants_of(study.dump())) {
        folders.insert(variant.folder);
        EXPECT_LT(variant.folder.size(), 130U);
        EXPECT_EQ(variant.folder.find('/'), std::string::npos);
        EXPECT_NE(variant.folder[0], '.');
    }
    EXPECT_EQ(folders.size(), 8U);
}

} // namespace
} // namespace abut::study_test
