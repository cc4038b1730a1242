#include "dense.h"

#include "results/history.h"

#include <map>

namespace {

using namespace test;

State<2> block_state(const std::function<void(Scene&)>& change = [](Scene&) {}) {
    Scene scene = plane_scene(1, 0, 0, 10, 10, material(2, 100, 40));
    scene.method.shape = ShapeKind::ugimp;
    change(scene);
    Model model;
    add_box(model, add_body(model, "a", {0.3, -0.2, 0}), 2, 1, 6, 7, 8, 12);
    return make_state<2>(scene, model);
}

TEST(Walls, ControlNodesToTheirDepthAndAllOutside) {
    for (const double depth : {0.0, 1.0, 2.5})
        for (const Side side : {Side::lower, Side::upper})
            for (const int axis : {0, 1}) {
                State<2> state = block_state([&](Scene& s) {
                    add_wall(s, "w", axis, side, side == Side::lower ? 3 : 5, 0.25, true, depth);
                    s.boundaries[0].wall.gradient = 0.5;
                });
                find_velocity_fields(state);
                const double time = 2; // the wall is at 3.5 or 5.5
                find_controlled(state.walls[0], state.grid, state.fields, time);
                const auto nodes = slot_nodes(state.fields);
                std::map<int, double> expected;
                for (std::size_t slot = 0; slot < nodes.size(); ++slot) {
                    const double x = state.grid.node_position(nodes[slot])[axis];
                    if (side == Side::lower ? x <= 3.5 + depth : x >= 5.5 - depth)
                        expected[static_cast<int>(slot)] = 0.25 + 0.5 * (x - (side == Side::lower ? 3.5 : 5.5));
                }
                std::map<int, double> found;
                for (const auto& c : state.walls[0].controlled) found[c.slot] = c.velocity;
                ASSERT_EQ(found.size(), state.walls[0].controlled.size());
                ASSERT_EQ(found.size(), expected.size());
                ASSERT_FALSE(expected.empty());
                for (const auto& [slot, v] : expected) {
                    ASSERT_EQ(found.count(slot), 1u);
                    EXPECT_NEAR(found[slot], v, 1e-13);
                }
            }
}

TEST(Walls, ImpulseIsMassTimesChangeAndFreeWallsOnlyPush) {
    for (const bool grip : {true, false}) {
        State<2> state = block_state([&](Scene& s) { add_wall(s, "w", 1, Side::lower, 1.5, 0.1, grip); });
        find_velocity_fields(state);
        find_controlled(state.walls[0], state.grid, state.fields, 0);
        std::mt19937 random(1);
        std::uniform_real_distribution<double> in(-1, 1);
        std::vector<Pack> before(state.fields.size());
        for (Pack& v : before) v = Pack{1 + in(random), in(random), in(random), 0};
        std::vector<Pack> after = before;
        impose(state.walls[0], after);
        double impulse = 0;
        double work = 0;
        std::vector<bool> controlled(before.size(), false);
        for (const auto& c : state.walls[0].controlled) {
            controlled[c.slot] = true;
            const double expected = grip ? 0.1 : std::max(0.1, before[c.slot][2]); // never pulls down
            EXPECT_EQ(after[c.slot][2], expected);
            const double change = before[c.slot][0] * (expected - before[c.slot][2]);
            EXPECT_NEAR(c.impulse, change, 1e-15);
            impulse += change;
            work += change * 0.1;
        }
        for (std::size_t i = 0; i < before.size(); ++i) {
            EXPECT_EQ(after[i][0], before[i][0]);
            EXPECT_EQ(after[i][1], before[i][1]) << "a wall is smooth";
            if (!controlled[i]) {
                EXPECT_EQ(after[i][2], before[i][2]);
            }
        }
        EXPECT_NEAR(settle(state.walls[0]), work, 1e-13);
        EXPECT_NEAR(state.walls[0].impulse, impulse, 1e-13);
    }
}

/// Forces of all walls and gravity against the change of momentum, step by step.
void check_momentum_balance(ShapeKind shape, TransferSpec scheme, StressUpdate update, double tolerance) {
    State<2> state = block_state([&](Scene& s) {
        s.method = {shape, scheme, update};
        add_wall(s, "floor", 1, Side::lower, 0.5, 0, false, 0);
        add_wall(s, "side", 0, Side::upper, 6.5, -0.2);
        s.gravity = {0.1, -1, 0};
    });
    prepare(state);
    Vector before = totals(state).momentum;
    auto tasks = step_tasks<2>(state.scene);
    for (int step = 0; step < 200; ++step) {
        state.dt = next_step(state, 1e9);
        advance(state, tasks);
        const Totals all = totals(state);
        const std::vector<std::string> columns = history_columns(state);
        const std::vector<double> row = history_row(state, all, state.dt);
        ASSERT_EQ(columns.size(), row.size());
        std::map<std::string, double> value;
        for (std::size_t i = 0; i < row.size(); ++i) value[columns[i]] = row[i];
        const double fx = value["force_side_x"] + 0.1 * all.mass;
        const double fy = value["force_floor_y"] - all.mass;
        EXPECT_NEAR((all.momentum[0] - before[0]) / state.dt, fx, tolerance * all.mass) << "step " << step;
        EXPECT_NEAR((all.momentum[1] - before[1]) / state.dt, fy, tolerance * all.mass) << "step " << step;
        EXPECT_EQ(value["force_side_y"], 0);
        EXPECT_GE(value["force_floor_y"], 0) << "a floor that does not grip only pushes";
        before = all.momentum;
    }
}

TEST(Walls, ReactionIsTheRateOfChangeOfMomentum) {
    const double round_off = 1e-11;
    check_momentum_balance(ShapeKind::ugimp, transfer(TransferScheme::flip), StressUpdate::usl, round_off);
    check_momentum_balance(ShapeKind::ugimp, transfer(TransferScheme::flip), StressUpdate::usf, round_off);
    check_momentum_balance(ShapeKind::cpdi, transfer(TransferScheme::pic), StressUpdate::usl, round_off);
    check_momentum_balance(ShapeKind::cpdi, transfer(TransferScheme::xpic, 4), StressUpdate::usl, round_off);
    check_momentum_balance(ShapeKind::linear, transfer(TransferScheme::pic), StressUpdate::usf, round_off);
}

TEST(Walls, TheForceOnARestingBodyIsItsWeight) {
    State<2> state = block_state([](Scene& s) {
        s.method.transfer = transfer(TransferScheme::pic);
        s.gravity = {0, -0.5, 0};
        add_wall(s, "floor", 1, Side::lower, 1, 0, false, 0);
    });
    for (auto& v : state.particles.velocity) v.setZero();
    run(state, 20);
    state.walls[0].impulse = 0;
    run(state, 40);
    EXPECT_NEAR(state.walls[0].impulse / 20, 2 * 24 * 0.5, 0.002 * 24);
}

} // namespace
