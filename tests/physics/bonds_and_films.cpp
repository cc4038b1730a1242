/// Laws with tractions on whole bodies: a bond fails at its strength whatever the time step, a viscous film brakes with
/// its closed form whatever the transfer, softened contact carries a weight.

#include "core/support.h"

#include <cstdio>

namespace {

using namespace test;

/// Largest tensile stress near the bond of two blocks that walls pull apart slowly, over the bond's strength. (Next to
/// the walls, which hold a cell each, it is less.)
double failure(double cfl, bool perfect = false) {
    const MaterialSpec m = material(1000, 2e9, 1e9);
    Scene scene = plane_scene(1, -2, -2, 6, 14, m);
    scene.method.shape = ShapeKind::ugimp;
    scene.method.transfer = transfer(TransferScheme::xpic, 2);
    scene.time.cfl = cfl;
    const double strength = 2e6;
    scene.contact = ContactSpec{};
    scene.contact->law.type = perfect ? LawType::perfect : LawType::adhesion;
    scene.contact->law.strength = scene.contact->law.shear_strength = strength;
    // Twice the strain at failure in a ramp that lasts 300 crossings of the blocks.
    const double end = 3000 / wave_speed(m);
    const double extension = 2 * strength / (2e9 + 4.0 / 3 * 1e9) * 10;
    add_wall(scene, "bottom", 1, Side::lower, 0);
    add_wall(scene, "top", 1, Side::upper, 10);
    std::get<WallSpec>(scene.boundaries[1].condition).velocity = TimeFunction({0, end}, {0, 2 * extension / end});
    add_wall(scene, "left", 0, Side::lower, 0);
    add_wall(scene, "right", 0, Side::upper, 4);
    Model model;
    add_box(model, add_body(model, "lower"), 0, 0, 4, 5, 8, 10);
    add_box(model, add_body(model, "upper"), 0, 5, 4, 10, 8, 10);
    State<2> state = make_state<2>(scene, model);
    double peak = 0;
    run(state, end, [&] {
        double stress = 0;
        int count = 0;
        for (std::size_t p = 0; p < state.particles.size(); ++p) {
            if (std::abs(state.particles.position[p][1] - 5) > 2) continue;
            stress += state.particles.stress[p][1];
            ++count;
        }
        peak = std::max(peak, stress / count);
    });
    double edge_below = 0, edge_above = 10;
    for (std::size_t p = 0; p < state.particles.size(); ++p)
        if (state.particles.body[p] == 0)
            edge_below = std::max(edge_below, state.particles.position[p][1]);
        else
            edge_above = std::min(edge_above, state.particles.position[p][1]);
    if (!perfect) {
        EXPECT_GT(edge_above - edge_below, 0.5 + 0.5 * extension) << "the blocks have parted";
    }
    return peak / strength;
}

TEST(Bonds, FailAtTheirStrengthWhateverTheTimeStep) {
    for (const double cfl : {0.5, 0.1}) {
        const double stress = failure(cfl);
        std::printf("[ figures  ] adhesion, CFL %.2f: fails at %.3f of its strength\n", cfl, stress);
        EXPECT_NEAR(stress, 1, 0.03) << cfl;
    }
    EXPECT_GT(failure(0.5, true), 2) << "a perfect bond holds on";
}

/// Velocity of a block on a viscous film after one time constant ρ h/η, over e^-1 of the initial one. The floor is as
/// wide as the block, which hardly moves: where one body ends on another, contact areas come out half a cell too wide.
double braked(const TransferSpec& scheme) {
    const MaterialSpec m = material(1000, 2e6, 1e6);
    Scene scene = plane_scene(0.1, -1, -1, 5, 2, m);
    scene.method.shape = ShapeKind::ugimp;
    scene.method.transfer = scheme;
    scene.gravity = {0, -1, 0};
    scene.contact = ContactSpec{};
    scene.contact->law.type = LawType::viscous_friction;
    const double height = 0.4, constant = 0.4, speed = 0.01;
    scene.contact->law.viscosity = 1000 * height / constant;
    BodySpec declared;
    declared.rigid = RigidSpec{};
    scene.bodies.push_back(declared);
    Model model;
    model.bodies.push_back({"floor", -1, {}, RigidSpec{}});
    add_box(model, 0, 0, -0.4, 1, 0, 20, 8);
    add_box(model, add_body(model, "block", {speed, 0, 0}), 0, 0, 1, height, 20, 8);
    State<2> state = make_state<2>(scene, model);
    prepare(state);
    run(state, constant);
    return body_totals(state)[1].mean_velocity()[0] / (speed * std::exp(-1.0));
}

TEST(Films, BrakeAlikeWithEveryTransfer) {
    for (const auto& [name, scheme] :
         {std::pair{"flip", transfer(TransferScheme::flip)}, std::pair{"pic", transfer(TransferScheme::pic)},
          std::pair{"xpic(3)", transfer(TransferScheme::xpic, 3)},
          std::pair{"fmpm(2)", transfer(TransferScheme::fmpm, 2, PositionUpdate::mean_velocity)}}) {
        const double v = braked(scheme);
        std::printf("[ figures  ] viscous film, %s: velocity after a time constant %.3f of the closed form's\n", name,
                    v);
        EXPECT_NEAR(v, 1, 0.05) << name;
    }
}

TEST(SoftContact, CarriesAWeightOnItsOverlap) {
    const MaterialSpec m = material(1000, 2e7, 1e7);
    Scene scene = plane_scene(0.1, -1, -1, 3, 2, m);
    scene.method.shape = ShapeKind::ugimp;
    scene.method.transfer = transfer(TransferScheme::xpic, 2);
    scene.gravity = {0, -10, 0};
    scene.contact = contact(LawType::friction, 0.2);
    const double pressure = 1000 * 0.4 * 10;
    scene.contact->law.contact_stiffness = pressure / 0.02; // a fifth of a cell
    BodySpec declared;
    declared.rigid = RigidSpec{};
    scene.bodies.push_back(declared);
    Model model;
    model.bodies.push_back({"floor", -1, {}, RigidSpec{}});
    add_box(model, 0, 0.5, -0.4, 1.5, 0, 20, 8);
    add_box(model, add_body(model, "block"), 0.5, 0, 1.5, 0.4, 20, 8);
    State<2> state = make_state<2>(scene, model);
    // It swings on its contact springs, about the overlap at rest.
    const double period = 2 * M_PI * std::sqrt(0.02 / 10);
    double mean = 0, last = 0;
    run(state, 10 * period, [&] {
        mean += (0.2 - body_totals(state)[1].center()[1]) * (state.time - last) / (10 * period);
        last = state.time;
    });
    std::printf("[ figures  ] softened contact: sinks in by %.4f m in the mean, pressure over stiffness 0.02 m\n",
                mean);
    EXPECT_NEAR(mean, 0.02, 0.0015); // contact areas of overlapping edges are 6 % too large
}

} // namespace
