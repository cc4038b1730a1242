/// The watch-dog: what is noticed, what is said of it, and going back to a good state.
#include "step/watch.h"

#include "step/good_state.h"
#include "step/setback.h"
#include "support.h"

#include <gmock/gmock.h>

#include <limits>

namespace {

using namespace test;
using testing::AllOf;
using testing::HasSubstr;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// Two blocks, one above the other, that approach; 8 x 8 particles each.
State<2> two_blocks(const std::function<void(Scene&)>& change = [](Scene&) {}) {
    Scene scene = plane_scene(1, 0, 0, 12, 14, material(1, 100, 60));
    scene.method.transfer = transfer(TransferScheme::xpic);
    scene.contact = contact(LawType::friction, 0.2);
    change(scene);
    Model model;
    add_box(model, add_body(model, "lower", {0.1, 0, 0}), 3, 3, 7, 7, 8, 8);
    add_box(model, add_body(model, "upper", {0, -2, 0}), 3, 7.5, 7, 11.5, 8, 8);
    return make_state<2>(scene, model);
}

void steps(State<2>& state, int count) {
    auto tasks = step_tasks<2>(state.scene);
    for (int i = 0; i < count; ++i) {
        state.dt = next_step(state, 1e9);
        advance(state, tasks);
    }
}

std::int32_t place_of(const State<2>& state, std::int32_t id) {
    const auto found = std::find(state.particles.id.begin(), state.particles.id.end(), id);
    return static_cast<std::int32_t>(found - state.particles.id.begin());
}

/// Changes a particle of a run under way and takes a step. \return what is said of it
std::string said(
    Trouble expected, const std::function<void(State<2>&, std::int32_t)>& harm,
    const std::function<void(Scene&)>& change = [](Scene&) {}) {
    State<2> state = two_blocks(change);
    steps(state, 3);
    harm(state, place_of(state, 70));
    try {
        steps(state, 1);
    } catch (const RunError& error) {
        EXPECT_EQ(static_cast<int>(error.trouble()), static_cast<int>(expected)) << error.what();
        return error.what();
    }
    ADD_FAILURE() << "the step went well";
    return "";
}

TEST(Watch, NoticesWhatIsNoNumber) {
    const auto stress = said(Trouble::not_a_number, [](auto& s, auto p) { s.particles.stress[p][1] = nan; });
    EXPECT_THAT(stress, AllOf(HasSubstr("step 3, time "), HasSubstr("of body \"upper\" at ("),
                              HasSubstr("the particle's velocity is not a number; at the nodes it shows in: forces")));
    EXPECT_THAT(said(Trouble::not_a_number, [](auto& s, auto p) { s.particles.velocity[p][0] = nan; }),
                HasSubstr("it shows in: momenta, velocities"));
    EXPECT_THAT(said(Trouble::not_a_number,
                     [](auto& s, auto p) { s.particles.stress[p][0] = std::numeric_limits<double>::infinity(); }),
                HasSubstr("is not a number"));
    // USF: the stresses come before the forces, from velocities that are still sound.
    const auto usf = [](Scene& scene) { scene.method.stress_update = StressUpdate::usf; };
    EXPECT_THAT(said(
                    Trouble::not_a_number, [](auto& s, auto p) { s.particles.deformation_gradient[p](0, 0) = nan; },
                    [&](Scene& scene) {
                        usf(scene);
                        scene.method.shape = ShapeKind::ugimp;
                    }),
                AllOf(HasSubstr("particle 70 "), HasSubstr("the particle's deformation gradient is not a number")));
}

TEST(Watch, NoticesSpeedsAndNamesTheLimit) {
    const std::string text =
        said(Trouble::too_fast, [](auto& s, auto) { s.scene.time.limits.speed = s.speed_limit = 1.5; });
    EXPECT_THAT(text, AllOf(HasSubstr("of body \"upper\""), HasSubstr("the particle moves at "),
                            HasSubstr("above /time/limits/speed of 1.5 m/s")));
}

TEST(Watch, NoticesParticlesTurnedInsideOut) {
    const auto point = [](Scene& scene) { scene.method.shape = ShapeKind::ugimp; };
    EXPECT_THAT(
        said(
            Trouble::inside_out, [](auto& s, auto p) { s.particles.deformation_gradient[p](0, 0) *= -1; }, point),
        AllOf(HasSubstr("particle 70 "), HasSubstr("turned inside out, det F = -")));
    EXPECT_THAT(
        said(
            Trouble::stretched, [](auto& s, auto p) { s.particles.deformation_gradient[p](0, 0) = 3e4; }, point),
        AllOf(HasSubstr("particle 70 "), HasSubstr("absurdly stretched")));
}

TEST(Watch, NamesTheParticleWhoseDomainLeavesTheGrid) {
    // Nothing else of its tile reaches as far.
    const auto cpdi = [](Scene& scene) { scene.method.shape = ShapeKind::cpdi; };
    EXPECT_THAT(
        said(
            Trouble::domain_left_grid, [](auto& s, auto p) { s.particles.deformation_gradient[p](0, 0) = 1000; }, cpdi),
        AllOf(HasSubstr("particle 70 of body \"upper\""), HasSubstr("domain reaches out of the grid")));
}

/// Found by fuzzing checkpoints: nodes that no int can count wrapped around, and the domain passed for a small one.
TEST(Watch, NamesTheParticleWhoseDomainReachesFartherThanIntegers) {
    for (const ShapeKind shape : {ShapeKind::cpdi, ShapeKind::gimp})
        for (const double stretch : {1e10, 1e18, 1e300})
            EXPECT_THAT(said(
                            Trouble::domain_left_grid,
                            [&](auto& s, auto p) { s.particles.deformation_gradient[p](0, 0) = stretch; },
                            [&](Scene& scene) { scene.method.shape = shape; }),
                        AllOf(HasSubstr("particle 70 of body \"upper\""), HasSubstr("domain reaches out of the grid")))
                << static_cast<int>(shape) << ", " << stretch;
}

TEST(Watch, NamesTheStiffestParticleIfAFixedStepIsTooLarge) {
    State<2> state = two_blocks([](Scene& scene) { scene.time.step = 0.05; });
    steps(state, 2);
    state.particles.deformation_gradient[place_of(state, 3)] *= 0.5;
    state.largest_wave_speed = 25; // as the sweep would have found
    try {
        next_step(state, 1);
        FAIL();
    } catch (const RunError& error) {
        EXPECT_EQ(error.trouble(), Trouble::step_too_large);
        EXPECT_THAT(error.what(), AllOf(HasSubstr("particle 3 of body \"lower\""), HasSubstr("time step of 0.05 s"),
                                        HasSubstr("above the stable one of 0.04 s")));
    }
    state.step_reductions = 1;
    EXPECT_EQ(next_step(state, 1), 0.025);
}

TEST(Watch, SpeedLimitIsTenTimesWhatTheSceneBrings) {
    const double c = wave_speed(material(1, 100, 60));
    EXPECT_DOUBLE_EQ(two_blocks().speed_limit, 10 * c);
    EXPECT_DOUBLE_EQ(two_blocks([](Scene& s) { s.time.limits.speed = 7; }).speed_limit, 7);
    EXPECT_DOUBLE_EQ(two_blocks([](Scene& s) { add_wall(s, "w", 1, Side::lower, 0, -300); }).speed_limit, 3000);
    // A fall through the box of 12 x 14, and one that the end cuts short.
    EXPECT_DOUBLE_EQ(two_blocks([](Scene& s) {
                         s.gravity = {0, -1e5, 0};
                     }).speed_limit,
                     10 * std::sqrt(2e5 * std::hypot(12, 14)));
    EXPECT_DOUBLE_EQ(two_blocks([](Scene& s) {
                         s.gravity = {0, -1e5, 0};
                         s.time.end = 1e-3;
                     }).speed_limit,
                     10 * 100.0);
}

/// What watch_energy() says after a run of energies and external works.
bool grows(const std::vector<std::pair<double, double>>& rows, double limit, int fmpm_order = 0) {
    State<2> state = two_blocks([&](Scene& s) {
        s.time.limits.energy_growth = limit;
        if (fmpm_order > 0)
            s.method.transfer = transfer(TransferScheme::fmpm, fmpm_order, PositionUpdate::mean_velocity);
    });
    for (const auto& [energy, work] : rows) {
        state.ledger.external_work = work;
        try {
            watch_energy(state, energy, 32);
        } catch (const RunError& error) {
            EXPECT_EQ(error.trouble(), Trouble::energy_growth);
            EXPECT_THAT(error.what(), HasSubstr("energy of "));
            return true;
        }
    }
    return false;
}

TEST(Watch, EnergyOutOfNothingIsNoticed) {
    EXPECT_FALSE(grows({{10, 0}, {14.9, 0}}, 0.5));
    EXPECT_TRUE(grows({{10, 0}, {15.1, 0}}, 0.5));
    EXPECT_FALSE(grows({{10, 0}, {110, 100}, {10, 0}, {110, 100}}, 1e-6)) << "work is no growth";
    EXPECT_TRUE(grows({{10, 0}, {1, 0}, {6.1, 0}}, 0.5)) << "dissipation before doesn't hide it";
    EXPECT_FALSE(grows({{10, 0}, {60, 100}, {109, 100}}, 0.5)) << "in proportion to all that was given, 110 J";
    EXPECT_FALSE(grows({{0, 0}, {1e-12, 0}}, 1)) << "round-off of a scene at rest";
    EXPECT_TRUE(grows({{0, 0}, {1e-6, 0}}, 1));
    EXPECT_TRUE(grows({{10, 0}, {nan, 0}}, 1));
    EXPECT_FALSE(grows({{10, 0}, {29, 0}}, 0.5, 4)) << "fmpm of order 4";
    EXPECT_TRUE(grows({{10, 0}, {31, 0}}, 0.5, 4));
}

TEST(Setback, ComesBackAtTheSameTimeAndPlace) {
    State<2> state = two_blocks();
    state.time = 5;
    state.dt = 0.01;
    const auto error = [&](std::int32_t id, Trouble trouble = Trouble::left_grid) {
        return run_error(trouble, state, place_of(state, id), "here");
    };
    EXPECT_EQ(setback_of(state, error(70)).returns, 0) << "the first one";
    const auto returns = [&](double time, std::int32_t id, Trouble trouble = Trouble::left_grid) {
        state.setback = setback_of(state, error(70));
        state.setback->returns = 1;
        State<2> again = state;
        again.dt = 0.005;
        again.time = time;
        return setback_of(again, run_error(trouble, again, place_of(again, id), "here")).returns;
    };
    EXPECT_EQ(returns(5, 70), 2);
    EXPECT_EQ(returns(5.019, 70), 2) << "less than two steps of 0.01 later";
    EXPECT_EQ(returns(4.981, 70), 2);
    EXPECT_EQ(returns(5.021, 70), 0);
    EXPECT_EQ(returns(4.979, 70), 0);
    EXPECT_EQ(returns(5, 71), 2) << "a neighbour";
    EXPECT_EQ(returns(5, 72), 0) << "a cell away";
    EXPECT_EQ(returns(5, 70, Trouble::inside_out), 0);
    state.particles.position[place_of(state, 70)][0] = nan;
    EXPECT_EQ(returns(5, 70), 0) << "who knows where";
}

TEST(Setback, WhatIsOfTheStepNeverComesBack) {
    State<2> state = two_blocks();
    for (const Trouble trouble : {Trouble::step_too_large, Trouble::energy_growth}) {
        state.setback.reset();
        state.setback = setback_of(state, run_error(trouble, state, 0, "here"));
        EXPECT_EQ(setback_of(state, run_error(trouble, state, 0, "here")).returns, 0);
    }
}

TEST(GoodState, GoingBackGivesTheSameBits) {
    for (const ShapeKind shape : {ShapeKind::cpdi, ShapeKind::ugimp}) {
        State<2> state = two_blocks([&](Scene& scene) {
            scene.method.shape = shape;
            scene.gravity = {0, -1, 0};
            add_wall(scene, "floor", 1, Side::lower, 3);
        });
        steps(state, 40);
        const State<2> kept = kept_copy(state);
        steps(state, 60);
        const Particles<2> once = state.particles;
        const Ledger ledger = state.ledger;
        const double time = state.time;
        go_back(kept, state);
        EXPECT_EQ(state.step, 40);
        steps(state, 60);
        EXPECT_EQ(state.time, time);
        EXPECT_TRUE(state.particles.position == once.position);
        EXPECT_TRUE(state.particles.velocity == once.velocity);
        EXPECT_TRUE(state.particles.stress == once.stress);
        EXPECT_TRUE(state.particles.id == once.id);
        EXPECT_EQ(state.ledger.external_work, ledger.external_work);
        EXPECT_EQ(state.ledger.contact_work, ledger.contact_work);
    }
}

} // namespace
