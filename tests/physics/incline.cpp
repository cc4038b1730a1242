/// A block on an incline: sliding a = g (sin θ − µ cos θ), sticking below the angle of friction. Gravity is tilted
/// instead of the incline; the incline is a second body on walls.

#include "core/support.h"

#include <Eigen/Dense>
#include <cstdio>

namespace {

using namespace test;

struct Sliding {
    double acceleration;  ///< along the incline, of the block
    double first, second; ///< mean ways in the first and the second 0.2 s, over the floor under the block's middle
    double normal;        ///< height lost or gained, in cells
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
    const auto place = [&] {
        double below = 0;
        for (std::size_t p = 0; p < state.particles.size(); ++p)
            if (state.particles.id[p] == 11 * 152 + 28) below = state.particles.position[p][0];
        return body_totals(state)[block].center()[0] - below;
    };
    const double start = place();
    state.scene.gravity = {g * std::sin(angle), -g * std::cos(angle), 0};
    state.scene.method.transfer = transfer(TransferScheme::flip);
    // The parabola through all places of the block's centre, when the first shear waves have passed.
    Eigen::Matrix3d A = Eigen::Matrix3d::Zero();
    Eigen::Vector3d b = Eigen::Vector3d::Zero();
    double sum[2] = {};
    int count[2] = {};
    run(state, 0.6, [&] {
        const int half = state.time < 0.4 ? 0 : 1;
        sum[half] += place() - start;
        ++count[half];
        const double t = state.time - 0.3;
        if (t < 0) return;
        const Eigen::Vector3d row(1, t, 0.5 * t * t);
        A += row * row.transpose();
        b += row * body_totals(state)[block].center()[0];
    });
    const double slope = g * std::sin(angle) - friction * g * std::cos(angle);
    return {A.ldlt().solve(b)[2], sum[0] / count[0], sum[1] / count[1],
            (body_totals(state)[block].center()[1] - 0.55) / cell, std::max(0.0, slope)};
}

TEST(Incline, ABlockSlidesAsCoulombSays) {
    for (const double degrees : {15.0, 30.0})
        for (const double friction : {0.0, 0.1, 0.2}) {
            const Sliding s = slide(degrees, friction);
            std::printf("[ figures  ] incline %2.0f deg, friction %.1f: a = %.4f, theory %.4f m/s^2\n", degrees,
                        friction, s.acceleration, s.theory);
            EXPECT_NEAR(s.acceleration, s.theory, 0.003 * 10 * std::sin(degrees * M_PI / 180));
            EXPECT_LT(std::abs(s.normal), 0.1);
        }
}

/// Gravity is tilted at once and the block rocks: with a friction of 0.6 (angle 31 degrees) its heel slips by a few
/// hundredths of a cell until the rocking is over.
TEST(Incline, ABlockSticksBelowTheAngleOfFriction) {
    const Sliding s = slide(15, 1);
    std::printf("[ figures  ] incline 15 deg, friction 1: moved %.2e m in the first 0.2 s, %+.2e m more in the second; "
                "without friction 0.017 and 0.104 m\n",
                s.first, s.second - s.first);
    // Its own shear and that of the floor, 3 ρ g sin θ h²/2G = 3.5e-4 m, swings about that and does not creep on.
    EXPECT_NEAR(s.first, 3.5e-4, 3.5e-4);
    EXPECT_LT(std::abs(s.second - s.first), 1e-4);
}

} // namespace
