#include "dense.h"

#include <map>

namespace {

using namespace test;

/// A block of particles from 2 to 6 in x, 1 to 7 in y (2 to 6 along all axes in 3D), cells of 1.
template <int D>
State<D> block_state(const std::function<void(Scene&)>& change = [](Scene&) {}) {
    const MaterialSpec m = material(2, 100, 40);
    Scene scene = D == 2 ? plane_scene(1, 0, 0, 10, 10, m) : space_scene(1, 0, 10, m);
    scene.method.shape = ShapeKind::ugimp;
    change(scene);
    Model model;
    const int a = add_body(model, "a", {0.3, -0.2, 0});
    if (D == 2)
        add_box(model, a, 2, 1, 6, 7, 8, 12);
    else
        add_cube(model, a, {2, 2, 2}, 4, 8);
    return make_state<D>(scene, model);
}

WallSpec& wall_of(Scene& scene) {
    return std::get<WallSpec>(scene.boundaries.at(0).condition);
}

/// Velocities that the wall wants, by slot; every slot at most once.
std::map<int, double> velocities(const std::vector<Control>& controls, int axis) {
    std::map<int, double> found;
    for (const Control& c : controls) {
        EXPECT_TRUE(found.emplace(c.slot, c.velocity).second);
        for (int a = 0; a < 3; ++a) EXPECT_EQ(c.direction[a + 1], a == axis ? 1 : 0);
    }
    return found;
}

template <int D>
void check_depths() {
    for (const double depth : {0.0, 0.6, 1.0, 2.5})
        for (const Side side : {Side::lower, Side::upper})
            for (int axis = 0; axis < D; ++axis) {
                State<D> state = block_state<D>([&](Scene& s) {
                    add_wall(s, "w", axis, side, side == Side::lower ? 3 : 5, 0, true, depth);
                    wall_of(s).velocity = TimeFunction({0, 4}, {0.1, 0.4}); // integral to 2: 0.35
                    wall_of(s).gradient = TimeFunction({1, 3}, {0, 1});     // 0.5 at 2
                });
                find_velocity_fields(state);
                const double time = 2;
                const double dt = 0.4;
                std::vector<Control> controls;
                control_wall<D>(wall_of(state.scene), 7, state.grid, state.fields, {}, time, dt, controls);
                const double wall = side == Side::lower ? 3.35 : 5.35;
                const double wall_velocity = 0.1 + 0.3 * 2.4 / 4; // at the end of the step
                const auto nodes = slot_nodes(state.fields);
                std::map<int, double> expected;
                for (std::size_t slot = 0; slot < nodes.size(); ++slot) {
                    const double x = state.grid.node_position(nodes[slot])[axis];
                    if (side == Side::lower ? x <= wall + depth : x >= wall - depth)
                        expected[static_cast<int>(slot)] = wall_velocity + 0.5 * (x - wall);
                }
                const auto found = velocities(controls, axis);
                ASSERT_FALSE(expected.empty());
                ASSERT_EQ(found.size(), expected.size());
                for (const auto& [slot, v] : expected) {
                    ASSERT_EQ(found.count(slot), 1u);
                    EXPECT_NEAR(found.at(slot), v, 1e-13);
                }
                for (const Control& c : controls) EXPECT_EQ(c.boundary, 7);
            }
}

TEST(Walls, ControlNodesToTheirDepthAndAllOutside) {
    check_depths<2>();
    check_depths<3>();
}

TEST(Walls, ANodeExactlyAtTheDepthIsControlledWhateverRoundOffSays) {
    for (const double cell : {0.1, 0.3, 0.7})
        for (int layer = 2; layer < 9; ++layer) {
            Scene scene = plane_scene(cell, 0.1, 0.1, 0.1 + 12 * cell, 0.1 + 12 * cell, material(2, 100, 40));
            add_wall(scene, "w", 0, Side::lower, 0.1 + layer * cell);
            Model model;
            const double x = 0.1 + cell * 1.5;
            add_box(model, add_body(model, "a"), x, x, x + 9 * cell, x + 9 * cell, 18, 18);
            State<2> state = make_state<2>(scene, model);
            find_velocity_fields(state);
            std::vector<Control> controls;
            control_wall<2>(wall_of(scene), 0, state.grid, state.fields, {}, 0, 1, controls);
            int innermost = 0;
            const auto nodes = slot_nodes(state.fields);
            for (const Control& c : controls) innermost = std::max(innermost, nodes[c.slot][0]);
            EXPECT_EQ(innermost, grid_margin + layer + 1) << cell;
        }
}

/// FMPM paper Eq. (4) by hand, for every line of nodes on its own. Velocities here are v = a + b x with b by line.
template <int D>
void check_estimated_gradient() {
    for (const Side side : {Side::lower, Side::upper})
        for (const double depth : {0.0, 1.0, 1.5})
            for (int axis = 0; axis < D; ++axis) {
                State<D> state = block_state<D>([&](Scene& s) {
                    add_wall(s, "w", axis, side, side == Side::lower ? 3.4 : 4.6, 0.25, true, depth);
                    wall_of(s).estimated_gradient = true;
                    wall_of(s).gradient = 77; // not read
                });
                find_velocity_fields(state);
                const auto nodes = slot_nodes(state.fields);
                std::mt19937 random(3);
                std::uniform_real_distribution<double> in(-1, 1);
                std::vector<Pack> v(state.fields.size());
                for (Pack& each : v) each = Pack{1 + in(random), in(random), in(random), in(random)};
                std::map<std::array<int, 3>, double> at; // velocity across the wall by node
                for (std::size_t slot = 0; slot < nodes.size(); ++slot) {
                    std::array<int, 3> key{};
                    for (int a = 0; a < D; ++a) key[a] = nodes[slot][a];
                    at[key] = v[slot][axis + 1];
                }
                std::vector<Control> controls;
                control_wall<D>(wall_of(state.scene), 0, state.grid, state.fields, v, 0, 0.1, controls);
                ASSERT_FALSE(controls.empty());
                const double wall = side == Side::lower ? 3.4 : 4.6;
                const int inward = side == Side::lower ? 1 : -1;
                // Nodes 1 and 2 of the paper's figure; with depth 0 there is no controlled node inside.
                int controlled = side == Side::lower ? static_cast<int>(std::floor(wall + depth))
                                                     : static_cast<int>(std::ceil(wall - depth));
                const int uncontrolled = controlled + inward;
                const bool inside = (controlled - wall) * inward > 0;
                EXPECT_EQ(inside, depth > 0);
                for (const Control& c : controls) {
                    std::array<int, 3> key{};
                    for (int a = 0; a < D; ++a) key[a] = nodes[c.slot][a];
                    double products = 0;
                    double squares = 0;
                    for (const int layer : {controlled, uncontrolled}) {
                        if (layer == controlled && !inside) continue;
                        key[axis] = layer + grid_margin;
                        products += (at.at(key) - 0.25) * (layer - wall);
                        squares += (layer - wall) * (layer - wall);
                    }
                    const double x = state.grid.node_position(nodes[c.slot])[axis];
                    EXPECT_NEAR(c.velocity, 0.25 + products / squares * (x - wall), 1e-12);
                }
            }
}

TEST(Walls, EstimateTheirGradientAsTheFmpmPaperDoes) {
    check_estimated_gradient<2>();
    check_estimated_gradient<3>();
}

TEST(Walls, AnEstimatedGradientFindsThatOfAUniformlyStretchedBody) {
    State<2> state = block_state<2>([](Scene& s) {
        add_wall(s, "w", 0, Side::lower, 2.3, 0.1 + 0.05 * 2.3);
        wall_of(s).estimated_gradient = true;
    });
    find_velocity_fields(state);
    std::vector<Pack> v(state.fields.size());
    const auto nodes = slot_nodes(state.fields);
    for (std::size_t slot = 0; slot < nodes.size(); ++slot)
        v[slot] = Pack{1, 0.1 + 0.05 * state.grid.node_position(nodes[slot])[0], 5, 0};
    std::vector<Control> controls;
    control_wall<2>(wall_of(state.scene), 0, state.grid, state.fields, v, 0, 0, controls);
    ASSERT_FALSE(controls.empty());
    for (const Control& c : controls) EXPECT_NEAR(c.velocity, v[c.slot][1], 1e-14);
}

/// A corner node obeys all walls that meet there.
template <int D>
void check_corner() {
    State<D> state = block_state<D>([](Scene& s) {
        for (int axis = 0; axis < D; ++axis)
            add_wall(s, "w" + std::to_string(axis), axis, axis == 1 ? Side::upper : Side::lower, axis == 1 ? 6 : 2,
                     0.1 * (axis + 1));
    });
    auto tasks = step_tasks<D>(state.scene);
    state.dt = 0.01;
    advance(state, tasks);
    const auto nodes = slot_nodes(state.fields);
    int most = 0;
    for (std::size_t slot = 0; slot < nodes.size(); ++slot) {
        const Vec<D> x = state.grid.node_position(nodes[slot]);
        int held = 0;
        for (int axis = 0; axis < D; ++axis) {
            if (axis == 1 ? x[axis] < 5 : x[axis] > 3) continue;
            ++held;
            EXPECT_NEAR(state.nodes.end_velocity[slot][axis + 1], 0.1 * (axis + 1), 1e-15);
        }
        most = std::max(most, held);
    }
    EXPECT_EQ(most, D);
}

TEST(Walls, MeetInCorners) {
    check_corner<2>();
    check_corner<3>();
}

TEST(Walls, ImpulseIsMassTimesChangeAndFreeWallsOnlyPush) {
    for (const Side side : {Side::lower, Side::upper})
        for (const bool grip : {true, false}) {
            State<2> state = block_state<2>(
                [&](Scene& s) { add_wall(s, "w", 1, side, side == Side::lower ? 1.5 : 6.5, 0.1, grip); });
            find_velocity_fields(state);
            std::vector<Control>& controls = state.controls;
            control_wall<2>(wall_of(state.scene), 0, state.grid, state.fields, {}, 0, 0, controls);
            std::mt19937 random(1);
            std::uniform_real_distribution<double> in(-1, 1);
            std::vector<Pack> before(state.fields.size());
            for (Pack& v : before) v = Pack{1 + in(random), in(random), in(random), 0};
            std::vector<Pack> after = before;
            std::vector<Pack> untracked = before;
            impose_untracked(controls, untracked);
            impose(controls, after);
            double impulse = 0;
            std::vector<bool> controlled(before.size(), false);
            for (const Control& c : controls) {
                controlled[c.slot] = true;
                const double v = before[c.slot][2];
                const double held = side == Side::lower ? std::max(0.1, v) : std::min(0.1, v); // never pulls
                const double expected = grip ? 0.1 : held;
                EXPECT_NEAR(after[c.slot][2], expected, 1e-15);
                EXPECT_NEAR(c.impulse, before[c.slot][0] * (expected - v), 1e-15);
                impulse += before[c.slot][0] * (expected - v);
            }
            for (std::size_t i = 0; i < before.size(); ++i) {
                EXPECT_EQ(after[i][0], before[i][0]);
                EXPECT_EQ(after[i][1], before[i][1]) << "a wall is smooth";
                for (int lane = 0; lane < 4; ++lane) EXPECT_EQ(untracked[i][lane], after[i][lane]);
                if (!controlled[i]) {
                    EXPECT_EQ(after[i][2], before[i][2]);
                }
            }
            EXPECT_NEAR(settle(controls, state.boundaries), impulse * 0.1, 1e-13);
            EXPECT_NEAR(state.boundaries[0].impulse[1], impulse, 1e-13);
            EXPECT_EQ(state.boundaries[0].impulse[0], 0);
            EXPECT_EQ(settle(controls, state.boundaries), 0) << "the next step begins from nothing";
            EXPECT_NEAR(state.boundaries[0].impulse[1], impulse, 1e-13)
                << "but the impulse is kept until it is written";
        }
}

TEST(Walls, TheForceOnARestingBodyIsItsWeight) {
    State<2> state = block_state<2>([](Scene& s) {
        s.method.transfer = transfer(TransferScheme::pic);
        s.gravity = {0, -0.5, 0};
        add_wall(s, "floor", 1, Side::lower, 1, 0, false, 0);
    });
    for (auto& v : state.particles.velocity) v.setZero();
    run(state, 20);
    state.boundaries[0].impulse = {};
    run(state, 40);
    EXPECT_NEAR(state.boundaries[0].impulse[1] / 20, 2 * 24 * 0.5, 0.002 * 24);
}

} // namespace
