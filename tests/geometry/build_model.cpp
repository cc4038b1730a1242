// Scenes to models: what comes out, and every way in which a scene can be wrong.
#include "geometry/build_model.h"

#include "geometry/images/image.h"
#include "model_support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

using namespace abut; // NOLINT(google-build-using-namespace): the room under test
using test::box;
using test::Folder;
using test::grey;
using test::picture;
using test::problems;
using test::unit_scene;
using testing::ElementsAre;
using testing::HasSubstr;

namespace {

/// A scene of a picture in a folder of its own; pixels of 1 m, 2 × 2 particles a pixel.
struct PictureScene {
    Folder folder;
    Scene scene = unit_scene(4);
    std::string name = (folder.path / "scene.json").string();

    explicit PictureScene(const Image& image) {
        write_image(image, folder.path / "bed.png");
        ImageSpec spec;
        spec.file = "bed.png";
        spec.pixel = {1, 1};
        scene.images.push_back(spec);
    }
    std::vector<LegendEntry>& legend() { return scene.images[0].legend; }
    std::vector<std::string> problems() const { return test::problems(scene, name); }
    Model model() const { return build_model(scene, name); }
};

const Image two_grains = picture({{255, 255, 255, 255}, {10, 10, 20, 20}, {10, 10, 20, 20}, {10, 10, 20, 20}});

} // namespace

TEST(BuildModel, AnglesOfTurnedBoxesOnly) {
    Scene scene = unit_scene(4);
    scene.bodies = {box("straight", {0, 0, 0}, {1, 1, 0}), box("turned", {2, 2, 0}, {3, 3, 0})};
    EXPECT_TRUE(build_model(scene, "scene.json").angle.empty());
    std::get<Box>(scene.bodies[1].shape).angle = 0.5;
    EXPECT_THAT(build_model(scene, "scene.json").angle, ElementsAre(0, 0, 0, 0, 0.5, 0.5, 0.5, 0.5));
}

TEST(BuildModel, BodiesThenImageBodiesInTheOrderOfTheLegend) {
    PictureScene test(two_grains);
    test.legend() = {grey(20, "right", "glass"), grey(10, "left"), grey(255, "")};
    test.legend()[0].velocity = {3, 0, 0};
    test.scene.bodies = {box("lid", {0, 3, 0}, {4, 4, 0})};
    test.scene.bodies[0].velocity.value = {0, -1, 0};
    const Model model = test.model();
    ASSERT_EQ(model.bodies.size(), 3u);
    EXPECT_EQ(model.bodies[0].name, "lid");
    EXPECT_EQ(model.bodies[1].name, "right");
    EXPECT_EQ(model.bodies[2].name, "left");
    EXPECT_EQ(model.bodies[1].material, 1);
    EXPECT_EQ(model.bodies[2].material, 0);
    EXPECT_THAT(model.bodies[0].velocity.value, ElementsAre(0, -1, 0));
    EXPECT_THAT(model.bodies[1].velocity.value, ElementsAre(3, 0, 0));
    EXPECT_EQ(model.size(), 16u * 4);
    EXPECT_EQ(model.half_size.size(), model.size());
    EXPECT_EQ(model.body.size(), model.size());
    for (std::size_t k = 0; k < model.size(); ++k) {
        EXPECT_THAT(model.half_size[k], ElementsAre(0.25, 0.25, 0));
        const int expected = model.position[k][1] > 3 ? 0 : (model.position[k][0] > 2 ? 1 : 2);
        EXPECT_EQ(model.body[k], expected);
    }
}

TEST(BuildModel, SameNameAddsToTheSameBody) {
    PictureScene test(two_grains);
    test.legend() = {grey(20, "one"), grey(10, "one"), grey(255, "")};
    test.scene.bodies = {box("one", {0, 3, 0}, {4, 4, 0})};
    const Model model = test.model();
    EXPECT_EQ(model.bodies.size(), 1u);
    EXPECT_EQ(model.size(), 16u * 4);
}

TEST(BuildModel, SameNameOtherMaterialOrVelocity) {
    PictureScene test(two_grains);
    test.legend() = {grey(20, "one", "glass"), grey(10, "two"), grey(255, "")};
    test.scene.bodies = {box("one", {0, 3, 0}, {4, 4, 0})};
    EXPECT_THAT(test.problems(),
                ElementsAre("/images/0/legend/0/material: body \"one\" exists already, of material \"steel\""));
    test.legend()[0].material = "steel";
    test.legend()[0].velocity = {1, 0, 0};
    EXPECT_THAT(test.problems(),
                ElementsAre("/images/0/legend/0/velocity: body \"one\" exists already, with another velocity"));
}

TEST(BuildModel, UnknownMaterial) {
    Scene scene = unit_scene(4);
    scene.bodies = {box("a", {0, 0, 0}, {1, 1, 0}, "steal")};
    EXPECT_THAT(problems(scene), ElementsAre("/bodies/0/material: no material \"steal\""));
}

TEST(BuildModel, NoParticlesAtAll) {
    EXPECT_THAT(problems(unit_scene(4)), ElementsAre(": the scene has no particles: it needs bodies or images"));
}

TEST(BuildModel, UnusableGridAndParticlesPerCell) {
    Scene scene = unit_scene(4);
    scene.bodies = {box("a", {0, 0, 0}, {1, 1, 0})};
    scene.bodies[0].particles_per_cell = 0;
    EXPECT_THAT(problems(scene), ElementsAre("/bodies/0/particles_per_cell: must be at least 1"));
    scene.grid.cell = {0, 1, 0};
    EXPECT_THAT(problems(scene), ElementsAre(HasSubstr("/grid: needs cells larger than 0")));
}

TEST(BuildModel, ShapeTooSmallForParticles) {
    Scene scene = unit_scene(4);
    scene.bodies = {{"dot", "steel", {}, Disk{{1, 1, 0}, 0.1}, {}, 2}};
    EXPECT_THAT(
        problems(scene),
        ElementsAre("/bodies/0: body \"dot\" got no particles: it is too small for particles of 500 mm × 500 mm"));
}

TEST(BuildModel, BodiesPartlyOutsideTheGrid) {
    Scene scene = unit_scene(4);
    scene.bodies = {box("in", {0, 0, 0}, {4, 1, 0}), box("out", {3, 2, 0}, {5, 3, 0})};
    EXPECT_THAT(problems(scene),
                ElementsAre("/bodies/1: body \"out\" lies partly outside the grid: 4 of its 8 particles"));
}

TEST(BuildModel, OverlapOfShapeAndImage) {
    PictureScene test(two_grains);
    test.legend() = {grey(10, "left"), grey(20, "right"), grey(255, "")};
    test.scene.bodies = {box("lid", {0, 2.5, 0}, {4, 4, 0})};
    EXPECT_THAT(
        test.problems(),
        ElementsAre("/images/0/legend/0: body \"left\" claims a place that body \"lid\" has already (/bodies/0): "
                    "4 of its 24 particles coincide",
                    HasSubstr("/images/0/legend/1: body \"right\"")));
}

TEST(BuildModel, ImageThatCannotBeRead) {
    PictureScene test(two_grains);
    test.scene.images[0].file = "bad.png";
    const std::string path = (test.folder.path / "bad.png").string();
    EXPECT_THAT(test.problems(), ElementsAre("/images/0/file: image \"" + path + "\" does not exist"));
    EXPECT_THAT(::test::message_of([&] { test.model(); }), HasSubstr(test.name + ": /images/0/file: "));
}

TEST(BuildModel, AbsoluteImagePath) {
    PictureScene test(two_grains);
    test.legend() = {grey(10, "left"), grey(20, "right"), grey(255, "")};
    test.scene.images[0].file = test.folder.path / "bed.png";
    EXPECT_THAT(problems(test.scene, "elsewhere/scene.json"), ElementsAre());
}

TEST(BuildModel, ColoursThatNoEntryCovers) {
    PictureScene test(two_grains);
    test.legend() = {grey(10, "left")};
    EXPECT_THAT(test.problems(),
                ElementsAre("/images/0/legend: no entry covers grey 20 (6 pixels), grey 255 (4 pixels); "
                            "add entries, a tolerance to the ones there, or a \"grey_range\""));
    Image many{16, 1, 3, {}};
    for (int k = 0; k < 16; ++k)
        for (const int value : {200, 40, k < 5 ? 0 : k}) many.pixels.push_back(static_cast<std::uint8_t>(value));
    PictureScene colours(many);
    colours.scene.images[0].pixel = {0.25, 4};
    colours.legend() = {grey(10, "left")};
    EXPECT_THAT(colours.problems(),
                testing::Contains(HasSubstr("no entry covers #c82800 (5 pixels), #c82805 (1 pixel), ")));
    EXPECT_THAT(colours.problems(), testing::Contains(HasSubstr("#c8280b (1 pixel) and 4 more colours; add")));
}

TEST(BuildModel, ImageBodyWhoseColourIsAbsent) {
    PictureScene test(two_grains);
    test.legend() = {grey(10, "left"), grey(20, "right"), grey(255, ""), grey(40, "grain-07")};
    EXPECT_THAT(test.problems(),
                ElementsAre("/images/0/legend/3: body \"grain-07\" got no particles: no pixel of the image has its "
                            "colour grey 40"));
}

TEST(BuildModel, ImageBodyTooSmallForParticles) {
    Image image{40, 40, 1, std::vector<std::uint16_t>(1600, 255)};
    for (const int k : {820, 821, 860}) image.pixels[k] = 40; // 3 pixels of 0.1, particles of 0.5
    PictureScene test(image);
    test.scene.images[0].pixel = {0.1, 0.1};
    test.scene.bodies = {box("block", {0, 0, 0}, {1, 1, 0})};
    test.legend() = {grey(255, ""), grey(40, "grain-07")};
    EXPECT_THAT(
        test.problems(),
        ElementsAre("/images/0/legend/1: body \"grain-07\" got no particles: its colour grey 40 covers 3 pixels, "
                    "nowhere the largest part of a particle (500 mm × 500 mm)"));
    test.legend().push_back(grey(41, "grain-07"));
    EXPECT_THAT(test.problems(), ElementsAre(HasSubstr("its colours grey 40, grey 41 cover 3 pixels, nowhere")));
}

TEST(BuildModel, ImageBodySmallerThanACell) {
    PictureScene test(picture({{255, 255}, {7, 255}}));
    test.scene.images[0].pixel = {0.5, 1};
    test.legend() = {grey(255, ""), grey(7, "sliver")};
    EXPECT_THAT(test.problems(),
                ElementsAre("/images/0/legend/1: body \"sliver\" is smaller than a cell along x: 500 mm "
                            "against 1 m"));
}

TEST(BuildModel, ImageBeyondTheGrid) {
    PictureScene test(two_grains);
    test.legend() = {grey(10, "left"), grey(20, "right"), grey(255, "")};
    test.scene.images[0].lower = {0.5, 0, 0};
    EXPECT_THAT(test.problems(), ElementsAre()) << "half a pixel is fine";
    test.scene.images[0].lower = {0.6, 0, 0};
    EXPECT_THAT(test.problems(),
                ElementsAre("/images/0: the image reaches beyond the grid along x: it goes from 600 mm "
                            "to 4.6 m, the grid from 0 m to 4 m"));
    test.scene.images[0].lower = {0, -0.6, 0};
    EXPECT_THAT(test.problems(), ElementsAre(HasSubstr("beyond the grid along y: it goes from -600 mm to 3.4 m")));
}

TEST(BuildModel, ImageWithoutSize) {
    PictureScene test(two_grains);
    test.scene.images[0].pixel = {0, 0};
    EXPECT_THAT(test.problems(), ElementsAre("/images/0: needs \"pixel\", the size of a pixel, or \"size\", that of "
                                             "the whole image; the file itself has none"));
    test.scene.images[0].size = {4, 4};
    test.legend() = {grey(10, "left"), grey(20, "right"), grey(255, "")};
    EXPECT_EQ(test.model().size(), 48u);
}

TEST(BuildModel, ReportsAllProblemsTogether) {
    PictureScene test(two_grains);
    test.legend() = {grey(10, "left"), grey(255, ""), grey(30, "none", "wood")};
    test.scene.bodies = {box("out", {3, 3, 0}, {5, 4, 0})};
    EXPECT_THAT(test.problems(), ElementsAre("/images/0/legend/2/material: no material \"wood\"",
                                             HasSubstr("/images/0/legend: no entry"),
                                             HasSubstr("/images/0/legend/2: body \"none\" got no particles"),
                                             HasSubstr("/bodies/0: body \"out\" lies partly outside")));
}
