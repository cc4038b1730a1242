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
            s.gravity = {};
        },
        32)
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

/// What contact holds together, as an orthogonal projection in the metric of the masses: with a row of C for each
/// component of a jump that may not be, P = 1 − m^-1 C^T (C m^-1 C^T)^-1 C. It acts on nodal velocities as a column.
MatrixXd holding(const State<2>& state, const Dense<2>& d) {
    const Eigen::Index n = d.m.size();
    std::vector<Eigen::VectorXd> rows;
    const auto add = [&](const auto& point, const Vec<2>& direction) {
        Eigen::VectorXd row = Eigen::VectorXd::Zero(2 * n);
        row.segment<2>(2 * point.slot_a) = -direction;
        row.segment<2>(2 * point.slot_b) = direction;
        rows.push_back(row);
    };
    for (const auto& point : state.contact.points) {
        if (point.held == Hold::normal) add(point, point.normal);
        if (point.held == Hold::all) {
            add(point, Vec<2>(1, 0));
            add(point, Vec<2>(0, 1));
        }
    }
    Eigen::VectorXd light = Eigen::VectorXd::Zero(2 * n); // 1 / m
    for (Eigen::Index i = 0; i < n; ++i)
        if (d.m[i] > 0) light.segment<2>(2 * i).setConstant(1 / d.m[i]);
    if (rows.empty()) return MatrixXd::Identity(2 * n, 2 * n);
    MatrixXd C(static_cast<Eigen::Index>(rows.size()), 2 * n);
    for (std::size_t r = 0; r < rows.size(); ++r) C.row(static_cast<Eigen::Index>(r)) = rows[r].transpose();
    const MatrixXd W = light.asDiagonal() * C.transpose();
    return MatrixXd::Identity(2 * n, 2 * n) - W * (C * W).completeOrthogonalDecomposition().pseudoInverse() * C;
}

/// P of rows of velocities.
MatrixXd held(const MatrixXd& P, const MatrixXd& u) {
    const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> by_row = u;
    const Eigen::VectorXd column = P * Eigen::Map<const Eigen::VectorXd>(by_row.data(), by_row.size());
    return Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, 2, Eigen::RowMajor>>(column.data(), u.rows(), 2);
}

/// Σ_{j<k−1} (1 − P S+ S)^j P (v − Δv) + (1 − P S+ S)^(k−1) v
MatrixXd held_filter(const Dense<2>& d, const MatrixXd& P, int k, const MatrixXd& v, const MatrixXd& delta) {
    MatrixXd term = held(P, v - delta);
    MatrixXd last = v;
    MatrixXd sum = MatrixXd::Zero(v.rows(), v.cols());
    for (int j = 0; j + 1 < k; ++j) {
        sum += term;
        term -= held(P, d.S_plus * (d.S * term));
        last -= held(P, d.S_plus * (d.S * last));
    }
    return sum + last;
}

/// With a law that is not perfect Δv comes from the contact pass; what becomes of it is contact paper Eq. (43), (44)
/// and FMPM paper Eq. (5), with what contact holds together held in every sweep (hold_together.h).
TEST(TransferRules, FiltersHoldWhatContactHoldsTogether) {
    int changed = 0;
    int holds = 0;
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
            const MatrixXd v = rows_of<2>(nodes.velocity);
            const MatrixXd end = rows_of<2>(nodes.end_velocity);
            changed += static_cast<int>(((v - v0).rowwise().norm().array() > 1e-9).count());
            for (const auto& point : r.state.contact.points) holds += point.held != Hold::none;
            const MatrixXd P = holding(r.state, d);
            const MatrixXd V = scheme == TransferScheme::fmpm
                                   ? MatrixXd(d.S * held_filter(d, P, k, end, v - v0))
                                   : MatrixXd(d.S * (held_filter(d, P, k, v, v - v0) + end - v));
            EXPECT_LT((rows_of<2>(r.state.particles.velocity) - V).norm(), 1e-10);
        }
    EXPECT_GT(changed, 40);
    EXPECT_GT(holds, 40);
}

/// The filter alone never gives energy, whatever the velocities: XPIC in the first step of bodies at rest strain.
TEST(TransferRules, FiltersGiveNoEnergyWhereContactHolds) {
    double worst = -INFINITY;
    for (const LawType law : {LawType::perfect, LawType::stick, LawType::frictionless})
        for (int k = 2; k <= 6; ++k)
            for (int seed = 80; seed < 90; ++seed) {
                State<2> state = random_state<2>(
                    [&](Scene& s) {
                        scene_with(ShapeKind::ugimp, transfer(TransferScheme::xpic, k))(s);
                        s.contact = contact(law);
                        s.contact->overlap_correction = 0; // parting is work
                    },
                    seed);
                for (auto& stress : state.particles.stress) stress.setZero();
                state.scene.gravity = {};
                state.effects.gravity = false;
                const double before = totals(state).kinetic_energy;
                auto tasks = step_tasks<2>(state.scene);
                advance(state, tasks);
                worst = std::max(worst, totals(state).kinetic_energy / before - 1);
            }
    std::printf("[ figures  ] kinetic energy that filters give: %.3g of what there is\n", worst);
    EXPECT_LT(worst, 1e-12);
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
