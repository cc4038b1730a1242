#pragma once
/// \file solid.h
/// Shapes of the scene as one thing: what a straight line along the last axis has of it.

#include "scene/scene.h"

#include <array>
#include <functional>
#include <vector>

namespace abut {

/// A piece of a line, from < to [m].
struct Span {
    double from = 0, to = 0;
    bool operator==(const Span&) const = default;
};

/// Pieces of one line in ascending order that neither overlap nor touch.
using Spans = std::vector<Span>;

Spans united(const Spans& a, const Spans& b);
Spans intersection(const Spans& a, const Spans& b);
Spans difference(const Spans& a, const Spans& b);

/// A shape, open or closed at its outline as round-off has it. Lines run along y in plane scenes and along z in 3D.
/// "Inside by centre" and "covered fraction" both ask only for spans, and so do unions, differences and intersections.
struct Solid {
    Vector lower{}, upper{}; ///< box that holds it (z 0 in plane scenes) [m]
    /// Coordinates x (first) and, in 3D, y (second) at which the spans may jump or have a kink (corners, faces across
    /// the axis), ascending. Integrals over x and y are made piecewise between them; shapes with many corners may leave
    /// them out.
    std::array<std::vector<double>, 2> breaks;
    /// The spans of the line at x (and, in 3D, y). May be called by several threads at once.
    std::function<Spans(double x, double y)> spans;
    /// Whether the places whose centre lies on its outline are its own only on its lower and left sides: of shapes with
    /// straight sides, which may share them with others. Round ones take all, which keeps them symmetric.
    bool half_open = false;
};

} // namespace abut
