/// Whole time steps of small clouds against the papers' matrix equations: how particles move, by every scheme.

#include "dense_step.h"

namespace {

using namespace test;

class Transfers : public testing::TestWithParam<ShapeKind> {};

TEST_P(Transfers, FlipMovesBySecondOrder) {
    for (const bool perfect : {false, true})
        Step<2>(scene_with(GetParam(), transfer(TransferScheme::flip), perfect), 1).expect();
    Step<3>(scene_with(GetParam(), transfer(TransferScheme::flip)), 1).expect();
}

/// The three PIC methods of the FMPM paper's Eq. (2).
TEST_P(Transfers, PicMovesByThreeRules) {
    for (const PositionUpdate position : all_positions) {
        for (const bool perfect : {false, true})
            Step<2>(scene_with(GetParam(), transfer(TransferScheme::pic, 2, position), perfect), 2).expect();
        Step<3>(scene_with(GetParam(), transfer(TransferScheme::pic, 2, position)), 2).expect();
    }
}

TEST_P(Transfers, XpicOfOrdersTwoToSix) {
    for (int k = 2; k <= 6; ++k)
        for (const PositionUpdate position : {PositionUpdate::end_velocity, PositionUpdate::start_velocity}) {
            for (const bool perfect : {false, true})
                Step<2>(scene_with(GetParam(), transfer(TransferScheme::xpic, k, position), perfect), 10 + k).expect();
            if (k == 3) Step<3>(scene_with(GetParam(), transfer(TransferScheme::xpic, k, position), true), k).expect();
        }
}

TEST_P(Transfers, FmpmOfOrdersOneToFive) {
    for (int k = 1; k <= 5; ++k)
        for (const PositionUpdate position : all_positions) {
            for (const bool perfect : {false, true})
                Step<2>(scene_with(GetParam(), transfer(TransferScheme::fmpm, k, position), perfect), 20 + k).expect();
            if (k == 3) Step<3>(scene_with(GetParam(), transfer(TransferScheme::fmpm, k, position), true), k).expect();
        }
}

TEST_P(Transfers, LinearIncrementsAndFlipOfFirstOrder) {
    const auto linear = [&](TransferSpec t, bool perfect) {
        return [=, base = scene_with(GetParam(), t, perfect)](Scene& s) {
            base(s);
            s.method.deformation_increment = DeformationIncrement::linear;
        };
    };
    for (const bool perfect : {false, true})
        for (const TransferScheme scheme : {TransferScheme::flip, TransferScheme::xpic, TransferScheme::fmpm})
            Step<2>(linear(transfer(scheme, 3, PositionUpdate::end_velocity), perfect), 30).expect();
    Step<3>(linear(transfer(TransferScheme::flip, 2, PositionUpdate::end_velocity), true), 31).expect();
    Step<2>(
        [&](Scene& s) {
            linear(transfer(TransferScheme::flip), false)(s);
            s.analysis = Analysis::axisymmetric;
            s.gravity = {0, -2, 0};
        },
        32,
        [](const std::vector<Vector>& node, MatrixXd& velocity) { // the axis
            for (std::size_t i = 0; i < node.size(); ++i)
                if (std::abs(node[i][0]) < 1e-9) velocity(static_cast<Eigen::Index>(i), 0) = 0;
        })
        .expect();
}

INSTANTIATE_TEST_SUITE_P(All, Transfers, testing::ValuesIn(all_shapes),
                         [](const auto& shape) { return std::string(name_of(shape.param)); });

TEST(TransferRules, FmpmMovesByTheMeanVelocityUnlessTheSceneSaysOtherwise) {
    TransferSpec t{TransferScheme::fmpm, 2, {}, {}};
    EXPECT_EQ(position_update(t), PositionUpdate::mean_velocity);
    const Step<2> r(scene_with(ShapeKind::cpdi, t), 3);
    r.expect();
    const auto& o = r.oracle;
    EXPECT_LT((o.next_X - o.X - 0.5 * o.dt * (o.V + o.next_V)).norm(), 1e-14);
    t.scheme = TransferScheme::xpic;
    EXPECT_EQ(position_update(t), PositionUpdate::end_velocity);
}

TEST(TransferRules, XpicAndFmpmOfOrderOneArePic) {
    const auto run_one = [](TransferScheme scheme, PositionUpdate position) {
        return Step<2>(scene_with(ShapeKind::b2cpdi, transfer(scheme, 1, position), true), 3).state.particles;
    };
    for (const PositionUpdate position : all_positions) {
        const Particles<2> pic = run_one(TransferScheme::pic, position);
        for (const TransferScheme scheme : {TransferScheme::xpic, TransferScheme::fmpm}) {
            const Particles<2> one = run_one(scheme, position);
            EXPECT_EQ(one.velocity, pic.velocity);
            EXPECT_EQ(one.position, pic.position);
        }
    }
}

/// A body spins by a third of a turn a step: positions and deformation gradients go as one.
TEST(TransferRules, LinearIncrementsAreTheGradientOfTheParticlesMotion) {
    for (const DeformationIncrement increment : {DeformationIncrement::linear, DeformationIncrement::exponential}) {
        Scene scene = plane_scene(1, 0, 0, 12, 12, material(1, 1, 1));
        scene.method.transfer = transfer(TransferScheme::flip, 2, PositionUpdate::end_velocity);
        scene.method.deformation_increment = increment;
        Model model;
        add_box(model, add_body(model, "block"), 2, 2, 10, 10, 16, 16);
        model.bodies[0].velocity.gradient[0] = {0.3, -2, 0};
        model.bodies[0].velocity.gradient[1] = {2, 0.1, 0};
        model.bodies[0].velocity.center = {6, 6, 0};
        State<2> state = make_state<2>(scene, model);
        prepare(state);
        const std::vector<Vec<2>> before = state.particles.position;
        state.dt = 0.1;
        auto tasks = step_tasks<2>(state.scene);
        advance(state, tasks);
        double largest = 0;
        int inside = 0;
        for (std::size_t p = 0; p < before.size(); ++p) {
            const auto is_inside = [](const Vec<2>& x) { return (x.array() > 5).all() && (x.array() < 7).all(); };
            for (std::size_t q = 0; q < before.size(); ++q)
                if (is_inside(before[p]) && is_inside(before[q])) {
                    ++inside;
                    const Vec<2> moved = state.particles.position[q] - state.particles.position[p];
                    const Vec<2> deformed = state.particles.deformation_gradient[p] * (before[q] - before[p]);
                    largest = std::max(largest, (moved - deformed).norm());
                }
        }
        EXPECT_GE(inside, 256);
        if (increment == DeformationIncrement::linear)
            EXPECT_LT(largest, 1e-13);
        else
            EXPECT_GT(largest, 0.02) << "or there is nothing to choose";
    }
}

/// FMPM's grid velocities with friction: m_k^-1 of all momenta but what stops approaching pairs, and then pair by pair
/// the normal velocities that the law wants.
MatrixXd fmpm_in_contact(const State<2>& state, const Dense<2>& d, int k, const MatrixXd& start, const MatrixXd& end,
                         const MatrixXd& delta) {
    const auto normal_jump = [](const auto& point, const MatrixXd& u) {
        return (u.row(point.slot_b) - u.row(point.slot_a)).dot(point.normal);
    };
    const auto exchange = [&](const auto& point, double impulse, MatrixXd& u) { // along the normal, on a
        u.row(point.slot_a) += impulse / d.m[point.slot_a] * point.normal.transpose();
        u.row(point.slot_b) -= impulse / d.m[point.slot_b] * point.normal.transpose();
    };
    MatrixXd impacts = MatrixXd::Zero(end.rows(), end.cols());
    for (const auto& point : state.contact.points) {
        const double mass = 1 / (1 / d.m[point.slot_a] + 1 / d.m[point.slot_b]);
        const double stops = std::max(0.0, -mass * normal_jump(point, start));
        exchange(point, -std::min(stops, std::max(0.0, -point.impulse.dot(point.normal))), impacts);
    }
    MatrixXd u = d.inverse(k, end - impacts) - d.inverse(k - 1, delta) + impacts;
    for (const auto& point : state.contact.points) {
        if (point.impulse.isZero(0)) continue;
        const double mass = 1 / (1 / d.m[point.slot_a] + 1 / d.m[point.slot_b]);
        exchange(point, mass * (normal_jump(point, u) - normal_jump(point, end)), u);
    }
    return u;
}

/// With a law that is not perfect Δv comes from the contact pass; what becomes of it is FMPM paper Eq. (5) and the one
/// after it.
TEST(TransferRules, FiltersUseTheVelocityChangeOfTheFirstContactPass) {
    int changed = 0;
    for (const TransferScheme scheme : {TransferScheme::xpic, TransferScheme::fmpm})
        for (int k = 2; k <= 6; ++k) {
            const Step<2> r(
                [&](Scene& s) {
                    scene_with(ShapeKind::cpdi, transfer(scheme, k))(s);
                    s.contact = contact(LawType::friction, 0.3);
                },
                50 + k);
            const auto& nodes = r.state.nodes;
            const Dense<2>& d = r.oracle.d;
            const MatrixXd v0 = d.over_mass(d.S.transpose() * d.M.asDiagonal() * r.oracle.V);
            const MatrixXd delta = rows_of<2>(nodes.delta_velocity);
            const MatrixXd v = rows_of<2>(nodes.velocity);
            const MatrixXd end = rows_of<2>(nodes.end_velocity);
            EXPECT_LT((v - v0 - delta).norm(), 1e-11);
            changed += static_cast<int>((delta.rowwise().norm().array() > 1e-9).count());
            const MatrixXd V = scheme == TransferScheme::fmpm
                                   ? MatrixXd(d.S * fmpm_in_contact(r.state, d, k, v, end, delta))
                                   : MatrixXd(d.S * (d.inverse(k, v) - d.inverse(k - 1, delta) + end - v));
            EXPECT_LT((rows_of<2>(r.state.particles.velocity) - V).norm(), 1e-10);
        }
    EXPECT_GT(changed, 40);
}

/// Between two steps of a scheme its grid is FLIP's, also where stress is updated apart.
TEST(TransferRules, PeriodicTransfersAreFlipStepsBetween) {
    for (const TransferScheme scheme : {TransferScheme::pic, TransferScheme::xpic, TransferScheme::fmpm})
        for (const StressUpdate update : {StressUpdate::usl, StressUpdate::usavg_plus}) {
            State<2> state = random_state<2>(
                [&](Scene& s) {
                    scene_with(ShapeKind::cpdi, transfer(scheme, 3), true, update)(s);
                    s.time.cfl = 0.1;
                    s.method.transfer.every_cfl = 0.2;
                },
                60);
            auto tasks = step_tasks<2>(state.scene);
            int filtered = 0;
            for (int step = 0; step < 6; ++step) {
                // Wave speeds change from step to step; here the steps shall not.
                state.largest_wave_speed = 10;
                state.dt = next_step(state, 1e9);
                find_velocity_fields(state);
                const StepOracle<2> oracle(state, {}, step % 2 == 1);
                advance(state, tasks);
                EXPECT_EQ(state.transfers, step % 2 == 1) << step;
                oracle.expect(state, 1e-9);
                filtered += state.transfers;
            }
            EXPECT_EQ(filtered, 3);
        }
}

TEST(TransferRules, StressUpdatesDeformByTheVelocitiesOfTheirTime) {
    for (const StressUpdate update :
         {StressUpdate::usf, StressUpdate::usavg, StressUpdate::usl, StressUpdate::usl_plus, StressUpdate::usavg_plus})
        for (const TransferScheme scheme :
             {TransferScheme::flip, TransferScheme::pic, TransferScheme::xpic, TransferScheme::fmpm}) {
            for (const ShapeKind shape : {ShapeKind::ugimp, ShapeKind::cpdi, ShapeKind::b2spline, ShapeKind::gimp})
                for (const bool perfect : {false, true})
                    Step<2>(scene_with(shape, transfer(scheme, 3), perfect, update), 70).expect();
            Step<3>(scene_with(ShapeKind::b2gimp, transfer(scheme, 2), true, update), 71).expect();
        }
}

TEST(TransferRules, RingsAndPlaneStressAreSteppedAlike) {
    for (const Analysis analysis : {Analysis::axisymmetric, Analysis::plane_stress})
        for (const MaterialModel model :
             {MaterialModel::neo_hookean, MaterialModel::neo_hookean_isochoric, MaterialModel::linear_elastic})
            for (const ShapeKind shape : all_shapes)
                for (const StressUpdate update : {StressUpdate::usl, StressUpdate::usavg_plus}) {
                    // No radial gravity on rings; the axis lies beyond the nodes of these particles.
                    Step<2>(
                        [&](Scene& s) {
                            scene_with(shape, transfer(TransferScheme::fmpm, 3), true, update)(s);
                            s.analysis = analysis;
                            s.gravity = {0, -2, 0};
                            s.materials[0].model = model;
                        },
                        80,
                        [&](const std::vector<Vector>& node, MatrixXd& velocity) {
                            for (std::size_t i = 0; i < node.size(); ++i)
                                if (analysis == Analysis::axisymmetric && std::abs(node[i][0]) < 1e-9)
                                    velocity(static_cast<Eigen::Index>(i), 0) = 0;
                        })
                        .expect();
                }
}

} // namespace
