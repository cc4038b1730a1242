#include "geometry/shapes/check_surface.h"
#include "geometry/shapes/surface_to_cgal.h"

#include "geometry/parts.h"

#include <CGAL/Polygon_mesh_processing/border.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/repair.h>
#include <CGAL/Polygon_mesh_processing/repair_self_intersections.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Polygon_mesh_processing/stitch_borders.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <stdexcept>

namespace abut {

namespace {

namespace PMP = CGAL::Polygon_mesh_processing;
using Repairs = std::vector<std::string>;

/// Closing one hole takes time that grows with the cube of its edges.
constexpr std::size_t largest_hole = 2000;

void drop_duplicates(TriangleMesh& mesh, Repairs& repairs) {
    std::set<std::array<int, 3>> seen;
    std::vector<std::array<int, 3>> kept;
    for (const auto& triangle : mesh.triangles) {
        auto corners = triangle;
        std::sort(corners.begin(), corners.end());
        if (corners[0] == corners[1] || corners[1] == corners[2] || !seen.insert(corners).second) continue;
        kept.push_back(triangle);
    }
    const std::size_t dropped = mesh.triangles.size() - kept.size();
    if (dropped > 0)
        repairs.push_back(fmt::format("removed {} without area or there already", count_text(dropped, "triangle")));
    mesh.triangles = std::move(kept);
}

SurfaceMesh joined(const TriangleMesh& mesh, Repairs& repairs) {
    std::vector<Point> points;
    for (const Vector& x : mesh.points) points.push_back(to_point(x));
    std::vector<std::vector<std::size_t>> triangles;
    for (const auto& [a, b, c] : mesh.triangles)
        triangles.push_back({static_cast<std::size_t>(a), static_cast<std::size_t>(b), static_cast<std::size_t>(c)});
    PMP::orient_polygon_soup(points, triangles);
    if (points.size() > mesh.points.size())
        repairs.push_back(fmt::format("parted sheets that only touch at {}",
                                      count_text(points.size() - mesh.points.size(), "point")));
    if (!PMP::is_polygon_soup_a_polygon_mesh(triangles)) throw std::runtime_error("its triangles can't be joined");
    SurfaceMesh surface;
    PMP::polygon_soup_to_polygon_mesh(points, triangles, surface);
    const std::size_t stitched = PMP::stitch_borders(surface);
    if (stitched > 0) repairs.push_back(fmt::format("joined {}", count_text(stitched, "pair of edges")));
    PMP::remove_isolated_vertices(surface);
    return surface;
}

void remove_flat_triangles(SurfaceMesh& surface, Repairs& repairs) {
    std::vector<SurfaceMesh::Face_index> flat;
    PMP::degenerate_faces(surface, std::back_inserter(flat));
    if (flat.empty()) return;
    PMP::remove_degenerate_faces(surface);
    surface.collect_garbage();
    repairs.push_back(fmt::format("removed {} without area", count_text(flat.size(), "triangle")));
}

void close_holes(SurfaceMesh& surface, Repairs& repairs) {
    PMP::duplicate_non_manifold_vertices(surface);
    std::vector<SurfaceMesh::Halfedge_index> rims;
    PMP::extract_boundary_cycles(surface, std::back_inserter(rims));
    std::size_t closed = 0;
    for (const auto rim : rims) {
        std::size_t edges = 0;
        for (auto h = surface.next(rim); ++edges <= largest_hole && h != rim;) h = surface.next(h);
        // A triangle by itself is no rim of a hole, though CGAL would put a second one onto it.
        const bool alone = surface.face(surface.opposite(rim)) == surface.face(surface.opposite(surface.next(rim)));
        if (edges > largest_hole || (edges == 3 && alone)) continue;
        std::vector<SurfaceMesh::Face_index> patch;
        PMP::triangulate_hole(surface, rim, std::back_inserter(patch));
        closed += patch.empty() ? 0 : 1;
    }
    if (closed > 0) repairs.push_back(fmt::format("closed {}", count_text(closed, "hole")));
}

/// The union of the pieces of a surface, if each is a solid by itself.
bool unite_pieces(SurfaceMesh& surface, Repairs& repairs) {
    std::vector<SurfaceMesh> pieces;
    PMP::split_connected_components(surface, pieces);
    if (pieces.size() < 2) return false;
    for (SurfaceMesh& piece : pieces) {
        if (!CGAL::is_closed(piece) || PMP::does_self_intersect(piece)) return false;
        if (!PMP::is_outward_oriented(piece)) PMP::reverse_face_orientations(piece);
    }
    SurfaceMesh all = pieces.front();
    for (std::size_t i = 1; i < pieces.size(); ++i) {
        SurfaceMesh sum;
        if (!PMP::corefine_and_compute_union(all, pieces[i], sum)) return false;
        all = std::move(sum);
    }
    if (PMP::does_self_intersect(all)) return false;
    repairs.push_back(fmt::format("united {} pieces that crossed each other", pieces.size()));
    surface = std::move(all);
    return true;
}

void uncross(SurfaceMesh& surface, Repairs& repairs) {
    if (!PMP::does_self_intersect(surface)) return;
    if (CGAL::is_closed(surface) && unite_pieces(surface, repairs)) return;
    if (PMP::experimental::remove_self_intersections(surface)) repairs.push_back("removed what crossed itself");
}

/// Triangles of `before` that face the other way in `after`.
std::size_t turned_triangles(const TriangleMesh& before, const TriangleMesh& after) {
    const auto from_lowest = [](const TriangleMesh& mesh, const std::array<int, 3>& triangle) {
        std::array<Vector, 3> corners{};
        for (std::size_t i = 0; i < 3; ++i) corners[i] = mesh.points[static_cast<std::size_t>(triangle[i])];
        std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
        return corners;
    };
    std::set<std::array<Vector, 3>> known;
    for (const auto& triangle : before.triangles) known.insert(from_lowest(before, triangle));
    std::size_t turned = 0;
    for (const auto& triangle : after.triangles) {
        std::array<Vector, 3> corners = from_lowest(after, triangle);
        if (known.contains(corners)) continue;
        std::swap(corners[1], corners[2]);
        turned += known.contains(corners) ? 1 : 0;
    }
    return turned;
}

TriangleMesh from_surface_mesh(SurfaceMesh& surface) {
    surface.collect_garbage();
    TriangleMesh mesh;
    mesh.points.reserve(surface.number_of_vertices());
    for (const auto vertex : surface.vertices()) {
        const Point& p = surface.point(vertex);
        mesh.points.push_back({p.x(), p.y(), p.z()});
    }
    for (const auto face : surface.faces()) {
        std::array<int, 3> triangle{};
        std::size_t i = 0;
        for (const auto vertex : surface.vertices_around_face(surface.halfedge(face)))
            triangle.at(i++) = static_cast<int>(static_cast<unsigned>(vertex));
        mesh.triangles.push_back(triangle);
    }
    return mesh;
}

} // namespace

std::vector<std::string> repair_surface(TriangleMesh& mesh) {
    Repairs repairs;
    const TriangleMesh before = mesh;
    drop_duplicates(mesh, repairs);
    if (degenerate_triangles(mesh).size() == mesh.triangles.size()) { // CGAL's meshes are not to be emptied
        mesh.triangles.clear();
        return repairs;
    }
    SurfaceMesh surface = joined(mesh, repairs);
    remove_flat_triangles(surface, repairs);
    close_holes(surface, repairs);
    uncross(surface, repairs);
    if (CGAL::is_closed(surface) && !PMP::does_self_intersect(surface)) PMP::orient_to_bound_a_volume(surface);
    mesh = from_surface_mesh(surface);
    const std::size_t turned = turned_triangles(before, mesh);
    if (turned > 0)
        repairs.push_back(fmt::format("turned {} that faced the wrong way", count_text(turned, "triangle")));
    return repairs;
}

} // namespace abut
