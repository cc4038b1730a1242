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

    Collision(LawSpec law, double impact, TransferSpec scheme, double cell) : state(make(law, impact, scheme, cell)) {
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
    static State<2> make(LawSpec law, double impact, TransferSpec scheme, double cell) {
        Scene scene = plane_scene(cell, -4, -3, 4, 3, material(1, 8, 4));
        scene.method.transfer = scheme;
        scene.contact = ContactSpec{};
        scene.contact->law = law;
        Model model;
        add_disk(model, add_body(model, "left", {0.1, 0, 0}), -1.25, -impact / 2, 1, cell / 2);
        add_disk(model, add_body(model, "right", {-0.1, 0, 0}), 1.25, impact / 2, 1, cell / 2);
        return make_state<2>(scene, model);
    }
};

/// Kinetic and strain energy that is gone, as a share of the initial energy.
double lost(Collision& c) {
    const Totals after = totals(c.state);
    return 1 - (after.kinetic_energy + after.strain_energy) / c.before.kinetic_energy;
}
double contact_work(const Collision& c) {
    return c.state.ledger.contact_work / c.before.kinetic_energy;
}

void print_energy(const char* what, Collision& c) {
    std::printf("[ figures  ] %-30s momentum drift %.0e, energy lost %.4f, work of contact %+.4f\n", what,
                c.worst_momentum, lost(c), contact_work(c));
}

TEST(Collision, HeadOnWithoutFriction) {
    // Elastic disks: what a collision loses vanishes with the cell size, and contact does no work.
    Collision coarse({LawType::frictionless, 0}, 0, transfer(TransferScheme::flip), 0.125);
    Collision fine({LawType::frictionless, 0}, 0, transfer(TransferScheme::flip), 0.0625);
    print_energy("head-on, flip, radius 8 cells", coarse);
    print_energy("head-on, flip, radius 16 cells", fine);
    EXPECT_GT(lost(fine), 0) << "no energy from nowhere";
    EXPECT_LT(lost(fine), 0.08);
    EXPECT_GT(std::log2(lost(coarse) / lost(fine)), 0.9) << "first order";
    EXPECT_LT(std::abs(contact_work(fine)), 0.01);
    for (Collision* c : {&coarse, &fine}) {
        EXPECT_LT(c->worst_momentum, 1e-11);
        const auto bodies = body_totals(c->state);
        // They part, and each is the mirror image of the other.
        EXPECT_LT(bodies[0].mean_velocity()[0], -0.08);
        EXPECT_NEAR(bodies[0].mean_velocity()[0], -bodies[1].mean_velocity()[0], 1e-9);
        EXPECT_NEAR(bodies[0].mean_velocity()[1], 0, 1e-9);
        EXPECT_NEAR(bodies[0].angular_velocity_z(), 0, 1e-9);
        EXPECT_EQ(c->state.ledger.external_work, 0);
        EXPECT_EQ(interpenetration(c->state.particles).overlap, 0);
    }
}

TEST(Collision, ObliqueWithFriction) {
    for (const bool flip : {true, false}) {
        const TransferSpec scheme = flip ? transfer(TransferScheme::flip) : transfer(TransferScheme::xpic, 5);
        Collision rough({LawType::friction, 0.4}, 1, scheme, 0.125);
        Collision smooth({LawType::frictionless, 0}, 1, scheme, 0.125);
        print_energy(flip ? "oblique, friction 0.4, flip" : "oblique, friction 0.4, xpic(5)", rough);
        print_energy(flip ? "oblique, smooth, flip" : "oblique, smooth, xpic(5)", smooth);
        EXPECT_LT(rough.worst_momentum, 1e-11);
        EXPECT_LT(smooth.worst_momentum, 1e-11);
        const auto bodies = body_totals(rough.state);
        const auto free = body_totals(smooth.state);
        // Rigid disks that meet under 30° and stick: 3 x 2 J_t/m takes away the sliding of 0.1, and each disk turns
        // with 2 J_t/m = 1/30; if the tangential compliance gives all of it back, with twice that.
        const double spin = std::abs(bodies[0].angular_velocity_z());
        std::printf(
            "[ figures  ] spin %.4f, rigid disks 0.0333 to 0.0667; without friction %.4f (steps in the outline)\n",
            spin, std::abs(free[0].angular_velocity_z()));
        EXPECT_GT(spin, 1.0 / 30);
        EXPECT_LT(spin, 2.0 / 30);
        EXPECT_LT(std::abs(free[0].angular_velocity_z()), 0.5 / 30);
        EXPECT_NEAR(bodies[0].angular_velocity_z(), bodies[1].angular_velocity_z(), 1e-8) << "point symmetry";
        EXPECT_NEAR(bodies[0].mean_velocity()[1], -bodies[1].mean_velocity()[1], 1e-8);
        // The ledger: friction takes energy, and what friction takes is gone.
        EXPECT_LT(contact_work(rough), contact_work(smooth) - 0.005);
        EXPECT_GT(lost(rough), lost(smooth));
        const double L = rough.before.angular_momentum_z;
        std::printf("[ figures  ] angular momentum kept: %.4f\n", totals(rough.state).angular_momentum_z / L);
        if (!flip) continue; // the filter of xpic does not conserve it
        EXPECT_NEAR(totals(rough.state).angular_momentum_z, L, 0.03 * std::abs(L));
    }
}

TEST(Collision, OfThreeBodiesAtOnceConservesMomentum) {
    Scene scene = plane_scene(0.25, -4, -4, 4, 4, material(1, 8, 4));
    scene.contact = contact(LawType::friction, 0.3);
    scene.contact->three_or_more = ThreeOrMore::explicit_;
    Model model;
    for (int i = 0; i < 3; ++i) {
        const double angle = 0.4 + 2 * M_PI * i / 3;
        const int body = add_body(model, std::to_string(i), {-0.2 * std::cos(angle), -0.2 * std::sin(angle), 0});
        add_disk(model, body, 1.4 * std::cos(angle), 1.4 * std::sin(angle), 1, 0.125);
    }
    State<2> state = make_state<2>(scene, model);
    prepare(state);
    const Totals before = totals(state);
    std::size_t most = 0;
    run(state, 6, [&] {
        for (const auto& group : state.contact.groups)
            most = std::max(most, static_cast<std::size_t>(group.last - group.first));
        const Totals now = totals(state);
        for (int a = 0; a < 2; ++a) EXPECT_NEAR(now.momentum[a], before.momentum[a], 1e-12 * before.mass);
    });
    EXPECT_EQ(most, 3u) << "all three meet";
    EXPECT_LT(state.ledger.contact_work, 1e-3 * before.kinetic_energy);
}

/// Coefficient of restitution of a light disk that a disk of the same stiffness and a hundred times its mass hits.
double restitution(double cell) {
    Scene scene = plane_scene(cell, -4, -3, 4, 3, material(1, 8, 4));
    scene.materials.push_back(material(0.01, 8, 4));
    scene.contact = contact(LawType::frictionless);
    Model model;
    add_disk(model, add_body(model, "heavy", {0.05, 0, 0}), -1.05, 0, 1, cell / 2);
    add_disk(model, add_body(model, "light", {0, 0, 0}), 1.05, 0, 1, cell / 2);
    model.bodies[1].material = 1;
    State<2> state = make_state<2>(scene, model);
    prepare(state);
    const double before = totals(state).momentum[0];
    run(state, 4);
    EXPECT_NEAR(totals(state).momentum[0] / before, 1, 1e-11);
    const auto bodies = body_totals(state);
    return (bodies[1].mean_velocity()[0] - bodies[0].mean_velocity()[0]) / 0.05;
}

TEST(Collision, OfBodiesOfVeryDifferentMass) {
    // Not 1: the heavy disk carries energy off in waves before the light one has left it.
    const double coarse = restitution(0.25);
    const double fine = restitution(0.125);
    std::printf("[ figures  ] mass ratio 100: restitution %.3f, twice as fine %.3f\n", coarse, fine);
    EXPECT_GT(fine, 0.5);
    EXPECT_LT(fine, 1);
    EXPECT_NEAR(coarse, fine, 0.05);
}

TEST(Collision, FmpmGainsNoEnergyInContact) {
    for (const int k : {2, 4, 8}) {
        TransferSpec fmpm{TransferScheme::fmpm, k, {}, {}};
        Scene scene = plane_scene(0.125, -4, -3, 4, 3, material(1, 8, 4));
        scene.method.transfer = fmpm;
        scene.contact = contact(LawType::frictionless);
        Model model;
        add_disk(model, add_body(model, "left", {0.1, 0, 0}), -1.25, 0, 1, 0.0625);
        add_disk(model, add_body(model, "right", {-0.1, 0, 0}), 1.25, 0, 1, 0.0625);
        State<2> state = make_state<2>(scene, model);
        prepare(state);
        const double before = totals(state).kinetic_energy;
        double largest = 0;
        const auto energy = [&] {
            const Totals all = totals(state);
            return (all.kinetic_energy + all.strain_energy) / before;
        };
        run(state, 12, [&] { largest = std::max(largest, energy()); });
        std::printf("[ figures  ] head-on, FMPM(%d): largest energy %.4f, at the end %.4f of the first\n", k, largest,
                    energy());
        EXPECT_LT(largest, 1.02);
    }
}

} // namespace
