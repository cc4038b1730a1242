#include "geometry/shapes/check_surface.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_2_algorithms.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <cmath>

namespace abut {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<int, Kernel>;
using Structure = CGAL::Triangulation_data_structure_2<VertexBase, CGAL::Constrained_triangulation_face_base_2<Kernel>>;
using Triangulation = CGAL::Constrained_Delaunay_triangulation_2<Kernel, Structure>;

/// Twice the area times the mean normal (Newell).
Vector area_vector(const std::vector<Vector>& corners) {
    Vector sum{};
    for (std::size_t k = 0; k < corners.size(); ++k) {
        const Vector& a = corners[k];
        const Vector& b = corners[(k + 1) % corners.size()];
        for (std::size_t i = 0; i < 3; ++i) {
            const std::size_t j = (i + 1) % 3, l = (i + 2) % 3;
            sum[i] += (a[j] - b[j]) * (a[l] + b[l]);
        }
    }
    return sum;
}

} // namespace

std::vector<std::array<int, 3>> divide_polygon(const std::vector<Vector>& corners) {
    const Vector normal = area_vector(corners);
    std::size_t along = 0;
    for (const std::size_t axis : {1U, 2U})
        if (std::abs(normal[axis]) > std::abs(normal[along])) along = axis;
    std::size_t u = (along + 1) % 3, v = (along + 2) % 3;
    if (normal[along] < 0) std::swap(u, v);
    std::vector<Kernel::Point_2> outline;
    outline.reserve(corners.size());
    for (const Vector& x : corners) outline.emplace_back(x[u], x[v]);
    // CGAL takes crossing constraints and points at the same place amiss.
    if (!CGAL::is_simple_2(outline.begin(), outline.end()) ||
        CGAL::orientation_2(outline.begin(), outline.end()) != CGAL::COUNTERCLOCKWISE)
        return {};

    Triangulation triangulation;
    std::vector<Triangulation::Vertex_handle> vertices;
    for (std::size_t k = 0; k < outline.size(); ++k) {
        vertices.push_back(triangulation.insert(outline[k]));
        vertices.back()->info() = static_cast<int>(k);
    }
    for (std::size_t k = 0; k < vertices.size(); ++k)
        triangulation.insert_constraint(vertices[k], vertices[(k + 1) % vertices.size()]);

    std::vector<std::array<int, 3>> triangles;
    for (auto face = triangulation.finite_faces_begin(); face != triangulation.finite_faces_end(); ++face) {
        std::array<int, 3> t{face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()};
        std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
        // Counter-clockwise triangles inside have their corners in the order of the outline, those outside don't.
        if (t[1] < t[2]) triangles.push_back(t);
    }
    return triangles.size() + 2 == corners.size() ? triangles : std::vector<std::array<int, 3>>{};
}

} // namespace abut
