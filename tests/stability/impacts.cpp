/// Impacts that are fast, grazing, or rubbed by any friction.

#include "stability/hard.h"

#include "results/interpenetration.h"

namespace {

using namespace test;

MaterialSpec aluminium() {
    return material(2780, 78.09e9, 27.6e9);
}

TEST(Impacts, AtHalfTheWaveSpeed) {
    Figures figures("AtHalfTheWaveSpeed");
    for (const TransferSpec& scheme : usual_transfers()) {
        const std::string name = name_of(scheme);
        SCOPED_TRACE(name);
        const double v = 0.25 * wave_speed(aluminium()); // each
        Scene scene = plane_scene(1e-3, 0, 0, 30e-3, 18e-3, aluminium());
        scene.method.transfer = scheme;
        scene.contact = contact(LawType::friction, 0.3);
        Model model;
        add_box(model, add_body(model, "left", {v, 0, 0}), 4e-3, 6e-3, 14.5e-3, 12e-3, 21, 12);
        add_box(model, add_body(model, "right", {-v, 0, 0}), 15.5e-3, 6.3e-3, 26e-3, 12.3e-3, 21, 12);
        State<2> state = make_state<2>(scene, model);
        double overlap = 0;
        const auto watch = run_watched(state, 3e-6, [&] {
            if (state.step % 10 == 0) overlap = std::max(overlap, interpenetration(state.particles).fraction());
        });
        figures.at_most("interpenetration", name, overlap, 0.03);
        watch.expect_energy(figures, name);
        watch.expect_momentum(figures, name);
    }
}

/// What corners add to the ratio of forces: the node at a face's end sees a corner, and its normal may tilt by up to
/// 45 degrees; it is one of the n + 1 nodes along a face of n cells, with half the weight of the others.
double by_corners(double cells, double mu) {
    return 0.5 / cells * std::sin(M_PI / 4) * (1 + mu);
}

/// A block flies over a plate, one degree down. What friction may do is µ times what presses; without it, nothing.
TEST(Impacts, Grazing) {
    Figures figures("grazing");
    for (const double mu : {0.0, 0.3})
        for (const TransferSpec& scheme : usual_transfers()) {
            const std::string name = "friction " + std::to_string(mu).substr(0, 3) + ", " + name_of(scheme);
            SCOPED_TRACE(name);
            Scene scene = plane_scene(1, 0, 0, 36, 14, material(1, 100, 50));
            scene.method.transfer = scheme;
            scene.contact = contact(LawType::friction, mu);
            Model model;
            add_box(model, add_body(model, "plate"), 4, 3, 32, 6, 56, 6);
            const double speed = 0.3 * wave_speed(scene.materials[0]), tilt = M_PI / 180;
            add_box(model, add_body(model, "block", {speed * std::cos(tilt), -speed * std::sin(tilt), 0}), 7, 6.02, 11,
                    9.02, 8, 6);
            State<2> state = make_state<2>(scene, model);
            const auto watch = run_watched(state, 3);
            ASSERT_EQ(state.pair_totals.size(), 1U);
            const Vector impulse = state.pair_totals.begin()->second.impulse; // on the plate
            EXPECT_LT(impulse[1], 0) << "the block presses";
            figures.at_most("shear / normal impulse", name, std::abs(impulse[0] / impulse[1]), mu + by_corners(4, mu));
            watch.expect_energy(figures, name);
            watch.expect_momentum(figures, name);
        }
}

/// A block lands on a plate and slides: friction from none to what always sticks.
TEST(Impacts, FrictionFromNoneToTen) {
    Figures figures("FrictionFromNoneToTen");
    for (const double mu : {0.0, 0.01, 0.1, 1.0, 10.0})
        for (const TransferSpec& scheme : usual_transfers()) {
            const std::string name = "friction " + std::to_string(mu).substr(0, 5) + ", " + name_of(scheme);
            SCOPED_TRACE(name);
            Scene scene = plane_scene(1, 0, 0, 30, 16, material(1, 100, 50));
            scene.method.transfer = scheme;
            scene.contact = contact(LawType::friction, mu);
            Model model;
            add_box(model, add_body(model, "plate"), 4, 3, 26, 7, 44, 8);
            add_box(model, add_body(model, "block", {0.5, -0.5, 0}), 9, 7, 15, 10, 12, 6);
            State<2> state = make_state<2>(scene, model);
            const auto watch = run_watched(state, 1); // the block presses all the while
            const Vector impulse = state.pair_totals.begin()->second.impulse;
            const double ratio = std::abs(impulse[0] / impulse[1]);
            if (mu <= 1) figures.at_most("shear / normal impulse", name, ratio, mu + by_corners(6, mu));
            if (mu < 0.5) {
                EXPECT_GT(ratio, 0.9 * mu - 0.01) << "it slides, so all of the friction acts";
            }
            if (mu > 1) { // it sticks from the start: as with stick contact
                scene.contact = contact(LawType::stick);
                State<2> stuck = make_state<2>(scene, model);
                run(stuck, 1);
                const Vector wanted = stuck.pair_totals.begin()->second.impulse;
                figures.at_most("difference from stick contact", name,
                                std::hypot(impulse[0] - wanted[0], impulse[1] - wanted[1]) /
                                    std::hypot(wanted[0], wanted[1]),
                                by_corners(6, 0));
            }
            watch.expect_energy(figures, name);
            watch.expect_momentum(figures, name);
        }
}

} // namespace
