/// A block on an incline with friction from none to more than enough, on a plane along the grid (gravity tilted) and on
/// one that lies across the grid (floor and block turned): a = g (sin θ − µ cos θ), or the block stays.

#include "core/turned_box.h"

#include <Eigen/Dense>
#include <cstdio>
#include <numbers>

namespace {

using namespace test;

constexpr double g = 10;
constexpr double slope = 30 * std::numbers::pi / 180;

struct Sliding {
    double acceleration; ///< down the incline, from the parabola through all places
    double way;          ///< with the whole slope [m]
    double rise;         ///< off the incline [cells]
    double before;       ///< way while gravity turned [m]
};

/// Fixes the floor's lower half: nodes in steps of boxes along its length.
void hold_floor(Scene& scene, const Vec<2>& middle, double length, double height, const Vec<2>& along,
                const Vec<2>& normal) {
    constexpr int steps = 40;
    for (int i = 0; i < steps; ++i)
        for (const Vector& direction : {Vector{1, 0, 0}, Vector{0, 1, 0}}) {
            // A box below each piece of the middle line: its upper right corner, or upper left one, is on that line.
            const Vec<2> a = middle + ((i + 0.0) / steps - 0.5) * length * along;
            const Vec<2> b = middle + ((i + 1.0) / steps - 0.5) * length * along;
            const double top = std::min(a[1], b[1]);
            VelocitySpec fixed;
            fixed.lower = {a[0], top - 2 * height / normal[1], 0};
            fixed.upper = {b[0], top, 0};
            fixed.direction = direction;
            scene.boundaries.push_back({"held " + std::to_string(scene.boundaries.size()), fixed});
        }
}

/// \param tilt of the floor in the grid, clockwise; gravity makes up for the rest of the slope
Sliding slide(double friction, double tilt, double cell) {
    const Vec<2> along(std::cos(tilt), -std::sin(tilt));
    const Vec<2> normal(std::sin(tilt), std::cos(tilt));
    const MaterialSpec m = material(1000, 2e6, 1e6);
    Scene scene = plane_scene(cell, -1, -1, 1, 1, m);
    scene.gravity = {0, -1, 0}; // see ramp
    scene.contact = contact(LawType::friction, friction);
    scene.method.transfer = transfer(TransferScheme::pic); // settles under its weight, strongly damped
    const auto tilted = [&](double down, double into) {
        const Vec<2> v = down * along - into * normal;
        return Vector{v[0], v[1], 0};
    };
    Model model;
    const int floor = add_body(model, "floor");
    const int block = add_body(model, "block");
    constexpr double length = 1.6, height = 0.3;
    const Vec<2> middle = -height / 2 * normal; // the plane goes through the origin
    const Vec<2> start = -0.5 * along + 0.15 * normal;
    add_turned_box(model, floor, {middle[0], middle[1], 0}, length, height,
                   static_cast<int>(std::lround(2 * length / cell)), static_cast<int>(std::lround(2 * height / cell)),
                   -tilt);
    add_turned_box(model, block, {start[0], start[1], 0}, 0.4, 0.3, static_cast<int>(std::lround(0.8 / cell)),
                   static_cast<int>(std::lround(0.6 / cell)), -tilt);
    hold_floor(scene, middle, length, height, along, normal);
    State<2> state = make_state<2>(scene, model);
    // The weight comes within a few periods of the block on the floor, and so does the slope: it hardly bounces or
    // rocks.
    ramp(state, 0, 0.2, [&](double share) { return tilted(0, share * g * std::cos(slope)); });
    const auto place = [&] {
        const auto x = body_totals(state)[block].center();
        return Vec<2>(x[0], x[1]);
    };
    const Vec<2> settled = place();
    state.scene.method.transfer = transfer(TransferScheme::flip);
    ramp(state, 0.2, 0.4, [&](double share) { return tilted(g * std::sin(share * slope), g * std::cos(slope)); });
    const double before = (place() - settled).dot(along);
    Eigen::Matrix3d A = Eigen::Matrix3d::Zero();
    Eigen::Vector3d b = Eigen::Vector3d::Zero();
    run(state, 0.7, [&] {
        const double t = state.time - 0.4;
        const Eigen::Vector3d row(1, t, 0.5 * t * t);
        A += row * row.transpose();
        b += row * (place() - settled).dot(along);
    });
    const Vec<2> way = place() - settled;
    return {A.ldlt().solve(b)[2], way.dot(along) - before, way.dot(normal) / cell, before};
}

/// \param tolerance of the acceleration [m/s^2]
void sweep(const char* what, double tilt, double tolerance) {
    for (const double friction : {0.0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.7, 1.0}) {
        const Sliding s = slide(friction, tilt, 0.05);
        const double theory = std::max(0.0, g * (std::sin(slope) - friction * std::cos(slope)));
        std::printf(
            "[ figures  ] %s, 30 deg, friction %.1f: a = %.4f, theory %.4f m/s^2 (way %.4f after %.5f m; off the "
            "plane %+.3f cells)\n",
            what, friction, s.acceleration, theory, s.way, s.before, s.rise);
        EXPECT_NEAR(s.acceleration, theory, theory > 0 ? tolerance : 0.01) << friction;
        EXPECT_LT(std::abs(s.rise), 0.1) << friction;
    }
}

TEST(InclineSweep, PlaneAlongTheGrid) {
    sweep("along the grid", 0, 0.002 * g * std::sin(slope));
}

/// Normals that lean by a degree, as those of the regression alone do at the ends of a block, would brake it by 1 % of
/// its weight.
TEST(InclineSweep, PlaneAcrossTheGrid) {
    sweep("turned by 30 deg", slope, 0.002 * g * std::sin(slope));
}

} // namespace
