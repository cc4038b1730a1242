/// Bodies at rest for a very long time.

#include "stability/hard.h"

namespace {

using namespace test;

struct Rest {
    double heat = 0;     ///< largest T + U − external work after the first tenth, over its largest before
    double kinetic = 0;  ///< largest kinetic energy in the last tenth, over the largest of the first
    double drift = 0;    ///< how far centres move from the middle of the run to its end [cells]
    double sideways = 0; ///< how far centres are from their first x at the end [cells]
};

/// Two blocks on top of each other on a floor; gravity is switched on at time 0, a hundredth of a cell of settlement.
Rest rest(const TransferSpec& scheme, ShapeKind shape, long steps) {
    Scene scene = plane_scene(1, 0, 0, 8, 10, material(1, 100, 50));
    scene.method.shape = shape;
    scene.method.transfer = scheme;
    scene.contact = contact(LawType::friction, 0.3);
    scene.gravity = {0, -0.05, 0};
    add_wall(scene, "floor", 1, Side::lower, 1, 0, true, 1);
    Model model;
    add_box(model, add_body(model, "lower"), 2, 1, 6, 3, 8, 4);
    add_box(model, add_body(model, "upper"), 3.1, 3, 5.1, 5, 4, 4);
    State<2> state = make_state<2>(scene, model);
    prepare(state);
    const auto centres = [&] {
        std::vector<Vector> all;
        for (const Totals& t : body_totals(state)) all.push_back(t.center());
        return all;
    };
    const auto first = centres();
    auto middle = first;
    auto tasks = step_tasks<2>(scene);
    double early_energy = 0, late_energy = 0, early_kinetic = 0, late_kinetic = 0;
    for (long s = 0; s < steps; ++s) {
        state.dt = next_step(state, 1e30);
        advance(state, tasks);
        if (s % 7 == 0 || s < 1000) { // not in time with any oscillation
            const Totals t = totals(state);
            const double energy = t.kinetic_energy + t.strain_energy - state.ledger.external_work;
            if (s < steps / 10) {
                early_energy = std::max(early_energy, energy);
                early_kinetic = std::max(early_kinetic, t.kinetic_energy);
            } else {
                late_energy = std::max(late_energy, energy);
            }
            if (s > steps / 10 * 9) late_kinetic = std::max(late_kinetic, t.kinetic_energy);
        }
        if (s == steps / 2) middle = centres();
    }
    EXPECT_TRUE(is_sound(state));
    const auto last = centres();
    Rest r;
    // The scale of energies is what gravity has to give: half of it goes to strain, half to motion.
    r.heat = (late_energy - early_energy) / early_kinetic;
    r.kinetic = late_kinetic / early_kinetic;
    for (std::size_t b = 0; b < last.size(); ++b) {
        r.drift = std::max(r.drift, std::hypot(last[b][0] - middle[b][0], last[b][1] - middle[b][1]));
        r.sideways = std::max(r.sideways, std::abs(last[b][0] - first[b][0]));
    }
    return r;
}

void expect_rest(Figures& figures, long steps) {
    for (const TransferSpec& scheme : usual_transfers()) {
        const std::string name = name_of(scheme);
        SCOPED_TRACE(name);
        const Rest r = rest(scheme, ShapeKind::cpdi, steps);
        const bool flip = scheme.scheme == TransferScheme::flip;
        // No heating: the balance never rises again, and motion is at most what it was at first.
        figures.at_most("heat / first kinetic energy", name, std::max(0.0, r.heat), 1e-3);
        // FLIP rings on, all others filter it away: to 1 % in the first tenth, if at all.
        figures.at_most(flip ? "kinetic energy at the end / at first, flip" : "kinetic energy at the end / at first",
                        name, r.kinetic, flip ? 1 : 1e-4);
        // FLIP's blocks are caught anywhere in their oscillation, up to the settlement of a hundredth of a cell.
        figures.at_most(flip ? "drift in the second half [cells], flip" : "drift in the second half [cells]", name,
                        r.drift, flip ? 0.01 : 1e-3);
        figures.at_most("sideways [cells]", name, r.sideways, 0.01);
    }
}

TEST(LongTimes, AtRestForAHundredThousandSteps) {
    Figures figures("at rest for 1e5 steps");
    expect_rest(figures, 100000);
}

TEST(LongTimes, FullAtRestForAMillionSteps) {
    Figures figures("at rest for 1e6 steps");
    expect_rest(figures, 1000000);
}

} // namespace
