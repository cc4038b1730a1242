/// Forces between pairs of bodies: equal and opposite by construction, so what has to be shown is that they are the
/// momentum balance of every body, with every transfer, and that works and areas are those of the interface.

#include "support.h"

#include "results/frames.h"

namespace {

using namespace test;

/// Three disks that meet in the middle, with friction and gravity.
State<2> three_disks(TransferSpec scheme, ThreeOrMore three_or_more = ThreeOrMore::explicit_) {
    Scene scene = plane_scene(0.125, -4, -4, 4, 4, material(1, 8, 4));
    scene.method.transfer = scheme;
    scene.gravity = {0.01, -0.02, 0};
    scene.contact = contact(LawType::friction, 0.4);
    scene.contact->three_or_more = three_or_more;
    Model model;
    for (int i = 0; i < 3; ++i) {
        const double angle = 2 * M_PI * i / 3 + 0.2;
        const double x = 0.62 * std::cos(angle), y = 0.62 * std::sin(angle);
        add_disk(model, add_body(model, std::string(1, static_cast<char>('a' + i)), {-0.3 * x, -0.3 * y, 0}), x, y, 0.5,
                 0.0625);
    }
    return make_state<2>(scene, model);
}

struct Balance {
    double worst = 0;   ///< of a body's momentum, over all steps, relative to the momentum of a disk
    double impulse = 0; ///< largest of a step, in the same unit
    std::size_t pairs = 0;
};

Balance balance_of(State<2> state, double until) {
    prepare(state);
    Balance balance;
    std::vector<Totals> before = body_totals(state);
    const double scale = before[0].mass * 0.2;
    run(state, until, [&] {
        std::vector<Totals> after = body_totals(state);
        std::vector<Vector> change(after.size());
        for (std::size_t b = 0; b < after.size(); ++b)
            for (std::size_t a = 0; a < 2; ++a)
                change[b][a] =
                    after[b].momentum[a] - before[b].momentum[a] - after[b].mass * state.scene.gravity[a] * state.dt;
        balance.pairs = std::max(balance.pairs, state.pair_totals.size());
        for (const auto& [bodies, totals] : state.pair_totals)
            for (std::size_t a = 0; a < 2; ++a) {
                change[bodies.first][a] -= totals.impulse[a];
                change[bodies.second][a] += totals.impulse[a];
                balance.impulse = std::max(balance.impulse, std::abs(totals.impulse[a]) / scale);
            }
        for (const Vector& rest : change)
            for (const double r : rest) balance.worst = std::max(balance.worst, std::abs(r) / scale);
        state.pair_totals.clear();
        before = std::move(after);
    });
    return balance;
}

TEST(PairForces, AreTheMomentumBalanceOfEveryBody) {
    for (const TransferSpec& scheme :
         {transfer(TransferScheme::flip), transfer(TransferScheme::pic), transfer(TransferScheme::xpic, 1),
          transfer(TransferScheme::xpic, 4), transfer(TransferScheme::fmpm, 1, PositionUpdate::mean_velocity),
          transfer(TransferScheme::fmpm, 4, PositionUpdate::mean_velocity)}) {
        const Balance balance = balance_of(three_disks(scheme), 3);
        std::printf(
            "[ figures  ] pair forces, scheme %d of order %d: momentum of every body to %.1e, largest impulse of "
            "a step %.1e\n",
            static_cast<int>(scheme.scheme), scheme.order, balance.worst, balance.impulse);
        EXPECT_EQ(balance.pairs, 3U);
        EXPECT_GT(balance.impulse, 1e-3);
        EXPECT_LT(balance.worst, 1e-13);
    }
}

TEST(PairForces, PeriodicTransfersBalanceToo) {
    TransferSpec scheme = transfer(TransferScheme::pic);
    scheme.every_cfl = 3;
    const Balance balance = balance_of(three_disks(scheme), 2);
    EXPECT_GT(balance.impulse, 1e-3);
    EXPECT_LT(balance.worst, 1e-13);
}

/// Lumping doesn't conserve momentum (contact paper §3.4); pair forces can't then be equal, opposite and right.
TEST(PairForces, LumpingLeavesAResidual) {
    const Balance balance = balance_of(three_disks(transfer(TransferScheme::flip), ThreeOrMore::lumped), 3);
    std::printf("[ figures  ] pair forces, lumped: momentum of every body to %.1e, largest impulse of a step %.1e\n",
                balance.worst, balance.impulse);
    EXPECT_LT(balance.worst, 0.5 * balance.impulse);
    EXPECT_GT(balance.worst, 1e-6 * balance.impulse);
}

/// The paper's choice between pairs and lumping may differ between the passes; what is given is counted all the same.
TEST(PairForces, UpToTwoBalancesWherePairsAreSolved) {
    const Balance balance = balance_of(three_disks(transfer(TransferScheme::pic), ThreeOrMore::up_to_two), 3);
    const Balance lumped = balance_of(three_disks(transfer(TransferScheme::pic), ThreeOrMore::lumped), 3);
    std::printf("[ figures  ] pair forces, up to two: momentum of every body to %.1e; lumped %.1e\n", balance.worst,
                lumped.worst);
    EXPECT_LE(balance.worst, lumped.worst);
}

TEST(PairForces, RowsHoldMeanForceAreaAndWork) {
    // Two boxes pressed together by gravity: the weight of the upper one, the area of their common side.
    Scene scene = plane_scene(0.25, 0, 0, 4, 5, material(10, 2000, 1000));
    scene.method.shape = ShapeKind::ugimp;
    scene.method.transfer = transfer(TransferScheme::pic);
    scene.gravity = {0, -1, 0};
    scene.thickness = 0.5;
    scene.contact = contact(LawType::friction, 0.3);
    add_wall(scene, "floor", 1, Side::lower, 0.5);
    Model model;
    add_box(model, add_body(model, "lower"), 1, 0.5, 3, 1.5, 16, 8);
    add_box(model, add_body(model, "upper"), 1, 1.5, 3, 3, 16, 12);
    State<2> state = make_state<2>(scene, model);
    run(state, 5); // it still breathes a little
    pair_rows(state, 0);
    const double start = state.time;
    const double momentum = body_totals(state)[1].momentum[1];
    state.wants_areas = true;
    run(state, 6);
    const double interval = state.time - start;
    const std::vector<PairRow> rows = pair_rows(state, interval);
    ASSERT_EQ(rows.size(), 1U);
    EXPECT_EQ(rows[0].body_a, 0);
    EXPECT_EQ(rows[0].body_b, 1);
    const double weight = 10 * 2 * 1.5 * 0.5;
    EXPECT_NEAR(rows[0].values[0], 0, 1e-6 * weight);
    const double gained = (body_totals(state)[1].momentum[1] - momentum) / interval;
    EXPECT_NEAR(rows[0].values[1], -weight - gained, 1e-10 * weight) << "on the lower body";
    EXPECT_NEAR(gained, 0, 0.01 * weight);
    EXPECT_NEAR(rows[0].values[3], 2 * 0.5, 0.01) << "area";
    EXPECT_NEAR(rows[0].values[4], 0, 1e-3 * weight) << "hardly anything moves";
    EXPECT_TRUE(state.pair_totals.empty()) << "the next interval begins";
}

TEST(PairForces, FrictionTakesWhatSlidingLoses) {
    // A light box slides over a heavy one: kinetic energy goes to friction, and the ledger says so.
    Scene scene = plane_scene(0.25, 0, 0, 10, 4, material(10, 20000, 10000));
    scene.method.shape = ShapeKind::ugimp;
    scene.gravity = {0, -1, 0};
    scene.contact = contact(LawType::friction, 0.3);
    add_wall(scene, "floor", 1, Side::lower, 0.5);
    Model model;
    add_box(model, add_body(model, "lower"), 1, 0.5, 9, 1.5, 64, 8);
    add_box(model, add_body(model, "upper", {1, 0, 0}), 2, 1.5, 4, 2, 16, 4);
    State<2> state = make_state<2>(scene, model);
    prepare(state);
    const double before = body_totals(state)[1].kinetic_energy + body_totals(state)[0].kinetic_energy;
    run(state, 1);
    const double after = totals(state).kinetic_energy;
    std::printf("[ figures  ] sliding: kinetic energy lost %.4f J, work of friction %.4f J\n", before - after,
                state.ledger.friction_work);
    EXPECT_LT(state.ledger.friction_work, 0);
    EXPECT_NEAR(-state.ledger.friction_work, before - after, 0.06 * (before - after));
    EXPECT_NEAR(state.ledger.contact_work, state.ledger.friction_work, 0.05 * (before - after));
}

} // namespace
