/// Bodies whose motion is prescribed (notes 4.2.4).

#include "support.h"

#include "boundary/rigid_body.h"
#include "results/frames.h"

namespace {

using namespace test;

int add_rigid(Model& model, const std::string& name, const RigidSpec& rigid) {
    model.bodies.push_back({name, -1, {}, rigid});
    return static_cast<int>(model.bodies.size()) - 1;
}

/// A scene must say that it has rigid bodies: the model alone can't.
void declare_rigid(Scene& scene, const RigidSpec& rigid) {
    BodySpec body;
    body.rigid = rigid;
    scene.bodies.push_back(body);
}

TEST(RigidBodies, MoveAsPrescribed) {
    RigidSpec rigid;
    rigid.velocity = {TimeFunction({0, 2}, {0, 4}), TimeFunction(-1), TimeFunction(0)};
    rigid.angular_velocity = TimeFunction({0, 1}, {0, 3});
    rigid.center = Vector{1, 2, 0};
    const RigidPose pose = rigid_pose(rigid, 1);
    EXPECT_EQ(pose.center, (Vec<3>{2, 1, 0})) << "∫ 2t dt = 1";
    const double angle = 1.5; // ∫ 3t dt
    const Vector x = pose.position_of({3, 2, 0});
    EXPECT_NEAR(x[0], 2 + 2 * std::cos(angle), 1e-14);
    EXPECT_NEAR(x[1], 1 + 2 * std::sin(angle), 1e-14);
    const Vector v = pose.velocity_at(x);
    EXPECT_NEAR(v[0], 2 - 3 * 2 * std::sin(angle), 1e-14);
    EXPECT_NEAR(v[1], -1 + 3 * 2 * std::cos(angle), 1e-14);
    // About another axis in 3D.
    rigid.axis = {0, -2, 0};
    EXPECT_NEAR(rigid_pose(rigid, 1).velocity_at({3, 1, 5})[2], 3 * 1, 1e-14);
    // The position is the velocity's integral.
    const Vector x0{3, 1, 5};
    const Vector a = rigid_pose(rigid, 0.7 - 1e-6).position_of(x0), b = rigid_pose(rigid, 0.7 + 1e-6).position_of(x0);
    const RigidPose between = rigid_pose(rigid, 0.7);
    const Vector u = between.velocity_at(between.position_of(x0));
    for (int i = 0; i < 3; ++i) EXPECT_NEAR((b[i] - a[i]) / 2e-6, u[i], 1e-8);
}

struct Stirred {
    Scene scene;
    Model model;
    int rigid, block;
};

/// A rigid paddle turns into a block.
Stirred paddle(double friction, const TransferSpec& scheme) {
    Stirred s;
    s.scene = plane_scene(0.25, -4, -4, 4, 4, material(2, 800, 400));
    s.scene.method.transfer = scheme;
    s.scene.contact = contact(LawType::friction, friction);
    RigidSpec rigid;
    rigid.angular_velocity = 0.5;
    rigid.velocity[0] = 0.1;
    declare_rigid(s.scene, rigid);
    s.rigid = add_rigid(s.model, "paddle", rigid);
    s.block = add_body(s.model, "block");
    add_box(s.model, s.rigid, -3, -0.25, 0, 0.25, 24, 4);
    add_box(s.model, s.block, -3, 0.3, -2, 1.3, 8, 8);
    // It turns clockwise from above the block's side: from below, that is, upwards at its left end.
    s.model.bodies[s.rigid].rigid->angular_velocity = -0.5;
    return s;
}

TEST(RigidBodies, ForceAndTorqueAreWhatTheOthersGain) {
    for (const TransferSpec& scheme : {transfer(TransferScheme::flip), transfer(TransferScheme::xpic, 3),
                                       transfer(TransferScheme::fmpm, 2, PositionUpdate::mean_velocity)}) {
        const Stirred s = paddle(0.3, scheme);
        State<2> state = make_state<2>(s.scene, s.model);
        EXPECT_NEAR((*state.bodies[s.rigid].rigid->center)[0], -1.5, 1e-12) << "the centre of its volume";
        prepare(state);
        Totals before = body_totals(state)[s.block];
        double worst = 0, largest = 0, turned = 0, power = 0;
        run(state, 1.0, [&] {
            const Totals after = body_totals(state)[s.block];
            const RigidTotals& totals = state.rigid_totals[s.rigid];
            for (int a = 0; a < 2; ++a) {
                worst = std::max(worst, std::abs(after.momentum[a] - before.momentum[a] + totals.impulse[a]));
                largest = std::max(largest, std::abs(totals.impulse[a]));
            }
            // What force and torque do on the way of the paddle is the work of the ledger.
            power += 0.1 * totals.impulse[0] - 0.5 * totals.angular_impulse[2];
            turned += totals.angular_impulse[2];
            state.rigid_totals.clear();
            before = after;
        });
        EXPECT_GT(largest, 1e-3);
        EXPECT_LT(worst, 1e-12);
        EXPECT_GT(before.momentum[1], 0.05) << "the paddle lifts the block";
        EXPECT_GT(turned, 0.1) << "the block resists";
        // FMPM's jumps behind the full mass matrix are forces, but have no work in the ledger.
        const double tolerance = scheme.scheme == TransferScheme::fmpm ? 0.1 : 1e-12;
        EXPECT_NEAR(state.ledger.external_work, -power, tolerance * state.ledger.external_work);

        // The paddle has turned as told, whatever it met.
        for (std::size_t p = 0; p < state.particles.size(); ++p) {
            if (state.particles.body[p] != s.rigid) continue;
            const Vector x0 = to_array<2>(state.initial_position[state.particles.id[p]]);
            const double angle = -0.5 * state.time;
            const double dx = x0[0] + 1.5, dy = x0[1];
            EXPECT_NEAR(state.particles.position[p][0],
                        -1.5 + 0.1 * state.time + dx * std::cos(angle) - dy * std::sin(angle), 1e-12);
            EXPECT_NEAR(state.particles.deformation_gradient[p](0, 0), std::cos(angle), 1e-10);
            EXPECT_TRUE(state.particles.stress[p].isZero(0));
        }
    }
}

TEST(RigidBodies, WorkOnTheOthersComesFromOutside) {
    const Stirred s = paddle(0, transfer(TransferScheme::flip));
    State<2> state = make_state<2>(s.scene, s.model);
    prepare(state);
    run(state, 1.0);
    const Totals all = deformable_totals(state, body_totals(state));
    EXPECT_NEAR(all.mass, 2 * 1, 1e-12) << "rigid bodies have no mass in the totals";
    const double energy = all.kinetic_energy + all.strain_energy;
    std::printf("[ figures  ] paddle: energy of the block %.5f J, work of the paddle %.5f J, of contact %.5f J\n",
                energy, state.ledger.external_work, state.ledger.contact_work);
    EXPECT_GT(energy, 0.005);
    EXPECT_LT(energy, state.ledger.external_work * 1.001);
    // The rest goes in FLIP's rebound of a block of 4 x 4 cells.
    EXPECT_GT(energy, 0.75 * (state.ledger.external_work + state.ledger.contact_work));
}

TEST(RigidBodies, WallsGravityAndOtherRigidBodiesDoNotMoveThem) {
    Scene scene = plane_scene(0.25, -4, -4, 4, 4, material(2, 800, 400));
    scene.contact = contact(LawType::frictionless);
    scene.gravity = {0, -9, 0};
    add_wall(scene, "floor", 1, Side::lower, -1);
    declare_rigid(scene, {});
    Model model;
    const int fixed = add_rigid(model, "fixed", {}), other = add_rigid(model, "other", {});
    add_box(model, fixed, -1, -1, 0, 0, 8, 8);
    add_box(model, other, 0, -1, 1, 0, 8, 8); // side by side
    add_box(model, add_body(model, "block"), 2, -1, 3, 0, 8, 8);
    State<2> state = make_state<2>(scene, model);
    const auto start = state.particles.position;
    std::vector<Vec<2>> by_id(start.size());
    for (std::size_t p = 0; p < start.size(); ++p) by_id[state.particles.id[p]] = start[p];
    run(state, 0.3);
    for (std::size_t p = 0; p < state.particles.size(); ++p)
        if (state.bodies[state.particles.body[p]].rigid) {
            EXPECT_EQ(state.particles.position[p], by_id[state.particles.id[p]]);
        }
    EXPECT_EQ(state.rigid_totals.size(), 0U);
}

TEST(RigidBodies, LeavingTheGridIsAnError) {
    Scene scene = plane_scene(0.25, -4, -4, 4, 4, material(2, 800, 400));
    scene.contact = contact(LawType::frictionless);
    RigidSpec rigid;
    rigid.velocity[0] = 20;
    declare_rigid(scene, rigid);
    Model model;
    add_box(model, add_rigid(model, "ram", rigid), 1, -1, 2, 0, 8, 8);
    add_box(model, add_body(model, "block"), -3, -1, -2, 0, 8, 8);
    State<2> state = make_state<2>(scene, model);
    EXPECT_THROW(run(state, 1), std::runtime_error);
}

TEST(RigidBodies, WorkInThreeDimensions) {
    Scene scene = space_scene(0.25, -2, 2, material(2, 800, 400));
    scene.contact = contact(LawType::stick);
    RigidSpec rigid;
    rigid.velocity[2] = 0.4;
    declare_rigid(scene, rigid);
    Model model;
    add_cube(model, add_rigid(model, "plate", rigid), {-0.75, -0.75, -1}, 1.5, 12);
    add_cube(model, add_body(model, "cube"), {-0.25, -0.25, 0.5}, 0.5, 4);
    State<3> state = make_state<3>(scene, model);
    run(state, 0.5);
    const Vector v = body_totals(state)[1].mean_velocity();
    EXPECT_GT(v[2], 0.3);
    EXPECT_LT(v[2], 0.9) << "between keeping up and bouncing off";
    EXPECT_NEAR(v[0], 0, 1e-7); // the search for the widest gap is not symmetric to round-off
}

} // namespace
