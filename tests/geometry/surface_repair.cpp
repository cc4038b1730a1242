// What "repair" mends, what it says, and what it can't.
#include "surface_support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

using namespace test; // NOLINT(google-build-using-namespace)
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

namespace {

abut::RepairedMesh repaired(const TriangleMesh& mesh) {
    return read(off(faces_of(mesh)), "a.off", true);
}

} // namespace

TEST(SurfaceRepair, NothingToDo) {
    const abut::RepairedMesh result = repaired(cube());
    EXPECT_THAT(result.repairs, IsEmpty());
    EXPECT_DOUBLE_EQ(volume(result.mesh), 1);
}

TEST(SurfaceRepair, ClosesHoles) {
    TriangleMesh mesh = cube();
    mesh.triangles.erase(mesh.triangles.begin(), mesh.triangles.begin() + 4); // bottom and top
    const abut::RepairedMesh result = repaired(mesh);
    EXPECT_THAT(result.repairs, ElementsAre("closed 2 holes"));
    EXPECT_DOUBLE_EQ(volume(result.mesh), 1);
    EXPECT_EQ(result.mesh.triangles.size(), 12U);
}

TEST(SurfaceRepair, TurnsTriangles) {
    TriangleMesh mesh = cube();
    std::swap(mesh.triangles[0][0], mesh.triangles[0][1]);
    std::swap(mesh.triangles[7][0], mesh.triangles[7][1]);
    abut::RepairedMesh result = repaired(mesh);
    EXPECT_THAT(result.repairs, ElementsAre("turned 2 triangles that faced the wrong way"));
    EXPECT_DOUBLE_EQ(volume(result.mesh), 1);
    result = repaired(flipped(cube()));
    EXPECT_THAT(result.repairs, ElementsAre("turned 12 triangles that faced the wrong way"));
    EXPECT_DOUBLE_EQ(volume(result.mesh), 1);
    // Cavities face inwards.
    result = repaired(together(cube({0, 0, 0}, 4), cube({1, 1, 1}, 2)));
    EXPECT_DOUBLE_EQ(volume(result.mesh), 56);
}

TEST(SurfaceRepair, RemovesDuplicatesAndTrianglesWithoutArea) {
    TriangleMesh mesh = cube();
    mesh.triangles.push_back(mesh.triangles[5]);
    mesh.triangles.push_back({1, 1, 2});
    abut::RepairedMesh result = repaired(mesh);
    EXPECT_THAT(result.repairs, ElementsAre("removed 2 triangles without area or there already"));
    EXPECT_DOUBLE_EQ(volume(result.mesh), 1);
    // A point on the edge 0 - 1 of one of its triangles only, and a triangle without area to fill the gap.
    mesh = cube();
    mesh.points.push_back({0.5, 0, 0});
    const auto bottom = std::find_if(mesh.triangles.begin(), mesh.triangles.end(), [](const auto& t) {
        return std::count(t.begin(), t.end(), 0) && std::count(t.begin(), t.end(), 1) &&
               std::count(t.begin(), t.end(), 3);
    });
    ASSERT_NE(bottom, mesh.triangles.end());
    ASSERT_EQ(*bottom, (std::array<int, 3>{0, 3, 1}));
    *bottom = {0, 3, 8};
    mesh.triangles.push_back({8, 3, 1});
    mesh.triangles.push_back({0, 8, 1});
    result = repaired(mesh);
    EXPECT_THAT(result.repairs, Contains(HasSubstr("without area")));
    EXPECT_NEAR(volume(result.mesh), 1, 1e-12);
}

TEST(SurfaceRepair, PartsWhatOnlyTouches) {
    for (const Vector& other : {Vector{1, 1, 0}, Vector{1, 1, 1}}) {
        const abut::RepairedMesh result = repaired(together(cube(), cube(other)));
        EXPECT_THAT(result.repairs, Contains(HasSubstr("parted sheets that only touch")));
        EXPECT_DOUBLE_EQ(volume(result.mesh), 2);
    }
}

TEST(SurfaceRepair, UnitesPiecesThatCross) {
    const abut::RepairedMesh result = repaired(together(cube(), cube({0.5, 0.25, 0.125})));
    EXPECT_THAT(result.repairs, ElementsAre("united 2 pieces that crossed each other"));
    EXPECT_NEAR(volume(result.mesh), 2 - 0.5 * 0.75 * 0.875, 1e-12);
}

TEST(SurfaceRepair, RemovesWhatCrossesItself) {
    TriangleMesh mesh = icosphere(3);
    // One point pushed beyond a neighbour, so that triangles fold over others.
    const auto& t = mesh.triangles[500];
    Vector& x = mesh.points[static_cast<std::size_t>(t[0])];
    const Vector neighbour = mesh.points[static_cast<std::size_t>(t[1])];
    for (std::size_t i = 0; i < 3; ++i) x[i] += 1.7 * (neighbour[i] - x[i]);
    const std::string refused = complaint(off(faces_of(mesh)));
    ASSERT_THAT(refused, HasSubstr("cross"));
    const abut::RepairedMesh result = repaired(mesh);
    EXPECT_THAT(result.repairs, Contains("removed what crossed itself"));
    EXPECT_NEAR(volume(result.mesh), volume(icosphere(3)), 0.05 * volume(icosphere(3)));
}

TEST(SurfaceRepair, SaysWhatItCant) {
    // A single triangle has no inside.
    EXPECT_THAT(complaint(off(Faces{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}}), "a.off", true),
                HasSubstr("can't be repaired"));
    EXPECT_THAT(complaint(off(Faces{{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}}}), "a.off", true),
                HasSubstr("can't be repaired"));
}
