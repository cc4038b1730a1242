#include "geometry/shapes/check_surface.h"
#include "geometry/shapes/surface_to_cgal.h"

#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/assertions_behaviour.h>
#include <CGAL/box_intersection_d.h>

#include <algorithm>

namespace abut {

namespace {

constexpr std::size_t enough = 10000; ///< pairs, after which the search ends

using Triangle = std::array<Point, 3>;
using TriangleBox = CGAL::Box_intersection_d::Box_with_info_d<double, 3, int>;

Triangle corners_of(const TriangleMesh& mesh, int triangle) {
    Triangle corners;
    for (std::size_t i = 0; i < 3; ++i)
        corners[i] =
            to_point(mesh.points[static_cast<std::size_t>(mesh.triangles[static_cast<std::size_t>(triangle)][i])]);
    return corners;
}

/// Moves the corners that two triangles have in common to their ends, in the same order. Returns how many they are.
int move_common_last(Triangle& a, Triangle& b) {
    int common = 0;
    for (int i = 0; i < 3 - common; ++i)
        for (int j = 0; j < 3 - common; ++j)
            if (a[static_cast<std::size_t>(i)] == b[static_cast<std::size_t>(j)]) {
                std::swap(a[static_cast<std::size_t>(i)], a[static_cast<std::size_t>(2 - common)]);
                std::swap(b[static_cast<std::size_t>(j)], b[static_cast<std::size_t>(2 - common)]);
                ++common;
                --i;
                break;
            }
    return common;
}

bool intersect(Triangle a, Triangle b) {
    const int common = move_common_last(a, b);
    if (common == 3) return true; // also two sheets that are one: nothing lies between them
    if (common == 2)              // folded flat onto each other?
        return CGAL::coplanar(a[1], a[2], a[0], b[0]) &&
               CGAL::coplanar_orientation(a[1], a[2], a[0], b[0]) == CGAL::POSITIVE;
    const Kernel::Triangle_3 ta(a[0], a[1], a[2]), tb(b[0], b[1], b[2]);
    if (common == 1) // they meet elsewhere only if the edge across from the common corner meets the other triangle
        return CGAL::do_intersect(ta, Kernel::Segment_3(b[0], b[1])) ||
               CGAL::do_intersect(tb, Kernel::Segment_3(a[0], a[1]));
    return CGAL::do_intersect(ta, tb);
}

bool same_corners(const TriangleMesh& mesh, int a, int b) {
    const auto& other = mesh.triangles[static_cast<std::size_t>(b)];
    return std::is_permutation(other.begin(), other.end(), mesh.triangles[static_cast<std::size_t>(a)].begin());
}

struct Ended {};

} // namespace

void silence_cgal() {
    CGAL::set_error_handler([](const char*, const char*, const char*, int, const char*) {});
    CGAL::set_warning_handler([](const char*, const char*, const char*, int, const char*) {});
}

Intersections self_intersections(const TriangleMesh& mesh) {
    std::vector<TriangleBox> boxes;
    boxes.reserve(mesh.triangles.size());
    for (int i = 0; i < static_cast<int>(mesh.triangles.size()); ++i) {
        const Triangle t = corners_of(mesh, i);
        boxes.emplace_back(t[0].bbox() + t[1].bbox() + t[2].bbox(), i);
    }
    std::vector<const TriangleBox*> pointers;
    pointers.reserve(boxes.size());
    for (const TriangleBox& box : boxes) pointers.push_back(&box);

    Intersections found;
    const auto meet = [&](const TriangleBox* a, const TriangleBox* b) {
        if (same_corners(mesh, a->info(), b->info())) return; // counted as duplicates
        if (!intersect(corners_of(mesh, a->info()), corners_of(mesh, b->info()))) return;
        const std::pair<int, int> pair = std::minmax(a->info(), b->info());
        if (found.count == 0 || pair < found.first) {
            found.first = pair;
            for (int axis = 0; axis < 3; ++axis)
                found.where[static_cast<std::size_t>(axis)] = (std::max(a->min_coord(axis), b->min_coord(axis)) +
                                                               std::min(a->max_coord(axis), b->max_coord(axis))) /
                                                              2;
        }
        if (++found.count == enough) throw Ended();
    };
    try {
        CGAL::box_self_intersection_d(pointers.begin(), pointers.end(), meet, std::ptrdiff_t{300});
    } catch (const Ended&) {
        found.more = true;
    }
    return found;
}

std::vector<int> degenerate_triangles(const TriangleMesh& mesh) {
    std::vector<int> found;
    for (int i = 0; i < static_cast<int>(mesh.triangles.size()); ++i) {
        const Triangle t = corners_of(mesh, i);
        if (CGAL::collinear(t[0], t[1], t[2])) found.push_back(i);
    }
    return found;
}

WrongSides wrong_sides(const TriangleMesh& mesh) {
    namespace PMP = CGAL::Polygon_mesh_processing;
    SurfaceMesh surface = to_surface_mesh(mesh);
    auto component = surface.add_property_map<SurfaceMesh::Face_index, std::size_t>("f:component", 0).first;
    WrongSides result;
    result.components = PMP::connected_components(surface, component);
    PMP::orient_to_bound_a_volume(surface);
    std::vector<bool> seen(result.components);
    for (const auto face : surface.faces()) {
        if (seen[component[face]]) continue;
        seen[component[face]] = true;
        const auto index = static_cast<std::size_t>(face);
        const auto& before = mesh.triangles[index];
        const auto half_edge = surface.halfedge(face);
        const int from = static_cast<int>(static_cast<unsigned>(surface.source(half_edge)));
        const int to = static_cast<int>(static_cast<unsigned>(surface.target(half_edge)));
        const bool same = (from == before[0] && to == before[1]) || (from == before[1] && to == before[2]) ||
                          (from == before[2] && to == before[0]);
        if (!same) result.wrong.push_back(static_cast<int>(index));
    }
    return result;
}

} // namespace abut
