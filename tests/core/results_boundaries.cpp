#include "results/boundary_frame.h"

#include "support.h"

#include <gmock/gmock.h>

namespace {

using namespace test;

template <class Value>
const std::vector<Value>& values(const CellFrame& frame, const std::string& name) {
    for (const Array& array : frame.arrays)
        if (array.name == name) return std::get<std::vector<Value>>(array.values);
    throw std::runtime_error("no array " + name);
}

std::vector<Vector> corners(const CellFrame& frame, std::size_t cell) {
    std::vector<Vector> points;
    for (const std::int32_t p : frame.cells[cell])
        points.push_back({frame.points[3 * p], frame.points[3 * p + 1], frame.points[3 * p + 2]});
    return points;
}

TEST(BoundaryFrame, OfAPlaneScene) {
    Scene scene = plane_scene(1, -2, 0, 6, 5, material(1, 100, 40));
    add_wall(scene, "right", 0, Side::upper, 5.5, -3);
    scene.boundaries.push_back(
        {"held", VelocitySpec{{1, 2, 0}, {3, 4, 0}, {3, -4, 0}, TimeFunction({0, 1}, {10, 20})}});
    TractionSpec traction;
    traction.body = "block";
    traction.axis = 1;
    traction.side = Side::upper;
    traction.traction[0] = 7.0;
    traction.pressure = 2.0;
    scene.boundaries.push_back({"top", traction});
    add_wall(scene, "floor", 1, Side::lower, 0.25);
    Model model;
    add_box(model, add_body(model, "block"), 0, 1, 2, 2, 4, 2);
    const State<2> state = make_state<2>(scene, model);
    const CellFrame frame = boundary_frame(state);

    EXPECT_THAT(frame.words[0].values, testing::ElementsAre("right", "held", "top", "floor"));
    ASSERT_EQ(frame.cells.size(), 1U + 4U + 4U + 1U);
    EXPECT_THAT(values<std::int32_t>(frame, "boundary"), testing::ElementsAre(0, 1, 1, 1, 1, 2, 2, 2, 2, 3));
    EXPECT_THAT(values<std::int32_t>(frame, "axis"), testing::ElementsAre(0, -1, -1, -1, -1, 1, 1, 1, 1, 1));
    EXPECT_THAT(corners(frame, 0), testing::UnorderedElementsAre(Vector{5.5, 0, 0}, Vector{5.5, 5, 0}));
    EXPECT_THAT(corners(frame, 9), testing::UnorderedElementsAre(Vector{-2, 0.25, 0}, Vector{6, 0.25, 0}));
    std::vector<std::vector<Vector>> edges;
    for (std::size_t cell = 1; cell < 5; ++cell) edges.push_back(corners(frame, cell));
    using Edge = std::vector<Vector>;
    EXPECT_THAT(edges, testing::UnorderedElementsAre(Edge{{1, 2, 0}, {3, 2, 0}}, Edge{{1, 4, 0}, {3, 4, 0}},
                                                     Edge{{1, 2, 0}, {1, 4, 0}}, Edge{{3, 2, 0}, {3, 4, 0}}));
    double length = 0;
    for (std::size_t cell = 5; cell < 9; ++cell) {
        const std::vector<Vector> face = corners(frame, cell);
        length += std::abs(face[1][0] - face[0][0]);
        for (const Vector& x : face) EXPECT_NEAR(x[1], 2, 1e-14);
    }
    EXPECT_NEAR(length, 2, 1e-14);

    const auto& velocity = values<double>(frame, "velocity");
    const auto& force = values<double>(frame, "traction");
    for (std::size_t cell = 0; cell < 10; ++cell) {
        const bool right = cell == 0, held = cell >= 1 && cell < 5, top = cell >= 5 && cell < 9;
        EXPECT_NEAR(velocity[3 * cell], right ? -3 : held ? 6 : 0, 1e-14) << cell;
        EXPECT_NEAR(velocity[3 * cell + 1], held ? -8 : 0, 1e-14) << cell;
        EXPECT_NEAR(force[3 * cell], top ? 7 : 0, 1e-14) << cell;
        EXPECT_NEAR(force[3 * cell + 1], top ? -2 : 0, 1e-14) << cell; // pressure pushes into the body
    }
}

TEST(BoundaryFrame, OfASceneInSpaceHasLinesBeforePolygons) {
    Scene scene = space_scene(1, 0, 4, material(1, 100, 40));
    add_wall(scene, "lid", 2, Side::upper, 3);
    scene.boundaries.push_back({"held", VelocitySpec{{1, 1, 1}, {2, 3, 2}, {0, 0, 1}, 1.0}});
    TractionSpec traction;
    traction.body = "cube";
    traction.axis = 0;
    traction.side = Side::lower;
    traction.pressure = 5.0;
    scene.boundaries.push_back({"push", traction});
    Model model;
    add_cube(model, add_body(model, "cube"), {1, 1, 1}, 1, 2);
    const CellFrame frame = boundary_frame(make_state<3>(scene, model));

    ASSERT_EQ(frame.cells.size(), 12U + 1U + 4U);
    const auto& boundary = values<std::int32_t>(frame, "boundary");
    for (std::size_t cell = 0; cell < 17; ++cell) {
        EXPECT_EQ(frame.cells[cell].size(), cell < 12 ? 2U : 4U);
        EXPECT_EQ(boundary[cell], cell < 12 ? 1 : cell == 12 ? 0 : 2);
        EXPECT_EQ(values<double>(frame, "velocity")[3 * cell + 2], cell < 12 ? 1 : 0);
        EXPECT_NEAR(values<double>(frame, "traction")[3 * cell], cell < 13 ? 0 : 5, 1e-14);
    }
    // Around the rectangle, not across it.
    const std::vector<Vector> lid = corners(frame, 12);
    for (std::size_t i = 0; i < 4; ++i) {
        const Vector &a = lid[i], &b = lid[(i + 1) % 4];
        EXPECT_EQ(a[2], 3);
        EXPECT_EQ(std::abs(a[0] - b[0]) + std::abs(a[1] - b[1]), 4);
    }
}

TEST(BoundaryFrame, WallsMoveWithTheTime) {
    Scene scene = plane_scene(1, 0, 0, 4, 4, material(1, 100, 40));
    scene.boundaries.push_back({"w", WallSpec{0, Side::lower, 1, TimeFunction({0, 2}, {0, 2}), 1, 0.0, false, true}});
    Model model;
    add_box(model, add_body(model, "block"), 2, 1, 3, 2, 2, 2);
    State<2> state = make_state<2>(scene, model);
    state.time = 2;
    const CellFrame frame = boundary_frame(state);
    EXPECT_EQ(frame.time, 2);
    EXPECT_DOUBLE_EQ(frame.points[0], 1 + 2.0);
    EXPECT_DOUBLE_EQ(values<double>(frame, "velocity")[0], 2);
}

TEST(BoundaryFrame, OfNoBoundaries) {
    Model model;
    add_box(model, add_body(model, "block"), 2, 1, 3, 2, 2, 2);
    const CellFrame frame = boundary_frame(make_state<2>(plane_scene(1, 0, 0, 4, 4, material(1, 100, 40)), model));
    EXPECT_TRUE(frame.cells.empty());
    EXPECT_EQ(frame.arrays.size(), 4U);
}

} // namespace
