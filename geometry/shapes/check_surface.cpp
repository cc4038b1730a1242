// What keeps triangles from bounding a solid: counted by their indices; what needs exact geometry is CGAL's.
#include "geometry/shapes/check_surface.h"

#include "geometry/parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <set>

namespace abut {

namespace {

/// A side of a triangle, from the end of lower index.
struct Side {
    int a, b;
    int triangle;
    bool forward; ///< the triangle goes from a to b
};

std::vector<Side> sorted_sides(const TriangleMesh& mesh) {
    std::vector<Side> sides;
    sides.reserve(3 * mesh.triangles.size());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        for (std::size_t i = 0; i < 3; ++i) {
            const int from = mesh.triangles[t][i], to = mesh.triangles[t][(i + 1) % 3];
            sides.push_back({std::min(from, to), std::max(from, to), static_cast<int>(t), from < to});
        }
    std::sort(sides.begin(), sides.end(), [](const Side& x, const Side& y) {
        return std::tie(x.a, x.b, x.triangle) < std::tie(y.a, y.b, y.triangle);
    });
    return sides;
}

/// Sets that are united one by one.
class Union {
public:
    explicit Union(std::size_t size) : parent_(size) { std::iota(parent_.begin(), parent_.end(), 0); }
    int root(int i) {
        while (parent_[static_cast<std::size_t>(i)] != i) {
            int& parent = parent_[static_cast<std::size_t>(i)];
            parent = parent_[static_cast<std::size_t>(parent)];
            i = parent;
        }
        return i;
    }
    void unite(int i, int j) {
        const auto [low, high] = std::minmax({root(i), root(j)});
        parent_[static_cast<std::size_t>(high)] = low;
    }

private:
    std::vector<int> parent_;
};

std::string place(const Vector& x) {
    return fmt::format("({:.6g}, {:.6g}, {:.6g}) m", x[0], x[1], x[2]);
}

Vector centre(const TriangleMesh& mesh, int triangle) {
    Vector middle{};
    for (const int corner : mesh.triangles[static_cast<std::size_t>(triangle)])
        for (std::size_t axis = 0; axis < 3; ++axis)
            middle[axis] += mesh.points[static_cast<std::size_t>(corner)][axis] / 3;
    return middle;
}

std::string first_triangle(const TriangleMesh& mesh, int triangle) {
    return fmt::format("first at {}", place(centre(mesh, triangle)));
}

/// Something counted, and the first of it.
struct Count {
    std::size_t count = 0;
    std::string first;
    template <class Where>
    void add(Where&& where) {
        if (count++ == 0) first = where();
    }
};

class Topology {
public:
    explicit Topology(const TriangleMesh& mesh) : mesh_(mesh), sides_(sorted_sides(mesh)) {}

    std::vector<std::string> problems() {
        duplicates();
        edges();
        touching_points();
        return std::move(problems_);
    }

private:
    void report(const Count& found, const std::string& noun, const std::string& what) {
        if (found.count > 0)
            problems_.push_back(fmt::format("{}{}, first at {}", count_text(found.count, noun), what, found.first));
    }

    void duplicates() {
        std::vector<std::pair<std::array<int, 3>, int>> sorted;
        sorted.reserve(mesh_.triangles.size());
        for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
            auto corners = mesh_.triangles[t];
            std::sort(corners.begin(), corners.end());
            sorted.emplace_back(corners, static_cast<int>(t));
        }
        std::sort(sorted.begin(), sorted.end());
        std::vector<int> twice;
        for (std::size_t k = 1; k < sorted.size(); ++k)
            if (sorted[k].first == sorted[k - 1].first) twice.push_back(sorted[k].second);
        if (twice.empty()) return;
        const int first = *std::min_element(twice.begin(), twice.end());
        problems_.push_back(fmt::format(
            "{} there already, {}", twice.size() == 1 ? "1 triangle is" : fmt::format("{} triangles are", twice.size()),
            first_triangle(mesh_, first)));
    }

    void edges() {
        Count open, crowded, turned;
        Union rims(mesh_.points.size());
        std::vector<int> rim_points;
        for (std::size_t k = 0, end = 0; k < sides_.size(); k = end) {
            while (end < sides_.size() && sides_[end].a == sides_[k].a && sides_[end].b == sides_[k].b) ++end;
            const auto where = [&] { return middle(sides_[k]); };
            if (end - k == 1) {
                open.add(where);
                rims.unite(sides_[k].a, sides_[k].b);
                rim_points.push_back(sides_[k].a);
            } else if (end - k > 2) {
                crowded.add(where);
            } else if (sides_[k].forward == sides_[k + 1].forward) {
                turned.add(where);
            }
        }
        std::set<int> holes;
        for (const int point : rim_points) holes.insert(rims.root(point));
        if (open.count > 0)
            problems_.push_back(fmt::format("{} with a triangle on one side only, around {}, first at {}",
                                            count_text(open.count, "edge"), count_text(holes.size(), "hole"),
                                            open.first));
        report(crowded, "edge", " with more than two triangles");
        report(turned, "edge", " between triangles of which one faces the wrong way");
    }

    /// Points whose triangles are not one fan: corners at a point are joined across edges there.
    void touching_points() {
        Union corners(3 * mesh_.triangles.size());
        for (std::size_t k = 1; k < sides_.size(); ++k)
            if (sides_[k].a == sides_[k - 1].a && sides_[k].b == sides_[k - 1].b)
                for (const int point : {sides_[k].a, sides_[k].b})
                    corners.unite(corner(sides_[k].triangle, point), corner(sides_[k - 1].triangle, point));
        std::vector<int> fans(mesh_.points.size());
        for (std::size_t t = 0; t < mesh_.triangles.size(); ++t)
            for (std::size_t i = 0; i < 3; ++i) {
                const int c = static_cast<int>(3 * t + i);
                if (corners.root(c) == c) ++fans[static_cast<std::size_t>(mesh_.triangles[t][i])];
            }
        Count touching;
        for (std::size_t p = 0; p < fans.size(); ++p)
            if (fans[p] > 1) touching.add([&] { return place(mesh_.points[p]); });
        report(touching, "point", " where sheets of the surface only touch");
    }

    int corner(int triangle, int point) const {
        const auto& corners = mesh_.triangles[static_cast<std::size_t>(triangle)];
        return 3 * triangle + static_cast<int>(std::find(corners.begin(), corners.end(), point) - corners.begin());
    }

    std::string middle(const Side& side) const {
        Vector x{};
        for (std::size_t axis = 0; axis < 3; ++axis)
            x[axis] = (mesh_.points[static_cast<std::size_t>(side.a)][axis] +
                       mesh_.points[static_cast<std::size_t>(side.b)][axis]) /
                      2;
        return place(x);
    }

    const TriangleMesh& mesh_;
    std::vector<Side> sides_;
    std::vector<std::string> problems_;
};

} // namespace

std::vector<std::string> surface_problems(const TriangleMesh& mesh) {
    const std::vector<int> flat = degenerate_triangles(mesh);
    std::vector<std::string> problems;
    if (!flat.empty())
        problems.push_back(fmt::format("{} without area, {}", count_text(flat.size(), "triangle"),
                                       first_triangle(mesh, flat.front())));

    // Triangles of which two corners are one have no sides to speak of.
    TriangleMesh proper{mesh.points, {}}, with_area{mesh.points, {}};
    for (std::size_t t = 0, next = 0; t < mesh.triangles.size(); ++t) {
        const auto& [a, b, c] = mesh.triangles[t];
        if (a != b && b != c && c != a) proper.triangles.push_back(mesh.triangles[t]);
        if (next < flat.size() && flat[next] == static_cast<int>(t))
            ++next;
        else
            with_area.triangles.push_back(mesh.triangles[t]);
    }
    const std::vector<std::string> topology = Topology(proper).problems();
    problems.insert(problems.end(), topology.begin(), topology.end());

    const Intersections crossing = self_intersections(with_area);
    if (crossing.count > 0)
        problems.push_back(fmt::format("{}{} of triangles that cross or overlap each other, first at {}",
                                       crossing.more ? "more than " : "", count_text(crossing.count, "pair"),
                                       place(crossing.where)));
    if (!problems.empty()) return problems;
    const WrongSides sides = wrong_sides(mesh);
    if (sides.wrong.empty()) return problems;
    if (sides.wrong.size() == sides.components)
        problems.push_back(
            fmt::format("inside out: its triangles face inwards, {}", first_triangle(mesh, sides.wrong[0])));
    else
        problems.push_back(
            fmt::format("{} of {} closed pieces face the wrong way (a piece inside another is a cavity and "
                        "faces inwards), {}",
                        sides.wrong.size(), sides.components, first_triangle(mesh, sides.wrong[0])));
    return problems;
}

} // namespace abut
