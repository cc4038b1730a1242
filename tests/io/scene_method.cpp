/// The numerical method: words, what goes together, advice.
#include "scene_support.h"

#include "scene/validate.h"

namespace abut::scene_test {
namespace {

MethodSpec method(const std::string& json) {
    return load(changed("/method", json)).scene.method;
}

TEST(SceneMethod, Words) {
    const std::vector<std::pair<std::string, ShapeKind>> shapes{
        {"linear", ShapeKind::linear}, {"ugimp", ShapeKind::ugimp},       {"gimp", ShapeKind::gimp},
        {"cpdi", ShapeKind::cpdi},     {"b2spline", ShapeKind::b2spline}, {"b2gimp", ShapeKind::b2gimp},
        {"b2cpdi", ShapeKind::b2cpdi}};
    for (const auto& [word, shape] : shapes) EXPECT_EQ(method(R"({"shape": ")" + word + "\"}").shape, shape) << word;
    const std::vector<std::pair<std::string, StressUpdate>> updates{{"usf", StressUpdate::usf},
                                                                    {"usavg", StressUpdate::usavg},
                                                                    {"usl", StressUpdate::usl},
                                                                    {"usl+", StressUpdate::usl_plus},
                                                                    {"usavg+", StressUpdate::usavg_plus}};
    for (const auto& [word, update] : updates)
        EXPECT_EQ(method(R"({"stress_update": ")" + word + "\"}").stress_update, update) << word;
    EXPECT_EQ(method("{}").deformation_increment, DeformationIncrement::exponential);
    EXPECT_EQ(method(R"({"deformation_increment": "linear"})").deformation_increment, DeformationIncrement::linear);
    EXPECT_EQ(method(R"({"deformation_increment": "exponential"})").deformation_increment,
              DeformationIncrement::exponential);
}

TEST(SceneMethod, Transfer) {
    const MethodSpec fmpm = load(example_3d).scene.method;
    EXPECT_EQ(fmpm.transfer.scheme, TransferScheme::fmpm);
    EXPECT_EQ(fmpm.transfer.order, 4);
    EXPECT_EQ(fmpm.transfer.every_cfl, 0.6);
    EXPECT_EQ(fmpm.transfer.position, PositionUpdate::mean_velocity);
    EXPECT_EQ(fmpm.velocity_conditions, VelocityConditions::lumped);

    const MethodSpec pic = method(R"({"transfer": {"scheme": "pic", "position": "start-velocity"}})");
    EXPECT_EQ(pic.transfer.position, PositionUpdate::start_velocity);
    EXPECT_EQ(pic.velocity_conditions, VelocityConditions::combined);
    // No default: what is not given depends on the scheme.
    EXPECT_FALSE(method(R"({"transfer": {"scheme": "fmpm"}})").transfer.position);
    EXPECT_FALSE(method("{}").transfer.position);
    EXPECT_FALSE(method("{}").transfer.every_cfl);
}

TEST(SceneMethod, WhatGoesTogether) {
    const std::string at = "/method/transfer";
    expect_problems({
        {at, R"({"scheme": "fmpm", "position": "start-velocity"})", at + "/position", "does not go with \"fmpm\""},
        {at, R"({"scheme": "xpic", "position": "mean-velocity"})", at + "/position", "does not go with \"xpic\""},
        {at, R"({"scheme": "flip", "position": "mean-velocity"})", at + "/position", "\"flip\" has its own rule"},
        {at, R"({"scheme": "flip", "position": "start-velocity"})", at + "/position", "only \"end-velocity\""},
        {at, R"({"scheme": "pic", "order": 3})", at + "/order", "here it is \"pic\""},
        {"/method/velocity_conditions", R"("lumped")", "/method/velocity_conditions", "\"fmpm\" only"},
    });
    const std::vector<std::string> good{
        R"({"scheme": "flip", "position": "end-velocity"})", R"({"scheme": "fmpm", "position": "end-velocity"})",
        R"({"scheme": "pic", "position": "mean-velocity"})", R"({"scheme": "xpic", "position": "start-velocity"})",
        R"({"scheme": "fmpm", "every_cfl": 0.4})"};
    for (const std::string& transfer : good)
        EXPECT_THAT(problems_of(changed(at, transfer)), testing::IsEmpty()) << transfer;
}

std::vector<Problem> advice_on(const std::string& method, const std::string& wall) {
    return advice(load(changed("/boundaries/1/wall", wall, changed("/method", method, changed("/contact", "")))).scene);
}

/// growth = exp(½ ω² Δt T) − 1
TEST(SceneMethod, AdviceForBodiesThatSpin) {
    const auto spinning = [](const std::string& spin, const std::string& method) {
        return advice(
            load(changed("/bodies/1/angular_velocity", spin, changed("/method", method, changed("/contact", ""))))
                .scene);
    };
    EXPECT_THAT(spinning("0", "{}"), testing::IsEmpty());
    EXPECT_THAT(spinning("1e5", "{}"), testing::IsEmpty());
    const auto fast = spinning("-1e7", "{}");
    EXPECT_THAT(fast, testing::ElementsAre(IsProblem("/method", "\"ball\" spins by ")));
    EXPECT_THAT(fast, testing::ElementsAre(IsProblem("/method", "24 turns in all")));
    EXPECT_THAT(spinning("1e7", R"({"deformation_increment": "linear"})"),
                testing::ElementsAre(IsProblem("/method", "use \"position\": \"end-velocity\" in")));
    EXPECT_THAT(spinning("1e7", R"({"deformation_increment": "linear", "transfer": {"position": "end-velocity"}})"),
                testing::IsEmpty());
    EXPECT_THAT(spinning("1e7", R"({"transfer": {"scheme": "xpic", "order": 2}})"),
                testing::ElementsAre(IsProblem("/method", "use \"deformation_increment\": \"linear\", or smaller")));
}

TEST(SceneMethod, Advice) {
    using testing::ElementsAre;
    using testing::IsEmpty;
    const auto wall = [](const std::string& velocity, const std::string& depth, const std::string& grip) {
        return R"({"axis": "y", "side": "upper", "position": "1.9 mm", "velocity": )" + velocity + R"(, "depth": )" +
               depth + R"(, "grip": )" + grip + "}";
    };
    const std::string pull = wall("1", "1", "true");
    EXPECT_THAT(advice_on("{}", pull), IsEmpty());
    EXPECT_THAT(advice_on(R"({"shape": "linear"})", pull), ElementsAre(IsProblem("/method/shape", "unstable")));

    const std::string splines = R"({"shape": "b2cpdi"})";
    EXPECT_THAT(advice_on(splines, pull), ElementsAre(IsProblem("/boundaries/1/wall/depth", "use depth 1.5")));
    EXPECT_THAT(advice_on(splines, wall("-1", "1.5", "true")), IsEmpty());
    EXPECT_THAT(advice_on(splines, wall("0", "1", "true")), IsEmpty());

    EXPECT_THAT(advice_on(R"({"shape": "linear", "stress_update": "usf",
                              "transfer": {"scheme": "fmpm", "order": 2}})",
                          pull),
                ElementsAre(IsProblem("/method/transfer/scheme", "don't go together")));
    EXPECT_THAT(advice_on(R"({"shape": "cpdi", "transfer": {"scheme": "fmpm", "order": 16}})", pull), IsEmpty());
}

} // namespace
} // namespace abut::scene_test
