#include "geometry/shapes/check_surface.h"
#include "geometry/shapes/polygon_soup.h"
#include "geometry/shapes/surface.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

namespace abut {

namespace {

/// Beyond it products of coordinates overflow.
constexpr double largest_coordinate = 1e30;

std::string face_text(std::size_t face) {
    return fmt::format("face {} of the file", face + 1);
}

/// Rodrigues' formula: x turned about an axis through the origin.
class Turn {
public:
    Turn(const Vector& axis, double angle) : cosine_(std::cos(angle)), sine_(std::sin(angle)), turns_(angle != 0) {
        const double length = std::hypot(axis[0], axis[1], axis[2]);
        for (std::size_t i = 0; i < 3; ++i) axis_[i] = axis[i] / length;
    }
    Vector operator()(const Vector& x) const {
        if (!turns_) return x;
        const Vector& n = axis_;
        const double along = (1 - cosine_) * (n[0] * x[0] + n[1] * x[1] + n[2] * x[2]);
        return {cosine_ * x[0] + sine_ * (n[1] * x[2] - n[2] * x[1]) + along * n[0],
                cosine_ * x[1] + sine_ * (n[2] * x[0] - n[0] * x[2]) + along * n[1],
                cosine_ * x[2] + sine_ * (n[0] * x[1] - n[1] * x[0]) + along * n[2]};
    }

private:
    Vector axis_{};
    double cosine_, sine_;
    bool turns_;
};

/// The lengths of the file to those of the scene. \throws std::runtime_error if they are none
void place(PolygonSoup& soup, const Placement& placement) {
    const Turn turn(placement.axis, placement.angle);
    std::vector<bool> bad(soup.points.size());
    for (std::size_t p = 0; p < soup.points.size(); ++p) {
        Vector& x = soup.points[p];
        for (double& coordinate : x) coordinate *= placement.scale;
        x = turn(x);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            x[axis] += placement.translation[axis] + 0.0; // + 0.0: one zero only
            if (!(std::abs(x[axis]) <= largest_coordinate)) bad[p] = true;
        }
    }
    std::size_t count = 0, first = 0;
    for (std::size_t face = 0; face < soup.faces(); ++face)
        if (std::any_of(soup.corners.begin() + static_cast<std::ptrdiff_t>(soup.begin(face)),
                        soup.corners.begin() + static_cast<std::ptrdiff_t>(soup.ends[face]),
                        [&](int corner) { return bad[static_cast<std::size_t>(corner)]; }) &&
            count++ == 0)
            first = face;
    if (count > 0)
        throw std::runtime_error(fmt::format("{} coordinates that are not finite numbers, first in {}",
                                             count == 1 ? "1 face has" : fmt::format("{} faces have", count),
                                             face_text(first)));
}

/// Makes points at the same place one, in the order in which they came; drops those of no face.
void merge_points(PolygonSoup& soup) {
    std::vector<int> order(soup.points.size());
    std::iota(order.begin(), order.end(), 0);
    const auto point = [&](int i) -> const Vector& { return soup.points[static_cast<std::size_t>(i)]; };
    std::sort(order.begin(), order.end(),
              [&](int a, int b) { return point(a) != point(b) ? point(a) < point(b) : a < b; });
    std::vector<int> first(soup.points.size());
    for (std::size_t k = 0; k < order.size(); ++k)
        first[static_cast<std::size_t>(order[k])] =
            k > 0 && point(order[k]) == point(order[k - 1]) ? first[static_cast<std::size_t>(order[k - 1])] : order[k];
    std::vector<int> index(soup.points.size(), -1);
    std::vector<Vector> points;
    for (int& corner : soup.corners) {
        const int representative = first[static_cast<std::size_t>(corner)];
        int& merged = index[static_cast<std::size_t>(representative)];
        if (merged < 0) {
            merged = static_cast<int>(points.size());
            points.push_back(point(representative));
        }
        corner = merged;
    }
    soup.points = std::move(points);
}

/// Faces to triangles. \throws std::runtime_error if one is none
TriangleMesh triangulated(PolygonSoup soup) {
    TriangleMesh mesh;
    mesh.triangles.reserve(soup.faces());
    std::size_t few = 0, first_few = 0, undivided = 0, first_undivided = 0;
    std::vector<Vector> outline;
    for (std::size_t face = 0; face < soup.faces(); ++face) {
        const std::size_t begin = soup.begin(face);
        const std::size_t count = soup.ends[face] - begin;
        const int* corners = soup.corners.data() + begin;
        if (count < 3) {
            if (few++ == 0) first_few = face;
        } else if (count == 3) {
            mesh.triangles.push_back({corners[0], corners[1], corners[2]});
        } else {
            outline.clear();
            for (std::size_t k = 0; k < count; ++k)
                outline.push_back(soup.points[static_cast<std::size_t>(corners[k])]);
            const auto triangles = divide_polygon(outline);
            if (triangles.empty() && undivided++ == 0) first_undivided = face;
            for (const auto& [a, b, c] : triangles) mesh.triangles.push_back({corners[a], corners[b], corners[c]});
        }
    }
    if (few > 0)
        throw std::runtime_error(fmt::format("{} fewer than three corners, first {}",
                                             few == 1 ? "1 face has" : fmt::format("{} faces have", few),
                                             face_text(first_few)));
    if (undivided > 0)
        throw std::runtime_error(
            fmt::format("{} can't be divided into triangles, as their outlines cross or touch themselves, first {}",
                        undivided == 1 ? "1 face" : fmt::format("{} faces", undivided), face_text(first_undivided)));
    mesh.points = std::move(soup.points);
    return mesh;
}

TriangleMesh repaired(TriangleMesh mesh, std::vector<std::string>& repairs) {
    try {
        repairs = repair_surface(mesh);
    } catch (const std::exception&) { // CGAL's, which say nothing to users
        throw std::runtime_error("can't be repaired: its triangles can't be joined to a surface");
    }
    std::vector<std::string> left;
    if (mesh.triangles.empty())
        left.emplace_back("no triangle with an area is left");
    else
        left = surface_problems(mesh);
    if (!left.empty())
        throw std::runtime_error(fmt::format("can't be repaired. What remains: {}", fmt::join(left, "; ")));
    return mesh;
}

} // namespace

RepairedMesh read_surface(const Surface& spec, const std::filesystem::path& file) {
    silence_cgal();
    PolygonSoup soup = read_polygon_soup(file);
    try {
        place(soup, spec.placement);
        merge_points(soup);
        RepairedMesh result{triangulated(std::move(soup)), {}};
        const std::vector<std::string> problems = surface_problems(result.mesh);
        if (problems.empty()) return result;
        if (!spec.repair)
            throw std::runtime_error(fmt::format("does not bound a solid: {} (\"repair\": true tries to mend it)",
                                                 fmt::join(problems, "; ")));
        result.mesh = repaired(std::move(result.mesh), result.repairs);
        return result;
    } catch (const std::exception& error) {
        throw std::runtime_error(fmt::format("surface \"{}\": {}", file.string(), error.what()));
    }
}

} // namespace abut
