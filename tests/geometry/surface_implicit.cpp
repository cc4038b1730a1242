// Surfaces of expressions: volumes against closed forms, several pieces, sharp edges, and all that can be wrong.
#include "geometry/shapes/check_surface.h"
#include "surface_support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>

using namespace test; // NOLINT(google-build-using-namespace)
using abut::Implicit;
using testing::HasSubstr;
using testing::IsEmpty;

namespace {

TriangleMesh timed(const Implicit& spec, double distance, const char* name) {
    const auto start = std::chrono::steady_clock::now();
    TriangleMesh mesh = abut::mesh_implicit(spec, distance);
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    std::printf("%-40s distance %-8g %8zu triangles, %.2f s\n", name, distance, mesh.triangles.size(), seconds);
    return mesh;
}

std::string complaint(const Implicit& spec, double distance = 0.01) {
    try {
        abut::mesh_implicit(spec, distance);
    } catch (const std::runtime_error& error) {
        return error.what();
    }
    return "";
}

Implicit in_box(const std::string& expression, double half = 2) {
    return {expression, 1, {-half, -half, -half}, {half, half, half}};
}

} // namespace

TEST(SurfaceImplicit, Sphere) {
    // Eight particle edges across, to a thousandth of an edge.
    const double exact = 4.0 / 3 * std::numbers::pi;
    const TriangleMesh mesh = timed(in_box("x^2 + y^2 + z^2 - 1", 1.25), 0.25e-3, "sphere of radius 1");
    EXPECT_NEAR(volume(mesh), exact, 1e-3 * exact);
    EXPECT_THAT(abut::surface_problems(mesh), IsEmpty());
    for (const auto& t : mesh.triangles) {
        Vector middle{};
        for (const int corner : t)
            for (std::size_t i = 0; i < 3; ++i) middle[i] += mesh.points[static_cast<std::size_t>(corner)][i] / 3;
        ASSERT_NEAR(std::hypot(middle[0], middle[1], middle[2]), 1, 0.5e-3);
    }
}

TEST(SurfaceImplicit, ErrorFallsWithTheDistance) {
    const double exact = 4.0 / 3 * std::numbers::pi;
    for (const double distance : {0.04, 0.01, 0.0025}) {
        const double error =
            std::abs(volume(timed(in_box("x^2 + y^2 + z^2 - 1"), distance, "sphere of radius 1")) / exact - 1);
        std::printf("   relative error of volume %.2e\n", error);
        EXPECT_LT(error, 3 * distance); // no triangle lies farther inside than `distance`, which would be 3 d / r
    }
}

TEST(SurfaceImplicit, Torus) {
    const double exact = 2 * std::numbers::pi * std::numbers::pi * 1.0 * 0.4 * 0.4;
    const TriangleMesh mesh = timed(in_box("(sqrt(x^2 + y^2) - 1)^2 + z^2 - 0.16"), 1e-3, "torus 1, 0.4");
    EXPECT_NEAR(volume(mesh), exact, 5e-3 * exact);
    EXPECT_THAT(abut::surface_problems(mesh), IsEmpty());
}

TEST(SurfaceImplicit, UnitAndBox) {
    const Implicit spec{"(x - 10)^2 + y^2 + z^2/4 - 1", 1e-6, {8.5e-6, -1.2e-6, -2.5e-6}, {11.5e-6, 1.2e-6, 2.5e-6}};
    const double exact = 4.0 / 3 * std::numbers::pi * 2e-18;
    EXPECT_NEAR(volume(timed(spec, 1e-9, "ellipsoid of micrometres")), exact, 3e-3 * exact);
}

TEST(SurfaceImplicit, SeveralPiecesAndCavities) {
    // Two balls, one of them small and in a corner of the box.
    const TriangleMesh two =
        timed(in_box("min(x^2 + y^2 + z^2 - 1, (x-1.7)^2 + (y-1.7)^2 + (z+1.7)^2 - 0.04)"), 2e-3, "two balls");
    const double exact = 4.0 / 3 * std::numbers::pi * (1 + 0.008);
    EXPECT_NEAR(volume(two), exact, 6e-3 * exact);
    EXPECT_GT(volume(two), 4.0 / 3 * std::numbers::pi * 1.002) << "the small one is there";
    const TriangleMesh shell = timed(in_box("abs(sqrt(x^2 + y^2 + z^2) - 1) - 0.1"), 2e-3, "shell");
    const double hollow = 4.0 / 3 * std::numbers::pi * (1.331 - 0.729);
    EXPECT_NEAR(volume(shell), hollow, 1e-2 * hollow);
}

TEST(SurfaceImplicit, Gyroid) {
    // A sheet gyroid cut by a ball: volume by a fine raster.
    const auto value = [](double x, double y, double z) {
        const double g = std::sin(x) * std::cos(y) + std::sin(y) * std::cos(z) + std::sin(z) * std::cos(x);
        return std::max(std::abs(g) - 0.5, (x * x + y * y + z * z - 16) / 8);
    };
    const Implicit spec =
        in_box("max(abs(sin(x)*cos(y) + sin(y)*cos(z) + sin(z)*cos(x)) - 0.5, (x^2+y^2+z^2-16)/8)", 4.5);
    constexpr int n = 300;
    long long count = 0;
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j)
            for (int k = 0; k < n; ++k)
                count += value(-4.5 + 9 * (i + 0.5) / n, -4.5 + 9 * (j + 0.5) / n, -4.5 + 9 * (k + 0.5) / n) < 0;
    const double expected = static_cast<double>(count) * 9 * 9 * 9 / (1.0 * n * n * n);
    const TriangleMesh mesh = timed(spec, 0.02, "gyroid in a ball");
    EXPECT_NEAR(volume(mesh), expected, 0.01 * expected);
}

TEST(SurfaceImplicit, SharpEdges) {
    const TriangleMesh mesh = timed(in_box("max(abs(x), max(abs(y), abs(z))) - 1"), 0.01, "cube");
    EXPECT_NEAR(volume(mesh), 8, 0.24);
    const TriangleMesh lens = timed(in_box("max((x-0.6)^2 + y^2 + z^2, (x+0.6)^2 + y^2 + z^2) - 1"), 0.005, "lens");
    const double exact = 2 * std::numbers::pi * 0.16 / 3 * (3 - 0.4); // two caps of height 0.4
    // At most the area times the distance is lost: 2 * 2 pi 0.4 * 0.005.
    EXPECT_NEAR(volume(lens), exact, 4 * std::numbers::pi * 0.4 * 0.005);
    const TriangleMesh fine = timed(in_box("max(abs(x), max(abs(y), abs(z))) - 1"), 1e-3, "cube");
    EXPECT_NEAR(volume(fine), 8, 24e-3);
}

TEST(SurfaceImplicit, SameTwice) {
    const Implicit spec = in_box("x^4 + y^4 + z^4 - 1");
    const TriangleMesh a = abut::mesh_implicit(spec, 0.01), b = abut::mesh_implicit(spec, 0.01);
    EXPECT_EQ(a.points, b.points);
    EXPECT_EQ(a.triangles, b.triangles);
}

TEST(SurfaceImplicit, Errors) {
    EXPECT_THAT(complaint(in_box("x^2 + y^2 + z^2 - ")), HasSubstr("at its end: "));
    EXPECT_THAT(complaint(in_box("x + foo(y)")), HasSubstr("character 5"));
    EXPECT_THAT(complaint(in_box("x^2 + w")), HasSubstr("\"w\""));
    EXPECT_THAT(complaint(in_box("")), HasSubstr("implicit surface: "));
    EXPECT_THAT(complaint(in_box("2 - 3")), HasSubstr("don't occur"));
    EXPECT_THAT(complaint(in_box("x, y")), HasSubstr("commas"));
    EXPECT_THAT(complaint(in_box("x^2 + y^2 + z^2 + 1")), HasSubstr("nowhere negative"));
    EXPECT_THAT(complaint(in_box("x^2 + y^2 + z^2 - 5")), HasSubstr("reaches out of its box at "));
    EXPECT_THAT(complaint(in_box("y^2 + z^2 - 1")), HasSubstr("reaches out of its box at x = -2"));
    EXPECT_THAT(complaint(in_box("z - 1.9")), HasSubstr("reaches out of its box"));
    EXPECT_THAT(complaint(in_box("sqrt(x) + y^2 + z^2 - 1")), HasSubstr("is not a number at x = -2"));
}
