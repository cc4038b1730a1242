#include "io/render/solids.h"

#include "io/render/surface.h"

#include <algorithm>
#include <cmath>

namespace abut {
namespace {

double dot(const Vector3& a, const Vector3& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Vector3 cross(const Vector3& a, const Vector3& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Vector3 unit(const Vector3& a) {
    const double length = std::sqrt(dot(a, a));
    return {a[0] / length, a[1] / length, a[2] / length};
}

/// The colour of a surface with unit normal `normal`.
Rgb shaded(Rgb colour, const Vector3& normal) {
    static const Vector3 light = unit({0.25, -0.55, 0.8});
    constexpr double ambient = 0.55, diffuse = 0.57; // 1 on top, 0.86 in front, 0.69 on the right
    const double brightness = std::min(1.0, ambient + diffuse * std::max(0.0, dot(normal, light)));
    for (std::uint8_t& channel : colour) channel = static_cast<std::uint8_t>(std::lround(brightness * channel));
    return colour;
}

void add_domain(Faces& faces, const double* centre, std::array<Vector3, 3> edges, const View& view, Rgb colour) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const Vector3 &out = edges[axis], &a = edges[(axis + 1) % 3], &b = edges[(axis + 2) % 3];
        Vector3 normal = cross(a, b);
        const double length = std::sqrt(dot(normal, normal));
        if (!(length > 0)) continue;                                            // no area; nor for what is not a number
        const double outward = dot(normal, out) < 0 ? -1 / length : 1 / length; // also of domains turned inside out
        for (double& n : normal) n *= outward;
        const double sign = dot(normal, view.axes[2]) < 0 ? -1 : 1; // of the two faces the one that is seen
        const Rgb seen = shaded(colour, {sign * normal[0], sign * normal[1], sign * normal[2]});
        constexpr std::array<std::array<int, 2>, 4> around{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};
        for (const auto& [i, j] : around) {
            Vector3 corner{};
            for (std::size_t k = 0; k < 3; ++k) corner[k] = centre[k] + sign * out[k] + i * a[k] + j * b[k];
            faces.corners.push_back(view.pixel(corner.data()));
            faces.depths.push_back(view.depth(corner.data()));
        }
        faces.colours.push_back(seen);
    }
}

} // namespace

bool add_solids(Faces& faces, const PointFrame& frame, const View& view, const std::vector<Rgb>& colours) {
    const std::optional<Domains> domains = Domains::of(frame);
    if (!domains) return false;
    for (const std::size_t p : surface_particles(frame, *domains)) {
        auto edges = domains->half_edges(p);
        for (Vector3& edge : edges) { // domains that are neighbours don't share their corners exactly
            const double pixels = view.scale * std::sqrt(dot(edge, edge));
            for (double& e : edge) e *= pixels > 0 ? 1 + 0.3 / pixels : 1;
        }
        add_domain(faces, domains->centre(p), edges, view, colours[p]);
    }
    return true;
}

void add_box(Faces& faces, const Bounds& bounds, const View& view, double width, Rgb colour) {
    const auto corners = corners_of(bounds);
    std::size_t next_to_eye = 0;
    for (std::size_t i = 0; i < 8; ++i)
        if (view.depth(corners[i].data()) > view.depth(corners[next_to_eye].data())) next_to_eye = i;
    for (std::size_t i = 0; i < 8; ++i)
        for (const std::size_t axis : {1u, 2u, 4u}) { // corners that differ in one coordinate share an edge
            const std::size_t j = i | axis;
            if (i == j || i == next_to_eye || j == next_to_eye) continue;
            Quads line;
            add_line(line, view.pixel(corners[i].data()), view.pixel(corners[j].data()), width, colour);
            if (line.colours.empty()) continue; // seen end on
            const double from = view.depth(corners[i].data()), to = view.depth(corners[j].data());
            faces.corners.insert(faces.corners.end(), line.corners.begin(), line.corners.end());
            faces.depths.insert(faces.depths.end(), {from, to, to, from});
            faces.colours.push_back(colour);
        }
}

void add_axes(Picture& picture, const View& view, const Pixel& origin, double unit_length, Rgb colour) {
    constexpr std::array<const char*, 3> names{"x", "y", "z"};
    const double length = 30 * unit_length, size = 15 * unit_length;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const Pixel along{view.axes[0][axis], view.axes[1][axis]};
        const double seen = std::hypot(along[0], along[1]);
        add_arrow(picture.quads, origin, along, length * seen, 2 * unit_length, colour);
        const double at = length * seen + 9 * unit_length;
        picture.labels.push_back({names[axis],
                                  {origin[0] + at * along[0] / seen, origin[1] + at * along[1] / seen - 0.3 * size},
                                  size,
                                  Align::centre,
                                  false,
                                  colour});
    }
}

} // namespace abut
