#include "boundary/rigid_motion.h"

#include <Eigen/Geometry>

namespace abut {

namespace {

Eigen::Vector3d eigen(const Vector& v) {
    return {v[0], v[1], v[2]};
}
Vector vector(const Eigen::Vector3d& v) {
    return {v[0], v[1], v[2]};
}

Eigen::Vector3d center_at_start(const RigidSpec& rigid) {
    return eigen(rigid.center.value_or(Vector{}));
}

} // namespace

Vector rigid_center(const RigidSpec& rigid, double time) {
    Vector center = vector(center_at_start(rigid));
    for (std::size_t a = 0; a < 3; ++a) center[a] += rigid.velocity[a].integral(time);
    return center;
}

Vector rigid_velocity(const RigidSpec& rigid, const Vector& x, double time) {
    const Eigen::Vector3d arm = eigen(x) - eigen(rigid_center(rigid, time));
    const Eigen::Vector3d spin = rigid.angular_velocity.at(time) * eigen(rigid.axis).normalized().cross(arm);
    Vector v{};
    for (std::size_t a = 0; a < 3; ++a) v[a] = rigid.velocity[a].at(time) + spin[static_cast<int>(a)];
    return v;
}

Vector rigid_position(const RigidSpec& rigid, const Vector& x0, double time) {
    const Eigen::Vector3d arm = eigen(x0) - center_at_start(rigid);
    return vector(eigen(rigid_center(rigid, time)) + rigid_rotation(rigid, 0, time) * arm);
}

Mat<3> rigid_rotation(const RigidSpec& rigid, double from, double to) {
    const double angle = rigid.angular_velocity.integral(to) - rigid.angular_velocity.integral(from);
    return Eigen::AngleAxisd(angle, eigen(rigid.axis).normalized()).toRotationMatrix();
}

} // namespace abut
