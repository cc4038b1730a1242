/// What contact and walls hold, held through XPIC's and FMPM's filters, and walls that take back.

#include "support.h"

#include <map>

namespace {

using namespace test;

/// A block of 6 x 6 particles, in one piece or cut into nine; velocities differ from particle to particle.
State<2> block(bool cut, ShapeKind shape, TransferSpec t, ThreeOrMore three_or_more, StressUpdate update) {
    Scene scene = plane_scene(1, 0, 0, 8, 8, material(1, 100, 40));
    scene.method.shape = shape;
    scene.method.transfer = t;
    scene.method.stress_update = update;
    scene.time.cfl = 0.2;
    if (cut) {
        scene.contact = contact(LawType::perfect);
        scene.contact->three_or_more = three_or_more;
    }
    Model model;
    const int bodies = cut ? 9 : 1;
    for (int b = 0; b < bodies; ++b) add_body(model, std::to_string(b));
    for (int j = 0; j < 6; ++j)
        for (int i = 0; i < 6; ++i)
            add_particle(model, cut ? 3 * (j / 2) + i / 2 : 0, 2.35 + 0.5 * i, 2.6 + 0.5 * j, 0.25, 0.25);
    State<2> state = make_state<2>(scene, model);
    for (std::size_t p = 0; p < state.particles.size(); ++p) {
        const Vec<2> x = state.particles.position[p];
        state.particles.velocity[p] = {std::sin(3 * x[0] + 5 * x[1]), std::cos(7 * x[0] - 2 * x[1])};
    }
    return state;
}

/// Places by the number that particles have in the model.
std::map<std::int32_t, Vec<2>> places_after(State<2> state, int steps) {
    auto tasks = step_tasks<2>(state.scene);
    for (int s = 0; s < steps; ++s) {
        state.dt = next_step(state, 1e30);
        advance(state, tasks);
    }
    std::map<std::int32_t, Vec<2>> places;
    for (std::size_t p = 0; p < state.particles.size(); ++p)
        places[static_cast<std::int32_t>(state.particles.id[p])] = state.particles.position[p];
    return places;
}

/// The paper's own criterion for what contact should be (§3.2): it "reverts to single material MPM when all interfaces
/// are perfect". With its Eq. 37 XPIC and FMPM do not.
TEST(ContactHolds, PerfectInterfacesAreOneVelocityField) {
    for (const ThreeOrMore three_or_more : {ThreeOrMore::explicit_, ThreeOrMore::lumped})
        for (const StressUpdate update : {StressUpdate::usl, StressUpdate::usavg_plus})
            for (const ShapeKind shape : {ShapeKind::ugimp, ShapeKind::b2cpdi})
                for (const TransferSpec& t : {transfer(TransferScheme::flip), transfer(TransferScheme::pic),
                                              transfer(TransferScheme::xpic, 2), transfer(TransferScheme::xpic, 5),
                                              transfer(TransferScheme::fmpm, 2), transfer(TransferScheme::fmpm, 4)}) {
                    const auto one = places_after(block(false, shape, t, three_or_more, update), 8);
                    const auto cut = places_after(block(true, shape, t, three_or_more, update), 8);
                    double worst = 0;
                    for (const auto& [id, place] : one) worst = std::max(worst, (cut.at(id) - place).norm());
                    EXPECT_LT(worst, 1e-10) << "scheme " << int(t.scheme) << " order " << t.order;
                }
}

/// A wall that has pushed a body which contact then pushes away takes its impulse back; one that grips does not let go.
TEST(ContactHolds, WallsTakeBackWhatIsNotNeeded) {
    const auto wall = [](double push) {
        return std::vector<Control>{{0, 0, Pack{0, 0, 1, 0}, 0.5, push, false, -1, 0}};
    };
    for (const double push : {0.0, 1.0}) {
        std::vector<Control> controls = wall(push);
        std::vector<Pack> velocity{Pack{2, 0, -1, 0}};
        impose_again(controls, velocity);
        EXPECT_EQ(velocity[0][2], 0.5);
        EXPECT_EQ(controls[0].impulse, 3);
        velocity[0][2] += 1; // pushed by 2 away from the wall: it gives 1 only
        impose_again(controls, velocity);
        EXPECT_EQ(velocity[0][2], 0.5);
        EXPECT_EQ(controls[0].impulse, 1);
        velocity[0][2] += 2; // and nothing
        impose_again(controls, velocity);
        EXPECT_EQ(velocity[0][2], push == 0 ? 0.5 : 2);
        EXPECT_EQ(controls[0].impulse, push == 0 ? -3 : 0);
    }
}

/// Four particles run into a wall. FMPM's mass matrix would throw them back k times as fast as lumped masses stop them.
TEST(ContactHolds, WallsGiveNoEnergyThroughTheFullMassMatrix) {
    for (const ShapeKind shape : {ShapeKind::ugimp, ShapeKind::gimp, ShapeKind::cpdi, ShapeKind::b2cpdi})
        for (const int k : {2, 4, 8}) {
            Scene scene = plane_scene(1, 0, 0, 6, 6, material(1, 100, 40));
            scene.method.shape = shape;
            scene.method.transfer = transfer(TransferScheme::fmpm, k);
            scene.time.cfl = 0.1;
            add_wall(scene, "floor", 1, Side::lower, 1, 0, false, 0);
            Model model;
            add_box(model, add_body(model, "a", {0, -0.5, 0}), 2.3, 1.2, 3.3, 2.2, 2, 2);
            State<2> state = make_state<2>(scene, model);
            prepare(state);
            const Totals before = totals(state);
            double most = 0;
            double half_change = 0;
            double strain_energy = 0;
            run(state, 2.0, [&] {
                const Totals now = totals(state);
                most = std::max(most, now.kinetic_energy + now.strain_energy);
                half_change = std::max(half_change, 0.5 * std::abs(now.strain_energy - strain_energy));
                strain_energy = now.strain_energy;
            });
            EXPECT_GT(half_change, 0) << "it has met the wall";
            EXPECT_LE(most, before.kinetic_energy * (1 + 1e-12) + half_change) << k;
        }
}

} // namespace
