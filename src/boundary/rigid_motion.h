#pragma once
#include "math/linear_algebra.h"
#include "scene/scene.h"

namespace abut {

/// Where the centre of a rigid body is at a time [m].
Vector rigid_center(const RigidSpec& rigid, double time);

/// Velocity of a rigid body at a place (notes 4.28): v + ω × (x − c) [m/s].
Vector rigid_velocity(const RigidSpec& rigid, const Vector& x, double time);

/// Where a point of a rigid body that was at x0 at time 0 is at a time [m].
Vector rigid_position(const RigidSpec& rigid, const Vector& x0, double time);

/// The rotation of a rigid body from one time to another.
Mat<3> rigid_rotation(const RigidSpec& rigid, double from, double to);

} // namespace abut
