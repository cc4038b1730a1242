/// Problems that the table of keys finds, one by one and all at once.
#include "scene_support.h"

namespace abut::scene_test {
namespace {

TEST(SceneStructure, Keys) {
    expect_problems({
        {"/materials/steel/densty", "1", "/materials/steel/densty",
         "unknown key \"densty\"; did you mean \"density\"?"},
        {"/colour", "1", "/colour", "unknown key \"colour\"; known here: \"$schema\", \"abut_version\", \"title\""},
        {"/bodies/0/a~1b", "1", "/bodies/0/a~1b", "unknown key \"a/b\""},
        {"/grid/cell", "", "/grid/cell", "this key is required and missing. Wanted size of a cell"},
        {"/time", "", "/time", "required and missing"},
        {"/bodies/1/name", "", "/bodies/1/name", "required and missing"},
        {"/bodies/1/disk/radius", "", "/bodies/1/disk/radius", "required and missing"},
        {"/contact/law/coefficient", "", "/contact/law/coefficient", "required and missing"},
        {"/contact/laws/0/law/type", R"("friction")", "/contact/laws/0/law/coefficient", "required and missing"},
        {"/images/0/legend/0/body", "", "/images/0/legend/0/body", "required and missing"},
    });
}

TEST(SceneStructure, Types) {
    expect_problems({
        {"/title", "3", "/title", "a text is needed, not 3"},
        {"/grid", "[]", "/grid", "an object { } is needed, not a list"},
        {"/bodies", "{}", "/bodies", "a list [ ] is needed, not an object"},
        {"/bodies/1", "null", "/bodies/1", "an object { } is needed, not null"},
        {"/materials", "3", "/materials", "an object { } is needed, not 3"},
        {"/gravity", "-9.81", "/gravity", "a list of 2 components (an acceleration, m/s^2 each) is needed, not -9.81"},
        {"/gravity", "[0, -9.81, 0]", "/gravity", "2 components are needed in a plane scene, not 3"},
        {"/gravity", "[0, true]", "/gravity/1", "an acceleration (a number in m/s^2 or a text with a unit) is needed"},
        {"/grid/cell", "[1]", "/grid/cell", "2 components are needed"},
        {"/time/cfl", R"("0.4")", "/time/cfl", "a number without unit is needed, not the text \"0.4\""},
        {"/output/grid", "1", "/output/grid", "true or false is needed, not 1"},
        {"/bodies/2/particles_per_cell", "2.5", "/bodies/2/particles_per_cell", "a whole number is needed, not 2.5"},
        {"/bodies/1/name", R"("")", "/bodies/1/name", "must not be empty"},
        {"/images/0/legend/1/rgb", R"("d04020")", "/images/0/legend/1/rgb", "a colour as \"#rrggbb\""},
        {"/images/0/legend", "[]", "/images/0/legend", "at least 1 entries are needed, not 0"},
        {"/contact/laws/0/bodies", R"(["a"])", "/contact/laws/0/bodies", "exactly 2 entries are needed, not 1"},
        {"/contact", "null", "/contact", "an object { } is needed, not null"},
    });
}

TEST(SceneStructure, Quantities) {
    expect_problems({
        {"/materials/steel/density", R"("3 mm")", "/materials/steel/density",
         "3 mm is a length; a density (kg/m^3) is needed"},
        {"/materials/steel/density", R"("heavy")", "/materials/steel/density",
         "\"heavy\" does not begin with a number; a density (kg/m^3) is needed"},
        {"/materials/steel/density", R"("")", "/materials/steel/density", "does not begin with a number"},
        {"/materials/steel/density", R"("7800")", "/materials/steel/density", "\"7800\" has no unit"},
        {"/time/end", R"("15 uss")", "/time/end", "unknown unit \"uss\"; did you mean \"us\"?"},
        {"/grid/lower/1", R"("0 s")", "/grid/lower/1", "0 s is a time; a length (m) is needed"},
        {"/bodies/2/ellipse/angle", R"("30 m")", "/bodies/2/ellipse/angle", "an angle (rad) is needed"},
    });
}

TEST(SceneStructure, Ranges) {
    expect_problems({
        {"/materials/steel/density", "0", "/materials/steel/density", "must be greater than 0 kg/m^3, not 0"},
        {"/materials/steel/density", R"("-1 g/cm^3")", "/materials/steel/density", "not -1 g/cm^3"},
        {"/materials/steel/poissons_ratio", "0.5", "/materials/steel/poissons_ratio",
         "infinite bulk modulus; use e.g. 0.49"},
        {"/materials/steel/poissons_ratio", "-1", "/materials/steel/poissons_ratio",
         "between -1 and 0.5 (both excluded)"},
        {"/time/end", "0", "/time/end", "greater than 0 s"},
        {"/time/cfl", "1.5", "/time/cfl", "between 0 and 1 (0 excluded), not 1.5"},
        {"/time/cfl", "0", "/time/cfl", "between 0 and 1"},
        {"/method/transfer/order", "0", "/method/transfer/order", "between 1 and 100, not 0"},
        {"/method/transfer/order", "101", "/method/transfer/order", "beyond about 16, round-off and cost outweigh"},
        {"/method/transfer/every_cfl", "0", "/method/transfer/every_cfl", "greater than 0, not 0"},
        {"/contact/corrections", "3", "/contact/corrections", "between 1 and 2, not 3"},
        {"/contact/law/coefficient", "-0.1", "/contact/law/coefficient", "at least 0, not -0.1"},
        {"/images/0/legend/0/grey", "65536", "/images/0/legend/0/grey", "between 0 and 65535, not 65536"},
        {"/bodies/2/ellipse/semi_axes/1", "0", "/bodies/2/ellipse/semi_axes/1", "greater than 0 m"},
        {"/bodies/1/disk/radius", R"("-1 mm")", "/bodies/1/disk/radius", "greater than 0 m, not -1 mm"},
        {"/grid/cell", "-1", "/grid/cell", "greater than 0 m"},
    });
}

TEST(SceneStructure, Words) {
    expect_problems({
        {"/analysis", R"("3D")", "/analysis", "unknown word \"3D\"; did you mean \"3d\"?"},
        {"/method/velocity_conditions", R"("combine")", "/method/velocity_conditions", "did you mean \"combined\"?"},
        {"/boundaries/1/wall/gradient", R"("estimate")", "/boundaries/1/wall/gradient",
         "unknown word \"estimate\"; did you mean \"estimated\"?"},
        {"/method/shape", R"("cdpi")", "/method/shape", "unknown word \"cdpi\"; did you mean \"cpdi\"?"},
        {"/contact/normal", R"("logistic")", "/contact/normal", "did you mean \"logistic-regression\"?"},
        {"/boundaries/0/wall/axis", R"("z")", "/boundaries/0/wall/axis", "plane scenes have the axes x and y"},
        {"/boundaries/0/wall/side", "1", "/boundaries/0/wall/side", "\"lower\" or \"upper\" is needed, not 1"},
        {"/images/1/up", R"("top")", "/images/1/up", "allowed: \"first-row\" and \"last-row\""},
    });
}

TEST(SceneStructure, KeysThatGoTogether) {
    expect_problems({
        {"/time/step", "1e-9", "/time",
         "at most one of \"cfl\" and \"step\" is allowed; here are \"cfl\" and \"step\""},
        {"/bodies/1/disk", "", "/bodies/1", "\"union\", \"difference\" and \"intersection\" is needed; here is none"},
        {"/bodies/1/box", R"({"lower": [0, 0], "upper": [1, 1]})", "/bodies/1", "here are \"box\" and \"disk\""},
        {"/images/0/size", "[1, 1]", "/images/0", "at most one of \"pixel\" and \"size\" is allowed"},
        {"/images/0/legend/0/rgb", R"("#000000")", "/images/0/legend/0",
         "exactly one of \"grey\", \"rgb\" and \"grey_range\""},
        {"/images/0/legend/2/grey", "", "/images/0/legend/2",
         "exactly one of \"grey\", \"rgb\" and \"grey_range\" is needed"},
        {"/materials/steel/poissons_ratio", "", "/materials/steel", "needed; here is only \"youngs_modulus\""},
        {"/materials/steel/bulk_modulus", "1", "/materials/steel",
         "allowed; here are \"bulk_modulus\", \"youngs_modulus\" and \"poissons_ratio\""},
        {"/method/transfer/scheme", R"("flip")", "/method/transfer/order",
         "only goes with \"scheme\": \"xpic\" or \"fmpm\"; here it is \"flip\""},
        {"/method/transfer", R"({"every_cfl": 1})", "/method/transfer/every_cfl",
         "only goes with \"scheme\": \"pic\", \"xpic\" or \"fmpm\"; here it is \"flip\""},
        {"/bodies/0/velocity_center", "[0, 0]", "/bodies/0/velocity_center",
         "only goes with \"velocity_gradient\", which is not given"},
        {"/boundaries/0/wall", "", "/boundaries/0",
         "exactly one of \"wall\", \"velocity\" and \"traction\" is needed; here is none"},
        {"/boundaries/0/traction", R"({"body": "block", "axis": "x", "side": "lower", "pressure": 1})", "/boundaries/0",
         "here are \"wall\" and \"traction\""},
        {"/boundaries/0", R"({"name": "a", "traction": {"body": "block", "axis": "x", "side": "lower"}})",
         "/boundaries/0/traction", "exactly one of \"stress\" and \"pressure\" is needed; here is none"},
        {"/method/transfer/scheme", "", "/method/transfer/order", "here it is \"flip\""},
        {"/contact/separation", R"("none")", "/contact/offset", "only goes with \"separation\": \"critical-position\""},
        {"/contact/exponent", "0.5", "/contact/exponent", "only goes with \"separation\": \"fitted-position\""},
        {"/contact/laws/0/law/coefficient", "0.5", "/contact/laws/0/law/coefficient", "here it is \"perfect\""},
        {"/contact/law/viscosity", "3", "/contact/law/viscosity",
         "only goes with \"type\": \"viscous-friction\"; here it is \"friction\""},
        {"/contact/law", R"({"type": "linear-interface", "normal_stiffness": 1})", "/contact/law/tangential_stiffness",
         "required and missing"},
        {"/contact/law", R"({"type": "adhesion", "coefficient": 0, "strength": 1})", "/contact/law/shear_strength",
         "required and missing"},
        {"/bodies/1/rigid", "{}", "/bodies/1/material", "does not go with \"rigid\""},
        {"/bodies/0/material", "", "/bodies/0/material", "required and missing"},
        {"/images/0/legend/1/material", "", "/images/0/legend/1/material", "required and missing"},
        {"/images/0/legend/2/body", R"("x")", "/images/0/legend/2/body",
         "only goes with \"void\": false; here it is true"},
    });
}

TEST(SceneStructure, AllProblemsAtOnce) {
    Json scene = parsed(example);
    scene["thickness"] = "3 s";
    scene["grid"].erase("lower");
    scene["time"]["stepp"] = 1;
    scene["contact"]["normal"] = "own-gradients";
    scene["materials"]["steel"]["density"] = "3 mm";
    scene["bodies"][0]["material"] = "aluminum"; // a name that fits nothing, found beside the others
    scene["bodies"][1] = 3;
    scene["bodies"][2]["name"] = "block";
    scene["contact"]["law"]["type"] = "glue";
    EXPECT_THAT(problems_of(scene.dump()),
                testing::UnorderedElementsAre(
                    IsProblem("/thickness", "a length (m) is needed"), IsProblem("/grid/lower", "missing"),
                    IsProblem("/time/stepp", "did you mean \"step\"?"),
                    IsProblem("/contact/normal", "\"own-gradient\"?"),
                    IsProblem("/materials/steel/density", "3 mm is a length"),
                    IsProblem("/bodies/0/material", "no material \"aluminum\"; did you mean \"aluminium\"?"),
                    IsProblem("/bodies/1", "an object { } is needed, not 3"),
                    IsProblem("/bodies/2/name", "already the name of /bodies/0"),
                    IsProblem("/contact/law/type", "unknown word \"glue\"")));
}

} // namespace
} // namespace abut::scene_test
