#pragma once
/// \file surface.h
/// Closed surfaces of triangles: from files, checked and repaired, and from expressions. CGAL's part of the program.

#include "geometry/shapes/solid.h"
#include "scene/scene.h"

#include <array>
#include <filesystem>
#include <string>
#include <vector>

namespace abut {

struct TriangleMesh {
    std::vector<Vector> points;                ///< [m]
    std::vector<std::array<int, 3>> triangles; ///< indices of points, counter-clockwise seen from outside
};

/// What was wrong with a surface and what was done about it, for the report of `abut particles`.
struct RepairedMesh {
    TriangleMesh mesh;
    std::vector<std::string> repairs; ///< "closed 2 holes", …; empty if nothing had to be done
};

/// Reads an STL (text or binary), OFF, PLY or OBJ file, told apart by name and contents, places it and checks it: all
/// coordinates are finite, no triangle without area, no edge of one or of more than two triangles, no points where
/// sheets only touch, no self-intersection, the outside is outside. Faces of more corners are divided into triangles;
/// points at the same place are one.
/// \throws std::runtime_error naming the file, all that is wrong, how often, and where first (coordinates of the
/// scene); with spec.repair only when it can't be repaired
RepairedMesh read_surface(const Surface& spec, const std::filesystem::path& file);

/// Triangles of the surface expression = 0, closed, at most `distance` from it [m]. Variables x, y, z in multiples of
/// spec.unit; operators, functions and constants as muParser has them (+ - * / ^ sin cos sqrt exp abs min max pi …).
/// \throws std::runtime_error when the expression is wrong (says where), is nowhere negative or reaches out of its box
TriangleMesh mesh_implicit(const Implicit& spec, double distance);

/// The solid inside a closed mesh. Exact: a line that meets an edge or a corner counts it once.
Solid solid_of(const TriangleMesh& mesh);

} // namespace abut
