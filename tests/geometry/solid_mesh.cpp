// The solid in a mesh against CGAL's Side_of_triangle_mesh, where lines meet edges and corners too.
#include "geometry/packing/random.h"
#include "surface_support.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Side_of_triangle_mesh.h>
#include <CGAL/Surface_mesh.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>

using namespace test; // NOLINT(google-build-using-namespace)
using abut::Solid;
using abut::Span;
using testing::ElementsAre;
using testing::IsEmpty;

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using SurfaceMesh = CGAL::Surface_mesh<Kernel::Point_3>;

/// CGAL's answer: 1 inside, 0 on the surface, -1 outside.
class Oracle {
public:
    explicit Oracle(const TriangleMesh& mesh) : surface_(made(mesh)), side_(surface_) {}
    int operator()(const Vector& x) const { return side_({x[0], x[1], x[2]}); }

private:
    static SurfaceMesh made(const TriangleMesh& mesh) {
        SurfaceMesh surface;
        for (const Vector& x : mesh.points) surface.add_vertex({x[0], x[1], x[2]});
        using Vertex = SurfaceMesh::Vertex_index;
        for (const auto& [a, b, c] : mesh.triangles)
            surface.add_face(Vertex(static_cast<unsigned>(a)), Vertex(static_cast<unsigned>(b)),
                             Vertex(static_cast<unsigned>(c)));
        return surface;
    }
    SurfaceMesh surface_;
    CGAL::Side_of_triangle_mesh<SurfaceMesh, Kernel> side_;
};

bool contains(const abut::Spans& spans, double z) {
    return std::any_of(spans.begin(), spans.end(), [&](const Span& s) { return s.from < z && z < s.to; });
}

/// Compares at points that are not on the surface. Returns how many there were.
int compare(const TriangleMesh& mesh, const std::vector<Vector>& points) {
    const Oracle oracle(mesh);
    const Solid solid = abut::solid_of(mesh);
    int compared = 0;
    for (const Vector& x : points) {
        const int side = oracle(x);
        if (side == 0) continue;
        ++compared;
        EXPECT_EQ(contains(solid.spans(x[0], x[1]), x[2]), side > 0) << x[0] << " " << x[1] << " " << x[2];
        if (testing::Test::HasFailure()) break;
    }
    return compared;
}

std::vector<Vector> lattice(const Vector& lower, const Vector& upper, double step) {
    std::vector<Vector> points;
    for (double x = lower[0]; x <= upper[0]; x += step)
        for (double y = lower[1]; y <= upper[1]; y += step)
            for (double z = lower[2]; z <= upper[2]; z += step) points.push_back({x, y, z});
    return points;
}

std::vector<Vector> scattered(int count, const Solid& box, std::uint64_t seed) {
    abut::Random random(seed);
    std::vector<Vector> points(static_cast<std::size_t>(count));
    for (Vector& x : points)
        for (std::size_t i = 0; i < 3; ++i) x[i] = random.between(box.lower[i], box.upper[i]);
    return points;
}

TriangleMesh rounded(TriangleMesh mesh) {
    for (Vector& x : mesh.points)
        for (double& c : x) c = std::round(c);
    return mesh;
}

} // namespace

TEST(SolidMesh, SpansOfACube) {
    const Solid solid = abut::solid_of(cube({1, 2, 3}, 2));
    EXPECT_EQ(solid.lower, (Vector{1, 2, 3}));
    EXPECT_EQ(solid.upper, (Vector{3, 4, 5}));
    EXPECT_THAT(solid.breaks[0], ElementsAre(1, 3));
    EXPECT_THAT(solid.breaks[1], ElementsAre(2, 4));
    EXPECT_THAT(solid.spans(1.5, 2.25), ElementsAre(Span{3, 5}));
    EXPECT_THAT(solid.spans(2, 3), ElementsAre(Span{3, 5})) << "through the diagonals of two faces";
    EXPECT_THAT(solid.spans(0.99, 3), IsEmpty());
    EXPECT_THAT(solid.spans(2, 4.01), IsEmpty());
    EXPECT_THAT(solid.spans(std::nan(""), 3), IsEmpty());
}

TEST(SolidMesh, SheetsThatTouchAndCavities) {
    // Two cubes on top of each other are one column; a cavity parts it.
    const TriangleMesh stack = together(cube(), cube({0, 0, 1}));
    EXPECT_THAT(abut::solid_of(stack).spans(0.5, 0.5), ElementsAre(Span{0, 2}));
    const TriangleMesh hollow = together(cube({0, 0, 0}, 4), flipped(cube({1, 1, 1}, 2)));
    EXPECT_THAT(abut::solid_of(hollow).spans(2, 2), ElementsAre(Span{0, 1}, Span{3, 4}));
    EXPECT_THAT(abut::solid_of(together(hollow, cube({1.5, 1.5, 1.5}, 1))).spans(2, 2),
                ElementsAre(Span{0, 1}, Span{1.5, 2.5}, Span{3, 4}));
    // More crossings than are kept without an allocation.
    TriangleMesh tower;
    for (int i = 0; i < 50; ++i) tower = together(tower, cube({0, 0, 2.0 * i}));
    const abut::Spans spans = abut::solid_of(tower).spans(0.5, 0.5);
    ASSERT_EQ(spans.size(), 50U);
    for (std::size_t i = 0; i < 50; ++i) EXPECT_EQ(spans[i], (Span{2.0 * i, 2.0 * i + 1}));
}

TEST(SolidMesh, CurvedSurfacesAtScatteredPoints) {
    const TriangleMesh ring = torus(2, 0.7, 60, 25);
    EXPECT_GT(compare(ring, scattered(20000, abut::solid_of(ring), 1)), 19000);
    const TriangleMesh shell = together(icosphere(3, 1.0), flipped(icosphere(2, 0.6)));
    EXPECT_GT(compare(shell, scattered(20000, abut::solid_of(shell), 2)), 19000);
}

TEST(SolidMesh, LinesThroughCornersAndEdges) {
    // All corners at integers: the lines of these points pass through corners and along edges and upright faces.
    for (const TriangleMesh& mesh : {rounded(icosphere(1, 9)), rounded(torus(9, 4, 12, 8)), cube({-2, -2, -2}, 4),
                                     together(cube({0, 0, 0}, 9), flipped(cube({3, 3, 3}, 3)))}) {
        const Solid solid = abut::solid_of(mesh);
        EXPECT_TRUE(read(off(faces_of(mesh)), "a.off").repairs.empty());
        std::vector<Vector> points = lattice(solid.lower, solid.upper, 0.5);
        for (Vector& x : points) x[2] += 0.2515625; // off most faces
        EXPECT_GT(compare(mesh, points), 400);
    }
}

TEST(SolidMesh, LinesThroughEveryCornerAndTheMiddleOfEveryEdge) {
    // A turned torus: no coordinate is exact, and middles of edges lie beside their edges by round-off.
    TriangleMesh mesh = torus(2, 0.7, 40, 17);
    for (Vector& x : mesh.points) {
        const double y = 0.6 * x[1] - 0.8 * x[2];
        x = {x[0] * 0.28 - y * 0.96, x[0] * 0.96 + y * 0.28, 0.8 * x[1] + 0.6 * x[2]};
    }
    std::vector<Vector> points;
    for (const Vector& x : mesh.points)
        for (const double dz : {-3.0, -0.9, -0.03, 0.04, 1.1}) points.push_back({x[0], x[1], x[2] + dz});
    for (const auto& t : mesh.triangles)
        for (std::size_t i = 0; i < 3; ++i) {
            const Vector& a = mesh.points[static_cast<std::size_t>(t[i])];
            const Vector& b = mesh.points[static_cast<std::size_t>(t[(i + 1) % 3])];
            for (const double dz : {-1.0, -0.02, 0.03, 1.2})
                points.push_back({(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2 + dz});
        }
    EXPECT_GT(compare(mesh, points), 18000);
}

TEST(SolidMesh, VolumeOfAllLines) {
    const TriangleMesh mesh = icosphere(4);
    const Solid solid = abut::solid_of(mesh);
    double sum = 0;
    constexpr int lines = 400;
    for (int i = 0; i < lines; ++i)
        for (int j = 0; j < lines; ++j)
            for (const Span& s : solid.spans(-1 + (i + 0.5) * 2 / lines, -1 + (j + 0.5) * 2 / lines))
                sum += s.to - s.from;
    EXPECT_NEAR(sum * 4 / lines / lines, volume(mesh), 2e-4 * volume(mesh));
    EXPECT_TRUE(solid.breaks[0].empty()) << "too many to be of use";
}

TEST(SolidMesh, LongTrianglesDontFillMemory) {
    // A fan of slivers, each as long as the box: in a fine division each would be in a thousand bins or more.
    TriangleMesh mesh;
    constexpr int n = 20000;
    for (int i = 0; i < n; ++i) {
        const double angle = 2 * std::numbers::pi * i / n;
        mesh.points.push_back({std::cos(angle), std::sin(angle), 0});
    }
    mesh.points.push_back({0, 0, 1});
    mesh.points.push_back({0, 0, -1});
    for (int i = 0; i < n; ++i) {
        mesh.triangles.push_back({i, (i + 1) % n, n});
        mesh.triangles.push_back({(i + 1) % n, i, n + 1});
    }
    const Solid solid = abut::solid_of(mesh);
    const abut::Spans spans = solid.spans(0.25, 0.25);
    ASSERT_EQ(spans.size(), 1U);
    EXPECT_NEAR(spans[0].to, 1 - std::hypot(0.25, 0.25), 1e-6);
    EXPECT_THAT(solid.spans(0, 0), ElementsAre(Span{-1, 1}));
}

TEST(SolidMesh, FullMillionTrianglesTenMillionPoints) {
    const TriangleMesh mesh = torus(2, 0.7, 1000, 500);
    auto seconds = [start = std::chrono::steady_clock::now()]() mutable {
        const auto now = std::chrono::steady_clock::now();
        return std::chrono::duration<double>(now - std::exchange(start, now)).count();
    };
    const Solid solid = abut::solid_of(mesh);
    std::printf("solid_of, %zu triangles: %.2f s\n", mesh.triangles.size(), seconds());
    constexpr int n = 215;
    long long in_lattice = 0;
#pragma omp parallel for reduction(+ : in_lattice) num_threads(2)
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
            const abut::Spans spans = solid.spans(solid.lower[0] + (i + 0.5) / n * (solid.upper[0] - solid.lower[0]),
                                                  solid.lower[1] + (j + 0.5) / n * (solid.upper[1] - solid.lower[1]));
            for (int k = 0; k < n; ++k)
                in_lattice += contains(spans, solid.lower[2] + (k + 0.5) / n * (solid.upper[2] - solid.lower[2]));
        }
    std::printf("%d points of a lattice: %.3f s\n", n * n * n, seconds());
    const std::vector<Vector> points = scattered(10'000'000, solid, 3);
    seconds();
    long long inside = 0;
#pragma omp parallel for reduction(+ : inside) num_threads(2)
    for (std::size_t k = 0; k < points.size(); ++k)
        inside += contains(solid.spans(points[k][0], points[k][1]), points[k][2]);
    const double scattered_seconds = seconds();
    std::printf("%zu scattered points: %.2f s\n", points.size(), scattered_seconds);
    const Oracle oracle(mesh);
    oracle(points[0]);
    std::printf("CGAL: built in %.2f s\n", seconds());
    long long differ = 0;
    for (std::size_t k = 0; k < 1'000'000; ++k)
        differ += (oracle(points[k]) > 0) != contains(solid.spans(points[k][0], points[k][1]), points[k][2]);
    std::printf("CGAL and this, 1000000 scattered points: %.2f s, %lld differ\n", seconds(), differ);
    EXPECT_EQ(differ, 0);
    const double fraction = volume(mesh) / (5.4 * 5.4 * 1.4);
    EXPECT_NEAR(static_cast<double>(inside) / 1e7, fraction, 1e-3);
    EXPECT_NEAR(static_cast<double>(in_lattice) / (1.0 * n * n * n), fraction, 1e-3);
    EXPECT_LT(scattered_seconds, 30);
}
