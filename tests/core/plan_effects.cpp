#include "support.h"

#include "plan/effects.h"
#include "plan/fields.h"

#include <gmock/gmock.h>

namespace {

using namespace test;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

std::vector<std::string> task_names(const Scene& scene) {
    std::vector<std::string> names;
    for (const auto& task : step_tasks<2>(scene)) {
        names.push_back(task.name);
        EXPECT_FALSE(task.reason.empty()) << task.name;
    }
    return names;
}

std::vector<std::string> field_names(const Scene& scene) {
    std::vector<std::string> names;
    for (const Field& field : fields_of<2>(effects_of(scene))) {
        names.push_back(field.name);
        EXPECT_FALSE(field.reason.empty()) << field.name;
        EXPECT_GT(field.bytes_each, 0u) << field.name;
    }
    return names;
}

Scene bare() {
    Scene scene = plane_scene(1, 0, 0, 8, 8, material(1, 10, 3));
    scene.method.shape = ShapeKind::ugimp;
    return scene;
}

bool any_contains(const std::vector<std::string>& names, const std::string& part) {
    for (const std::string& name : names)
        if (name.find(part) != std::string::npos) return true;
    return false;
}

TEST(Plan, ASingleBodyPaysForNothingElse) {
    EXPECT_THAT(task_names(bare()), ElementsAre("find velocity fields", "extrapolate momenta and forces",
                                                "find velocities", "update momenta", "update particles and stress"));
    for (const char* word : {"contact", "cloud", "normal", "gradient of", "filter", "change", "bodies, normal"})
        EXPECT_FALSE(any_contains(field_names(bare()), word)) << word;
}

TEST(Plan, ASceneWithoutContactKeepsNoContactStorage) {
    Scene scene = bare();
    Model model;
    add_box(model, add_body(model, "a"), 2, 2, 4, 4, 4, 4);
    add_box(model, add_body(model, "b"), 3, 3, 5, 5, 4, 4);
    State<2> state = make_state<2>(scene, model);
    run(state, 0.2);
    EXPECT_TRUE(state.fields.contact_nodes.empty());
    EXPECT_TRUE(state.contact.groups.empty() && state.contact.points.empty() && state.contact.cloud_particles.empty());
    EXPECT_TRUE(state.contact.volume_gradient.empty() && state.contact.mass_position.empty());
    EXPECT_TRUE(state.nodes.delta_velocity.empty() && state.nodes.filtered.empty());
    EXPECT_TRUE(state.stencil_store.slot.empty());
}

TEST(Plan, PerfectInterfacesNeedNeitherNormalsNorClouds) {
    Scene scene = bare();
    scene.contact = contact(LawType::perfect);
    scene.contact->laws.push_back({{"a", "b"}, {LawType::perfect, 0}});
    const auto names = task_names(scene);
    EXPECT_FALSE(any_contains(names, "cloud") || any_contains(names, "normals"));
    EXPECT_TRUE(any_contains(names, "first contact pass") && any_contains(names, "second contact pass"));
    EXPECT_FALSE(any_contains(field_names(scene), "cloud"));
    scene.contact->laws[0].law.type = LawType::stick;
    EXPECT_TRUE(any_contains(task_names(scene), "cloud"));
    EXPECT_TRUE(any_contains(task_names(scene), "normals"));
}

TEST(Plan, EachEffectHasItsCause) {
    struct Row {
        NormalMethod normal;
        SeparationMethod separation;
        bool clouds, regression, gradients, positions;
    };
    using N = NormalMethod;
    using S = SeparationMethod;
    for (const Row& row : {Row{N::logistic_regression, S::particle_edges, true, true, false, false},
                           Row{N::logistic_regression, S::critical_position, true, true, false, true},
                           Row{N::logistic_regression, S::none, true, true, false, false},
                           Row{N::average_gradient, S::particle_edges, true, false, true, false},
                           Row{N::average_gradient, S::fitted_position, false, false, true, true},
                           Row{N::average_gradient, S::none, false, false, true, false}}) {
        Scene scene = bare();
        scene.contact = contact(LawType::frictionless);
        scene.contact->normal = row.normal;
        scene.contact->separation = row.separation;
        const Effects e = effects_of(scene);
        EXPECT_TRUE(e.contact);
        EXPECT_EQ(e.clouds, row.clouds);
        EXPECT_EQ(e.regression, row.regression);
        EXPECT_EQ(e.gradients, row.gradients);
        EXPECT_EQ(e.positions, row.positions);
        const auto names = task_names(scene);
        EXPECT_EQ(any_contains(names, "point clouds"), row.clouds);
        EXPECT_EQ(any_contains(names, "contact fields"), row.gradients || row.positions);
        const auto fields = field_names(scene);
        EXPECT_EQ(any_contains(fields, "point cloud"), row.clouds);
        EXPECT_EQ(any_contains(fields, "volume gradient"), row.gradients);
        EXPECT_EQ(any_contains(fields, "mass times position"), row.positions);
    }
}

TEST(Plan, FilterAndItsContactTermFollowSchemeOrderAndCorrections) {
    for (int order : {1, 2, 5}) {
        Scene scene = bare();
        scene.method.transfer = transfer(TransferScheme::xpic, order);
        EXPECT_EQ(effects_of(scene).extra_orders, order - 1);
        EXPECT_EQ(any_contains(task_names(scene), "filter"), order > 1);
        EXPECT_FALSE(effects_of(scene).delta_velocity);
        scene.contact = contact(LawType::frictionless);
        EXPECT_EQ(effects_of(scene).delta_velocity, order > 1);
        scene.contact->corrections = 1;
        EXPECT_FALSE(effects_of(scene).delta_velocity);
        EXPECT_FALSE(any_contains(task_names(scene), "first contact pass"));
        scene.method.transfer.scheme = TransferScheme::flip;
        scene.contact->corrections = 2;
        EXPECT_EQ(effects_of(scene).extra_orders, 0);
        EXPECT_FALSE(effects_of(scene).delta_velocity);
    }
}

TEST(Plan, StressUpdateWallsGravityAndStencils) {
    Scene scene = bare();
    scene.method.stress_update = StressUpdate::usf;
    EXPECT_THAT(task_names(scene),
                ElementsAre("find velocity fields", "extrapolate momenta", "find velocities", "update stress",
                            "extrapolate forces", "update momenta", "update particles"));
    scene = bare();
    EXPECT_FALSE(any_contains(task_names(scene), "wall"));
    EXPECT_FALSE(any_contains(task_names(scene), "works"));
    scene.gravity = {0, -9.81, 0};
    EXPECT_TRUE(effects_of(scene).gravity);
    EXPECT_THAT(task_names(scene), Contains(HasSubstr("works")));
    scene.gravity = {};
    add_wall(scene, "floor", 1, Side::lower, 1);
    EXPECT_TRUE(any_contains(task_names(scene), "wall") && any_contains(task_names(scene), "works"));
    EXPECT_THAT(task_names(scene), Not(Contains(HasSubstr("stencils"))));
    scene.method.shape = ShapeKind::cpdi;
    EXPECT_THAT(task_names(scene), Contains(HasSubstr("stencils")));
}

} // namespace
