#include "scene_support.h"

#include "io/scene/overrides.h"

namespace abut::scene_test {
namespace {

using testing::ElementsAre;

TEST(SceneOverrides, ReplaceValues) {
    const Scene scene = load(example, {"/method/transfer/order=4", "/contact/normal=average-gradient",
                                       "/materials/steel/density=8 g/cm^3", "/bodies/0/velocity/1=-2 m/s",
                                       "/gravity=[0, 1]", "/title=a=b"})
                            .scene;
    EXPECT_EQ(scene.method.transfer.order, 4);
    EXPECT_EQ(scene.contact->normal, NormalMethod::average_gradient);
    EXPECT_EQ(scene.materials[1].density, 8000);
    EXPECT_EQ(scene.bodies[0].velocity.value, (Vector{8, -2, 0}));
    EXPECT_EQ(scene.gravity, (Vector{0, 1, 0}));
    EXPECT_EQ(scene.title, "a=b");
}

TEST(SceneOverrides, LaterOnesWin) {
    EXPECT_EQ(load(example, {"/time/cfl=0.2", "/time/cfl=0.3"}).scene.time.cfl, 0.3);
}

TEST(SceneOverrides, MakeWhatIsMissing) {
    const std::string no_contact = changed("/contact", "");
    const Scene scene = load(no_contact, {"/contact/law/type=stick", "/output/grid=false"}).scene;
    ASSERT_TRUE(scene.contact);
    EXPECT_EQ(scene.contact->law.type, LawType::stick);
    EXPECT_FALSE(scene.output.grid.write);
    EXPECT_EQ(load(changed("/gravity", ""), {"/gravity/1=-3"}).scene.gravity, (Vector{0, -3, 0}));
    EXPECT_EQ(
        load(example,
             {R"(/materials/wood={"model": "neo-hookean", "density": 600, "bulk_modulus": 1e9, "shear_modulus": 1e9})",
              "/bodies/1/material=wood"})
            .scene.materials[2]
            .density,
        600);
}

TEST(SceneOverrides, VectorsOfThreeComponents) {
    const std::string no_gravity = [] {
        Json scene = parsed(example_3d);
        scene.erase("gravity");
        return scene.dump();
    }();
    EXPECT_EQ(load(no_gravity, {"/gravity/2=-3"}).scene.gravity, (Vector{0, 0, -3}));
    EXPECT_EQ(load(example_3d, {"/bodies/0/velocity_gradient/2/0=7 1/s"}).scene.bodies[0].velocity.gradient[2],
              (Vector{7, 0, 3}));
}

TEST(SceneOverrides, FunctionsOfTime) {
    const auto wall = [](const std::vector<std::string>& overrides) {
        return std::get<WallSpec>(load(example_3d, overrides).scene.boundaries[0].condition);
    };
    EXPECT_EQ(wall({"/boundaries/0/wall/velocity/values/1=1 mm/s"}).velocity.value, (std::vector{0.0, 1e-3, 0.0}));
    EXPECT_EQ(wall({"/boundaries/0/wall/velocity=-1e-3"}).velocity.value, (std::vector{-1e-3}));
    const auto traction = [](const std::vector<std::string>& overrides) {
        return std::get<TractionSpec>(load(example_3d, overrides).scene.boundaries[2].condition);
    };
    EXPECT_EQ(traction({"/boundaries/2/traction/stress/1/pulse/start=1 ms"}).traction[1].time.front(), 1e-3);
    EXPECT_EQ(traction({"/boundaries/2/traction/stress/0=5 kPa"}).traction[0].value, (std::vector{5e3}));
    EXPECT_THAT(problems_of(example_3d, {"/boundaries/0/wall/velocity/vales/1=1"}),
                ElementsAre(IsProblem("/boundaries/0/wall/velocity/vales/1",
                                      "a function of time has no \"vales\"; did you mean \"values\"?")));
    EXPECT_THAT(problems_of(example_3d, {"/boundaries/0/wall/velocity/values/3=1"}),
                ElementsAre(IsProblem("/boundaries/0/wall/velocity/values/3", "it has entries 0 to 2")));
    EXPECT_THAT(problems_of(example, {"/boundaries/0/wall/velocity/values=1"}),
                ElementsAre(IsProblem("/boundaries/0/wall/velocity/values", "is a single value")));
}

TEST(SceneOverrides, NullRemoves) {
    EXPECT_FALSE(load(example, {"/contact=null"}).scene.contact);
    EXPECT_FALSE(load(changed("/contact", ""), {"/contact=null"}).scene.contact);
    EXPECT_FALSE(load(changed("/contact", ""), {"/contact/offset=null"}).scene.contact);
    EXPECT_EQ(load(example, {"/time/cfl=null", "/time/step=1 ns"}).scene.time.step, 1e-9);
    EXPECT_THAT(problems_of(example, {"/time/end=null"}), ElementsAre(IsProblem("/time/end", "required and missing")));
}

TEST(SceneOverrides, ImageFilesStartFromTheSceneFolder) {
    const SceneOnDisk disk(example);
    EXPECT_EQ(load_scene(disk.file(), {"/images/0/file=a/../b.png"}).scene.images[0].file, disk.folder() / "b.png");
}

TEST(SceneOverrides, EscapedNames) {
    const std::string text =
        changed("/materials/a~1b", R"({"model": "neo-hookean", "density": 1, "bulk_modulus": 1, "shear_modulus": 1})");
    EXPECT_EQ(load(text, {"/materials/a~1b/density=5"}).scene.materials.back().density, 5);
}

TEST(SceneOverrides, Problems) {
    const std::vector<std::array<std::string, 3>> cases{
        {"/method/transfer/ordr=4", "/method/transfer/ordr",
         "the scene format has no key \"/method/transfer/ordr\"; did you mean \"/method/transfer/order\"?"},
        {"/methd/shape=cpdi", "/methd/shape", "did you mean \"/method\"?"},
        {"/=3", "/", "the scene format has no key \"/\""},
        {"/materials/steal/density=3", "/materials/steal/density",
         "\"/materials\" has no entry \"steal\"; did you mean \"steel\"?"},
        {"/bodies/3/name=x", "/bodies/3/name", "\"/bodies\" has no entry 3; it has entries 0 to 2"},
        {"/bodies/-/name=x", "/bodies/-/name", "has no entry -"},
        {"/bodies/ball/name=x", "/bodies/ball/name", "has no entry ball"},
        {"/gravity/2=1", "/gravity/2", "it has entries 0 to 1"},
        {"/gravity/0/0=1", "/gravity/0/0", "has no entry 0"},
        {"/title/0=1", "/title/0", "\"/title\" is a single value, nothing is below it"},
        {"/time/cfl=2", "/time/cfl", "between 0 and 1"},
        {"/time/end=NaN", "/time/end", "\"NaN\" does not begin with a number"},
        {"/bodies/0=null", "/bodies/0", "an object { } is needed, not null"},
        {"/method/transfer={\"order\": 1, \"order\": 2, \"scheme\": \"xpic\"}", "/method/transfer/order",
         "given twice"},
        {"method/shape=cpdi", "", "write a JSON pointer"},
        {"/method/shape", "", "write a JSON pointer"},
        {"=3", "", "write a JSON pointer"},
        {"", "", "write a JSON pointer"},
    };
    const std::string text = changed("/contact", "");
    for (const auto& [override, pointer, fragment] : cases) {
        const std::vector<Problem> problems = problems_of(text, {override});
        EXPECT_THAT(problems, ElementsAre(IsProblem(pointer, fragment))) << override << "\n" << in_lines(problems);
    }
}

TEST(SceneOverrides, AListThatIsNoJsonIsSaidToBeNone) {
    Json scene = parsed(example);
    const Json before = scene;
    std::vector<Problem> problems;
    apply_override(scene, "/gravity=[.5, 0]", problems);
    ASSERT_EQ(problems.size(), 1u);
    EXPECT_THAT(problems[0], IsProblem("/gravity", "[.5, 0] is not valid JSON"));
    EXPECT_EQ(scene, before);
}

} // namespace
} // namespace abut::scene_test
