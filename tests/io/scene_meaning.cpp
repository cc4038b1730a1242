/// Problems that only the meaning of a scene shows: names, sizes and places.
#include "scene_support.h"

#include "scene/suggest.h"
#include "scene/validate.h"

#include <fmt/format.h>

namespace abut::scene_test {
namespace {

TEST(Suggest, EditDistance) {
    EXPECT_EQ(edit_distance("steel", "steel"), 0U);
    EXPECT_EQ(edit_distance("steal", "steel"), 1U);
    EXPECT_EQ(edit_distance("setel", "steel"), 1U); // a swap
    EXPECT_EQ(edit_distance("STEEL", "steel"), 0U);
    EXPECT_EQ(edit_distance("", "abc"), 3U);
    EXPECT_EQ(edit_distance("abc", ""), 3U);
    EXPECT_EQ(edit_distance("kitten", "sitting"), 3U);
}

TEST(Suggest, Nearest) {
    EXPECT_EQ(nearest("steal", {"aluminium", "steel"}), "steel");
    EXPECT_EQ(nearest("particle", {"none", "particle-edges"}), "particle-edges");
    EXPECT_EQ(nearest("copper", {"aluminium", "steel"}), std::nullopt);
    EXPECT_EQ(nearest("a", {"b"}), std::nullopt);
    EXPECT_EQ(did_you_mean("steal", {"steel"}), "; did you mean \"steel\"?");
    EXPECT_EQ(quoted_list({"a", "b", "c"}), "\"a\", \"b\" or \"c\"");
    EXPECT_EQ(pointer_token("a/b~c"), "a~1b~0c");
}

TEST(SceneMeaning, Names) {
    expect_problems({
        {"/bodies/2/material", R"("steal")", "/bodies/2/material", "no material \"steal\"; did you mean \"steel\"?"},
        {"/bodies/2/material", R"("wood")", "/bodies/2/material",
         "no material \"wood\"; there are: \"aluminium\" and \"steel\""},
        {"/images/0/legend/1/material", R"("steal")", "/images/0/legend/1/material", "did you mean \"steel\"?"},
        {"/bodies/2/name", R"("ball")", "/bodies/2/name", "\"ball\" is already the name of /bodies/1"},
        {"/images/0/legend/1/body", R"("egg")", "/images/0/legend/1/body", "\"egg\" is already the name of /bodies/2"},
        {"/images/1/legend/0/material", R"("steel")", "/images/1/legend/0/material",
         "the material differs from that of the same body \"grain-01\" at /images/0/legend/0"},
        {"/images/1/legend/0/velocity", "[1, 0]", "/images/1/legend/0/velocity", "the velocity differs"},
        {"/boundaries/1/name", R"("floor")", "/boundaries/1/name", "\"floor\" is already the name of /boundaries/0"},
        {"/contact/laws/0/bodies/1", R"("bell")", "/contact/laws/0/bodies/1",
         "no body \"bell\"; did you mean \"ball\"?"},
        {"/contact/laws/0/bodies/1", R"("block")", "/contact/laws/0/bodies", "a pair is two bodies"},
        {"/contact/laws/1", R"({"bodies": ["ball", "block"], "law": {"type": "stick"}})", "/contact/laws/1/bodies",
         "already given at /contact/laws/0"},
    });
    EXPECT_THAT(problems_of(changed("/contact/laws/0/bodies/1", R"("grain-02")")), testing::IsEmpty());
}

TEST(SceneMeaning, GridAndTime) {
    EXPECT_THAT(
        problems_of(changed("/grid/upper/0", "0")),
        testing::Contains(IsProblem("/grid/upper", "must lie above \"lower\" along x: it is at 0 m, lower at 0 m")));
    EXPECT_THAT(
        problems_of(changed("/grid/cell", R"(["1.5 mm", "1 um"])")),
        testing::Contains(IsProblem("/grid/cell", "larger than the grid along x: a cell is 0.0015 m, the grid")));
    Json empty = parsed(changed("/contact/laws", "[]"));
    empty.erase("bodies");
    empty.erase("images");
    EXPECT_THAT(problems_of(empty.dump()), testing::ElementsAre(IsProblem("/bodies", "the scene is empty")));
}

TEST(SceneMeaning, Bodies) {
    expect_problems({
        {"/bodies/0/box/upper/0", R"("1.1 mm")", "/bodies/0/box", "up to x = 0.0011 m, the grid ends at 0.001 m"},
        {"/bodies/0/box/lower/1", R"("-1 um")", "/bodies/0/box", "down to y = -1e-06 m, the grid begins at 0 m"},
        {"/bodies/0/box/upper/0", "0", "/bodies/0/box/upper", "must lie above \"lower\" along x"},
        {"/bodies/0/box/upper/0", R"("14 um")", "/bodies/0/box",
         "cell larger than the body: its edge along x is 1.4e-05 m, a cell 1.43e-05 m"},
        {"/bodies/1/disk/center/0", R"("0.2 mm")", "/bodies/1/disk", "down to x = -5e-05 m"},
        {"/bodies/1/disk/radius", R"("7 um")", "/bodies/1/disk", "its diameter is 1.4e-05 m"},
        {"/bodies/2/ellipse/semi_axes/1", R"("7 um")", "/bodies/2/ellipse", "its smaller diameter is 1.4e-05 m"},
        // The half width of the egg is sqrt((0.2 cos 30°)² + (0.1 sin 30°)²) = 0.180278 mm.
        {"/bodies/2/ellipse/center/0", R"("0.18 mm")", "/bodies/2/ellipse", "down to x = -2.77564e-07 m"},
    });
    EXPECT_THAT(problems_of(changed("/bodies/2/ellipse/center/0", R"("0.1803 mm")")), testing::IsEmpty());
}

/// 1 mm × 0.5 mm about (0.5 mm, 0.25 mm): half the width of the turned box is (1 cos 10° + 0.5 sin 10°)/2 = 0.535816
/// mm, half its height (1 sin 10° + 0.5 cos 10°)/2 = 0.333026 mm.
TEST(SceneMeaning, TurnedBoxes) {
    EXPECT_THAT(problems_of(changed("/bodies/0/box/angle", R"("10 deg")")),
                testing::UnorderedElementsAre(IsProblem("/bodies/0/box", "down to x = -3.58159e-05 m"),
                                              IsProblem("/bodies/0/box", "up to x = 0.00103582 m"),
                                              IsProblem("/bodies/0/box", "down to y = -8.3026e-05 m")));
    EXPECT_THAT(problems_of(changed("/bodies/0/box/angle", R"("180 deg")")), testing::IsEmpty());
    expect_problems({{"/bodies/0/box/angle", R"("1 mm")", "/bodies/0/box/angle", "an angle (rad) is needed"}});
}

TEST(SceneMeaning, ImagesWallsAndMaterials) {
    expect_problems({
        {"/images/1/size/1", R"("0.6 mm")", "/images/1", "up to y = 0.0021 m"},
        {"/boundaries/0/wall/position", R"("-1 mm")", "/boundaries/0/wall/position",
         "outside the grid at -0.001 m; the grid reaches from 0 m to 0.002 m"},
        {"/boundaries/1/wall/velocity", R"("1 m/s")", "/boundaries/1/wall/velocity",
         "moves out of the grid at t = 0 s"},
        {"/boundaries/1/wall/velocity", R"("-200 m/s")", "/boundaries/1/wall/velocity",
         "moves out of the grid at t = 1e-05 s"},
        {"/materials/steel/poissons_ratio", "-0.99999999999999999", "/materials/steel/poissons_ratio",
         "between -1 and 0.5"},
        {"/materials/steel",
         R"({"model": "neo-hookean", "density": 1, "bulk_modulus": "1 GPa", "youngs_modulus": "10 GPa"})",
         "/materials/steel", "these elastic constants give"},
    });
}

TEST(SceneMeaning, ContactLawsAndRigidBodies) {
    expect_problems({
        {"/contact/law/coefficient", "-0.1", "/contact/law/coefficient", "at least 0"},
        {"/contact/law", R"({"type": "friction", "coefficient": 0.3, "static_coefficient": 0.2})",
         "/contact/law/static_coefficient", "must not be less than the coefficient while sliding"},
        {"/contact/law", R"({"type": "linear-interface", "normal_stiffness": "3 GPa", "tangential_stiffness": 1})",
         "/contact/law/normal_stiffness", "a stiffness of an interface (Pa/m) is needed"},
        {"/contact/law", R"({"type": "adhesion", "coefficient": 0, "strength": 0, "shear_strength": 1})",
         "/contact/law/strength", "greater than 0"},
    });
    Json scene = parsed(example);
    scene["bodies"][0].erase("material");
    scene["bodies"][0]["rigid"] = parsed(R"({"velocity": ["1 m/s", 0]})");
    EXPECT_THAT(problems_of(scene.dump()),
                testing::ElementsAre(IsProblem("/bodies/0/velocity", "does not go with \"rigid\"")));
    scene["bodies"][0].erase("velocity");
    EXPECT_THAT(problems_of(scene.dump()), testing::IsEmpty());
    scene["boundaries"].push_back(
        parsed(R"({"name": "load", "traction": {"body": "block", "axis": "x", "side": "lower", "pressure": 1}})"));
    EXPECT_THAT(problems_of(scene.dump()), testing::ElementsAre(IsProblem("/boundaries/2/traction/body",
                                                                          "\"block\" is rigid: no force moves it")));
    scene["boundaries"].erase(2);
    scene["contact"].erase("laws");
    scene.erase("contact");
    EXPECT_THAT(problems_of(scene.dump()), testing::ElementsAre(IsProblem("/bodies/0/rigid", "add \"contact\"")));

    Json axisymmetric = parsed(example_axisymmetric);
    axisymmetric["contact"] = Json::object();
    for (Json& body : axisymmetric["bodies"]) {
        body.erase("material");
        body.erase("velocity_gradient");
        body["rigid"] = parsed(R"({"velocity": ["1 m/s", 0], "angular_velocity": 1})");
    }
    axisymmetric.erase("boundaries");
    const std::string problems = in_lines(problems_of(axisymmetric.dump()));
    EXPECT_THAT(problems, testing::HasSubstr("can't move along x, the radius"));
    EXPECT_THAT(problems, testing::HasSubstr("can't turn in the plane"));
    EXPECT_THAT(problems, testing::HasSubstr("all bodies are rigid"));
}

TEST(SceneMeaning, InterfacesTooStiffForTheStepAreAdvisedAgainst) {
    Json scene = parsed(example);
    scene["contact"] = Json::object();
    const auto advice_for = [&](const char* stiffness) {
        scene["contact"]["law"] = {
            {"type", "linear-interface"}, {"normal_stiffness", stiffness}, {"tangential_stiffness", 0}};
        return advice(load(scene.dump()).scene);
    };
    EXPECT_THAT(advice_for("1 GPa/mm"), testing::IsEmpty());
    // κ Δt < π/2 with m = ρ Δx/4 per area: D < (π/2)² ρ Δx/(4 Δt²), Δt = 0.4 Δx/c with the faster material's c.
    const double c = std::sqrt((133.333e9 + 4.0 / 3 * 80e9) / 7800), step = 0.4 * 14.3e-6 / std::max(c, 6430.0);
    const double limit = std::pow(M_PI / 2, 2) * 2780 * 14.3e-6 / (4 * step * step);
    EXPECT_THAT(advice_for(fmt::format("{} Pa/m", 0.9 * limit).c_str()), testing::IsEmpty());
    EXPECT_THAT(advice_for(fmt::format("{} Pa/m", 1.1 * limit).c_str()),
                testing::ElementsAre(IsProblem("/contact/law", "the bodies will stick as if bonded")));
}

TEST(SceneMeaning, MeaningProblemsComeTogether) {
    Json scene = parsed(example);
    scene["bodies"][0]["material"] = "steal";
    scene["bodies"][1]["disk"]["radius"] = 1;
    scene["materials"]["steel"] =
        parsed(R"({"model": "neo-hookean", "density": 1, "bulk_modulus": 1, "lame_lambda": 2})");
    EXPECT_THAT(problems_of(scene.dump()),
                testing::IsSupersetOf({IsProblem("/materials/steel", "these elastic constants give"),
                                       IsProblem("/bodies/1/disk", "reaches out of the grid"),
                                       IsProblem("/bodies/0/material", "steal")}));
}

TEST(SceneMeaning, ScenesThatNoFileMade) {
    Scene scene = load(example).scene;
    EXPECT_THAT(validate(scene), testing::IsEmpty());
    scene.time.end = std::nan("");
    scene.time.cfl = 2;
    scene.materials[0].density = 0;
    scene.bodies[1].shape = Disk{{0.5e-3, 1e-3, 0}, 0};
    std::get<WallSpec>(scene.boundaries[0].condition).axis = 2;
    scene.boundaries.pop_back();
    scene.grid.cell = {0, 1e-5, 0};
    EXPECT_THAT(validate(scene),
                testing::UnorderedElementsAre(
                    IsProblem("/time/end", "greater than 0"), IsProblem("/time/cfl", "at most 1"),
                    IsProblem("/materials/aluminium/density", "greater than 0"),
                    IsProblem("/bodies/1/disk/radius", "greater than 0"),
                    IsProblem("/boundaries/0/wall/axis", "x and y"), IsProblem("/grid/cell", "along x")));
}

} // namespace
} // namespace abut::scene_test
