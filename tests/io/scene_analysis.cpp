/// What the analysis changes: the number of components, and which keys and bodies there are.
#include "scene_support.h"

#include "scene/validate.h"

namespace abut::scene_test {
namespace {

TEST(SceneAnalysis, ThreeDimensions) {
    const Scene scene = load(example_3d).scene;
    EXPECT_EQ(scene.analysis, Analysis::three_d);
    EXPECT_EQ(scene.grid.cell, (Vector{5e-3, 5e-3, 5e-3}));
    EXPECT_EQ(scene.grid.lower, (Vector{0, 0, -0.05}));
    EXPECT_EQ(scene.gravity, (Vector{0, 0, -9.81}));
    EXPECT_EQ(std::get<Box>(scene.bodies[0].shape).upper, (Vector{0.05, 0.06, 0.04}));
    EXPECT_EQ(scene.bodies[0].velocity,
              (InitialVelocity{{0, 0, 1e-3}, {{{0, -2, 0}, {2, 0, 0}, {0, 0, 3}}}, {0.025, 0.03, 0}}));
    EXPECT_EQ(std::get<Ball>(scene.bodies[1].shape).center, (Vector{0.07, 0.07, 0}));
    EXPECT_EQ(std::get<Ball>(scene.bodies[1].shape).radius, 0.02);
    EXPECT_EQ(scene.materials[0].model, MaterialModel::linear_elastic);
    EXPECT_EQ(load(changed("/grid/cell", "[0.01, 0.005, 0.004]", example_3d)).scene.grid.cell,
              (Vector{0.01, 0.005, 0.004}));
}

TEST(SceneAnalysis, ResolvedScenesHaveTheDefaultsOfTheirAnalysis) {
    const Json resolved = parsed(load(changed("/gravity", "", example_3d)).resolved);
    EXPECT_EQ(resolved["gravity"], Json::array({0.0, 0.0, 0.0}));
    EXPECT_EQ(resolved["bodies"][1]["velocity"], Json::array({0.0, 0.0, 0.0}));
    EXPECT_FALSE(resolved["bodies"][1].contains("velocity_center"));
    EXPECT_FALSE(resolved.contains("thickness"));
    EXPECT_EQ(resolved["images"], Json::array());

    const Json ring = parsed(load(example_axisymmetric).resolved);
    EXPECT_FALSE(ring.contains("thickness"));
    EXPECT_EQ(ring["gravity"], Json::array({0.0, 0.0}));
    EXPECT_EQ(ring["bodies"][0]["velocity_center"], Json::array({0.0, 0.0}));
    EXPECT_EQ(parsed(load(changed("/analysis", R"("plane-stress")")).resolved)["thickness"], 1.0);
}

TEST(SceneAnalysis, Components) {
    expect_problems(
        {
            {"/gravity", "[0, -9.81]", "/gravity", "3 components are needed in a 3d scene, not 2"},
            {"/gravity", "-9.81", "/gravity", "a list of 3 components (an acceleration, m/s^2 each) is needed"},
            {"/grid/cell", "[1, 1]", "/grid/cell", "3 components are needed in a 3d scene"},
            {"/bodies/0/velocity_gradient", "[[0, 0], [0, 0]]", "/bodies/0/velocity_gradient",
             "3 rows are needed in a 3d scene, not 2"},
            {"/bodies/0/velocity_gradient/1", "[0, 0]", "/bodies/0/velocity_gradient/1",
             "3 components are needed in a 3d scene, not 2"},
            {"/bodies/0/velocity_gradient/1", "0", "/bodies/0/velocity_gradient/1",
             "a list of 3 components (a rate, 1/s each) is needed, not 0"},
            {"/bodies/0/velocity_gradient/1/0", R"("1 m/s")", "/bodies/0/velocity_gradient/1/0", "a rate (1/s)"},
            {"/boundaries/2/traction/stress", "[0, 0]", "/boundaries/2/traction/stress", "3 components are needed"},
            {"/boundaries/1/velocity/direction", R"(["1", 0, 0])", "/boundaries/1/velocity/direction/0",
             "a number without unit is needed"},
            {"/boundaries/1/velocity/direction", "1", "/boundaries/1/velocity/direction",
             "a list of 3 components (numbers) is needed, not 1"},
        },
        example_3d);
    expect_problems({{"/gravity", "[0, 0, 0]", "/gravity", "2 components are needed in an axisymmetric scene, not 3"}},
                    example_axisymmetric);
}

TEST(SceneAnalysis, WrongWordBringsNothingElse) {
    expect_problems({{"/analysis", R"("3-d")", "/analysis", "unknown word"}}, example_3d);
    expect_problems({{"/analysis", "3", "/analysis", "is needed, not 3"}}, example_3d);
    expect_problems({{"/analysis", R"("axi")", "/analysis", "did you mean \"axisymmetric\"?"}});
    Json scene = parsed(example_3d);
    scene["analysis"] = "3-d";
    scene["gravity"] = Json::array({1});
    EXPECT_THAT(problems_of(scene.dump()),
                testing::UnorderedElementsAre(IsProblem("/analysis", "unknown word"),
                                              IsProblem("/gravity", "2 or 3 components are needed in a scene, not 1")));
}

TEST(SceneAnalysis, KeysOfOneAnalysis) {
    expect_problems(
        {
            {"/thickness", "1", "/thickness",
             "only goes with \"analysis\": \"plane-strain\" or \"plane-stress\"; here it is \"3d\""},
            {"/images",
             R"([{"file": "a_*.png", "lower": [0, 0, 0], "slice": 3, "legend": [{"grey": 0, "void": true}]}])",
             "/images/0/slice", "here it is \"3d\""},
        },
        example_3d);
    expect_problems({{"/thickness", "1", "/thickness", "here it is \"axisymmetric\""}}, example_axisymmetric);

    EXPECT_THAT(problems_of(changed("/bodies/0/box/angle", "0.1", example_3d)), testing::IsEmpty());
    expect_problems({{"/bodies/0/box/axis", "[0, 1]", "/bodies/0/box/axis", "here it is \"plane-strain\""}});

    Json scene = parsed(example_3d);
    scene["bodies"][1].erase("ball");
    scene["bodies"][1]["disk"] = parsed(R"({"center": [0, 0], "radius": 1})");
    EXPECT_THAT(problems_of(scene.dump()),
                testing::ElementsAre(IsProblem("/bodies/1/disk", "only goes with \"analysis\": \"plane-strain\", "
                                                                 "\"plane-stress\" or \"axisymmetric\"; here it is "
                                                                 "\"3d\"")));
    scene = parsed(example);
    scene["bodies"][1].erase("disk");
    scene["bodies"][1]["ball"] = parsed(R"({"center": [0, 0, 0], "radius": 1})");
    EXPECT_THAT(problems_of(scene.dump()),
                testing::ElementsAre(IsProblem("/bodies/1/ball", "only goes with \"analysis\": \"3d\"; here it is "
                                                                 "\"plane-strain\"")));
}

TEST(SceneAnalysis, PlacesAndSizesInThreeDimensions) {
    expect_problems(
        {
            {"/bodies/0/box/upper/2", R"("5.1 cm")", "/bodies/0/box", "up to z = 0.051 m, the grid ends at 0.05 m"},
            {"/bodies/0/box/upper/2", R"("4 mm")", "/bodies/0/box", "its edge along z is 0.004 m, a cell 0.005 m"},
            {"/bodies/1/ball/center/2", R"("-4 cm")", "/bodies/1/ball", "down to z = -0.06 m"},
            {"/bodies/1/ball/radius", R"("2 mm")", "/bodies/1/ball", "its diameter is 0.004 m, a cell 0.005 m"},
        },
        example_3d);
}

TEST(SceneAnalysis, CellsInThreeDimensions) {
    EXPECT_THAT(problems_of(changed("/grid/cell", R"(["5 mm", "5 mm", "11 cm"])", example_3d)),
                testing::Contains(IsProblem("/grid/cell", "larger than the grid along z")));
}

TEST(SceneAnalysis, Axisymmetric) {
    const Scene scene = load(example_axisymmetric).scene;
    EXPECT_EQ(scene.analysis, Analysis::axisymmetric);
    EXPECT_EQ(scene.grid.cell, (Vector{1e-3, 2e-3, 0}));
    EXPECT_EQ(scene.bodies[0].velocity.gradient, (std::array<Vector, 3>{{{1, 0, 0}, {0, -2, 0}, {0, 0, 0}}}));
    EXPECT_EQ(scene.bodies[0].velocity.at({2, 3, 0}), (Vector{2, -6, 0}));
    expect_problems(
        {
            {"/grid/lower/0", R"("-1 mm")", "/grid/lower", "r must not be negative"},
            {"/gravity", "[1, 0]", "/gravity/0", "not symmetric"},
            {"/boundaries/0/wall/axis", R"("z")", "/boundaries/0/wall/axis", "the axes x (the radius) and y"},
        },
        example_axisymmetric);
    const std::string ring = changed("/bodies/0/box/lower/0", R"("5 mm")", example_axisymmetric);
    EXPECT_THAT(problems_of(changed("/grid/lower/0", R"("2 mm")", ring)), testing::IsEmpty());
    expect_problems({{"/grid/lower/0", R"("1.9 mm")", "/grid/lower",
                      "r must begin at 0 or at least 2 cells (0.002 m) from the axis, not at 0.0019 m"}},
                    ring);
}

TEST(SceneAnalysis, PlaneStressNeedsShearStiffness) {
    const std::string liquid = changed("/materials/aluminium/shear_modulus", "0");
    EXPECT_THAT(problems_of(liquid), testing::IsEmpty());
    expect_problems({{"/analysis", R"("plane-stress")", "/materials/aluminium", "a law without shear stiffness"}},
                    liquid);
    EXPECT_THAT(problems_of(changed("/analysis", R"("plane-stress")")), testing::IsEmpty());
}

TEST(SceneAnalysis, ScenesThatNoFileMade) {
    Scene scene = load(example).scene;
    scene.bodies[0].shape = Ball{{0, 0, 0}, 1};
    EXPECT_THAT(validate(scene), testing::ElementsAre(IsProblem("/bodies/0/ball", "only 3d scenes have balls")));
    scene = load(example_3d).scene;
    std::get<Box>(scene.bodies[0].shape).axis = {0, 0, 0};
    scene.bodies[1].shape = Disk{{0, 0, 0}, 1};
    EXPECT_THAT(validate_numbers(scene),
                testing::UnorderedElementsAre(IsProblem("/bodies/0/box/axis", "must not have the length 0"),
                                              IsProblem("/bodies/1/disk", "only plane scenes")));
}

} // namespace
} // namespace abut::scene_test
