#pragma once
/// \file turn3.h
/// Rotations in space.

#include "scene/scene.h"

#include <cmath>

namespace abut {

/// A rotation matrix, row by row.
using Rotation = std::array<Vector, 3>;

/// Counter-clockwise by an angle seen against an axis of any length but 0 (Rodrigues).
inline Rotation rotation(const Vector& axis, double angle) {
    const double length = std::hypot(axis[0], axis[1], axis[2]);
    const Vector n{axis[0] / length, axis[1] / length, axis[2] / length};
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    Rotation R{};
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) R[i][j] = (1 - c) * n[i] * n[j] + (i == j ? c : 0);
    R[0][1] -= s * n[2];
    R[1][0] += s * n[2];
    R[0][2] += s * n[1];
    R[2][0] -= s * n[1];
    R[1][2] -= s * n[0];
    R[2][1] += s * n[0];
    return R;
}

inline Vector rotated(const Rotation& R, const Vector& x) {
    Vector y{};
    for (std::size_t i = 0; i < 3; ++i) y[i] = R[i][0] * x[0] + R[i][1] * x[1] + R[i][2] * x[2];
    return y;
}

} // namespace abut
