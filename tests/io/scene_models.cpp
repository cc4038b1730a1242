/// What a scene says about models: shapes, images, initial states.
#include "scene_support.h"

#include <array>
#include <numbers>

namespace abut::scene_test {
namespace {

using testing::ElementsAre;

TEST(SceneModels, ShapesAndBodies) {
    const Scene scene = load(example_models).scene;
    ASSERT_EQ(scene.shapes.size(), 5u);
    EXPECT_EQ(scene.shapes[0].name, "plate");
    const auto& plate = std::get<Polygon>(scene.shapes[0].shape);
    ASSERT_EQ(plate.points.size(), 4u);
    EXPECT_DOUBLE_EQ(plate.points[2][1], 0.02);
    ASSERT_EQ(plate.holes.size(), 1u);
    EXPECT_DOUBLE_EQ(plate.holes[0][2][0], 0.007);
    EXPECT_DOUBLE_EQ(std::get<Ring>(scene.shapes[1].shape).outer_radius, 0.005);
    const auto& logo = std::get<Path>(scene.shapes[2].shape);
    EXPECT_EQ(logo.file.filename(), "logo.svg");
    EXPECT_TRUE(logo.file.is_absolute());
    EXPECT_DOUBLE_EQ(logo.placement.scale, 1e-4);
    EXPECT_DOUBLE_EQ(logo.placement.angle, std::numbers::pi / 2);
    EXPECT_DOUBLE_EQ(logo.placement.translation[0], 0.05);
    EXPECT_EQ(std::get<Combination>(scene.shapes[3].shape).operation, Operation::difference);
    EXPECT_THAT(std::get<Combination>(scene.shapes[4].shape).shapes, ElementsAre("plate", "logo"));

    EXPECT_EQ(scene.overlap, Overlap::last);
    const BodySpec& frame = scene.bodies[0];
    EXPECT_EQ(std::get<NamedShape>(frame.shape).name, "rest");
    EXPECT_EQ(frame.fill, Fill::covered_fraction);
    EXPECT_EQ(frame.arrangement, Arrangement::fitted);
    EXPECT_THAT(frame.state.angular_velocity, ElementsAre(0, 0, 30));
    EXPECT_EQ(frame.state.temperature, 300);
    EXPECT_DOUBLE_EQ(*frame.state.orientation, std::numbers::pi / 9);
    EXPECT_EQ(frame.state.stress, (std::array<double, 6>{1e6, 0, 0.3e6, -1e4, 0, 0}));
    const BodySpec& all = scene.bodies[1];
    EXPECT_EQ(std::get<Combination>(all.shape).operation, Operation::union_);
    EXPECT_EQ(all.fill, Fill::centre);
    EXPECT_FALSE(all.arrangement);
    EXPECT_FALSE(all.state.temperature || all.state.orientation || all.state.stress);
}

TEST(SceneModels, Images) {
    const ImageSpec image = load(example_models).scene.images.at(0);
    EXPECT_EQ(image.file.filename(), "ct_*.tif");
    EXPECT_EQ(image.slice, 12);
    EXPECT_DOUBLE_EQ(image.pixel[1], 2e-4);
    EXPECT_TRUE(image.first_row_is_up);
    ASSERT_TRUE(image.crop);
    EXPECT_THAT((*image.crop)[0], ElementsAre(10, 109));
    EXPECT_THAT((*image.crop)[1], ElementsAre(0, 49));
    EXPECT_THAT((*image.crop)[2], ElementsAre(0, -1));
    EXPECT_THAT(image.flip, ElementsAre(true, true, false));
    EXPECT_EQ(image.quarter_turns, 3);
    EXPECT_EQ(image.bodies, BodiesBy::component);
    EXPECT_EQ(image.connectivity, 8);
    EXPECT_EQ(image.split, 1.5);
    EXPECT_EQ(image.speckle, 20);
    EXPECT_EQ(image.fill, Fill::covered_fraction);
    EXPECT_EQ(image.legend[0].grey_range, (std::array{20000, 65535}));
    EXPECT_EQ(image.legend[0].state.temperature, 350);
    EXPECT_EQ(image.legend[0].state.angular_velocity[2], 2);
    EXPECT_TRUE(image.legend[1].is_void);
    EXPECT_EQ(image.temperature->white, 400);
    EXPECT_DOUBLE_EQ(image.orientation->white, std::numbers::pi);
    EXPECT_TRUE(image.temperature->file.is_absolute());
}

TEST(SceneModels, Solids) {
    const Scene scene = load(example_solids).scene;
    EXPECT_DOUBLE_EQ(std::get<Cone>(scene.shapes[1].shape).top_radius, 1e-3);
    EXPECT_DOUBLE_EQ(std::get<Implicit>(scene.shapes[3].shape).unit, 5e-3);
    EXPECT_THAT(scene.bodies[0].state.angular_velocity, ElementsAre(0, 0, 3));
    EXPECT_THAT(std::get<Ellipsoid>(scene.bodies[1].shape).axis, ElementsAre(1, 1, 0));
    EXPECT_EQ((*scene.bodies[1].state.stress)[4], 1000);
    EXPECT_TRUE(std::get<Surface>(scene.bodies[2].shape).repair);
    EXPECT_THAT(std::get<Box>(scene.bodies[3].shape).axis, ElementsAre(1, 0, 0));
    EXPECT_EQ(scene.images[0].turn_axis, 0);
    EXPECT_DOUBLE_EQ(scene.images[0].pixel[2], 50e-6);
}

TEST(SceneModels, WhatIsWrongWithShapes) {
    expect_problems(
        {
            {"/shapes/plate/polygon/points", "[[0, 0], [1, 1]]", "/shapes/plate/polygon/points",
             "at least 3 points are needed, not 2"},
            {"/shapes/plate/polygon/points/1", "[0]", "/shapes/plate/polygon/points/1", "2 components are needed"},
            {"/shapes/plate/polygon/holes/0/1/0", R"("3 s")", "/shapes/plate/polygon/holes/0/1/0", "is a time"},
            {"/shapes/eye/ring/inner_radius", R"("6 mm")", "/shapes/eye/ring/inner_radius",
             "must be smaller than the outer radius"},
            {"/shapes/eye/disk", R"({"center": [0, 0], "radius": 1})", "/shapes/eye", "exactly one of"},
            {"/shapes/rest/difference", R"(["plate"])", "/shapes/rest/difference", "at least 2 entries are needed"},
            {"/shapes/rest/difference/1", R"("eyes")", "/shapes/rest/difference/1", "did you mean \"eye\"?"},
            {"/bodies/0/shape", R"("rst")", "/bodies/0/shape", "no shape \"rst\"; did you mean \"rest\"?"},
            {"/bodies/0/fill", R"("majority")", "/bodies/0/fill", "unknown word \"majority\""},
            {"/bodies/0/angular_velocity", "[0, 0, 3]", "/bodies/0/angular_velocity",
             "one angular velocity is needed in a plane scene, not a list"},
            {"/bodies/0/temperature", "-3", "/bodies/0/temperature", "must be greater than 0"},
            {"/bodies/0/stress/xz", "1", "/bodies/0/stress/xz", "only goes with \"analysis\""},
            {"/bodies/0/stress", "3", "/bodies/0/stress", "an object"},
            {"/shapes/logo/path/axis", "[0, 0]", "/shapes/logo/path/axis", "only goes with \"analysis\": \"3d\""},
        },
        example_models);
    expect_problems(
        {
            {"/shapes/rod/cylinder/to", "[0, 0, 0]", "/shapes/rod/cylinder/to", "must not be the same place"},
            {"/shapes/drop/implicit/upper/0", R"("-7 mm")", "/shapes/drop/implicit/upper", "above \"lower\" along x"},
            {"/bodies/1/ellipsoid/axis", "[0, 0, 0]", "/bodies/1/ellipsoid/axis", "must not have the length 0"},
            {"/bodies/0/angular_velocity", "3", "/bodies/0/angular_velocity", "a list of 3 components"},
            {"/bodies/3/arrangement", R"("fitted")", "/bodies/3/arrangement", "turned in 3d"},
        },
        example_solids);
}

TEST(SceneModels, WhatIsWrongWithImages) {
    expect_problems(
        {
            {"/images/0/crop/columns", "[10]", "/images/0/crop/columns", "exactly 2 entries are needed, not 1"},
            {"/images/0/crop/columns", "[10, 3]", "/images/0/crop/columns", "must not come before the first"},
            {"/images/0/crop/colums", "[1, 2]", "/images/0/crop/colums", "did you mean \"columns\"?"},
            {"/images/0/flip/0", R"("w")", "/images/0/flip/0", "unknown word \"w\""},
            {"/images/0/quarter_turns", "4", "/images/0/quarter_turns", "must be between 0 and 3"},
            {"/images/0/connectivity", "6", "/images/0/connectivity", "must be 4 or 8 in a plane scene"},
            {"/images/0/bodies", R"("by-color")", "/images/0/bodies", "did you mean \"by-colour\"?"},
            {"/images/0/legend/0/grey_range", "[5, 4]", "/images/0/legend/0/grey_range",
             "must not be below the lowest"},
            {"/images/0/legend/0/grey", "4", "/images/0/legend/0", "exactly one of"},
            {"/images/0/temperature/black", R"("3 m")", "/images/0/temperature/black", "a temperature (K) is needed"},
            {"/images/0/turn_axis", R"("x")", "/images/0/turn_axis", "only goes with \"analysis\": \"3d\""},
            {"/images/0/size", R"(["1 m", "1 m"])", "/images/0", "at most one of \"pixel\" and \"size\" is allowed"},
            {"/contact/laws/0/bodies/0", R"("grains")", "/contact/laws/0/bodies/0", "no body \"grains\""},
        },
        example_models);
}

} // namespace
} // namespace abut::scene_test
