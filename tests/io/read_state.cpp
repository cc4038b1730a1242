/// States from frames: what they tell of contacts is what the run found.

#include "io/results/read_state.h"
#include "contact_clouds_support.h"
#include "io/results/read_frame.h"
#include "io/results/write_frame.h"

#include <cmath>
#include <gmock/gmock.h>

namespace abut::test {
namespace {

using testing::HasSubstr;

template <int D>
void check_state_from_frame(const Choice& choice) {
    const TemporaryFolder folder;
    State<D> state = pressed<D>(choice);
    write_particles(folder / "p.vtu", particle_frame(state));
    State<D> again = read_state<D>(state.scene, read_points(folder / "p.vtu", arrays_of_state()));
    look(again);
    EXPECT_EQ(again.time, state.time);
    EXPECT_EQ(again.step, 12);
    const PointFrame expected = contact_frame(state);
    const PointFrame found = contact_frame(again);
    ASSERT_FALSE(expected.points.empty());
    EXPECT_EQ(found.points, expected.points);
    for (std::size_t i = 0; i < expected.arrays.size(); ++i) {
        const std::string& name = expected.arrays[i].name;
        if (name == "force" || name == "in_contact") continue; // of the last step
        if (const auto* reals = std::get_if<std::vector<double>>(&expected.arrays[i].values)) {
            const auto& others = std::get<std::vector<double>>(found.arrays[i].values);
            ASSERT_EQ(others.size(), reals->size());
            for (std::size_t k = 0; k < reals->size(); ++k)
                if (std::isfinite((*reals)[k]))
                    EXPECT_NEAR(others[k], (*reals)[k], 1e-12) << name;
                else
                    EXPECT_EQ(others[k], (*reals)[k]) << name;
        } else {
            EXPECT_EQ(found.arrays[i].values, expected.arrays[i].values) << name;
        }
    }
    for (std::size_t p = 0; p < state.particles.size(); ++p) { // masses are what extrapolated positions hang on
        const auto id = static_cast<std::size_t>(state.particles.id[p]);
        const auto q = std::find(again.particles.id.begin(), again.particles.id.end(), id) - again.particles.id.begin();
        EXPECT_NEAR(again.particles.mass[q], state.particles.mass[p], 1e-14 * state.particles.mass[p]);
        EXPECT_NEAR(again.particles.volume[q], state.particles.volume[p], 1e-14 * state.particles.volume[p]);
    }
}

TEST(ReadState, FindsTheContactsOfTheRun) {
    for (const NormalMethod normal :
         {NormalMethod::logistic_regression, NormalMethod::average_gradient, NormalMethod::own_gradient})
        for (const SeparationMethod separation : {SeparationMethod::particle_edges, SeparationMethod::fitted_position,
                                                  SeparationMethod::displacement, SeparationMethod::none})
            check_state_from_frame<2>({Analysis::plane_strain, false, normal, separation});
}
TEST(ReadState, FindsThemInEveryAnalysis) {
    for (const Analysis analysis : {Analysis::plane_stress, Analysis::axisymmetric})
        check_state_from_frame<2>({analysis, false, NormalMethod::average_gradient, SeparationMethod::fitted_position});
    check_state_from_frame<3>({});
}
TEST(ReadState, FindsThemAtRigidBodies) {
    check_state_from_frame<2>(
        {Analysis::plane_strain, true, NormalMethod::average_gradient, SeparationMethod::fitted_position});
    check_state_from_frame<3>({Analysis::three_d, true});
}

TEST(ReadState, KnowsBodiesOfImagesByTheirGroups) {
    State<2> state = pressed<2>();
    const PointFrame frame = [&] {
        PointFrame f = particle_frame(state);
        f.words[0].values = {"grain-001", "grain-big-002", "upper"};
        return f;
    }();
    Scene scene = state.scene;
    scene.bodies = {body_spec("upper", false)};
    scene.materials.push_back(scene.materials[0]);
    scene.materials[1].name = "hard";
    scene.materials[1].density = 7;
    ImageSpec image;
    image.bodies = BodiesBy::component;
    for (const char* name : {"grain", "grain-big"}) {
        LegendEntry entry;
        entry.body = name;
        entry.material = image.legend.empty() ? "solid" : "hard";
        image.legend.push_back(entry);
    }
    scene.images = {image};
    const State<2> read = read_state<2>(scene, frame);
    EXPECT_EQ(read.bodies[0].group, "grain");
    EXPECT_EQ(read.bodies[1].group, "grain-big");
    EXPECT_EQ(read.bodies[1].material, 1);
    EXPECT_EQ(read.bodies[2].group, "");
    EXPECT_EQ(read.bodies[2].material, 0);
}

TEST(ReadState, SaysWhatIsMissing) {
    State<2> state = pressed<2>();
    const PointFrame good = particle_frame(state);
    const auto error = [&](const Scene& scene, const PointFrame& frame) {
        return error_of([&] { read_state<2>(scene, frame); });
    };
    for (const std::string& name : arrays_of_state()) {
        PointFrame frame = good;
        std::erase_if(frame.arrays, [&](const Array& array) { return array.name == name; });
        EXPECT_THAT(error(state.scene, frame), HasSubstr("no array \"" + name + "\""));
    }
    Scene some = state.scene;
    some.output.bodies = {"left"};
    EXPECT_THAT(error(some, good), HasSubstr("only the particles of some bodies were written"));
    PointFrame cut = good;
    for (Array& array : cut.arrays)
        std::visit([&](auto& values) { values.erase(values.begin(), values.begin() + array.components); },
                   array.values);
    cut.points.erase(cut.points.begin(), cut.points.begin() + 3);
    EXPECT_THAT(error(state.scene, cut), HasSubstr("doesn't hold all particles"));
    PointFrame unnamed = good;
    unnamed.words.clear();
    EXPECT_THAT(error(state.scene, unnamed), HasSubstr("body_names"));
    PointFrame other = good;
    other.words[0].values[0] = "elsewhere";
    EXPECT_THAT(error(state.scene, other), HasSubstr("a body \"elsewhere\" that the scene doesn't have"));
}

} // namespace
} // namespace abut::test
