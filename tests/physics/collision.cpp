/// Free collisions: nothing but contact acts, so momentum must stay to round-off and energy must go where the ledger
/// says: change of kinetic and strain energy = work of contact + dissipation of the transfer.

#include "core/support.h"

#include "results/interpenetration.h"

#include <cstdio>

namespace {

using namespace test;

struct Collision {
    State<2> state;
    Totals before;
    double worst_momentum = 0; ///< change of momentum over the momentum of one disk

    Collision(LawSpec law, double impact, TransferSpec scheme, ShapeKind shape = ShapeKind::cpdi)
        : state(make(law, impact, scheme, shape)) {
        prepare(state);
        before = totals(state);
        const double scale = body_totals(state)[0].mass * 0.1;
        run(state, 12, [&] {
            const Totals now = totals(state);
            for (int a = 0; a < 2; ++a)
                worst_momentum = std::max(worst_momentum, std::abs(now.momentum[a] - before.momentum[a]) / scale);
        });
    }

private:
    /// \param impact height between the centres: 0 head-on
    static State<2> make(LawSpec law, double impact, TransferSpec scheme, ShapeKind shape) {
        Scene scene = plane_scene(0.25, -4, -3, 4, 3, material(1, 8, 4));
        scene.method.shape = shape;
        scene.method.transfer = scheme;
        scene.contact = ContactSpec{};
        scene.contact->law = law;
        Model model;
        add_disk(model, add_body(model, "left", {0.1, 0, 0}), -1.25, -impact / 2, 1, 0.125);
        add_disk(model, add_body(model, "right", {-0.1, 0, 0}), 1.25, impact / 2, 1, 0.125);
        return make_state<2>(scene, model);
    }
};

void print_energy(const char* what, Collision& c) {
    const Totals after = totals(c.state);
    const double E0 = c.before.kinetic_energy;
    const double lost = E0 - after.kinetic_energy - after.strain_energy;
    std::printf("[ figures  ] %-24s momentum drift %.1e, kinetic energy left %.4f, lost in all %.4f, by contact %.4f\n",
                what, c.worst_momentum, after.kinetic_energy / E0, lost / E0, -c.state.ledger.contact_work / E0);
}

TEST(Collision, HeadOnWithoutFriction) {
    Collision c({LawType::frictionless, 0}, 0, transfer(TransferScheme::flip));
    print_energy("head-on, flip", c);
    EXPECT_LT(c.worst_momentum, 1e-11);
    const auto bodies = body_totals(c.state);
    // They part, and each is the mirror image of the other.
    EXPECT_LT(bodies[0].mean_velocity()[0], -0.05);
    EXPECT_NEAR(bodies[0].mean_velocity()[0], -bodies[1].mean_velocity()[0], 1e-9);
    EXPECT_NEAR(bodies[0].mean_velocity()[1], 0, 1e-9);
    EXPECT_NEAR(bodies[0].angular_velocity_z(), 0, 1e-9);
    const Totals after = totals(c.state);
    const double E0 = c.before.kinetic_energy;
    EXPECT_NEAR((after.kinetic_energy + after.strain_energy) / E0, 1, 0.05) << "elastic disks, flip";
    EXPECT_LE(after.kinetic_energy + after.strain_energy, E0 * 1.001) << "no energy from nowhere";
    EXPECT_EQ(c.state.ledger.external_work, 0);
    EXPECT_LT(std::abs(c.state.ledger.contact_work) / E0, 0.02) << "without friction contact does no work";
    EXPECT_EQ(interpenetration(c.state.particles).overlap, 0);
}

TEST(Collision, ObliqueWithFriction) {
    const LawSpec friction{LawType::friction, 0.4};
    for (const TransferSpec scheme : {transfer(TransferScheme::flip), transfer(TransferScheme::xpic, 5)}) {
        Collision rough(friction, 1, scheme);
        Collision smooth({LawType::frictionless, 0}, 1, scheme);
        const bool flip = scheme.scheme == TransferScheme::flip;
        print_energy(flip ? "oblique, 0.4, flip" : "oblique, 0.4, xpic(5)", rough);
        print_energy(flip ? "oblique, smooth, flip" : "oblique, smooth, xpic(5)", smooth);
        EXPECT_LT(rough.worst_momentum, 1e-11);
        EXPECT_LT(smooth.worst_momentum, 1e-11);
        // The left disk passes below: friction turns both disks the same way, clockwise seen from z for this geometry.
        const auto bodies = body_totals(rough.state);
        const auto free = body_totals(smooth.state);
        EXPECT_GT(std::abs(bodies[0].angular_velocity_z()), 0.005);
        EXPECT_GT(std::abs(bodies[0].angular_velocity_z()), 5 * std::abs(free[0].angular_velocity_z()));
        EXPECT_NEAR(bodies[0].angular_velocity_z(), bodies[1].angular_velocity_z(), 1e-8) << "point symmetry";
        EXPECT_NEAR(bodies[0].mean_velocity()[1], -bodies[1].mean_velocity()[1], 1e-8);
        // Friction dissipates; nothing else but the transfer does.
        const double E0 = rough.before.kinetic_energy;
        const Totals after = totals(rough.state);
        const double lost = E0 - after.kinetic_energy - after.strain_energy;
        EXPECT_LT(rough.state.ledger.contact_work, smooth.state.ledger.contact_work - 0.001 * E0);
        EXPECT_GT(lost, -rough.state.ledger.contact_work - 0.02 * E0);
        EXPECT_NEAR(rough.before.angular_momentum_z, after.angular_momentum_z,
                    0.05 * std::abs(rough.before.angular_momentum_z));
    }
}

TEST(Collision, OfBodiesOfVeryDifferentMass) {
    Scene scene = plane_scene(0.25, -4, -3, 4, 3, material(1, 8, 4));
    MaterialSpec light = material(0.01, 8, 4);
    scene.materials.push_back(light);
    scene.contact = contact(LawType::frictionless);
    Model model;
    add_disk(model, add_body(model, "heavy", {0.05, 0, 0}), -1.25, 0, 1, 0.125);
    add_disk(model, add_body(model, "light", {0, 0, 0}), 1.25, 0, 1, 0.125);
    model.bodies[1].material = 1;
    State<2> state = make_state<2>(scene, model);
    prepare(state);
    const double before = totals(state).momentum[0];
    run(state, 15);
    EXPECT_NEAR(totals(state).momentum[0] / before, 1, 1e-11);
    const auto bodies = body_totals(state);
    const double e = (bodies[1].mean_velocity()[0] - bodies[0].mean_velocity()[0]) / 0.05;
    std::printf("[ figures  ] mass ratio 100: coefficient of restitution %.3f\n", e);
    EXPECT_GT(e, 0.6);
    EXPECT_LT(e, 1.02);
}

} // namespace
