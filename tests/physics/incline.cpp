/// A block on an incline: sliding a = g (sin θ − µ cos θ), sticking below the angle of friction. Gravity is tilted
/// instead of the incline; the incline is a second body on walls.

#include "core/support.h"

#include <cstdio>

namespace {

using namespace test;

struct Sliding {
    double acceleration; ///< along the incline, of the block
    double normal;       ///< height lost or gained, in cells
    double theory;
};

Sliding slide(double angle, double friction, TransferSpec scheme, ShapeKind shape = ShapeKind::ugimp) {
    constexpr double g = 10;
    constexpr double cell = 0.05;
    const MaterialSpec m = material(1000, 2e6, 1e6);
    Scene scene = plane_scene(cell, 0, 0, 4, 1.2, m);
    scene.method.shape = shape;
    scene.method.transfer = scheme;
    scene.gravity = {g * std::sin(angle), -g * std::cos(angle), 0};
    scene.contact = contact(LawType::friction, friction);
    add_wall(scene, "bottom", 1, Side::lower, 0.1);
    add_wall(scene, "left", 0, Side::lower, 0.1);
    add_wall(scene, "right", 0, Side::upper, 3.9);
    // Grips also along the incline: the floor must not slide off; its ends are held.
    Model model;
    const int floor = add_body(model, "floor");
    const int block = add_body(model, "block");
    add_box(model, floor, 0.1, 0.1, 3.9, 0.4, 152, 12);
    add_box(model, block, 0.6, 0.4, 1.0, 0.7, 16, 12);
    State<2> state = make_state<2>(scene, model);
    // Let gravity's first wave pass, then measure by the block's velocity.
    run(state, 0.1);
    const auto before = body_totals(state)[block];
    run(state, 0.4);
    const auto after = body_totals(state)[block];
    const double slope = g * std::sin(angle) - friction * g * std::cos(angle);
    return {(after.mean_velocity()[0] - before.mean_velocity()[0]) / 0.3,
            (after.center()[1] - 0.55) / cell, std::max(0.0, slope)};
}

TEST(Incline, ABlockSlidesAsCoulombSays) {
    for (const double degrees : {15.0, 30.0})
        for (const double friction : {0.0, 0.1, 0.2}) {
            const Sliding s = slide(degrees * M_PI / 180, friction, transfer(TransferScheme::xpic, 3));
            std::printf("[ figures  ] incline %2.0f deg, friction %.1f: a = %.4f, theory %.4f m/s^2\n", degrees,
                        friction, s.acceleration, s.theory);
            EXPECT_NEAR(s.acceleration, s.theory, 0.02 * 10 * std::sin(degrees * M_PI / 180));
            EXPECT_LT(std::abs(s.normal), 0.1);
        }
}

TEST(Incline, ABlockSticksBelowTheAngleOfFriction) {
    const Sliding s = slide(15 * M_PI / 180, 0.4, transfer(TransferScheme::xpic, 3));
    std::printf("[ figures  ] incline 15 deg, friction 0.4: a = %.5f m/s^2, theory 0\n", s.acceleration);
    EXPECT_LT(std::abs(s.acceleration), 0.02);
}

} // namespace
