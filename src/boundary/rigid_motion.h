#pragma once
#include "math/linear_algebra.h"
#include "scene/scene.h"

namespace abut {

/// Place and velocity of a rigid body at one time.
struct RigidPose {
    Vec<3> center_at_start;  ///< [m]
    Vec<3> center;           ///< [m]
    Mat<3> rotation;         ///< since time 0
    Vec<3> velocity;         ///< of the centre [m/s]
    Vec<3> angular_velocity; ///< [rad/s]

    /// Where a point of the body that was at x0 at time 0 is [m].
    Vector position_of(const Vector& x0) const;
    /// Velocity of the body at a place (notes 4.28): v + ω × (x − c) [m/s].
    Vector velocity_at(const Vector& x) const;
};

/// The pose that a prescribed motion has at a time; its centre must be set.
RigidPose rigid_pose(const RigidSpec& rigid, double time);

} // namespace abut
