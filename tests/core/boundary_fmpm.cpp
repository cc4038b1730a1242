/// Velocity conditions in whole steps: where they enter the full mass matrix calculation (FMPM paper §2.4), and that
/// the forces of all boundaries account for the momentum.

#include "dense_step.h"

#include "results/history.h"

#include <map>

namespace {

using namespace test;

constexpr VelocityConditions all_methods[] = {VelocityConditions::combined, VelocityConditions::velocity,
                                              VelocityConditions::lumped};

/// A wall that grips with a gradient at the left, and one that moves down at the top.
void add_conditions(Scene& scene) {
    add_wall(scene, "left", 0, Side::lower, 1.5, 0.2);
    std::get<WallSpec>(scene.boundaries[0].condition).gradient = 0.1;
    add_wall(scene, "top", 1, Side::upper, 3.25, -0.3, true, 0.5);
}

/// The same in other words; \return whether a node's component is held
bool hold(const Vector& node, int component, double& velocity) {
    if (component == 0 && node[0] <= 2.5)
        velocity = 0.2 + 0.1 * (node[0] - 1.5);
    else if (component == 1 && node[1] >= 2.75)
        velocity = -0.3;
    else
        return false;
    return true;
}

void impose_on_all(const std::vector<Vector>& node, MatrixXd& velocity) {
    for (std::size_t i = 0; i < node.size(); ++i)
        for (int a = 0; a < 2; ++a) hold(node[i], a, velocity(static_cast<Eigen::Index>(i), a));
}

TEST(VelocityConditionsOfFmpm, AreThoseOfThePaper) {
    for (const VelocityConditions method : all_methods)
        for (int k = 1; k <= 5; ++k)
            for (const bool perfect : {false, true}) {
                const Step<2> r(
                    [&](Scene& s) {
                        scene_with(ShapeKind::cpdi, transfer(TransferScheme::fmpm, k), perfect)(s);
                        s.method.velocity_conditions = method;
                        add_conditions(s);
                    },
                    90 + k, impose_on_all);
                r.expect();
            }
}

TEST(VelocityConditionsOfFmpm, HoldExactlyUnlessLumped) {
    for (const VelocityConditions method : all_methods)
        for (const int k : {2, 4}) {
            const Step<2> r(
                [&](Scene& s) {
                    scene_with(ShapeKind::cpdi, transfer(TransferScheme::fmpm, k))(s);
                    s.method.velocity_conditions = method;
                    add_conditions(s);
                },
                95);
            const auto nodes = slot_nodes(r.state.fields);
            double worst = 0;
            int held = 0;
            for (std::size_t slot = 0; slot < nodes.size(); ++slot)
                for (int a = 0; a < 2; ++a) {
                    double wanted = 0;
                    if (!(r.oracle.d.m[static_cast<Eigen::Index>(slot)] > 0)) continue;
                    if (!hold(to_array<2>(r.state.grid.node_position(nodes[slot])), a, wanted)) continue;
                    worst = std::max(worst, std::abs(r.state.nodes.filtered[slot][a + 1] - wanted));
                    ++held;
                }
            EXPECT_GT(held, 15);
            const char* names[] = {"combined", "velocity", "lumped"};
            std::printf("[ figures  ] FMPM(%d), %s: controlled velocities off by up to %.1e\n", k,
                        names[static_cast<int>(method)], worst);
            if (method == VelocityConditions::lumped)
                EXPECT_GT(worst, 1e-3);
            else
                EXPECT_LT(worst, 1e-15);
        }
}

TEST(VelocityConditionsOfFmpm, CombinedReachTheNeighboursButVelocityDoNot) {
    const auto filtered = [](VelocityConditions method, double wall_velocity) {
        const Step<2> r(
            [&](Scene& s) {
                scene_with(ShapeKind::cpdi, transfer(TransferScheme::fmpm, 2))(s);
                s.method.velocity_conditions = method;
                add_wall(s, "left", 0, Side::lower, 1.5, wall_velocity);
            },
            96);
        double beside = 0; // v_x of the first uncontrolled nodes
        const auto nodes = slot_nodes(r.state.fields);
        for (std::size_t slot = 0; slot < nodes.size(); ++slot)
            if (nodes[slot][0] == grid_margin + 3) beside += std::abs(r.state.nodes.filtered[slot][1]);
        return beside;
    };
    EXPECT_EQ(filtered(VelocityConditions::velocity, 0), filtered(VelocityConditions::velocity, 5));
    EXPECT_GT(std::abs(filtered(VelocityConditions::combined, 0) - filtered(VelocityConditions::combined, 5)), 0.1);
}

/// Stress updates apart from the momentum update use velocities that fulfil the conditions.
TEST(VelocityConditionsInSteps, HoldForEveryStressUpdateAndScheme) {
    for (const StressUpdate update :
         {StressUpdate::usf, StressUpdate::usavg, StressUpdate::usl, StressUpdate::usl_plus, StressUpdate::usavg_plus})
        for (const TransferScheme scheme :
             {TransferScheme::flip, TransferScheme::pic, TransferScheme::xpic, TransferScheme::fmpm})
            for (const bool perfect : {false, true})
                Step<2>(
                    [&](Scene& s) {
                        scene_with(ShapeKind::cpdi, transfer(scheme, 3), perfect, update)(s);
                        add_conditions(s);
                    },
                    97, impose_on_all)
                    .expect();
}

/// Forces of all walls and gravity against the change of momentum, step by step.
void check_momentum_balance(const MethodSpec& method, bool with_contact = false) {
    Scene scene = plane_scene(1, 0, 0, 10, 10, material(2, 100, 40));
    scene.method = method;
    add_wall(scene, "floor", 1, Side::lower, 0.5, 0, false, 0);
    add_wall(scene, "side", 0, Side::upper, 6.5, -0.2);
    scene.boundaries.push_back({"oblique", VelocitySpec{{2, 5, 0}, {3, 6, 0}, {1, 2, 0}, -0.1}});
    scene.gravity = {0.1, -1, 0};
    if (with_contact) scene.contact = contact(LawType::perfect);
    Model model;
    add_box(model, add_body(model, "a", {0.3, -0.2, 0}), 2, 1, 6, 7, 8, 12);
    State<2> state = make_state<2>(scene, model);
    prepare(state);
    Vector before = totals(state).momentum;
    auto tasks = step_tasks<2>(state.scene);
    for (int step = 0; step < 100; ++step) {
        state.dt = next_step(state, 1e9);
        advance(state, tasks);
        const Totals all = totals(state);
        const std::vector<std::string> columns = history_columns(state);
        const std::vector<double> row = history_row(state, all, state.dt);
        ASSERT_EQ(columns.size(), row.size());
        std::map<std::string, double> value;
        for (std::size_t i = 0; i < row.size(); ++i) value[columns[i]] = row[i];
        const double fx = value["force_side_x"] + value["force_oblique_x"] + 0.1 * all.mass;
        const double fy = value["force_floor_y"] + value["force_oblique_y"] - all.mass;
        // A change of momentum over a short step has the round-off of the momentum over that step.
        const double tolerance = 1e-11 * all.mass;
        EXPECT_NEAR((all.momentum[0] - before[0]) / state.dt, fx, tolerance) << "step " << step;
        EXPECT_NEAR((all.momentum[1] - before[1]) / state.dt, fy, tolerance) << "step " << step;
        EXPECT_EQ(value["force_side_y"], 0);
        EXPECT_NE(value["force_oblique_y"], 0);
        before = all.momentum;
    }
}

TEST(Boundaries, ForcesAreTheRateOfChangeOfMomentum) {
    const auto method = [](ShapeKind shape, TransferSpec t, StressUpdate update = StressUpdate::usl,
                           VelocityConditions conditions = VelocityConditions::combined) {
        return MethodSpec{.shape = shape, .transfer = t, .stress_update = update, .velocity_conditions = conditions};
    };
    check_momentum_balance(method(ShapeKind::ugimp, transfer(TransferScheme::flip)));
    check_momentum_balance(method(ShapeKind::b2spline, transfer(TransferScheme::flip), StressUpdate::usf));
    check_momentum_balance(method(ShapeKind::cpdi, transfer(TransferScheme::pic)));
    check_momentum_balance(method(ShapeKind::gimp, transfer(TransferScheme::xpic, 4)));
    check_momentum_balance(method(ShapeKind::linear, transfer(TransferScheme::pic), StressUpdate::usavg_plus));
    for (const VelocityConditions conditions : all_methods)
        check_momentum_balance(
            method(ShapeKind::cpdi, transfer(TransferScheme::fmpm, 3), StressUpdate::usl, conditions));
    check_momentum_balance(method(ShapeKind::b2gimp, transfer(TransferScheme::fmpm, 2), StressUpdate::usl_plus), true);
    TransferSpec periodic = transfer(TransferScheme::fmpm, 4);
    periodic.every_cfl = 1.2;
    check_momentum_balance(method(ShapeKind::b2cpdi, periodic));
}

TEST(Boundaries, AFloorThatDoesNotGripOnlyPushes) {
    for (const TransferScheme scheme : {TransferScheme::flip, TransferScheme::xpic, TransferScheme::fmpm}) {
        Scene scene = plane_scene(1, 0, 0, 10, 10, material(2, 100, 40));
        scene.method.shape = ShapeKind::cpdi;
        scene.method.transfer = transfer(scheme, 2);
        add_wall(scene, "floor", 1, Side::lower, 1, 0, false, 0);
        Model model;
        add_box(model, add_body(model, "a", {0, -0.5, 0}), 2, 1.2, 6, 5.2, 8, 8);
        State<2> state = make_state<2>(scene, model);
        double smallest = 0;
        double largest = 0;
        run(state, 6, [&] {
            smallest = std::min(smallest, state.boundaries[0].impulse[1]);
            largest = std::max(largest, state.boundaries[0].impulse[1]);
            state.boundaries[0].impulse = {};
        });
        EXPECT_GT(largest, 0);
        const double mass = 2 * 16;
        // FMPM imposes twice: what the second time undoes of the first is no pull of their sum beyond round-off.
        EXPECT_GE(smallest, -1e-12 * mass) << static_cast<int>(scheme);
        EXPECT_GT(totals(state).momentum[1], 0.2 * mass) << "it bounces";
    }
}

} // namespace
