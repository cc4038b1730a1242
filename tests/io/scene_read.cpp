#include "scene_support.h"

#include <numbers>
#include <sstream>

namespace abut::scene_test {
namespace {

std::ostream& operator<<(std::ostream& out, const Vector& vector) {
    return out << vector[0] << ' ' << vector[1] << ' ' << vector[2];
}

std::ostream& operator<<(std::ostream& out, const TimeFunction& function) {
    for (std::size_t i = 0; i < function.time.size(); ++i) out << function.time[i] << ':' << function.value[i] << ' ';
    return out;
}

std::string describe(const ShapeSpec& shape) {
    std::ostringstream out;
    out << std::hexfloat;
    if (const Box* box = std::get_if<Box>(&shape))
        out << "box " << box->lower << ' ' << box->upper << ' ' << box->angle;
    if (const Disk* disk = std::get_if<Disk>(&shape)) out << "disk " << disk->center << ' ' << disk->radius;
    if (const Ring* ring = std::get_if<Ring>(&shape))
        out << "ring " << ring->center << ' ' << ring->inner_radius << ' ' << ring->outer_radius;
    if (const Polygon* polygon = std::get_if<Polygon>(&shape)) {
        out << "polygon";
        for (const PlanePoint& point : polygon->points) out << ' ' << point[0] << ' ' << point[1];
        for (const auto& hole : polygon->holes)
            for (const PlanePoint& point : hole) out << " hole " << point[0] << ' ' << point[1];
    }
    const auto placement = [&](const Placement& p) {
        out << p.scale << ' ' << p.axis << ' ' << p.angle << ' ' << p.translation;
    };
    if (const Path* path = std::get_if<Path>(&shape)) {
        out << "path " << path->file;
        placement(path->placement);
    }
    if (const Surface* surface = std::get_if<Surface>(&shape)) {
        out << "surface " << surface->file << surface->repair;
        placement(surface->placement);
    }
    if (const Ellipsoid* ellipsoid = std::get_if<Ellipsoid>(&shape))
        out << "ellipsoid " << ellipsoid->center << ellipsoid->semi_axes << ellipsoid->axis << ellipsoid->angle;
    if (const Cylinder* cylinder = std::get_if<Cylinder>(&shape))
        out << "cylinder " << cylinder->from << cylinder->to << cylinder->radius;
    if (const Cone* cone = std::get_if<Cone>(&shape))
        out << "cone " << cone->from << cone->to << cone->radius << ' ' << cone->top_radius;
    if (const Implicit* implicit = std::get_if<Implicit>(&shape))
        out << "implicit " << implicit->expression << implicit->unit << implicit->lower << implicit->upper;
    if (const Combination* combination = std::get_if<Combination>(&shape)) {
        out << "combination " << int(combination->operation);
        for (const std::string& name : combination->shapes) out << ' ' << name;
    }
    if (const NamedShape* named = std::get_if<NamedShape>(&shape)) out << "shape " << named->name;
    if (const Ball* ball = std::get_if<Ball>(&shape)) out << "ball " << ball->center << ' ' << ball->radius;
    if (const Ellipse* ellipse = std::get_if<Ellipse>(&shape))
        out << "ellipse " << ellipse->center << ' ' << ellipse->semi_axes[0] << ' ' << ellipse->semi_axes[1] << ' '
            << ellipse->angle;
    return out.str();
}

std::ostream& operator<<(std::ostream& out, const InitialVelocity& velocity) {
    out << velocity.value << ' ' << velocity.center;
    for (const Vector& row : velocity.gradient) out << ' ' << row;
    return out;
}

std::ostream& operator<<(std::ostream& out, const InitialState& state) {
    out << state.angular_velocity << state.temperature.value_or(-1) << state.orientation.value_or(-9);
    for (const double s : state.stress.value_or(std::array<double, 6>{})) out << ' ' << s;
    return out;
}

void describe(std::ostream& out, const ImageSpec& image) {
    out << image.file << ' ' << image.lower << image.first_row_is_up << image.slice.value_or(-1) << image.quarter_turns
        << image.turn_axis << int(image.bodies) << image.connectivity << ' ' << image.speckle << ' '
        << image.split.value_or(-1) << int(image.fill) << image.particles_per_cell;
    for (std::size_t a = 0; a < 3; ++a) out << ' ' << image.pixel[a] << ' ' << image.size[a] << image.flip[a];
    if (image.crop)
        for (const auto& [first, last] : *image.crop) out << ' ' << first << ':' << last;
    for (const auto& values : {image.temperature, image.orientation})
        if (values) out << ' ' << values->file << values->black << ' ' << values->white;
    out << '\n';
}

std::ostream& operator<<(std::ostream& out, const WallSpec& wall) {
    return out << "wall " << wall.axis << int(wall.side) << ' ' << wall.position << ' ' << wall.velocity << ' '
               << wall.depth << ' ' << wall.gradient << wall.estimated_gradient << wall.grip;
}

std::ostream& operator<<(std::ostream& out, const VelocitySpec& velocity) {
    return out << "velocity " << velocity.lower << velocity.upper << velocity.direction << velocity.velocity;
}

std::ostream& operator<<(std::ostream& out, const TractionSpec& traction) {
    out << "traction " << traction.body << traction.axis << int(traction.side) << ' ' << traction.pressure;
    if (traction.within) out << traction.within->lower << traction.within->upper;
    for (const TimeFunction& component : traction.traction) out << component;
    return out;
}

/// Every member of a scene with all its bits.
std::string describe(const Scene& s) {
    std::ostringstream out;
    out << std::hexfloat << s.title << '|' << int(s.analysis) << s.thickness << '|' << s.grid.cell << ' '
        << s.grid.lower << ' ' << s.grid.upper << '|' << s.time.end << ' ' << s.time.cfl << ' '
        << s.time.step.value_or(-1) << '|' << int(s.method.shape) << int(s.method.transfer.scheme)
        << s.method.transfer.order << ' ' << int(s.method.transfer.position.value_or(PositionUpdate(9))) << ' '
        << s.method.transfer.every_cfl.value_or(-1) << int(s.method.stress_update) << int(s.method.velocity_conditions)
        << int(s.method.deformation_increment) << '\n';
    for (const MaterialSpec& m : s.materials)
        out << m.name << ' ' << int(m.model) << ' ' << m.density << ' ' << m.bulk_modulus << ' ' << m.shear_modulus
            << '\n';
    for (const BodySpec& b : s.bodies)
        out << b.name << ' ' << b.material << ' ' << describe(b.shape) << ' ' << b.velocity << ' '
            << b.particles_per_cell << int(b.fill) << int(b.arrangement.value_or(Arrangement(9))) << b.state << '\n';
    for (const NamedShapeSpec& shape : s.shapes) out << shape.name << ' ' << describe(shape.shape) << '\n';
    out << int(s.overlap) << '\n';
    for (const ImageSpec& i : s.images) {
        describe(out, i);
        for (const LegendEntry& e : i.legend)
            out << e.rgb[0] << ' ' << e.rgb[1] << ' ' << e.rgb[2] << ' ' << e.grey << e.tolerance << e.is_void << e.body
                << ' ' << e.material << e.velocity << e.state
                << (e.grey_range ? (*e.grey_range)[0] * 100000 + (*e.grey_range)[1] : -1) << '\n';
    }
    if (s.contact) {
        out << int(s.contact->normal) << int(s.contact->separation) << ' ' << s.contact->offset << ' '
            << s.contact->exponent << int(s.contact->fit) << s.contact->direction << s.contact->corrections
            << int(s.contact->law.type) << s.contact->law.coefficient;
        for (const PairLawSpec& p : s.contact->laws)
            out << p.bodies[0] << p.bodies[1] << int(p.law.type) << p.law.coefficient << '\n';
    }
    for (const BoundarySpec& b : s.boundaries) {
        out << b.name << ' ';
        std::visit([&out](const auto& condition) { out << condition << '\n'; }, b.condition);
    }
    out << s.gravity << '|' << s.output.every << ' ' << s.output.history_every.value_or(-1) << s.output.particles.write
        << s.output.grid.write << s.output.contact.write;
    return out.str();
}

TEST(ReadScene, ExampleOfTheContract) {
    const SceneOnDisk disk(example);
    const Scene scene = load_scene(disk.file()).scene;
    EXPECT_EQ(scene.title, "Compaction of a packed bed");
    EXPECT_EQ(scene.grid.cell, (Vector{14.3e-6, 14.3e-6, 0}));
    EXPECT_EQ(scene.grid.upper, (Vector{1e-3, 2e-3, 0}));
    EXPECT_EQ(scene.time.end, 15e-6);
    EXPECT_EQ(scene.time.cfl, 0.4);
    EXPECT_FALSE(scene.time.step);
    EXPECT_EQ(scene.method.shape, ShapeKind::cpdi);
    EXPECT_EQ(scene.method.transfer.scheme, TransferScheme::xpic);
    EXPECT_EQ(scene.method.transfer.order, 5);
    EXPECT_EQ(scene.method.stress_update, StressUpdate::usl);

    ASSERT_EQ(scene.materials.size(), 2U);
    EXPECT_EQ(scene.materials[0].name, "aluminium");
    EXPECT_EQ(scene.materials[0].model, MaterialModel::neo_hookean_isochoric);
    EXPECT_EQ(scene.materials[0].density, 2780);
    EXPECT_EQ(scene.materials[0].bulk_modulus, 78.09e9);
    EXPECT_EQ(scene.materials[0].shear_modulus, 27.6e9);
    EXPECT_DOUBLE_EQ(scene.materials[1].shear_modulus, 80e9);

    ASSERT_EQ(scene.bodies.size(), 3U);
    EXPECT_EQ(std::get<Box>(scene.bodies[0].shape).upper, (Vector{1e-3, 0.5e-3, 0}));
    EXPECT_EQ(scene.bodies[0].velocity, (InitialVelocity{{8, 0, 0}}));
    EXPECT_EQ(scene.bodies[0].particles_per_cell, 2);
    EXPECT_EQ(std::get<Disk>(scene.bodies[1].shape).radius, 0.25e-3);
    EXPECT_EQ(std::get<Ellipse>(scene.bodies[2].shape).angle, std::numbers::pi / 6);
    EXPECT_EQ(scene.bodies[2].particles_per_cell, 3);
}

TEST(ReadScene, ExampleOfTheContractContinued) {
    const SceneOnDisk disk(example);
    const Scene scene = load_scene(disk.file()).scene;
    ASSERT_EQ(scene.images.size(), 2U);
    EXPECT_EQ(scene.images[0].file, disk.folder() / "bed.png");
    EXPECT_EQ(scene.images[0].pixel, (std::array{7.14e-6, 7.14e-6, 7.14e-6}));
    EXPECT_EQ(scene.images[0].size, (std::array{0.0, 0.0, 0.0}));
    EXPECT_TRUE(scene.images[0].first_row_is_up);
    const std::vector<LegendEntry>& legend = scene.images[0].legend;
    EXPECT_TRUE(legend[0].grey);
    EXPECT_EQ(legend[0].rgb, (std::array{40, 40, 40}));
    EXPECT_EQ(legend[1].rgb, (std::array{0xd0, 0x40, 0x20}));
    EXPECT_EQ(legend[1].tolerance, 6);
    EXPECT_EQ(legend[1].velocity, (Vector{0, -1, 0}));
    EXPECT_TRUE(legend[2].is_void);
    EXPECT_EQ(scene.images[1].file, "/data/top.png");
    EXPECT_EQ(scene.images[1].size, (std::array{1e-3, 0.5e-3, 0.0}));
    EXPECT_FALSE(scene.images[1].first_row_is_up);

    ASSERT_TRUE(scene.contact);
    EXPECT_EQ(scene.contact->separation, SeparationMethod::critical_position);
    EXPECT_EQ(scene.contact->offset, 0.7);
    EXPECT_EQ(scene.contact->law.type, LawType::friction);
    EXPECT_EQ(scene.contact->law.coefficient, 0.2);
    ASSERT_EQ(scene.contact->laws.size(), 1U);
    EXPECT_EQ(scene.contact->laws[0].bodies, (std::array<std::string, 2>{"block", "ball"}));
    EXPECT_EQ(scene.contact->laws[0].law.type, LawType::perfect);

    ASSERT_EQ(scene.boundaries.size(), 2U);
    EXPECT_EQ(scene.boundaries[1].name, "piston");
    const WallSpec& piston = std::get<WallSpec>(scene.boundaries[1].condition);
    EXPECT_EQ(piston.axis, 1);
    EXPECT_EQ(piston.side, Side::upper);
    EXPECT_EQ(piston.velocity.at(0), -100);
    EXPECT_TRUE(piston.velocity.is_constant());
    EXPECT_EQ(piston.gradient.at(0), 3);
    EXPECT_FALSE(piston.estimated_gradient);
    EXPECT_FALSE(piston.grip);
    EXPECT_EQ(scene.gravity, (Vector{0, -9.81, 0}));
    EXPECT_EQ(scene.output.every, 0.5e-6);
    EXPECT_EQ(scene.output.history_every, 10e-9);
}

const std::string smallest = R"({
  "grid": { "cell": [0.1, 0.2], "lower": [0, 0], "upper": [1, 1] },
  "time": { "end": 1 },
  "materials": { "m": { "model": "neo-hookean", "density": 1, "bulk_modulus": 1, "shear_modulus": 1 } },
  "bodies": [ { "name": "b", "material": "m", "box": { "lower": [0, 0], "upper": [1, 1] } } ]
})";

TEST(ReadScene, TurnedBoxes) {
    const std::string upright = smallest.substr(0, smallest.find("\"bodies\"")) + R"("bodies": [
        { "name": "b", "material": "m", "box": { "lower": [0.3, 0.4], "upper": [0.7, 0.6], "angle": "30 deg" } } ] })";
    EXPECT_EQ(std::get<Box>(load(upright).scene.bodies[0].shape).angle, std::numbers::pi / 6);
}

TEST(ReadScene, DefaultsAreThoseOfSceneH) {
    const Scene scene = load(smallest).scene;
    Scene expected;
    expected.grid = {{0.1, 0.2, 0}, {0, 0, 0}, {1, 1, 0}};
    expected.time.end = 1;
    expected.materials = {{"m", MaterialModel::neo_hookean, 1, 1, 1}};
    expected.bodies = {{"b", "m", {}, Box{{0, 0, 0}, {1, 1, 0}}, {}, 2}};
    EXPECT_EQ(describe(scene), describe(expected));

    const Scene with_contact = load(smallest, {"/contact={}"}).scene;
    expected.contact.emplace();
    EXPECT_EQ(describe(with_contact), describe(expected));
}

TEST(ReadScene, ResolvedSceneIsTheSameScene) {
    for (const std::string& text : {example, smallest, example_3d, example_axisymmetric, example_models, example_solids,
                                    changed("/time", R"({"end": "15 us", "step": "1 ns"})")}) {
        const SceneOnDisk disk(text);
        const LoadedScene loaded = load_scene(disk.file());
        const LoadedScene again = load(loaded.resolved); // in another folder
        EXPECT_EQ(describe(again.scene), describe(loaded.scene));
        EXPECT_EQ(again.resolved, loaded.resolved);
    }
}

TEST(ReadScene, ResolvedSceneHasNumbersDefaultsOverridesAndVersion) {
    const Json resolved = parsed(load(example, {"/thickness=2 mm", "/title=new"}).resolved);
    EXPECT_EQ(resolved.begin().key(), "abut_version");
    EXPECT_EQ(resolved["title"], "new");
    EXPECT_EQ(resolved["thickness"], 2e-3);
    EXPECT_EQ(resolved["materials"]["aluminium"]["density"], 2780.0);
    EXPECT_EQ(resolved["boundaries"][0]["wall"]["grip"], true);
    EXPECT_EQ(resolved["bodies"][1]["velocity"], Json::array({0.0, 0.0}));
    EXPECT_FALSE(resolved["time"].contains("step"));
    EXPECT_FALSE(parsed(load(changed("/time", R"({"end": "15 us", "step": 1e-9})")).resolved)["time"].contains("cfl"));
    EXPECT_TRUE(std::filesystem::path(resolved["images"][0]["file"].get<std::string>()).is_absolute());
}

TEST(ReadScene, EditorsMayNameTheSchema) {
    const Json resolved = parsed(load(changed("/$schema", R"("../scene.schema.json")")).resolved);
    EXPECT_FALSE(resolved.contains("$schema"));
}

TEST(ReadScene, MissingFile) {
    try {
        load_scene("/nowhere/scene.json");
        FAIL();
    } catch (const SceneError& error) {
        ASSERT_EQ(error.problems().size(), 1U);
        EXPECT_EQ(error.problems()[0].pointer, "");
        EXPECT_THAT(error.what(), testing::StartsWith("/nowhere/scene.json: cannot read the scene file: No such file"));
    }
    EXPECT_THROW(load_scene("/tmp"), SceneError);
}

TEST(ReadScene, SyntaxErrorsHaveLineAndColumn) {
    using testing::ElementsAre;
    EXPECT_THAT(problems_of("{\n  \"title\": \"a\",\n}"),
                ElementsAre(IsProblem("", "syntax error at line 3, column 1:")));
    EXPECT_THAT(problems_of("{ \"title\" \"a\" }"), ElementsAre(IsProblem("", "syntax error at line 1, column 13:")));
    EXPECT_THAT(problems_of(""), ElementsAre(IsProblem("", "syntax error at line 1, column 1:")));
    EXPECT_THAT(problems_of("{"), ElementsAre(IsProblem("", "end of input")));
    EXPECT_THAT(problems_of("{} {}"), ElementsAre(IsProblem("", "syntax error at line 1, column 4:")));
    EXPECT_THAT(problems_of("{\"thickness\": 1e999}"), ElementsAre(IsProblem("", "syntax error at line 1")));
    EXPECT_THAT(problems_of("{\"thickness\": NaN}"), ElementsAre(IsProblem("", "syntax error at line 1")));
    EXPECT_THAT(problems_of("{\"title\": \"\xff\"}"), ElementsAre(IsProblem("", "syntax error at line 1")));
    EXPECT_THAT(problems_of("{} /* open"), ElementsAre(IsProblem("", "syntax error at line 1")));
    EXPECT_THAT(problems_of("[]"), ElementsAre(IsProblem("", "an object { } is needed, not a list")));
    EXPECT_THAT(problems_of("3", {"/title=a"}), ElementsAre(IsProblem("", "an object { } is needed, not 3")));
}

TEST(ReadScene, RepeatedKeys) {
    std::string text = example;
    text.replace(text.find("\"model\": \"neo-hookean\","), 0, "\"density\": 1, ");
    text.replace(text.find("\"name\": \"ball\""), 0, "\"name\": [{\"x\": 1, \"x\": 2}], ");
    EXPECT_THAT(problems_of(text), testing::IsSupersetOf({IsProblem("/materials/steel/density", "given twice"),
                                                          IsProblem("/bodies/1/name", "given twice"),
                                                          IsProblem("/bodies/1/name/0/x", "given twice")}));
}

} // namespace
} // namespace abut::scene_test
