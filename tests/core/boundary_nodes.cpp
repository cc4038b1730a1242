/// Conditions on the velocity of nodes: several directions at a node (notes 2.3.2, 2.5), boxes of nodes, the axis of
/// rings.

#include "dense.h"

#include <Eigen/Geometry>

#include <map>

namespace {

using namespace test;

Pack direction(const Vec<3>& n) {
    return pack<3>(0, n.normalized());
}

Vec<3> random_vector(std::mt19937& random) {
    std::normal_distribution<double> in;
    return {in(random), in(random), in(random)};
}

Control control(std::int32_t slot, std::int32_t boundary, const Vec<3>& n, double velocity) {
    return {slot, boundary, direction(n), velocity, 0, true, -1, 0};
}

Control of_wall(std::int32_t slot, std::int32_t boundary, const Vec<3>& n, double velocity, double push) {
    return {slot, boundary, direction(n), velocity, push, false, -1, 0};
}

TEST(NodeConditions, TwoObliqueDirectionsHoldTogether) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> in(-1, 1);
    for (int trial = 0; trial < 200; ++trial) {
        Vec<3> n1 = random_vector(random);
        Vec<3> n2 = random_vector(random);
        const bool plane = trial % 2 == 0;
        if (plane) n1[2] = n2[2] = 0;
        n1.normalize();
        n2.normalize();
        if (std::abs(n1.dot(n2)) > 0.999) continue;
        const double v1 = in(random);
        const double v2 = in(random);
        std::vector<Control> controls = {control(0, 0, n1, v1), control(1, 0, n1, 9), control(0, 1, n2, v2)};
        make_orthogonal(controls, 2);
        ASSERT_EQ(controls.size(), 3u);
        EXPECT_EQ(controls[1].velocity, 9) << "a slot with a single condition stays as it is";
        std::vector<Pack> velocity(2, Pack{2.5, in(random), in(random), plane ? 0 : in(random)});
        const Vec<3> before = vector_of<3>(velocity[0]);
        impose(controls, velocity);
        const Vec<3> after = vector_of<3>(velocity[0]);
        const double cosine = n1.dot(n2);
        const double s = 1 - cosine * cosine;
        EXPECT_NEAR(after.dot(n1), v1, 1e-13 / s);
        EXPECT_NEAR(after.dot(n2), v2, 1e-13 / s);
        EXPECT_EQ(velocity[0][0], 2.5);
        // The notes' in-plane momentum, and what is left: the component along n1 × n2.
        Vec<3> expected = (v1 - cosine * v2) / s * n1 + (v2 - cosine * v1) / s * n2;
        const Vec<3> nX = n1.cross(n2).normalized();
        if (!plane) {
            expected += before.dot(nX) * nX;
        }
        EXPECT_LT((after - expected).norm(), 1e-12 / s);
        // Impulses add up to the change of momentum.
        std::vector<Boundary> boundaries(2);
        settle(controls, boundaries);
        Vec<3> impulse = Vec<3>::Zero();
        for (const Control* c : {&controls[0], &controls[2]}) EXPECT_EQ(c->impulse, 0) << "settled";
        for (int a = 0; a < 3; ++a) impulse[a] = boundaries[0].impulse[a] + boundaries[1].impulse[a];
        const Vec<3> lone = 2.5 * (9 - before.dot(n1)) * n1; // of slot 1, boundary 0
        EXPECT_LT((impulse - lone - 2.5 * (after - before)).norm(), 1e-12 / s);
    }
}

TEST(NodeConditions, ImposingIsTheForcesOfTheNotes) {
    // (2.10), (2.11): f = m v n/Δt − (p·n)/Δt n − (f·n) n on top of p + f Δt.
    std::mt19937 random(2);
    std::uniform_real_distribution<double> in(-1, 1);
    for (int trial = 0; trial < 50; ++trial) {
        const Vec<3> n = random_vector(random).normalized();
        const Vec<3> p = random_vector(random);
        const Vec<3> f = random_vector(random);
        const double m = 1.5 + in(random);
        const double dt = 0.1;
        const double v = in(random);
        std::vector<Control> controls = {control(0, 0, n, v)};
        std::vector<Pack> velocity = {pack<3>(m, (p + f * dt) / m)};
        impose(controls, velocity);
        const double reaction = (m * v - p.dot(n)) / dt - f.dot(n);
        EXPECT_NEAR(controls[0].impulse, reaction * dt, 1e-14);
        EXPECT_LT((m * vector_of<3>(velocity[0]) - (p + (f + reaction * n) * dt)).norm(), 1e-14);
        std::vector<Boundary> boundaries(1);
        EXPECT_NEAR(settle(controls, boundaries), reaction * dt * v, 1e-14) << "work: impulse times velocity";
    }
}

TEST(NodeConditions, ThreeObliqueDirectionsHoldTogether) {
    std::mt19937 random(3);
    for (int trial = 0; trial < 100; ++trial) {
        Mat<3> n;
        for (int i = 0; i < 3; ++i) n.row(i) = random_vector(random).normalized();
        const Vec<3> v = random_vector(random);
        std::vector<Control> controls;
        for (int i = 0; i < 3; ++i) controls.push_back(control(0, i, n.row(i), v[i]));
        make_orthogonal(controls, 1);
        std::vector<Pack> velocity = {pack<3>(1, random_vector(random))};
        impose(controls, velocity);
        EXPECT_LT((vector_of<3>(velocity[0]) - n.fullPivLu().solve(v)).norm(), 1e-11 / std::abs(n.determinant()));
    }
}

TEST(NodeConditions, VelocitiesInOneDirectionAddUp) {
    const Vec<3> n(3, 4, 0);
    std::vector<Control> controls = {control(0, 0, n, 0.5), control(0, 1, n, 0.25), control(0, 2, -n, 0.125)};
    make_orthogonal(controls, 1);
    ASSERT_EQ(controls.size(), 1u);
    EXPECT_DOUBLE_EQ(controls[0].velocity, 0.5 + 0.25 - 0.125); // notes (2.12)
    std::vector<Pack> velocity = {Pack{1, 7, -5, 0}};
    impose(controls, velocity);
    EXPECT_NEAR(velocity[0][1] * 0.6 + velocity[0][2] * 0.8, 0.625, 1e-15);
    EXPECT_NEAR(velocity[0][1] * 0.8 - velocity[0][2] * 0.6, 7 * 0.8 + 5 * 0.6, 1e-14);
}

TEST(NodeConditions, GoBeforeWallsOfTheSameDirection) {
    // A floor that only pushes would let the node rise; the condition holds it.
    std::vector<Control> controls = {of_wall(0, 0, {0, 1, 0}, 0, 1), control(0, 1, {0, 1, 0}, 0),
                                     of_wall(1, 0, {0, 1, 0}, 0, 1), control(2, 1, {1, 0, 0}, 3)};
    make_orthogonal(controls, 3);
    ASSERT_EQ(controls.size(), 3u);
    std::vector<Pack> velocity(3, Pack{1, 0, 5, 0});
    impose(controls, velocity);
    EXPECT_EQ(velocity[0][2], 0);
    EXPECT_EQ(velocity[1][2], 5) << "a wall alone still lets go";
    EXPECT_EQ(velocity[2][1], 3);
}

TEST(NodeConditions, LeaveWallsElsewhereAlone) {
    // Two walls across one axis: the later has the last word, whatever is set at another node.
    std::vector<Control> controls = {of_wall(0, 0, {1, 0, 0}, 0.1, 0), control(1, 2, {0, 1, 0}, 7),
                                     of_wall(0, 1, {1, 0, 0}, -0.1, 0)};
    make_orthogonal(controls, 2);
    std::vector<Pack> velocity(2, Pack{1, 4, 4, 0});
    impose(controls, velocity);
    EXPECT_EQ(velocity[0][1], -0.1);
    EXPECT_EQ(velocity[1][2], 7);
}

TEST(NodeConditions, AThirdDirectionInThePlaneIsLeftOut) {
    std::vector<Control> controls = {control(0, 0, {1, 0, 0}, 0.5), control(0, 1, {1, 1, 0}, 0.2),
                                     control(0, 2, {0, 1, 0}, 8)};
    make_orthogonal(controls, 1);
    ASSERT_EQ(controls.size(), 2u);
    std::vector<Pack> velocity = {Pack{1, 7, -5, 3}};
    impose(controls, velocity);
    EXPECT_NEAR(velocity[0][1], 0.5, 1e-15);
    EXPECT_NEAR((velocity[0][1] + velocity[0][2]) / std::sqrt(2.0), 0.2, 1e-15);
    EXPECT_EQ(velocity[0][3], 3);
}

/// A block from 2 to 6 per axis with 8 particles per edge, at rest.
template <int D>
State<D> block(const std::function<void(Scene&)>& change) {
    const MaterialSpec m = material(2, 100, 40);
    Scene scene = D == 2 ? plane_scene(1, 0, 0, 8, 8, m) : space_scene(1, 0, 8, m);
    change(scene);
    Model model;
    const int a = add_body(model, "a");
    if (D == 2)
        add_box(model, a, 2, 2, 6, 6, 8, 8);
    else
        add_cube(model, a, {2, 2, 2}, 4, 8);
    return make_state<D>(scene, model);
}

template <int D>
void check_box() {
    State<D> state = block<D>([](Scene& s) {
        // Both faces on nodes: they are in it. Direction of any length.
        VelocitySpec v{{3, 2.5, 1}, {5, 4, 4.2}, {3, -4, 0}, TimeFunction({0, 1}, {0, 2})};
        s.boundaries.push_back({"v", v});
    });
    find_velocity_fields(state);
    std::vector<Control> controls;
    control_box<D>(std::get<VelocitySpec>(state.scene.boundaries[0].condition), 3, state.grid, state.fields, 0.2, 0.1,
                   controls);
    const auto nodes = slot_nodes(state.fields);
    std::vector<int> expected;
    for (std::size_t slot = 0; slot < nodes.size(); ++slot) {
        const Vec<D> x = state.grid.node_position(nodes[slot]);
        bool in = x[0] >= 3 - 1e-9 && x[0] <= 5 + 1e-9 && x[1] >= 2.5 && x[1] <= 4 + 1e-9;
        if constexpr (D == 3) in = in && x[2] >= 1 - 1e-9 && x[2] <= 4.2;
        if (in) expected.push_back(static_cast<int>(slot));
    }
    std::vector<int> found;
    for (const Control& c : controls) {
        found.push_back(c.slot);
        EXPECT_EQ(c.boundary, 3);
        EXPECT_NEAR(c.velocity, 0.6, 1e-14) << "that at the end of the step";
        EXPECT_NEAR(c.direction[1], 0.6, 1e-15);
        EXPECT_NEAR(c.direction[2], -0.8, 1e-15);
        EXPECT_EQ(c.direction[3], 0);
        EXPECT_EQ(c.push, 0);
    }
    std::sort(found.begin(), found.end());
    ASSERT_GE(expected.size(), D == 2 ? 6u : 18u);
    EXPECT_EQ(found, expected);
}

TEST(NodeConditions, ABoxControlsItsNodes) {
    check_box<2>();
    check_box<3>();
}

TEST(NodeConditions, ABoxAndAWallThatMeetObliquelyBothHold) {
    State<2> state = block<2>([](Scene& s) {
        add_wall(s, "floor", 1, Side::lower, 2, 0.1);
        s.boundaries.push_back({"v", VelocitySpec{{0, 0, 0}, {4, 4, 0}, {1, 2, 0}, 0.3}});
        s.gravity = {1, -3, 0};
    });
    auto tasks = step_tasks<2>(state.scene);
    state.dt = 0.01;
    advance(state, tasks);
    const auto nodes = slot_nodes(state.fields);
    int both = 0;
    for (std::size_t slot = 0; slot < nodes.size(); ++slot) {
        const Vec<2> x = state.grid.node_position(nodes[slot]);
        const Pack v = state.nodes.end_velocity[slot];
        const bool in_box = x[0] <= 4 && x[1] <= 4;
        const bool at_wall = x[1] <= 3;
        if (at_wall) {
            EXPECT_NEAR(v[2], 0.1, 1e-15);
        }
        if (in_box) {
            EXPECT_NEAR((v[1] + 2 * v[2]) / std::sqrt(5.0), 0.3, 1e-15);
        }
        both += in_box && at_wall;
    }
    EXPECT_GT(both, 5);
}

/// Radial velocity is zero on the axis and odd across it, axial velocity free.
TEST(Axis, MirrorsTheRadialVelocity) {
    for (const ShapeKind shape : all_shapes) {
        Scene scene = plane_scene(1, 0, 0, 6, 6, material(2, 100, 40));
        scene.analysis = Analysis::axisymmetric;
        scene.method.shape = shape;
        Model model;
        add_box(model, add_body(model, "a"), 0, 1, 4, 5, 16, 16);
        State<2> state = make_state<2>(scene, model);
        std::mt19937 random(4);
        std::uniform_real_distribution<double> in(-1, 1);
        for (auto& v : state.particles.velocity) v = Vec<2>(in(random), in(random));
        auto tasks = step_tasks<2>(state.scene);
        state.dt = 1e-3;
        advance(state, tasks);
        const auto nodes = slot_nodes(state.fields);
        std::map<Index<2>, Vec<2>> at;
        for (std::size_t slot = 0; slot < nodes.size(); ++slot)
            at[nodes[slot]] = vector_of<2>(state.nodes.end_velocity[slot]);
        int on_axis = 0;
        int beyond = 0;
        for (const auto& [node, v] : at) {
            const int r = node[0] - grid_margin;
            if (r == 0) {
                EXPECT_NEAR(v[0], 0, 1e-15);
                on_axis += v[1] != 0;
            }
            if (r < 0) {
                EXPECT_NEAR(v[0], -at.at({grid_margin - r, node[1]})[0], 1e-14);
                ++beyond;
            }
        }
        EXPECT_GT(on_axis, 3);
        if (degree_of(shape) == 2) {
            EXPECT_GT(beyond, 3) << name_of(shape);
        }
        EXPECT_EQ(state.ledger.external_work, 0) << "the axis does no work";
    }
}

} // namespace
