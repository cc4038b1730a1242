/// Boundary conditions and functions of time.
#include "scene_support.h"

namespace abut::scene_test {
namespace {

using testing::ElementsAre;

template <class Spec>
Spec boundary(std::size_t index, const std::string& text = example_3d) {
    return std::get<Spec>(load(text).scene.boundaries.at(index).condition);
}

TEST(SceneBoundaries, Walls) {
    const auto lid = boundary<WallSpec>(0);
    EXPECT_EQ(lid.axis, 2);
    EXPECT_TRUE(lid.estimated_gradient);
    EXPECT_EQ(lid.velocity.time, (std::vector{0.0, 2e-3, 5e-3}));
    EXPECT_EQ(lid.velocity.value, (std::vector{0.0, -1e-3, 0.0}));
    const auto mantle = boundary<WallSpec>(0, example_axisymmetric);
    EXPECT_FALSE(mantle.estimated_gradient);
    EXPECT_EQ(mantle.gradient.time, TimeFunction::pulse(1e-6, 2e-6, 5).time);
    EXPECT_EQ(mantle.gradient.value, (std::vector{0.0, 5.0, 0.0}));
    EXPECT_EQ(mantle.velocity.value, (std::vector{0.0}));
}

TEST(SceneBoundaries, Velocities) {
    const auto pin = boundary<VelocitySpec>(1);
    EXPECT_EQ(pin.lower, (Vector{0, 0, 0}));
    EXPECT_EQ(pin.upper, (Vector{1e-2, 0, 0}));
    EXPECT_EQ(pin.direction, (Vector{1, 0, -2}));
    EXPECT_EQ(pin.velocity.at(7), 2e-3);
    EXPECT_TRUE(boundary<VelocitySpec>(1, changed("/boundaries/1/velocity/value", "", example_3d)).velocity.is_zero());
}

TEST(SceneBoundaries, Tractions) {
    const auto load = boundary<TractionSpec>(2);
    EXPECT_EQ(load.body, "brick");
    EXPECT_EQ(load.axis, 0);
    EXPECT_EQ(load.side, Side::upper);
    ASSERT_TRUE(load.within);
    EXPECT_EQ(load.within->upper, (Vector{0.05, 0.06, 0.02}));
    EXPECT_TRUE(load.traction[0].is_zero());
    EXPECT_EQ(load.traction[1].at(2e-3), 1e4);
    EXPECT_EQ(load.traction[1].at(1), 0);
    EXPECT_EQ(load.traction[2].at(0), -2e3);
    EXPECT_TRUE(load.pressure.is_zero());
    const auto push = boundary<TractionSpec>(3);
    EXPECT_FALSE(push.within);
    EXPECT_EQ(push.pressure.at(0.5), 500);
    EXPECT_TRUE(push.traction[0].is_zero());
}

TEST(SceneBoundaries, ResolvedFunctionsOfTime) {
    const Json boundaries = parsed(load(example_3d).resolved)["boundaries"];
    EXPECT_EQ(boundaries[0]["wall"]["velocity"],
              parsed(R"({"times": [0.0, 0.002, 0.005], "values": [0.0, -0.001, 0.0]})"));
    EXPECT_EQ(boundaries[0]["wall"]["gradient"], "estimated");
    EXPECT_EQ(boundaries[1]["velocity"]["value"], 2e-3);
    EXPECT_EQ(boundaries[2]["traction"]["stress"][1],
              parsed(R"({"pulse": {"start": 0.0, "width": 0.004, "peak": 10000.0}})"));
}

TEST(SceneBoundaries, FunctionsOfTimeThatAreWrong) {
    const std::string at = "/boundaries/0/wall/velocity";
    expect_problems({
        {at, "[1, 2]", at, "a velocity (a number in m/s or a text with a unit) or a function of time { } is needed"},
        {at, "true", at, "is needed, not true"},
        {at, R"("1 m")", at, "1 m is a length; a velocity (m/s) is needed"},
        {at, "{}", at, "has \"times\" and \"values\", or a \"pulse\"; here is neither"},
        {at, R"({"times": [0, 1]})", at + "/values", "required and missing"},
        {at, R"({"values": [0, 1]})", at + "/times", "required and missing"},
        {at, R"({"times": [0], "values": [0, 1]})", at + "/times", "at least 2 entries are needed, not 1"},
        {at, R"({"times": [0, 1], "values": 3})", at + "/values", "a list [ ] is needed, not 3"},
        {at, R"({"times": [0, 1, 2], "values": [0, 1]})", at, "here are 3 times and 2 values"},
        {at, R"({"times": [0, "1 us", "1 us"], "values": [0, 0, 0]})", at + "/times/2",
         "must be later than the time before, 1e-06 s"},
        {at, R"({"times": [0, "1 m"], "values": [0, 0]})", at + "/times/1", "1 m is a length; a time (s) is needed"},
        {at, R"({"times": [0, 1, 2], "values": [0, 0, "3 s"]})", at + "/values/2", "a velocity (m/s) is needed"},
        {at, R"({"times": [0, 1], "values": [0, 0], "value": 3})", at + "/value", "did you mean \"values\"?"},
        {at, R"({"pulse": 3})", at + "/pulse", "an object { } is needed, not 3"},
        {at, R"({"pulse": {"width": 1}})", at + "/pulse/peak", "required and missing"},
        {at, R"({"pulse": {"peak": 0}})", at + "/pulse/width", "required and missing"},
        {at, R"({"pulse": {"width": 0, "peak": 0}})", at + "/pulse/width", "must be greater than 0 s, not 0"},
        {at, R"({"pulse": {"width": 1, "peak": "3 s"}})", at + "/pulse/peak", "a velocity (m/s) is needed"},
        {at, R"({"pulse": {"width": 1e-20, "peak": 0, "start": 1}})", at + "/pulse", "too small beside the start"},
        {at, R"({"pulse": {"width": 1, "peak": 0, "begin": 1}})", at + "/pulse/begin", "unknown key \"begin\""},
        {at, R"({"pulse": {"width": 1, "peak": 0}, "times": [0, 1]})", at + "/times", "unknown key \"times\""},
        {at, R"("estimated")", at, "a velocity (m/s) is needed"},
    });
    expect_problems({{"/boundaries/2/traction/stress/1/pulse/peak", "\"1 m\"",
                      "/boundaries/2/traction/stress/1/pulse/peak", "a pressure (Pa) is needed"}},
                    example_3d);
}

TEST(SceneBoundaries, MeaningOfVelocities) {
    const std::string at = "/boundaries/1/velocity";
    expect_problems(
        {
            {at + "/upper/1", "-0.01", at + "/upper", "must not lie below \"lower\" along y"},
            {at + "/lower", "[0.4, 0, 0]", at + "/upper", "must not lie below \"lower\" along x"},
            {at + "/direction", "[0, 0, 0]", at + "/direction", "must not be zero"},
        },
        changed(at + "/lower/1", "-0.005", changed(at + "/upper", "[0.3, 0, 0]", example_3d)));
    Json beside = parsed(example_3d);
    beside["boundaries"][1]["velocity"]["lower"] = {0, 0, 0.06};
    beside["boundaries"][1]["velocity"]["upper"] = {0.1, 0.1, 0.07};
    EXPECT_THAT(problems_of(beside.dump()),
                ElementsAre(IsProblem(at, "beside the grid along z: it reaches from 0.06 m to 0.07 m, the grid from "
                                          "-0.05 m to 0.05 m")));
}

TEST(SceneBoundaries, MeaningOfTractions) {
    const std::string at = "/boundaries/2/traction";
    expect_problems({{at + "/body", R"("brik")", at + "/body", "no body \"brik\"; did you mean \"brick\"?"},
                     {at + "/within/upper/0", "-0.01", at + "/within", "beside the grid along x"}},
                    changed(at + "/within/lower/0", "-0.02", example_3d));
    // Bodies of images have faces too; plane scenes have no axis z.
    const std::string plane = changed(
        "/boundaries/2",
        R"({"name": "load", "traction": {"body": "grain-02", "axis": "y", "side": "upper", "stress": [1, 2]}})");
    EXPECT_THAT(problems_of(plane), testing::IsEmpty());
    expect_problems({{at + "/axis", R"("z")", at + "/axis", "plane scenes have the axes x and y"},
                     {at + "/body", R"("grain-2")", at + "/body", "did you mean \"grain-02\"?"}},
                    plane);
    EXPECT_THAT(problems_of(changed("/images", "3", plane)), ElementsAre(IsProblem("/images", "a list [ ] is needed")));
}

TEST(SceneBoundaries, WallsStayInTheGrid) {
    const std::string at = "/boundaries/0/wall/velocity"; // a floor at y = 0 of a grid up to 2 mm; the end is 15 us
    EXPECT_THAT(problems_of(changed(at, R"({"times": [0, "10 us"], "values": ["300 m/s", "-300 m/s"]})")),
                ElementsAre(IsProblem(at, "moves out of the grid at t = 1e-05 s")));
    EXPECT_THAT(problems_of(changed(at, R"({"times": [0, "10 us", "10.1 us"], "values": ["300 m/s", "-300 m/s", 0]})")),
                ElementsAre(IsProblem(at, "moves out of the grid at t = 1e-05 s")));
    EXPECT_THAT(problems_of(changed(at, R"({"times": [0, "10 us", "10.1 us"], "values": ["310 m/s", "-300 m/s", 0]})")),
                testing::IsEmpty());
    // Out and back in again between two points: the velocity changes its sign at 5 us, 2.5 mm up.
    EXPECT_THAT(problems_of(changed(at, R"({"times": [0, "10 us", "20 us"], "values": ["1000 m/s", "-1000 m/s", 0]})")),
                testing::Contains(IsProblem(at, "moves out of the grid at t = 2.76393e-06 s")));
}

} // namespace
} // namespace abut::scene_test
