/// A disk on an incline rolls if µ > tan(θ)/3, with a = (2/3) g sin θ, and slips while it turns otherwise: a = g (sin θ
/// − µ cos θ), α = 2 µ g cos θ / R. Gravity is tilted instead of the incline.

#include "core/turned_box.h"

#include <Eigen/Dense>
#include <cstdio>
#include <numbers>

namespace {

using namespace test;

constexpr double g = 10;
constexpr double slope = 30 * std::numbers::pi / 180;

struct Rolling {
    double acceleration, angular; ///< slopes of the velocities over time
    double slip;                  ///< (v − ω R)/v at the end
};

/// A disk of rings of particles with turned domains: a smooth outline. Each ring's particles have the area of their
/// piece of the ring.
void add_ring_disk(Model& model, int body, const Vector& center, double radius, double spacing) {
    const int rings = static_cast<int>(std::lround(radius / spacing));
    const double dr = radius / rings;
    for (int i = 0; i < rings; ++i) {
        const double r = (i + 0.5) * dr;
        const int count = std::max(4, 4 * static_cast<int>(std::lround(2 * std::numbers::pi * r / spacing / 4)));
        const double width = 2 * std::numbers::pi * r / count;
        for (int k = 0; k < count; ++k) {
            const double angle = 2 * std::numbers::pi * (k + 0.5) / count;
            add_particle(model, body, center[0] + r * std::cos(angle), center[1] + r * std::sin(angle), dr / 2,
                         width / 2);
            model.angle.push_back(angle);
        }
    }
}

/// \param cells to a radius
Rolling roll(double friction, double cells, bool rings, StressUpdate update) {
    constexpr double R = 0.5;
    const double cell = R / cells;
    const MaterialSpec m = material(1000, 2e6, 1e6);
    Scene scene = plane_scene(cell, -0.6, -0.3, 1.4, 1.2, m);
    scene.method.stress_update = update;
    scene.gravity = {0, -1, 0}; // see ramp
    scene.contact = contact(LawType::friction, friction);
    scene.method.transfer = transfer(TransferScheme::pic); // settles under its weight
    Model model;
    const int floor = add_body(model, "floor");
    const int disk = add_body(model, "disk");
    const double depth = 0.2;
    add_box(model, floor, -0.6, -depth, 1.4, 0, static_cast<int>(std::lround(4 / cell)),
            static_cast<int>(std::lround(2 * depth / cell)));
    model.angle.assign(model.size(), 0);
    if (rings) {
        add_ring_disk(model, disk, {0, R, 0}, R, cell / 2);
    } else {
        add_disk(model, disk, 0, R, R, cell / 2);
        model.angle.clear();
    }
    for (const int axis : {0, 1}) { // the floor's lower half is held
        VelocitySpec fixed;
        fixed.lower = {-9, -9, 0};
        fixed.upper = {9, -depth / 2, 0};
        fixed.direction[axis] = 1;
        scene.boundaries.push_back({axis ? "held y" : "held x", fixed});
    }
    State<2> state = make_state<2>(scene, model);
    // The weight comes and the incline rises within a few periods of the disk on its elastic contact: it hardly
    // bounces.
    constexpr double settled = 0.3, begin = 0.45, end = 0.85;
    ramp(state, 0, settled, [](double share) { return Vector{0, -g * std::cos(slope) * share, 0}; });
    state.scene.method.transfer = transfer(TransferScheme::flip);
    ramp(state, settled, begin, [](double share) {
        return Vector{g * std::sin(share * slope), -g * std::cos(slope), 0};
    });
    Eigen::Matrix2d A = Eigen::Matrix2d::Zero();
    Eigen::Matrix2d b = Eigen::Matrix2d::Zero();
    run(state, end, [&] {
        const Eigen::Vector2d row(1, state.time - begin);
        const auto now = body_totals(state)[disk];
        A += row * row.transpose();
        b += row * Eigen::RowVector2d(now.mean_velocity()[0], -now.angular_velocity_z());
    });
    const Eigen::Matrix2d fit = A.inverse() * b;
    const auto now = body_totals(state)[disk];
    return {fit(1, 0), fit(1, 1), 1 + now.angular_velocity_z() * R / now.mean_velocity()[0]};
}

struct Errors {
    double a, alpha; ///< relative, of acceleration and angular acceleration
    double slip;
};

Errors errors(const char* what, double friction, double cells, bool rings, StressUpdate update) {
    const Rolling r = roll(friction, cells, rings, update);
    const bool rolls = friction > std::tan(slope) / 3;
    const double a = rolls ? 2 * g * std::sin(slope) / 3 : g * (std::sin(slope) - friction * std::cos(slope));
    const double alpha = rolls ? a / 0.5 : 2 * friction * g * std::cos(slope) / 0.5;
    std::printf(
        "[ figures  ] %s, radius %.0f cells, friction %.2f: a = %.3f, theory %.3f m/s^2; alpha = %.3f, theory %.3f "
        "rad/s^2; slip at the end %.3f (%s)\n",
        what, cells, friction, r.acceleration, a, r.angular, alpha, r.slip, rolls ? "rolls" : "slips");
    return {std::abs(r.acceleration / a - 1), std::abs(r.angular / alpha - 1), r.slip};
}

/// The limit between both is µ = 0.19. FLIP takes angular momentum away, as the particles around a node turn about it,
/// less with smaller cells (and less with usavg+). In slip α is still 9 % too small at 16 cells to the radius (7 % with
/// usavg+): here it is its falling that is tested.
TEST(Rolling, ASmoothDiskRollsOrSlips) {
    for (const double friction : {0.1, 0.4}) {
        const Errors coarse = errors("smooth outline", friction, 8, true, StressUpdate::usl);
        const Errors fine = errors("smooth outline", friction, 16, true, StressUpdate::usl);
        const Errors averaged = errors("smooth outline, USAVG+", friction, 16, true, StressUpdate::usavg_plus);
        EXPECT_LT(fine.alpha, 0.7 * coarse.alpha);
        EXPECT_LT(averaged.alpha, fine.alpha);
        EXPECT_LT(fine.a, 0.02);
        EXPECT_LT(averaged.a, 0.02);
        if (friction > 0.2) {
            EXPECT_LT(fine.alpha, 0.035);
            EXPECT_LT(std::abs(fine.slip), 0.02);
        } else {
            EXPECT_GT(fine.slip, 0.5); // 0.58 in theory
        }
    }
}

/// A disk of particles on a lattice rolls on corners: it loses much of its way. Smaller cells help.
TEST(Rolling, ADiskWithStepsIsBraked) {
    const Errors coarse = errors("steps in the outline", 0.4, 8, false, StressUpdate::usl);
    const Errors fine = errors("steps in the outline", 0.4, 16, false, StressUpdate::usl);
    EXPECT_LT(fine.a, 0.6 * coarse.a);
    EXPECT_LT(fine.alpha, 0.6 * coarse.alpha);
    EXPECT_LT(std::abs(fine.slip), 0.05);
}

} // namespace
