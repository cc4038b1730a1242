#pragma once
/// \file check_surface.h
/// Whether triangles bound a solid, and how to make them.

#include "geometry/shapes/surface.h"

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace abut {

/// Where triangles meet without sharing what they have in common.
struct Intersections {
    std::size_t count = 0;       ///< of pairs of triangles
    bool more = false;           ///< the search was ended after `count`
    std::pair<int, int> first{}; ///< the pair of lowest indices
    Vector where{};              ///< a point near it: the middle of what its two boxes share
};

/// Pairs of triangles of a surface that intersect, overlap or touch apart from the corners and edges they have in
/// common (points at the same place are the same corner). Exact. Triangles without area must not be among them.
Intersections self_intersections(const TriangleMesh& mesh);

/// Triangles that look the wrong way.
struct WrongSides {
    std::size_t components = 0; ///< connected pieces of the surface
    std::vector<int> wrong;     ///< one triangle of every piece whose outside is inside
};

/// Of a closed surface without self-intersections. Pieces in others look inwards: they are cavities; and so on.
WrongSides wrong_sides(const TriangleMesh& mesh);

/// Indices of triangles of which two corners are at the same place or all three on a line. Exact.
std::vector<int> degenerate_triangles(const TriangleMesh& mesh);

/// Everything that is wrong with a surface whose points at the same place are one: what, how often, and where first.
std::vector<std::string> surface_problems(const TriangleMesh& mesh);

/// Joins, closes, turns and removes until `mesh` bounds a solid as far as possible; says what was done. The result may
/// have several points at the same place, where sheets only touch.
std::vector<std::string> repair_surface(TriangleMesh& mesh);

/// Divides a polygon of more than three corners into triangles, plane or not: by what it looks like along that axis
/// which is closest to its mean normal. Indices into `corners`; empty if its outline, seen so, touches or crosses
/// itself.
std::vector<std::array<int, 3>> divide_polygon(const std::vector<Vector>& corners);

/// Makes CGAL throw where its checks fail, and say nothing. \throws nothing
void silence_cgal();

} // namespace abut
