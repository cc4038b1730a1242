/// `abut contact` on results of all kinds of scenes; what scenes may ask for with output.contact_clouds.
#include "app_support.h"

namespace abut::app_test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

TEST(ContactCommandOn, ResultsThatCannotTell) {
    const Folder folder;
    const auto outcome_of = [&](const std::string& patch) {
        folder.write("s.json", small_scene({patch, R"({"time": {"end": "10 us"}, "output": {"every": 0}})"}).dump());
        const Outcome run = folder.abut({"run", "s.json", "-o", "r", "--overwrite"});
        EXPECT_EQ(run.exit_code, 0) << run.err;
        return folder.abut({"contact", "r"});
    };
    const auto expect_error = [&](const std::string& patch, const std::string& message) {
        const Outcome outcome = outcome_of(patch);
        EXPECT_EQ(outcome.exit_code, 2) << message;
        EXPECT_THAT(outcome.err, HasSubstr(message));
    };
    expect_error(R"({"contact": null})", "the scene has no \"contact\"");
    expect_error(R"({"contact": {"law": {"type": "perfect", "coefficient": null}}})", "perfect");
    expect_error(R"({"output": {"particles": false}})", ": no particles.pvd");
}

/// Particles in single precision tell less than the run knew when it recorded.
TEST(ContactCommandOn, SinglePrecisionLeavesWhatWasRecorded) {
    const Folder folder;
    folder.write("s.json", small_scene({R"({"output": {"precision": "single",
                                                       "contact_clouds": {"near": [["6 mm", "4 mm"]]}}})"})
                               .dump());
    ASSERT_EQ(folder.abut({"run", "s.json", "-o", "r"}).exit_code, 0);
    const std::string recorded = folder.read("r/clouds/node_00004_6_4.csv");
    const Outcome refused = folder.abut({"contact", "r", "--near", "6mm,4mm"});
    EXPECT_EQ(refused.exit_code, 2);
    EXPECT_EQ(refused.out, "");
    EXPECT_THAT(refused.err, AllOf(HasSubstr("single precision"), HasSubstr("-o")));
    EXPECT_EQ(folder.read("r/clouds/node_00004_6_4.csv"), recorded);
    EXPECT_EQ(folder.abut({"contact", "r"}).exit_code, 0);
    EXPECT_EQ(folder.abut({"contact", "r", "--near", "6mm,4mm", "-o", "other"}).exit_code, 0);
    EXPECT_NE(folder.read("other/node_00004_6_4.csv"), recorded);
}

TEST(ContactCommandOn, SceneWithoutSeparations) {
    const Folder folder;
    folder.write("s.json", small_scene({R"({"contact": {"separation": "none"}})"}).dump());
    ASSERT_EQ(folder.abut({"run", "s.json", "-o", "r"}).exit_code, 0);
    const Outcome list = folder.abut({"contact", "r"});
    EXPECT_EQ(list.exit_code, 0) << list.err;
    EXPECT_THAT(list.out, AllOf(HasSubstr(" contact nodes, all taken as in contact (separation \"none\")"),
                                HasSubstr("block / ball"), Not(HasSubstr("nearer")), Not(HasSubstr("inf"))));
}

/// All places are in the unit of the grid, here 12 mm wide, those near its origin too.
TEST(ContactCommandOn, PlacesNearTheOrigin) {
    const Folder folder;
    folder.write("s.json", small_scene({R"({"grid": {"lower": ["-6 mm", "-6 mm"], "upper": ["6 mm", "6 mm"]},
        "bodies": [
        {"name": "a", "material": "rubber", "box": {"lower": ["-0.5 mm", "-1 mm"], "upper": ["0.5 mm", 0]}},
        {"name": "b", "material": "rubber", "box": {"lower": [0, 0], "upper": ["1 mm", "1 mm"]}}],
        "boundaries": [], "time": {"end": "1 us"}, "output": {"every": 0}})"})
                               .dump());
    ASSERT_EQ(folder.abut({"run", "s.json", "-o", "r"}).exit_code, 0);
    const std::string list = folder.abut({"contact", "r"}).out;
    EXPECT_THAT(list, HasSubstr("  6,6          0.0000, 0.0000 mm "));
    std::size_t rows = 0;
    for (const std::string& line : lines(list))
        if (line.find("a / b") != std::string::npos) {
            EXPECT_THAT(line, HasSubstr(" mm "));
            ++rows;
        }
    EXPECT_GT(rows, 1U);
    EXPECT_THAT(folder.abut({"contact", "r", "--near", "0,0", "-o", "x"}).out,
                HasSubstr("node 6,6 at 0.0000, 0.0000 mm"));
}

TEST(ContactCommandOn, BodiesFarApart) {
    const Folder folder;
    folder.write("s.json", small_scene({R"({"bodies": [
        {"name": "a", "material": "rubber", "box": {"lower": [0, 0], "upper": ["2 mm", "2 mm"]}},
        {"name": "b", "material": "rubber", "box": {"lower": ["8 mm", "8 mm"], "upper": ["10 mm", "10 mm"]}}],
        "time": {"end": "10 us"}, "output": {"every": 0}})"})
                               .dump());
    ASSERT_EQ(folder.abut({"run", "s.json", "-o", "r"}).exit_code, 0);
    const Outcome list = folder.abut({"contact", "r"});
    EXPECT_EQ(list.exit_code, 0);
    EXPECT_THAT(list.out, HasSubstr("0 contact nodes"));
    const Outcome node = folder.abut({"contact", "r", "--near", "0,0"});
    EXPECT_EQ(node.exit_code, 2);
    EXPECT_THAT(node.err, HasSubstr("no node of frame 1 sees two bodies"));
}

TEST(ContactCloudsOfAScene, AreValidated) {
    const Folder folder;
    const auto error_of = [&](const std::string& patch) {
        folder.write("s.json", small_scene({patch}).dump());
        const Outcome outcome = folder.abut({"check", "s.json"});
        EXPECT_EQ(outcome.exit_code, 2) << patch;
        return outcome.err;
    };
    const auto clouds = [](const std::string& text) { return R"({"output": {"contact_clouds": )" + text + "}}"; };
    EXPECT_THAT(error_of(clouds("{}")), HasSubstr("/output/contact_clouds: names no nodes"));
    EXPECT_THAT(error_of(clouds(R"({"nodes": [[3, 13]]})")),
                HasSubstr("/output/contact_clouds/nodes/0/1: outside the grid, whose nodes along y are 0 to 12"));
    EXPECT_THAT(error_of(clouds(R"({"nodes": [[3, 3], [3, 3, 3]]})")),
                HasSubstr("/output/contact_clouds/nodes/1: must have 2 numbers in a plane scene"));
    EXPECT_THAT(error_of(clouds(R"({"nodes": [[-1, 3]]})")), HasSubstr("/output/contact_clouds/nodes/0/0"));
    EXPECT_THAT(error_of(clouds(R"({"nodes": [[99999999999, 3]]})")), HasSubstr("/output/contact_clouds/nodes/0/0"));
    EXPECT_THAT(error_of(clouds(R"({"nodes": [7, "x"]})")),
                AllOf(HasSubstr("/output/contact_clouds/nodes/0"), HasSubstr("/output/contact_clouds/nodes/1")));
    EXPECT_THAT(error_of(clouds(R"({"near": [["3 mm"]]})")), HasSubstr("/output/contact_clouds/near/0"));
    EXPECT_THAT(error_of(clouds(R"({"disagreement": "3 mm"})")), HasSubstr("an angle"));
    EXPECT_THAT(error_of(R"({"contact": null, "output": {"contact_clouds": {"disagreement": "5 deg"}}})"),
                HasSubstr("/output/contact_clouds: the scene has no \"contact\""));
    EXPECT_THAT(error_of(R"({"output": {"contact": false, "contact_clouds": {"disagreement": "5 deg"}}})"),
                HasSubstr("/output/contact_clouds: is written with the frames of contact pairs"));
    EXPECT_THAT(error_of(R"({"contact": {"law": {"type": "perfect", "coefficient": null}},
                             "output": {"contact_clouds": {"disagreement": "5 deg"}}})"),
                HasSubstr("/output/contact_clouds: all interfaces are perfect"));
    folder.write("s.json", small_scene({clouds(R"({"nodes": [[12, 12], [0, 0]]})")}).dump());
    EXPECT_EQ(folder.abut({"check", "s.json"}).exit_code, 0);
}

} // namespace
} // namespace abut::app_test
