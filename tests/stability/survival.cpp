/// Hard scenes that must run to their end with sound particles.

#include "core/support.h"

#include "results/interpenetration.h"

#include <cstdio>

namespace {

using namespace test;

void expect_sound(const State<2>& state) {
    for (std::size_t p = 0; p < state.particles.size(); ++p) {
        EXPECT_TRUE(state.particles.position[p].allFinite() && state.particles.velocity[p].allFinite());
        EXPECT_GT(state.particles.deformation_gradient[p].determinant(), 0);
    }
}

MaterialSpec aluminium() {
    return material(2780, 78.09e9, 27.6e9);
}

TEST(Survival, ThreeDisksSqueezedToHalfHeight) {
    constexpr double mm = 1e-3;
    Scene scene = plane_scene(0.0286 * mm, 0, 0, 0.6 * mm, 1.2 * mm, aluminium());
    scene.method.shape = ShapeKind::cpdi;
    scene.method.transfer = transfer(TransferScheme::xpic, 5);
    scene.contact = contact(LawType::frictionless);
    add_wall(scene, "bottom", 1, Side::lower, 0, 0, false, 0);
    add_wall(scene, "left", 0, Side::lower, 0, 0, false, 0);
    add_wall(scene, "right", 0, Side::upper, 0.6 * mm, 0, false, 0);
    add_wall(scene, "piston", 1, Side::upper, 1.05 * mm, -100, false, 0.5);
    Model model;
    const double spacing = 0.6 * mm / 21 / 2;
    add_disk(model, add_body(model, "large"), 0.3 * mm, 0.3 * mm, 0.28 * mm, spacing);
    add_disk(model, add_body(model, "middle"), 0.2 * mm, 0.75 * mm, 0.16 * mm, spacing);
    add_disk(model, add_body(model, "small"), 0.46 * mm, 0.9 * mm, 0.13 * mm, spacing);
    State<2> state = make_state<2>(scene, model);
    double worst = 0;
    double piston_work = 0; // force times velocity
    for (int i = 1; i <= 12; ++i) {
        run(state, i * 0.5e-6);
        worst = std::max(worst, interpenetration(state.particles).fraction());
        piston_work += state.boundaries[3].impulse[1] * -100;
        state.boundaries[3].impulse = {};
    }
    expect_sound(state);
    const Totals all = totals(state);
    const double energy = all.kinetic_energy + all.strain_energy;
    std::printf(
        "[ figures  ] three disks at half height: worst interpenetration %.4f, energy %.4f of the piston's work, "
        "%.4f of external_work\n",
        worst, energy / piston_work, energy / state.ledger.external_work);
    EXPECT_LT(worst, 0.015);
    EXPECT_LE(energy, 1.02 * piston_work) << "no energy from nowhere";
    EXPECT_GT(energy, 0.8 * piston_work);
}

TEST(Survival, BodiesOfOneParticleCollide) {
    for (const ShapeKind shape : {ShapeKind::ugimp, ShapeKind::cpdi}) // not linear: advice() warns of it with usl
        for (const TransferScheme scheme : {TransferScheme::flip, TransferScheme::pic, TransferScheme::xpic}) {
            Scene scene = plane_scene(1, 0, 0, 12, 12, material(1, 100, 50));
            scene.method.shape = shape;
            scene.method.transfer = transfer(scheme, 5);
            scene.contact = contact(LawType::friction, 0.3);
            add_wall(scene, "bottom", 1, Side::lower, 1, 0, false);
            add_wall(scene, "top", 1, Side::upper, 11, 0, false);
            add_wall(scene, "left", 0, Side::lower, 1, 0, false);
            add_wall(scene, "right", 0, Side::upper, 11, 0, false);
            std::mt19937 random(7);
            std::uniform_real_distribution<double> in(-1, 1);
            Model model;
            for (int j = 0; j < 6; ++j)
                for (int i = 0; i < 6; ++i) {
                    const int body = add_body(model, "g" + std::to_string(6 * j + i), {in(random), in(random), 0});
                    add_particle(model, body, 2.3 + 1.4 * i + 0.2 * in(random), 2.3 + 1.4 * j + 0.2 * in(random), 0.25,
                                 0.25);
                }
            State<2> state = make_state<2>(scene, model);
            prepare(state);
            const double before = totals(state).kinetic_energy;
            run(state, 6);
            expect_sound(state);
            const Totals after = totals(state);
            EXPECT_LT(after.kinetic_energy + after.strain_energy, before);
            EXPECT_LT(interpenetration(state.particles).fraction(), 0.05);
        }
}

TEST(Survival, BodyOneParticleThick) {
    for (const TransferScheme scheme : {TransferScheme::flip, TransferScheme::xpic}) {
        Scene scene = plane_scene(1, 0, 0, 14, 14, material(1, 100, 50));
        scene.method.transfer = transfer(scheme, 5);
        scene.contact = contact(LawType::friction, 0.2);
        add_wall(scene, "bottom", 1, Side::lower, 1);
        Model model;
        add_box(model, add_body(model, "base"), 2, 1, 12, 5, 20, 8);
        add_box(model, add_body(model, "sheet"), 2, 5, 12, 5.5, 20, 1);
        add_box(model, add_body(model, "hammer", {0, -1.5, 0}), 4, 6, 10, 10, 12, 8);
        State<2> state = make_state<2>(scene, model);
        run(state, 4);
        expect_sound(state);
        const auto bodies = body_totals(state);
        EXPECT_GT(bodies[2].center()[1], bodies[1].center()[1]) << "nothing falls through";
        EXPECT_GT(bodies[1].center()[1], bodies[0].center()[1]);
        EXPECT_LT(interpenetration(state.particles).fraction(), 0.02);
    }
}

TEST(Survival, ImpactAtThirtyPercentOfTheWaveSpeed) {
    for (const TransferScheme scheme : {TransferScheme::flip, TransferScheme::xpic}) {
        const double v = 0.15 * wave_speed(aluminium()); // each
        Scene scene = plane_scene(1e-3, 0, 0, 24e-3, 16e-3, aluminium());
        scene.method.transfer = transfer(scheme, 5);
        scene.contact = contact(LawType::friction, 0.3);
        Model model;
        add_box(model, add_body(model, "left", {v, 0, 0}), 3e-3, 5e-3, 11.5e-3, 11e-3, 17, 12);
        add_box(model, add_body(model, "right", {-v, 0, 0}), 12.5e-3, 5.3e-3, 21e-3, 11.3e-3, 17, 12);
        State<2> state = make_state<2>(scene, model);
        prepare(state);
        const Totals before = totals(state);
        double overlap = 0;
        run(state, 3e-6, [&] {
            if (state.step % 20 == 0) overlap = std::max(overlap, interpenetration(state.particles).fraction());
        });
        expect_sound(state);
        const Totals after = totals(state);
        std::printf("[ figures  ] impact at 30 %% of the wave speed: interpenetration %.4f, energy kept %.3f\n",
                    overlap, (after.kinetic_energy + after.strain_energy) / before.kinetic_energy);
        EXPECT_LT(overlap, 0.02);
        EXPECT_LE(after.kinetic_energy + after.strain_energy, 1.02 * before.kinetic_energy);
    }
}

TEST(Survival, StronglyShearedBlock) {
    // Simple shear of 150 %: the upper wall's nodes are dragged by a heavy plate that sticks to the block.
    Scene scene = plane_scene(1, 0, 0, 30, 12, material(1, 100, 20));
    scene.materials.push_back(material(1000, 1e5, 5e4));
    scene.method.transfer = transfer(TransferScheme::xpic, 5);
    scene.contact = contact(LawType::perfect);
    add_wall(scene, "top", 1, Side::upper, 9, 0, true, 1);
    add_wall(scene, "bottom", 1, Side::lower, 1, 0, true, 1);
    Model model;
    add_box(model, add_body(model, "lower plate"), 2, 1, 26, 3, 48, 4);
    add_box(model, add_body(model, "block"), 6, 3, 16, 7, 20, 8);
    add_box(model, add_body(model, "upper plate", {0.5, 0, 0}), 4, 7, 20, 9, 32, 4);
    model.bodies[0].material = model.bodies[2].material = 1;
    State<2> state = make_state<2>(scene, model);
    run(state, 12);
    expect_sound(state);
    double shear = 0;
    for (std::size_t p = 0; p < state.particles.size(); ++p)
        if (state.particles.body[p] == 1) shear += state.particles.deformation_gradient[p](0, 1) / 160;
    std::printf("[ figures  ] sheared block: mean shear %.2f\n", shear);
    EXPECT_GT(shear, 1);
}

TEST(Rings, ThatCrossTheAxisEndTheRun) {
    Scene scene = plane_scene(1, 0, 0, 8, 4, material(1, 10, 4));
    scene.analysis = Analysis::axisymmetric;
    Model model;
    add_box(model, add_body(model, "ring"), 1, 1, 3, 3, 4, 4);
    State<2> state = make_state<2>(scene, model);
    auto tasks = step_tasks<2>(scene);
    state.dt = next_step(state, 1);
    advance(state, tasks);
    // As after a step that was far too large.
    for (Vec<2>& v : state.particles.velocity) v[0] = -1.4 / state.dt;
    std::string what = "nothing";
    try {
        advance(state, tasks);
    } catch (const std::exception& error) {
        what = error.what();
    }
    EXPECT_NE(what.find("crossed the axis r = 0"), std::string::npos) << what;
}

} // namespace
