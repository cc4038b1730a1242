// Surfaces from files: every format, and everything that can be wrong with a file or with what it holds.
#include "surface_support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>

using namespace test; // NOLINT(google-build-using-namespace)
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

namespace {

Bytes cut(const Bytes& bytes, std::size_t size) {
    return {bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size)};
}

Bytes with_crlf(const Bytes& bytes) {
    Bytes result;
    for (const std::uint8_t byte : bytes) {
        if (byte == '\n') result.push_back('\r');
        result.push_back(byte);
    }
    return result;
}

} // namespace

TEST(SurfaceRead, EveryFormatGivesTheSameMesh) {
    const TriangleMesh made = cube({1, 2, 3}, 0.5);
    for (const auto& [name, bytes] : every_format(faces_of(made))) {
        const abut::RepairedMesh result = read(bytes, name);
        EXPECT_EQ(result.mesh.points.size(), 8U) << name;
        EXPECT_EQ(result.mesh.triangles.size(), 12U) << name;
        EXPECT_DOUBLE_EQ(volume(result.mesh), 0.125) << name;
        EXPECT_TRUE(result.repairs.empty()) << name;
    }
}

TEST(SurfaceRead, CurvedSurfacesInEveryFormat) {
    const TriangleMesh sphere = icosphere(2);
    for (const auto& [name, bytes] : every_format(faces_of(sphere))) {
        const TriangleMesh mesh = read(bytes, name).mesh;
        EXPECT_EQ(mesh.points.size(), sphere.points.size()) << name;
        EXPECT_NEAR(volume(mesh), volume(sphere), 1e-6) << name; // floats
    }
    const TriangleMesh ring = torus(2, 0.5, 30, 12);
    EXPECT_NEAR(volume(read(off(faces_of(ring)), "a.off").mesh), volume(ring), 1e-14);
}

TEST(SurfaceRead, WindowsLineEnds) {
    const Faces mesh = faces_of(cube());
    for (const auto& [name, bytes] : {std::pair<std::string, Bytes>{"a.stl", stl_text(mesh)},
                                      {"a.off", off(mesh)},
                                      {"a.obj", obj(mesh)},
                                      {"a.ply", ply(mesh, Ply::text)}})
        EXPECT_DOUBLE_EQ(volume(read(with_crlf(bytes), name).mesh), 1) << name;
}

TEST(SurfaceRead, FormatsAreToldByContents) {
    const Faces mesh = faces_of(cube());
    EXPECT_DOUBLE_EQ(volume(read(off(mesh), "wrong.stl").mesh), 1);
    EXPECT_DOUBLE_EQ(volume(read(ply(mesh, Ply::big), "wrong.off").mesh), 1);
    EXPECT_DOUBLE_EQ(volume(read(stl_binary(mesh), "wrong.ply").mesh), 1);
    EXPECT_DOUBLE_EQ(volume(read(stl_text(mesh), "no-extension").mesh), 1);
    EXPECT_DOUBLE_EQ(volume(read(stl_binary(mesh, "solid but binary"), "a.stl").mesh), 1);
    EXPECT_DOUBLE_EQ(volume(read(stl_text(mesh), "A.STL").mesh), 1);
    EXPECT_THAT(complaint(obj(mesh), "a.txt"), HasSubstr("is no STL, OFF, PLY or OBJ file"));
    EXPECT_THAT(complaint(bytes_of("hello world\n"), "a.stl"), HasSubstr("is no STL, OFF, PLY or OBJ file"));
    EXPECT_THAT(complaint({}, "a.stl"), HasSubstr("the file is empty"));
    EXPECT_THAT(complaint(bytes_of("# nothing\n"), "a.obj"), HasSubstr("has no faces"));
    EXPECT_THAT(complaint(bytes_of("solid nothing\nendsolid\n"), "a.stl"), HasSubstr("has no faces"));
    abut::Surface spec;
    EXPECT_THROW(abut::read_surface(spec, "/no/such/file.stl"), std::runtime_error);
    EXPECT_THROW(abut::read_surface(spec, "/tmp"), std::runtime_error);
    EXPECT_THROW(abut::read_surface(spec, "/dev/zero"), std::runtime_error);
}

TEST(SurfaceRead, VariantsOfTheFormats) {
    const Faces mesh = faces_of(tetrahedron());
    // OFF: colours behind faces, counts in the line of the keyword, normals and colours behind points.
    EXPECT_NEAR(volume(read(off(mesh, " 3 255 0 0"), "a.off").mesh), 1.0 / 6, 1e-15);
    EXPECT_NEAR(
        volume(read(bytes_of("CNOFF 4 4 6\n0 0 0 0 0 1 1 1 1 1\n+1 0 0 0 0 1 1 1 1 1\n0 1 0 0 0 1 1 1 1 1\n0 0 1e0 0 "
                             "0 1 1 1 1 1\n3 0 2 1\n3 0 1 3\n3 0 3 2 # done\n3 1 2 3"),
                    "a.off")
                   .mesh),
        1.0 / 6, 1e-15);
    // OBJ: relative indices, faces before points, lines that go on.
    EXPECT_NEAR(
        volume(read(bytes_of("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1 1.0\nf -4 -2 -3\nf 1/1/1 2/1/1 \\\n4/1/1\nf 1/2 4/3 "
                             "3/1\nf 2 3 4\n"),
                    "a.obj")
                   .mesh),
        1.0 / 6, 1e-15);
    EXPECT_NEAR(
        volume(
            read(bytes_of("f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n"), "a.obj").mesh),
        1.0 / 6, 1e-15);
    // STL: two solids in one file, capitals.
    Bytes two = stl_text(faces_of(cube()));
    append(two, stl_text(faces_of(cube({3, 0, 0}))));
    EXPECT_DOUBLE_EQ(volume(read(two, "a.stl").mesh), 2);
    std::string capitals;
    for (const std::uint8_t byte : stl_text(mesh)) capitals += static_cast<char>(std::toupper(byte));
    EXPECT_NEAR(volume(read(bytes_of(capitals), "a.stl").mesh), 1.0 / 6, 1e-15);
    // PLY: doubles, other lists, other elements.
    EXPECT_NEAR(
        volume(read(bytes_of("ply\nformat ascii 1.0\nelement thing 1\nproperty list int float x\nelement vertex 4\n"
                             "property double z\nproperty double y\nproperty double x\nelement face 4\n"
                             "property uchar flag\nproperty list ushort uint vertex_index\nend_header\n2 1.5 2.5\n"
                             "0 0 0\n0 0 1\n0 1 0\n1 0 0\n7 3 0 2 1\n7 3 0 1 3\n7 3 0 3 2\n7 3 1 2 3\n"),
                    "a.ply")
                   .mesh),
        1.0 / 6, 1e-15);
}

TEST(SurfaceRead, FacesOfMoreCorners) {
    EXPECT_DOUBLE_EQ(volume(read(off(quad_cube()), "a.off").mesh), 1);
    EXPECT_DOUBLE_EQ(volume(read(obj(quad_cube()), "a.obj").mesh), 1);
    // A prism over an L: concave faces of six corners.
    Faces prism;
    const std::vector<std::array<double, 2>> outline{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
    for (const double z : {0.0, 1.0})
        for (const auto& [x, y] : outline) prism.points.push_back({x, y, z});
    prism.faces = {{5, 4, 3, 2, 1, 0}, {6, 7, 8, 9, 10, 11}};
    for (int i = 0; i < 6; ++i) prism.faces.push_back({i, (i + 1) % 6, 6 + (i + 1) % 6, 6 + i});
    const TriangleMesh mesh = read(off(prism), "a.off").mesh;
    EXPECT_EQ(mesh.triangles.size(), 20U);
    EXPECT_NEAR(volume(mesh), 3, 1e-14);
    // Faces that are not plane are divided all the same.
    Faces bent = quad_cube();
    bent.points[7] = {1.2, 1.1, 1.3};
    EXPECT_EQ(read(off(bent), "a.off").mesh.triangles.size(), 12U);
    // A figure of eight can't be.
    Faces eight = quad_cube();
    std::swap(eight.faces[0][1], eight.faces[0][2]);
    EXPECT_THAT(complaint(off(eight)), HasSubstr("1 face can't be divided into triangles, as their outlines"));
    Faces line = quad_cube();
    line.faces.push_back({0, 1});
    EXPECT_THAT(complaint(off(line)), HasSubstr("1 face has fewer than three corners, first face 7 of the file"));
}

TEST(SurfaceRead, Placement) {
    abut::Placement placement;
    placement.scale = 1e-3;
    placement.axis = {0, 0, 2};
    placement.angle = std::numbers::pi / 2;
    placement.translation = {5, 0, 0};
    const TriangleMesh mesh = read(off(faces_of(cube({1, 0, 0}, 1))), "a.off", false, placement).mesh;
    EXPECT_NEAR(volume(mesh), 1e-9, 1e-15);
    for (const Vector& x : mesh.points) { // (x, y) -> (-y, x)
        EXPECT_TRUE(std::abs(x[0] - 5) < 1e-12 || std::abs(x[0] - 4.999) < 1e-12) << x[0];
        EXPECT_TRUE(std::abs(x[1] - 0.001) < 1e-12 || std::abs(x[1] - 0.002) < 1e-12) << x[1];
    }
    // About the diagonal by a third: x -> y -> z -> x.
    placement = {1, {1, 1, 1}, 2 * std::numbers::pi / 3, {}};
    const TriangleMesh turned =
        read(off(Faces{{{1, 0, 0}, {2, 0, 0}, {1, 3, 0}, {1, 0, 5}}, {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}}),
             "a.off", false, placement)
            .mesh;
    double y = 0, z = 0, x = 0;
    for (const Vector& p : turned.points) x = std::max(x, p[0]), y = std::max(y, p[1]), z = std::max(z, p[2]);
    EXPECT_NEAR(x, 5, 1e-14);
    EXPECT_NEAR(y, 2, 1e-14);
    EXPECT_NEAR(z, 3, 1e-14);
}

TEST(SurfaceRead, MissingFace) {
    TriangleMesh mesh = cube();
    mesh.triangles.erase(mesh.triangles.begin() + 2); // a triangle at the top
    EXPECT_THAT(complaint(off(faces_of(mesh))),
                AllOf(HasSubstr("3 edges with a triangle on one side only, around 1 hole, first at (0.5, 0.5, 1) m"),
                      HasSubstr("a.off\""), HasSubstr("\"repair\": true"), Not(HasSubstr("wrong way"))));
    mesh.triangles.erase(mesh.triangles.begin()); // and one at the bottom
    EXPECT_THAT(complaint(off(faces_of(mesh))), HasSubstr("6 edges with a triangle on one side only, around 2 holes"));
}

TEST(SurfaceRead, FlippedFaces) {
    TriangleMesh mesh = cube();
    std::swap(mesh.triangles[0][0], mesh.triangles[0][1]);
    EXPECT_THAT(complaint(off(faces_of(mesh))),
                HasSubstr("3 edges between triangles of which one faces the wrong way"));
    EXPECT_THAT(complaint(off(faces_of(flipped(cube())))), HasSubstr("inside out: its triangles face inwards"));
    EXPECT_THAT(complaint(off(faces_of(together(cube(), flipped(cube({4, 0, 0})))))),
                HasSubstr("1 of 2 closed pieces face the wrong way"));
}

TEST(SurfaceRead, Cavities) {
    const TriangleMesh hollow = together(cube({0, 0, 0}, 4), flipped(cube({1, 1, 1}, 2)));
    EXPECT_DOUBLE_EQ(volume(read(off(faces_of(hollow)), "a.off").mesh), 64 - 8);
    EXPECT_DOUBLE_EQ(volume(read(off(faces_of(together(hollow, cube({1.5, 1.5, 1.5}, 1)))), "a.off").mesh), 64 - 8 + 1);
    EXPECT_THAT(complaint(off(faces_of(together(cube({0, 0, 0}, 4), cube({1, 1, 1}, 2))))),
                HasSubstr("1 of 2 closed pieces face the wrong way"));
}

TEST(SurfaceRead, DuplicatesAndTrianglesWithoutArea) {
    TriangleMesh mesh = cube();
    mesh.triangles.push_back(mesh.triangles[5]);
    EXPECT_THAT(complaint(off(faces_of(mesh))),
                AllOf(HasSubstr("1 triangle is there already, first at"),
                      HasSubstr("3 edges with more than two triangles"), Not(HasSubstr("cross"))));
    mesh = cube();
    mesh.triangles.push_back({0, 1, 1});
    EXPECT_THAT(complaint(off(faces_of(mesh))), HasSubstr("1 triangle without area"));
    mesh = cube();
    mesh.points.push_back({0.5, 0, 0}); // on an edge
    mesh.triangles.push_back({0, 8, 1});
    EXPECT_THAT(complaint(off(faces_of(mesh))), HasSubstr("1 triangle without area, first at (0.5, 0, 0) m"));
}

TEST(SurfaceRead, NonManifold) {
    const TriangleMesh at_edge = together(cube(), cube({1, 1, 0})); // one edge in common
    EXPECT_THAT(complaint(off(faces_of(at_edge))),
                HasSubstr("1 edge with more than two triangles, first at (1, 1, 0.5) m"));
    const TriangleMesh at_corner = together(cube(), cube({1, 1, 1}));
    EXPECT_THAT(complaint(off(faces_of(at_corner))),
                AllOf(HasSubstr("1 point where sheets of the surface only touch, first at (1, 1, 1) m"),
                      Not(HasSubstr("edge"))));
}

TEST(SurfaceRead, SelfIntersections) {
    EXPECT_THAT(
        complaint(off(faces_of(together(cube(), cube({0.5, 0.25, 0.125}))))),
        AllOf(HasSubstr("pairs of triangles that cross or overlap each other, first at ("), Not(HasSubstr("edge"))));
    // Touching along parts of a face.
    EXPECT_THAT(complaint(off(faces_of(together(cube(), cube({1, 0.25, 0.25}, 0.5))))), HasSubstr("cross or overlap"));
    // A spike drawn through the opposite face: triangles that share a corner with none of those they cross.
    TriangleMesh mesh = icosphere(2);
    mesh.points[0] = {-mesh.points[0][0] * 2, -mesh.points[0][1] * 2, -mesh.points[0][2] * 2};
    EXPECT_THAT(complaint(off(faces_of(mesh))), HasSubstr("cross or overlap"));
}

TEST(SurfaceRead, AllProblemsInOneMessage) {
    TriangleMesh mesh = together(cube(), cube({0.5, 0.25, 0.125}));
    mesh.triangles.erase(mesh.triangles.begin());
    mesh.triangles.push_back(mesh.triangles[15]);
    mesh.triangles.push_back({3, 3, 2});
    EXPECT_THAT(complaint(off(faces_of(mesh))),
                AllOf(HasSubstr("without area"), HasSubstr("there already"), HasSubstr("hole"),
                      HasSubstr("more than two"), HasSubstr("cross")));
}

TEST(SurfaceRead, NotFinite) {
    for (const double bad : std::initializer_list<double>{std::nan(""), INFINITY, -INFINITY}) {
        TriangleMesh mesh = cube();
        mesh.points[7][1] = bad; // of faces 3, 4, 8, 11 … counted by hand: corners of the cube's last point
        int faces = 0;
        for (const auto& t : mesh.triangles) faces += std::count(t.begin(), t.end(), 7) > 0;
        for (const auto& [name, bytes] : every_format(faces_of(mesh)))
            EXPECT_THAT(complaint(bytes, name),
                        HasSubstr(std::to_string(faces) +
                                  " faces have coordinates that are not finite numbers, first in face 3"))
                << name << bad;
    }
    EXPECT_THAT(complaint(bytes_of("OFF 4 1 0\n0 0 0\n1e999 0 0\n0 1 0\n0 0 1\n3 0 1 2\n")), HasSubstr("not finite"));
}

TEST(SurfaceRead, CutOffFiles) {
    for (const auto& [name, bytes] : every_format(faces_of(icosphere(0)))) {
        // The name behind "endsolid", the normal of an OBJ file's last corner and the line's end are no loss.
        const std::size_t spare = name == "text.stl"                             ? 12
                                  : name == "a.obj"                              ? 4
                                  : name == "binary.stl" || bytes.back() != '\n' ? 0
                                                                                 : 1;
        for (std::size_t size = 0; size + spare < bytes.size(); size += 7)
            EXPECT_NE(complaint(cut(bytes, size), name), "") << name << " " << size;
        EXPECT_NE(complaint(cut(bytes, bytes.size() - spare - 1), name), "") << name;
        EXPECT_EQ(complaint(cut(bytes, bytes.size() - spare), name), "") << name;
    }
    const Faces mesh = faces_of(cube());
    EXPECT_THAT(complaint(cut(stl_binary(mesh), 500), "a.stl"),
                HasSubstr("12 triangles, which take 684 bytes, but the file has 500"));
    EXPECT_THAT(complaint(cut(stl_text(mesh), 500), "a.stl"), HasSubstr("cut off"));
    EXPECT_THAT(complaint(cut(off(mesh), 150)), HasSubstr("cut off"));
    EXPECT_THAT(complaint(cut(ply(mesh, Ply::little), 300), "a.ply"), HasSubstr("follow"));
    EXPECT_THAT(complaint(cut(ply(mesh, Ply::big), ply(mesh, Ply::big).size() - 1), "a.ply"), HasSubstr("cut off"));
}

TEST(SurfaceRead, FullMillionTriangles) {
    const Bytes bytes = stl_binary(faces_of(torus(2, 0.7, 1000, 500)));
    const Folder folder;
    const auto file = folder.write("big.stl", bytes);
    const auto start = std::chrono::steady_clock::now();
    const abut::RepairedMesh result = abut::read_surface({}, file);
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    std::printf("%zu triangles read and checked in %.2f s\n", result.mesh.triangles.size(), seconds);
    EXPECT_EQ(result.mesh.triangles.size(), 1000000U);
}
