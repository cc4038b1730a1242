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
        bool clouds, regression, gradients, positions, displacements = false;
    };
    using N = NormalMethod;
    using S = SeparationMethod;
    for (const Row& row : {Row{N::logistic_regression, S::particle_edges, true, true, false, false},
                           Row{N::logistic_regression, S::critical_position, true, true, false, true},
                           Row{N::logistic_regression, S::none, true, true, false, false},
                           Row{N::average_gradient, S::particle_edges, true, false, true, false},
                           Row{N::average_gradient, S::fitted_position, false, false, true, true},
                           Row{N::average_gradient, S::none, false, false, true, false},
                           Row{N::linear_regression, S::displacement, true, true, false, false, true},
                           Row{N::irls_regression, S::fitted_position, true, true, false, true},
                           Row{N::maximum_gradient, S::particle_edges, true, false, true, false},
                           Row{N::maximum_volume, S::displacement, false, false, true, false, true},
                           Row{N::own_gradient, S::critical_position, false, false, true, true},
                           Row{N::specified, S::particle_edges, true, false, false, false},
                           Row{N::specified, S::displacement, false, false, false, false, true},
                           Row{N::specified, S::none, false, false, false, false}}) {
        Scene scene = bare();
        scene.output.pairs = false;
        scene.contact = contact(LawType::frictionless);
        scene.contact->normal = row.normal;
        scene.contact->separation = row.separation;
        const Effects e = effects_of(scene);
        EXPECT_TRUE(e.contact);
        EXPECT_EQ(e.clouds, row.clouds);
        EXPECT_EQ(e.regression, row.regression);
        EXPECT_EQ(e.gradients, row.gradients);
        EXPECT_EQ(e.positions, row.positions);
        EXPECT_EQ(e.displacements, row.displacements);
        EXPECT_EQ(e.volumes, row.normal == N::maximum_volume);
        EXPECT_TRUE(e.planes);
        const auto names = task_names(scene);
        EXPECT_EQ(any_contains(names, "point clouds"), row.clouds);
        EXPECT_EQ(any_contains(names, "contact fields"), row.gradients || row.positions || row.displacements);
        EXPECT_TRUE(any_contains(names, "find normals") && any_contains(names, "find separations"));
        const auto fields = field_names(scene);
        EXPECT_EQ(any_contains(fields, "point cloud"), row.clouds);
        EXPECT_EQ(any_contains(fields, "volume gradient"), row.gradients);
        EXPECT_EQ(any_contains(fields, "mass times position"), row.positions);
        EXPECT_EQ(any_contains(fields, "mass times displacement"), row.displacements);
    }
}

TEST(Plan, LawsAndRigidBodiesPayForWhatTheyNeed) {
    Scene scene = bare();
    scene.contact = contact(LawType::friction, 0.2);
    EXPECT_TRUE(any_contains(task_names(scene), "contact areas")) << "for pairs.csv, now and then";
    EXPECT_FALSE(any_contains(field_names(scene), "volume gradient"));
    scene.output.pairs = false;
    for (const LawType type : {LawType::frictionless, LawType::friction, LawType::stick}) {
        scene.contact->law.type = type;
        EXPECT_FALSE(any_contains(task_names(scene), "contact areas"));
        EXPECT_FALSE(any_contains(task_names(scene), "contact fields"));
    }
    for (const LawType type : {LawType::viscous_friction, LawType::adhesion}) {
        scene.contact->law.type = type;
        EXPECT_TRUE(effects_of(scene).areas && !effects_of(scene).displacements);
        EXPECT_TRUE(any_contains(task_names(scene), "contact areas"));
        EXPECT_FALSE(any_contains(field_names(scene), "displacement of bodies") ||
                     any_contains(field_names(scene), "mass times displacement"));
    }
    for (const LawType type : {LawType::linear_interface, LawType::bilinear_interface, LawType::cohesive_interface}) {
        scene.contact->law = {};
        scene.contact->laws = {{{"a", "b"}, {type, 0}}};
        EXPECT_TRUE(effects_of(scene).areas && effects_of(scene).displacements && effects_of(scene).interfaces);
        EXPECT_TRUE(any_contains(field_names(scene), "mass times displacement"));
    }
    EXPECT_FALSE(any_contains(task_names(scene), "rigid"));
    scene.bodies.emplace_back().rigid = RigidSpec{};
    EXPECT_TRUE(any_contains(task_names(scene), "move rigid bodies"));
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
    EXPECT_FALSE(any_contains(task_names(scene), "condition") || any_contains(task_names(scene), "controlled"));
    EXPECT_FALSE(any_contains(task_names(scene), "works"));
    scene.gravity = {0, -9.81, 0};
    EXPECT_TRUE(effects_of(scene).gravity);
    EXPECT_THAT(task_names(scene), Contains(HasSubstr("works")));
    scene.gravity = {};
    add_wall(scene, "floor", 1, Side::lower, 1);
    EXPECT_TRUE(any_contains(task_names(scene), "impose conditions") && any_contains(task_names(scene), "works"));
    EXPECT_TRUE(any_contains(task_names(scene), "find controlled nodes"));
    EXPECT_THAT(task_names(scene), Not(Contains(HasSubstr("stencils"))));
    scene.method.shape = ShapeKind::cpdi;
    EXPECT_THAT(task_names(scene), Contains(HasSubstr("stencils")));
}

template <int D>
State<D> run_once(const std::function<void(Scene&)>& change) {
    const MaterialSpec m = material(1, 10, 3);
    Scene scene = D == 2 ? plane_scene(1, 0, 0, 8, 8, m) : space_scene(1, 0, 8, m);
    scene.method.shape = ShapeKind::ugimp;
    change(scene);
    Model model;
    const int a = add_body(model, "a");
    if (D == 2)
        add_box(model, a, 2, 2, 4, 4, 4, 4);
    else
        add_cube(model, a, {2, 2, 2}, 2, 4);
    State<D> state = make_state<D>(scene, model);
    run(state, 0.2);
    EXPECT_GT(state.step, 0);
    return state;
}

template <int D>
void check_bare_arrays() {
    const State<D> state = run_once<D>([](Scene&) {});
    EXPECT_TRUE(state.particles.across.empty());
    EXPECT_TRUE(state.nodes.traction.empty() && state.nodes.filtered.empty() && state.nodes.round_trip.empty());
    EXPECT_TRUE(state.nodes.delta_velocity.empty());
    EXPECT_TRUE(state.controls.empty() && state.boundaries.empty() && state.traction_faces.empty());
    EXPECT_TRUE(state.stencil_store.first.empty() && state.stencil_store.S.empty() && state.stencil_store.T.empty());
    EXPECT_TRUE(state.contact.points.empty());
    for (const Particles<D>& p = state.particles;
         const std::size_t size :
         {p.position.size(), p.velocity.size(), p.deformation_gradient.size(), p.stress.size(), p.volume.size()})
        EXPECT_EQ(size, D == 2 ? 16u : 64u);
}

TEST(Plan, WhatASceneDoesNotUseCostsNoArray) {
    check_bare_arrays<2>();
    check_bare_arrays<3>();
    // A tensor of 3D has six components, a particle three coordinates.
    EXPECT_EQ(sizeof(Stress<2>), 4 * sizeof(double));
    EXPECT_EQ(sizeof(Stress<3>), 6 * sizeof(double));
    EXPECT_EQ(bytes_per_particle<2>(), (3 * 2 + 4 + 4 + 2) * sizeof(double) + 8);
    EXPECT_EQ(bytes_per_particle<3>(), (3 * 3 + 9 + 6 + 2) * sizeof(double) + 8);
}

TEST(Plan, EachArrayHasItsCause) {
    using Change = std::function<void(Scene&)>;
    const Change stress = [](Scene& s) { s.analysis = Analysis::plane_stress; };
    const Change ring = [](Scene& s) { s.analysis = Analysis::axisymmetric; };
    const Change fmpm = [](Scene& s) { s.method.transfer = transfer(TransferScheme::fmpm, 2); };
    const Change pull = [](Scene& s) {
        TractionSpec t;
        t.body = "a";
        t.pressure = 1.0;
        s.boundaries.push_back({"pull", t});
    };
    EXPECT_EQ(run_once<2>(stress).particles.across.size(), 16u);
    EXPECT_TRUE(run_once<2>(stress).stencil_store.S.empty()) << "plane stress has no hoop terms";
    const State<2> rings = run_once<2>(ring);
    EXPECT_EQ(rings.particles.across.size(), 16u);
    EXPECT_EQ(rings.stencil_store.T.size(), rings.stencil_store.S.size());
    EXPECT_FALSE(rings.stencil_store.T.empty());
    EXPECT_TRUE(run_once<2>([](Scene& s) { s.method.shape = ShapeKind::b2cpdi; }).stencil_store.T.empty());
    EXPECT_EQ(run_once<2>(fmpm).nodes.filtered.size(), run_once<2>(fmpm).fields.size());
    EXPECT_TRUE(run_once<2>(fmpm).nodes.delta_velocity.empty());
    EXPECT_TRUE(run_once<3>(fmpm).nodes.traction.empty());
    const State<3> pulled = run_once<3>(pull);
    EXPECT_EQ(pulled.nodes.traction.size(), pulled.fields.size());
    EXPECT_EQ(pulled.traction_faces.size(), 16u);
    EXPECT_TRUE(pulled.controls.empty());
    EXPECT_TRUE(
        run_once<2>([](Scene& s) { s.method.transfer = transfer(TransferScheme::fmpm, 1); }).nodes.filtered.empty())
        << "order 1 has no full mass matrix";
}

/// Arrays that fields.h announces to the user of `abut check`.
TEST(Plan, FieldsAndTasksFollowTheNewEffects) {
    Scene scene = bare();
    EXPECT_FALSE(any_contains(field_names(scene), "stretch across") || any_contains(field_names(scene), "filtered"));
    scene.analysis = Analysis::plane_stress;
    EXPECT_TRUE(effects_of(scene).free_across);
    EXPECT_TRUE(any_contains(field_names(scene), "stretch across"));
    scene.analysis = Analysis::axisymmetric;
    EXPECT_TRUE(effects_of(scene).ring && effects_of(scene).velocity_conditions && effects_of(scene).stored_stencils);
    EXPECT_TRUE(any_contains(task_names(scene), "find controlled nodes"));
    EXPECT_TRUE(any_contains(field_names(scene), "stretch across") &&
                any_contains(field_names(scene), "shape functions"));

    scene = bare();
    scene.method.transfer = transfer(TransferScheme::fmpm, 3);
    EXPECT_TRUE(effects_of(scene).fmpm);
    EXPECT_EQ(effects_of(scene).extra_orders, 2);
    EXPECT_TRUE(any_contains(task_names(scene), "filter velocities") && any_contains(field_names(scene), "filtered"));
    EXPECT_FALSE(any_contains(task_names(scene), "choose transfer"));
    scene.method.transfer.every_cfl = 1.0;
    EXPECT_TRUE(any_contains(task_names(scene), "choose transfer"));
    scene.method.transfer.scheme = TransferScheme::flip;
    EXPECT_FALSE(any_contains(task_names(scene), "choose transfer") || any_contains(task_names(scene), "filter"));

    for (const StressUpdate update : {StressUpdate::usf, StressUpdate::usavg, StressUpdate::usl, StressUpdate::usl_plus,
                                      StressUpdate::usavg_plus}) {
        scene = bare();
        scene.method.stress_update = update;
        const auto names = task_names(scene);
        const bool again = update == StressUpdate::usl_plus || update == StressUpdate::usavg_plus;
        const bool first = update != StressUpdate::usl && update != StressUpdate::usl_plus;
        EXPECT_EQ(any_contains(names, "update stress again"), again);
        EXPECT_EQ(any_contains(names, "extrapolate forces"), first);
        EXPECT_EQ(any_contains(names, "store stencils"), again);
        EXPECT_EQ(any_contains(names, "particles and stress"),
                  update == StressUpdate::usl || update == StressUpdate::usavg);
        const bool both = update == StressUpdate::usavg || update == StressUpdate::usavg_plus;
        EXPECT_EQ(effects_of(scene).stress_share(), both ? 0.5 : 1.0);
    }

    scene = bare();
    TractionSpec t;
    t.body = "a";
    scene.boundaries.push_back({"pull", t});
    EXPECT_TRUE(effects_of(scene).tractions);
    EXPECT_FALSE(effects_of(scene).velocity_conditions);
    EXPECT_TRUE(any_contains(task_names(scene), "apply tractions"));
    EXPECT_FALSE(any_contains(task_names(scene), "impose"));
    EXPECT_TRUE(any_contains(field_names(scene), "traction")) << "an array by slot that abut check should list";
}

} // namespace
