#pragma once
/// \file turn.h
/// Rectangles that are turned in the plane, counter-clockwise by an angle in radians; z stays as it is.

#include "scene/scene.h"

#include <cmath>

namespace abut {

inline Vector turned(const Vector& x, double angle) {
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    return {c * x[0] - s * x[1], s * x[0] + c * x[1], x[2]};
}

inline Vector turned_about(const Vector& fixed, const Vector& x, double angle) {
    const Vector d = turned({x[0] - fixed[0], x[1] - fixed[1], 0}, angle);
    return {fixed[0] + d[0], fixed[1] + d[1], x[2]};
}

/// How far a rectangle of these half edges reaches from its centre along x and y when it is turned.
inline Vector turned_reach(const Vector& half_size, double angle) {
    const double c = std::abs(std::cos(angle));
    const double s = std::abs(std::sin(angle));
    return {c * half_size[0] + s * half_size[1], s * half_size[0] + c * half_size[1], half_size[2]};
}

/// What is a cell to a turned rectangle: the lengths of the lines along its edges that cross a cell's inscribed
/// ellipse. Cells that are squares stay what they are, a quarter turn exchanges the axes.
inline Vector turned_cell(const Vector& cell, double angle) {
    if (angle == 0) return cell;
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    return {1 / std::hypot(c / cell[0], s / cell[1]), 1 / std::hypot(s / cell[0], c / cell[1]), cell[2]};
}

inline Vector center(const Box& box) {
    Vector x{};
    for (std::size_t axis = 0; axis < 3; ++axis) x[axis] = (box.lower[axis] + box.upper[axis]) / 2;
    return x;
}

} // namespace abut
