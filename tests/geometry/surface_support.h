#pragma once
/// Surfaces made in the tests, and writers of surface files, byte by byte.

#include "geometry/shapes/surface.h"
#include "support.h"

#include <bit>
#include <cmath>
#include <map>
#include <numbers>

namespace test {

using abut::TriangleMesh;
using abut::Vector;

/// Faces of any number of corners.
struct Faces {
    std::vector<Vector> points;
    std::vector<std::vector<int>> faces;
};

inline Faces faces_of(const TriangleMesh& mesh) {
    Faces faces{mesh.points, {}};
    for (const auto& [a, b, c] : mesh.triangles) faces.faces.push_back({a, b, c});
    return faces;
}

inline Faces quad_cube(const Vector& lower = {0, 0, 0}, double edge = 1) {
    Faces cube;
    for (int k = 0; k < 8; ++k)
        cube.points.push_back(
            {lower[0] + edge * (k & 1), lower[1] + edge * ((k >> 1) & 1), lower[2] + edge * (k >> 2)});
    cube.faces = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
    return cube;
}

inline TriangleMesh cube(const Vector& lower = {0, 0, 0}, double edge = 1) {
    const Faces quads = quad_cube(lower, edge);
    TriangleMesh mesh{quads.points, {}};
    for (const auto& f : quads.faces) {
        mesh.triangles.push_back({f[0], f[1], f[2]});
        mesh.triangles.push_back({f[0], f[2], f[3]});
    }
    return mesh;
}

inline TriangleMesh tetrahedron() {
    return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
}

/// An icosahedron whose triangles are divided in four `levels` times, on a sphere.
inline TriangleMesh icosphere(int levels, double radius = 1, const Vector& center = {0, 0, 0}) {
    const double g = std::numbers::phi;
    TriangleMesh mesh{{{-1, g, 0},
                       {1, g, 0},
                       {-1, -g, 0},
                       {1, -g, 0},
                       {0, -1, g},
                       {0, 1, g},
                       {0, -1, -g},
                       {0, 1, -g},
                       {g, 0, -1},
                       {g, 0, 1},
                       {-g, 0, -1},
                       {-g, 0, 1}},
                      {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                       {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                       {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}}};
    for (int level = 0; level < levels; ++level) {
        std::map<std::pair<int, int>, int> middles;
        const auto middle = [&](int a, int b) {
            const auto [entry, added] =
                middles.try_emplace({std::min(a, b), std::max(a, b)}, static_cast<int>(mesh.points.size()));
            if (added) {
                Vector x{};
                for (std::size_t i = 0; i < 3; ++i)
                    x[i] = mesh.points[static_cast<std::size_t>(a)][i] + mesh.points[static_cast<std::size_t>(b)][i];
                const double length = std::hypot(x[0], x[1], x[2]) / std::hypot(1.0, g);
                for (double& coordinate : x) coordinate /= length;
                mesh.points.push_back(x);
            }
            return entry->second;
        };
        std::vector<std::array<int, 3>> finer;
        for (const auto& [a, b, c] : mesh.triangles) {
            const int ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
            finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
        }
        mesh.triangles = std::move(finer);
    }
    for (Vector& x : mesh.points)
        for (std::size_t i = 0; i < 3; ++i) x[i] = center[i] + x[i] * radius / std::hypot(1.0, g);
    return mesh;
}

/// Around z.
inline TriangleMesh torus(double ring, double tube, int around, int across) {
    TriangleMesh mesh;
    for (int i = 0; i < around; ++i)
        for (int j = 0; j < across; ++j) {
            const double u = 2 * std::numbers::pi * i / around, v = 2 * std::numbers::pi * j / across;
            const double r = ring + tube * std::cos(v);
            mesh.points.push_back({r * std::cos(u), r * std::sin(u), tube * std::sin(v)});
            const int i1 = (i + 1) % around, j1 = (j + 1) % across;
            mesh.triangles.push_back({i * across + j, i1 * across + j, i1 * across + j1});
            mesh.triangles.push_back({i * across + j, i1 * across + j1, i * across + j1});
        }
    return mesh;
}

inline TriangleMesh flipped(TriangleMesh mesh) {
    for (auto& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
    return mesh;
}

inline TriangleMesh together(TriangleMesh a, const TriangleMesh& b) {
    const int offset = static_cast<int>(a.points.size());
    a.points.insert(a.points.end(), b.points.begin(), b.points.end());
    for (const auto& t : b.triangles) a.triangles.push_back({t[0] + offset, t[1] + offset, t[2] + offset});
    return a;
}

inline double volume(const TriangleMesh& mesh) {
    double sum = 0;
    for (const auto& t : mesh.triangles) {
        const Vector& a = mesh.points[static_cast<std::size_t>(t[0])];
        const Vector& b = mesh.points[static_cast<std::size_t>(t[1])];
        const Vector& c = mesh.points[static_cast<std::size_t>(t[2])];
        sum += a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
               a[2] * (b[0] * c[1] - b[1] * c[0]);
    }
    return sum / 6;
}

// === Files

inline Bytes bytes_of(const std::string& text) {
    return {text.begin(), text.end()};
}
inline std::string text_of(double value) {
    char buffer[40];
    std::snprintf(buffer, sizeof buffer, "%.17g", value);
    return buffer;
}
inline std::string text_of(const Vector& x) {
    return text_of(x[0]) + " " + text_of(x[1]) + " " + text_of(x[2]);
}
inline Bytes float_bytes(double value) {
    return little(std::bit_cast<std::uint32_t>(static_cast<float>(value)), 4);
}

inline Bytes stl_text(const Faces& mesh, const std::string& name = "part of it") {
    std::string text = "solid " + name + "\n";
    for (const auto& face : mesh.faces) {
        text += "facet normal 0 0 0\n outer loop\n";
        for (const int corner : face)
            text += "  vertex " + text_of(mesh.points[static_cast<std::size_t>(corner)]) + "\n";
        text += " endloop\nendfacet\n";
    }
    return bytes_of(text + "endsolid " + name + "\n");
}
inline Bytes stl_binary(const Faces& mesh, const std::string& header = "made by hand") {
    Bytes bytes = bytes_of(header);
    bytes.resize(80);
    append(bytes, little(static_cast<std::uint32_t>(mesh.faces.size()), 4));
    for (const auto& face : mesh.faces) {
        for (int i = 0; i < 3; ++i) append(bytes, float_bytes(0));
        for (const int corner : face)
            for (const double x : mesh.points[static_cast<std::size_t>(corner)]) append(bytes, float_bytes(x));
        append(bytes, little(0, 2));
    }
    return bytes;
}
inline Bytes off(const Faces& mesh, const std::string& colour = "") {
    std::string text = "OFF\n# made by hand\n" + std::to_string(mesh.points.size()) + " " +
                       std::to_string(mesh.faces.size()) + " 0\n\n";
    for (const Vector& x : mesh.points) text += text_of(x) + "\n";
    for (const auto& face : mesh.faces) {
        text += std::to_string(face.size());
        for (const int corner : face) text += " " + std::to_string(corner);
        text += colour + "\n";
    }
    return bytes_of(text);
}
inline Bytes obj(const Faces& mesh) {
    std::string text = "# made by hand\nmtllib no.mtl\no thing\n";
    for (const Vector& x : mesh.points) text += "v " + text_of(x) + "\n";
    text += "vn 0 0 1\ns off\n";
    for (const auto& face : mesh.faces) {
        text += "f";
        for (const int corner : face) text += " " + std::to_string(corner + 1) + "//1";
        text += "\n";
    }
    return bytes_of(text);
}
enum class Ply { text, little, big };
inline Bytes ply(const Faces& mesh, Ply kind) {
    const char* const format = kind == Ply::text     ? "ascii"
                               : kind == Ply::little ? "binary_little_endian"
                                                     : "binary_big_endian";
    Bytes bytes =
        bytes_of(std::string("ply\nformat ") + format + " 1.0\ncomment made by hand\nelement vertex " +
                 std::to_string(mesh.points.size()) +
                 "\nproperty float x\nproperty float y\nproperty float z\nproperty uchar red\nelement face " +
                 std::to_string(mesh.faces.size()) + "\nproperty list uchar int vertex_indices\nend_header\n");
    const auto add = [&](std::uint32_t value) { append(bytes, kind == Ply::big ? big(value) : little(value, 4)); };
    for (const Vector& x : mesh.points) {
        if (kind == Ply::text)
            append(bytes, bytes_of(text_of(x) + " 255\n"));
        else {
            for (const double c : x) add(std::bit_cast<std::uint32_t>(static_cast<float>(c)));
            bytes.push_back(255);
        }
    }
    for (const auto& face : mesh.faces) {
        if (kind == Ply::text)
            append(bytes, bytes_of(std::to_string(face.size())));
        else
            bytes.push_back(static_cast<std::uint8_t>(face.size()));
        for (const int corner : face) {
            if (kind == Ply::text)
                append(bytes, bytes_of(" " + std::to_string(corner)));
            else
                add(static_cast<std::uint32_t>(corner));
        }
        if (kind == Ply::text) bytes.push_back('\n');
    }
    return bytes;
}

/// A file's name and contents, one for every format.
inline std::vector<std::pair<std::string, Bytes>> every_format(const Faces& mesh) {
    return {{"text.stl", stl_text(mesh)},
            {"binary.stl", stl_binary(mesh)},
            {"a.off", off(mesh)},
            {"a.obj", obj(mesh)},
            {"text.ply", ply(mesh, Ply::text)},
            {"little.ply", ply(mesh, Ply::little)},
            {"big.ply", ply(mesh, Ply::big)}};
}

// === Reading

inline abut::RepairedMesh read(const Bytes& bytes, const std::string& name, bool repair = false,
                               const abut::Placement& placement = {}) {
    const Folder folder;
    abut::Surface spec;
    spec.file = name;
    spec.repair = repair;
    spec.placement = placement;
    return abut::read_surface(spec, folder.write(name, bytes));
}
/// What is said about a file that is refused; empty if it is not.
inline std::string complaint(const Bytes& bytes, const std::string& name = "a.off", bool repair = false) {
    try {
        read(bytes, name, repair);
    } catch (const std::runtime_error& error) {
        return error.what();
    }
    return "";
}

} // namespace test
