#include "io/render/view.h"

#include "io/render/domains.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace abut {
namespace {

double dot(const std::array<double, 3>& a, const double* b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

View unscaled_view(bool flat) {
    if (flat) return {{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, {}, 1};
    const double azimuth = -1.1, elevation = 0.45; // of the eye [rad]; -y is the front
    const double c = std::cos(azimuth), s = std::sin(azimuth), ce = std::cos(elevation), se = std::sin(elevation);
    return {{{{-s, c, 0}, {-se * c, -se * s, ce}, {ce * c, ce * s, se}}}, {}, 1};
}

/// Domains that are neighbours don't share their corners exactly; a third of a pixel hides the cracks between them.
Pixel lengthened(const Pixel& half_edge) {
    const double length = std::hypot(half_edge[0], half_edge[1]);
    const double factor = length > 0 ? 1 + 0.3 / length : 1;
    return {factor * half_edge[0], factor * half_edge[1]};
}

struct Rectangle {
    Pixel lower{INFINITY, INFINITY}, upper{-INFINITY, -INFINITY};
};

Rectangle seen(const Bounds& bounds, const View& view) {
    Rectangle r;
    for (const auto& corner : corners_of(bounds)) {
        const Pixel p = view.pixel(corner.data());
        for (std::size_t k = 0; k < 2; ++k) {
            r.lower[k] = std::min(r.lower[k], p[k]);
            r.upper[k] = std::max(r.upper[k], p[k]);
        }
    }
    return r;
}

} // namespace

Pixel View::direction(const double* vector) const {
    return {scale * dot(axes[0], vector), scale * dot(axes[1], vector)};
}

Pixel View::pixel(const double* point) const {
    const Pixel d = direction(point);
    return {origin[0] + d[0], origin[1] + d[1]};
}

double View::depth(const double* point) const {
    return scale * dot(axes[2], point);
}

std::vector<std::array<double, 3>> corners_of(const Bounds& bounds) {
    std::vector<std::array<double, 3>> corners;
    for (int i = 0; i < 8; ++i)
        corners.push_back({(i & 1 ? bounds.upper : bounds.lower)[0], (i & 2 ? bounds.upper : bounds.lower)[1],
                           (i & 4 ? bounds.upper : bounds.lower)[2]});
    return corners;
}

View fitted_view(const Bounds& bounds, const Pixel& lower, const Pixel& upper) {
    View view = unscaled_view(bounds.flat());
    const Rectangle r = seen(bounds, view);
    view.scale =
        std::min((upper[0] - lower[0]) / (r.upper[0] - r.lower[0]), (upper[1] - lower[1]) / (r.upper[1] - r.lower[1]));
    for (std::size_t k = 0; k < 2; ++k)
        view.origin[k] = (lower[k] + upper[k]) / 2 - view.scale * (r.lower[k] + r.upper[k]) / 2;
    return view;
}

double seen_aspect(const Bounds& bounds) {
    const Rectangle r = seen(bounds, unscaled_view(bounds.flat()));
    return (r.upper[0] - r.lower[0]) / (r.upper[1] - r.lower[1]);
}

bool add_domains(Quads& quads, const PointFrame& frame, const View& view, const std::vector<Rgb>& colours,
                 const std::vector<std::size_t>& order) {
    const std::optional<Domains> domains = Domains::of(frame);
    if (!domains) return false;
    quads.corners.reserve(quads.corners.size() + 4 * order.size());
    quads.colours.reserve(quads.colours.size() + order.size());
    for (const std::size_t p : order) {
        const auto edges = domains->half_edges(p);
        const Pixel c = view.pixel(domains->centre(p));
        const Pixel a = lengthened(view.direction(edges[0].data())), b = lengthened(view.direction(edges[1].data()));
        quads.add({c[0] - a[0] - b[0], c[1] - a[1] - b[1]}, {c[0] + a[0] - b[0], c[1] + a[1] - b[1]},
                  {c[0] + a[0] + b[0], c[1] + a[1] + b[1]}, {c[0] - a[0] + b[0], c[1] - a[1] + b[1]}, colours[p]);
    }
    return true;
}

bool add_ellipses(Quads& quads, const PointFrame& frame, const View& view, const std::vector<Rgb>& colours,
                  const std::vector<std::size_t>& order) {
    const std::optional<Domains> domains = Domains::of(frame);
    if (!domains) return false;
    std::vector<Pixel> outline;
    for (const std::size_t p : order) {
        const auto edges = domains->half_edges(p);
        const Pixel c = view.pixel(domains->centre(p));
        const Pixel a = view.direction(edges[0].data()), b = view.direction(edges[1].data());
        // A chord of 2 pi/n leaves the circle of radius r by r (pi/n)^2/2 at most.
        constexpr double error = 0.15;
        const double radius = std::hypot(a[0], a[1], std::hypot(b[0], b[1])); // at least the longer semi-axis
        const double wanted = std::ceil(std::numbers::pi / 2 * std::sqrt(radius / (2 * error)));
        const auto half = static_cast<std::size_t>(std::fmax(3, std::fmin(60, wanted))); // 60 for what is not a number
        outline.resize(2 * half);
        for (std::size_t i = 0; i < half; ++i) {
            const double angle = std::numbers::pi * static_cast<double>(i) / static_cast<double>(half);
            const double cosine = std::cos(angle), sine = std::sin(angle);
            const Pixel from_centre{cosine * a[0] + sine * b[0], cosine * a[1] + sine * b[1]};
            outline[i] = {c[0] + from_centre[0], c[1] + from_centre[1]};
            outline[i + half] = {c[0] - from_centre[0], c[1] - from_centre[1]};
        }
        for (std::size_t i = 0; i + 1 < half; ++i) // strips across
            quads.add(outline[i], outline[i + 1], outline[2 * half - 2 - i], outline[2 * half - 1 - i], colours[p]);
    }
    return true;
}

void add_dots(Dots& dots, const PointFrame& frame, const View& view, const std::vector<Rgb>& colours,
              const std::vector<std::size_t>& order) {
    for (const std::size_t p : order) {
        dots.centres.push_back(view.pixel(&frame.points[3 * p]));
        dots.depths.push_back(view.depth(&frame.points[3 * p]));
        dots.colours.push_back(colours[p]);
    }
}

void add_line(Quads& quads, const Pixel& from, const Pixel& to, double width, Rgb colour) {
    const double length = std::hypot(to[0] - from[0], to[1] - from[1]);
    if (length == 0) return;
    const double along_x = (to[0] - from[0]) / length * width / 2, along_y = (to[1] - from[1]) / length * width / 2;
    // Half a width longer at both ends, so that the corners of a box close.
    const Pixel a{from[0] - along_x, from[1] - along_y}, b{to[0] + along_x, to[1] + along_y};
    quads.add({a[0] + along_y, a[1] - along_x}, {b[0] + along_y, b[1] - along_x}, {b[0] - along_y, b[1] + along_x},
              {a[0] - along_y, a[1] + along_x}, colour);
}

void add_arrow(Quads& quads, const Pixel& from, const Pixel& direction, double length, double width, Rgb colour) {
    const double norm = std::hypot(direction[0], direction[1]);
    if (!(norm > 0)) return;
    const double ux = direction[0] / norm, uy = direction[1] / norm;
    const double head = std::min(3.6 * width, 0.6 * length), half = 0.38 * head;
    const Pixel tip{from[0] + length * ux, from[1] + length * uy};
    const Pixel neck{tip[0] - head * ux, tip[1] - head * uy};
    add_line(quads, from, neck, width, colour);
    quads.add({neck[0] + half * uy, neck[1] - half * ux}, tip, tip, {neck[0] - half * uy, neck[1] + half * ux}, colour);
}

void add_outline(Quads& quads, const Bounds& bounds, const View& view, double width, Rgb colour) {
    const auto corners = corners_of(bounds);
    for (std::size_t i = 0; i < 8; ++i)
        for (const std::size_t axis : {1u, 2u, 4u}) { // corners that differ in one coordinate share an edge
            const bool hidden_twin = bounds.flat() && (i >= 4 || axis == 4);
            if ((i & axis) == 0 && !hidden_twin)
                add_line(quads, view.pixel(corners[i].data()), view.pixel(corners[i | axis].data()), width, colour);
        }
}

} // namespace abut
