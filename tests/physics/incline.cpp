/// A block on an incline: sliding a = g (sin θ − µ cos θ), sticking below the angle of friction. Gravity is tilted
/// instead of the incline; the incline is a second body on walls.

#include "core/support.h"

#include <Eigen/Dense>
#include <cstdio>

namespace {

using namespace test;

struct Sliding {
    double acceleration; ///< along the incline, of the block
    double distance;     ///< along the incline
    double normal;       ///< height lost or gained, in cells
    double theory;
};

Sliding slide(double degrees, double friction) {
    const double angle = degrees * M_PI / 180;
    constexpr double g = 10;
    constexpr double cell = 0.05;
    const MaterialSpec m = material(1000, 2e6, 1e6);
    Scene scene = plane_scene(cell, 0, 0, 4, 1.2, m);
    scene.method.shape = ShapeKind::ugimp;
    scene.gravity = {0, -g * std::cos(angle), 0};
    scene.method.transfer = transfer(TransferScheme::pic); // settles under its weight, strongly damped
    scene.contact = contact(LawType::friction, friction);
    add_wall(scene, "bottom", 1, Side::lower, 0.1);
    add_wall(scene, "left", 0, Side::lower, 0.1);
    add_wall(scene, "right", 0, Side::upper, 3.9);
    Model model;
    const int floor = add_body(model, "floor");
    const int block = add_body(model, "block");
    add_box(model, floor, 0.1, 0.1, 3.9, 0.4, 152, 12);
    add_box(model, block, 0.6, 0.4, 1.0, 0.7, 16, 12);
    State<2> state = make_state<2>(scene, model);
    run(state, 0.2);
    const double start = body_totals(state)[block].center()[0];
    state.scene.gravity = {g * std::sin(angle), -g * std::cos(angle), 0};
    state.scene.method.transfer = transfer(TransferScheme::flip);
    // The parabola through all places of the block's centre, when the first shear waves have passed.
    Eigen::Matrix3d A = Eigen::Matrix3d::Zero();
    Eigen::Vector3d b = Eigen::Vector3d::Zero();
    run(state, 0.6, [&] {
        const double t = state.time - 0.3;
        if (t < 0) return;
        const Eigen::Vector3d row(1, t, 0.5 * t * t);
        A += row * row.transpose();
        b += row * body_totals(state)[block].center()[0];
    });
    const double slope = g * std::sin(angle) - friction * g * std::cos(angle);
    return {A.ldlt().solve(b)[2], body_totals(state)[block].center()[0] - start,
            (body_totals(state)[block].center()[1] - 0.55) / cell, std::max(0.0, slope)};
}

TEST(Incline, ABlockSlidesAsCoulombSays) {
    for (const double degrees : {15.0, 30.0})
        for (const double friction : {0.0, 0.1, 0.2}) {
            const Sliding s = slide(degrees, friction);
            std::printf("[ figures  ] incline %2.0f deg, friction %.1f: a = %.4f, theory %.4f m/s^2\n", degrees,
                        friction, s.acceleration, s.theory);
            EXPECT_NEAR(s.acceleration, s.theory, 0.015 * 10 * std::sin(degrees * M_PI / 180));
            EXPECT_LT(std::abs(s.normal), 0.1);
        }
}

/// Gravity is tilted at once, so that the shear at the base swings up to 2 tan θ = 0.54 of the pressure.
TEST(Incline, ABlockSticksBelowTheAngleOfFriction) {
    const Sliding s = slide(15, 0.6);
    std::printf("[ figures  ] incline 15 deg, friction 0.6: moved %.2e m in 0.4 s, free slide 0.207 m\n", s.distance);
    // No farther than its own shear and that of the floor: ρ g sin θ h²/2G of 1e-4 m.
    EXPECT_LT(std::abs(s.distance), 5e-4);
}

} // namespace
