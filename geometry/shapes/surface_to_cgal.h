#pragma once
/// \file surface_to_cgal.h
/// Meshes as CGAL has them. Slow to compile: for the few files that call CGAL.

#include "geometry/shapes/surface.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

namespace abut {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using SurfaceMesh = CGAL::Surface_mesh<Point>;

inline Point to_point(const Vector& x) {
    return {x[0], x[1], x[2]};
}

/// Triangles must be a manifold with consistent orientation; index i stays face i.
inline SurfaceMesh to_surface_mesh(const TriangleMesh& mesh) {
    SurfaceMesh surface;
    surface.reserve(static_cast<SurfaceMesh::size_type>(mesh.points.size()),
                    static_cast<SurfaceMesh::size_type>(mesh.triangles.size() * 3 / 2),
                    static_cast<SurfaceMesh::size_type>(mesh.triangles.size()));
    std::vector<SurfaceMesh::Vertex_index> vertices;
    vertices.reserve(mesh.points.size());
    for (const Vector& x : mesh.points) vertices.push_back(surface.add_vertex(to_point(x)));
    for (const auto& [a, b, c] : mesh.triangles)
        surface.add_face(vertices[static_cast<std::size_t>(a)], vertices[static_cast<std::size_t>(b)],
                         vertices[static_cast<std::size_t>(c)]);
    return surface;
}

} // namespace abut
