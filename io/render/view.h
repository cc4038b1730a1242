#pragma once
/// \file view.h
/// From metres to pixels, and what is drawn at places of the scene: particle domains, dots, arrows, lines.

#include "io/render/picture.h"
#include "results/frame.h"

#include <array>
#include <vector>

namespace abut {

struct Bounds {
    std::array<double, 3> lower{}, upper{}; ///< [m]
    bool flat() const { return upper[2] - lower[2] <= 1e-9 * (upper[0] - lower[0]); }
};

/// A parallel projection. Flat scenes are seen from above, x to the right and y upwards; others obliquely, z upwards.
struct View {
    std::array<std::array<double, 3>, 3> axes{}; ///< unit vectors to the right, upwards and towards the eye
    Pixel origin{};                              ///< where the point (0, 0, 0) lies
    double scale = 1;                            ///< [pixels/m]

    Pixel direction(const double* vector) const; ///< of a vector, without the shift to the origin
    Pixel pixel(const double* point) const;
    double depth(const double* point) const; ///< towards the eye [pixels]
};

/// The eight corners of a box.
std::vector<std::array<double, 3>> corners_of(const Bounds& bounds);

/// A view in which `bounds` lie as large as possible in the middle of a rectangle of the picture.
View fitted_view(const Bounds& bounds, const Pixel& lower, const Pixel& upper);

/// Width / height of `bounds` as they are seen.
double seen_aspect(const Bounds& bounds);

/// Adds each plane particle's deformed domain (see domains.h) as a parallelogram in the given order, a third of a pixel
/// larger. Returns false, adding nothing, if there is no `half_size`.
bool add_domains(Quads& quads, const PointFrame& frame, const View& view, const std::vector<Rgb>& colours,
                 const std::vector<std::size_t>& order);

/// Likewise, the ellipses inscribed in the domains: F times the ellipses inscribed in the undeformed rectangles; as
/// polygons less than 0.15 pixels from them.
bool add_ellipses(Quads& quads, const PointFrame& frame, const View& view, const std::vector<Rgb>& colours,
                  const std::vector<std::size_t>& order);

void add_dots(Dots& dots, const PointFrame& frame, const View& view, const std::vector<Rgb>& colours,
              const std::vector<std::size_t>& order);

/// A straight line [pixels].
void add_line(Quads& quads, const Pixel& from, const Pixel& to, double width, Rgb colour);

/// An arrow from `from` along `direction` (of any length) [pixels].
void add_arrow(Quads& quads, const Pixel& from, const Pixel& direction, double length, double width, Rgb colour);

/// The edges of a box.
void add_outline(Quads& quads, const Bounds& bounds, const View& view, double width, Rgb colour);

} // namespace abut
