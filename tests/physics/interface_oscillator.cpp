/// Case 12 on whole bodies: a stiff block between two rigid plates, on springs along both interfaces, swings like a
/// harmonic oscillator of ω² = 2 D_t A / m, and what it loses in kinetic energy is in the springs.

#include "core/support.h"

#include <cstdio>

namespace {

using namespace test;

struct Swinging {
    double period = 0, theory = 0;
    double amplitude = 0; ///< of the last period over the first
    double balance = 0;   ///< largest change of kinetic + strain + interface energy, relative
};

Swinging swing_of(const TransferSpec& scheme, double phase) {
    constexpr double cell = 0.1, length = 2, height = 0.4, speed = 0.01;
    const MaterialSpec m = material(1000, 4e9, 2e9);
    Scene scene = plane_scene(cell, -2, -1, 4, 1.4, m);
    scene.method.shape = ShapeKind::ugimp;
    scene.method.transfer = scheme;
    // κ Δt at a node: the reduced mass of half a cell of material against a rigid plate.
    const double dt = 0.4 * cell / wave_speed(m);
    const double stiffness = phase * phase / (dt * dt) * 1000 * cell / 2;
    scene.contact = ContactSpec{};
    scene.contact->law.type = LawType::linear_interface;
    scene.contact->law.tension_stiffness = scene.contact->law.tangential_stiffness = stiffness;
    BodySpec declared;
    declared.rigid = RigidSpec{};
    scene.bodies.push_back(declared);
    Model model;
    const int block = add_body(model, "block", {speed, 0, 0});
    add_box(model, block, 0, 0, length, height, 40, 8);
    model.bodies.push_back({"below", -1, {}, RigidSpec{}});
    model.bodies.push_back({"above", -1, {}, RigidSpec{}});
    add_box(model, 1, -1, -0.2, 3, 0, 80, 4);
    add_box(model, 2, -1, height, 3, height + 0.2, 80, 4);
    State<2> state = make_state<2>(scene, model);
    prepare(state);
    Swinging result;
    const double mass = body_totals(state)[block].mass;
    const double omega = std::sqrt(2 * stiffness * length / mass);
    result.theory = 2 * M_PI / omega;
    const double energy = 0.5 * mass * speed * speed;
    std::vector<double> crossings;
    double last_x = 0, last_t = 0, first_peak = 0, last_peak = 0;
    constexpr int periods = 10;
    run(state, periods * result.theory, [&] {
        const Totals t = body_totals(state)[block];
        const double x = t.center()[0] - length / 2;
        if (last_x < 0 && x >= 0) crossings.push_back(last_t + (state.time - last_t) * last_x / (last_x - x));
        last_x = x;
        last_t = state.time;
        (state.time < result.theory ? first_peak : last_peak) = std::max(
            state.time < result.theory ? first_peak : (state.time > (periods - 1) * result.theory ? last_peak : 0), x);
        result.balance =
            std::max(result.balance,
                     std::abs(t.kinetic_energy + t.strain_energy + state.ledger.interface_energy - energy) / energy);
    });
    result.period = (crossings.back() - crossings.front()) / static_cast<double>(crossings.size() - 1);
    result.amplitude = last_peak / first_peak;
    return result;
}

TEST(InterfaceOscillator, ABlockSwingsOnItsInterfaces) {
    for (const double phase : {0.02, 0.1}) {
        const Swinging s = swing_of(transfer(TransferScheme::flip), phase);
        std::printf("[ figures  ] block on springs, flip, phase %.2f: period %.6g s, theory (rigid block) %.6g s, "
                    "amplitude x %.4f after 10 periods, energy balance within %.2e\n",
                    phase, s.period, s.theory, s.amplitude, s.balance);
        // The block shears: its own compliance h/6G beside 1/D_t of two interfaces lengthens the period.
        EXPECT_NEAR(s.period, s.theory, 0.02 * s.theory);
        EXPECT_NEAR(s.amplitude, 1, 0.03);
        EXPECT_LT(s.balance, 0.06);
    }
}

} // namespace
