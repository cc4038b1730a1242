#include "boundary/rigid_motion.h"

#include <Eigen/Geometry>

namespace abut {

namespace {

Vec<3> eigen(const Vector& v) {
    return {v[0], v[1], v[2]};
}

} // namespace

Vector RigidPose::position_of(const Vector& x0) const {
    return to_array<3>(center + rotation * (eigen(x0) - center_at_start));
}

Vector RigidPose::velocity_at(const Vector& x) const {
    return to_array<3>(velocity + angular_velocity.cross(eigen(x) - center));
}

RigidPose rigid_pose(const RigidSpec& rigid, double time) {
    const Vec<3> axis = eigen(rigid.axis).normalized();
    RigidPose pose;
    pose.center_at_start = pose.center = eigen(rigid.center.value_or(Vector{}));
    for (int a = 0; a < 3; ++a) {
        pose.center[a] += rigid.velocity[a].integral(time);
        pose.velocity[a] = rigid.velocity[a].at(time);
    }
    pose.rotation = Eigen::AngleAxisd(rigid.angular_velocity.integral(time), axis).toRotationMatrix();
    pose.angular_velocity = rigid.angular_velocity.at(time) * axis;
    return pose;
}

} // namespace abut
