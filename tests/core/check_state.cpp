#include "step/check_state.h"

#include "support.h"

#include <gmock/gmock.h>

namespace {

using namespace test;
using testing::HasSubstr;

/// A block from 2 to 6 in x and y, at rest, and what is wrong with it.
template <int D = 2>
std::vector<Problem> problems(const std::function<void(Scene&)>& change, const Vector& velocity = {}) {
    const MaterialSpec m = material(1, 100, 0);
    Scene scene = D == 2 ? plane_scene(1, 0, 0, 10, 10, m) : space_scene(1, 0, 10, m);
    change(scene);
    Model model;
    const int a = add_body(model, "a", velocity);
    if (D == 2)
        add_box(model, a, 2, 2, 6, 6, 8, 8);
    else
        add_cube(model, a, {2, 2, 2}, 4, 8);
    State<D> state = make_state<D>(scene, model);
    return check_state(state);
}

void expect_one(const std::vector<Problem>& found, const std::string& where, const std::string& what) {
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].pointer, where);
    EXPECT_THAT(found[0].message, HasSubstr(what));
}

TractionSpec pull() {
    TractionSpec t;
    t.body = "a";
    t.traction = {1.0, 0.0, 0.0};
    return t;
}

TEST(CheckState, AGoodSceneHasNoProblems) {
    const auto everything = [](Scene& s) {
        s.time.step = 0.04; // stable: 1 / 10, with fmpm of order 2 half of it
        s.method.transfer = transfer(TransferScheme::fmpm, 2);
        s.method.transfer.every_cfl = 0.95;
        add_wall(s, "floor", 1, Side::lower, 2);
        add_wall(s, "ceiling", 1, Side::upper, 6, -0.1);
        s.boundaries.push_back({"pull", pull()});
        s.boundaries.push_back({"v", VelocitySpec{{2, 2, 2}, {3, 3, 3}, {1, 0, 0}, 0.1}});
    };
    EXPECT_TRUE(problems(everything).empty());
    EXPECT_TRUE(problems<3>(everything).empty());
    EXPECT_TRUE(problems([](Scene&) {}).empty());
}

TEST(CheckState, AFixedStepMustBeStable) {
    expect_one(problems([](Scene& s) { s.time.step = 0.11; }), "/time/step", "0.11 s is above the stable step, 0.1 s");
    EXPECT_TRUE(problems([](Scene& s) { s.time.step = 0.1; }).empty());
    EXPECT_TRUE(problems([](Scene& s) { s.time.cfl = 0.5; }).empty());
    // The full mass matrix takes smaller steps (plan/time_step.h).
    const auto fmpm = [](double step) {
        return problems([&](Scene& s) {
            s.method.shape = ShapeKind::ugimp;
            s.method.transfer = transfer(TransferScheme::fmpm, 16);
            s.time.step = step;
        });
    };
    expect_one(fmpm(0.02), "/time/step", "0.02 s is above the stable step, 0.0175 s (0.175 cell / wave speed)");
    EXPECT_TRUE(fmpm(0.017).empty());
}

TEST(CheckState, PeriodicTransfersMustNotBeMoreOftenThanSteps) {
    const auto with = [](double every) {
        return problems([&](Scene& s) {
            s.time.step = 0.05;
            s.method.transfer = transfer(TransferScheme::xpic, 2);
            s.method.transfer.every_cfl = every;
        });
    };
    expect_one(with(0.4), "/method/transfer/every_cfl", "0.4 is less than a time step, 0.5 cell / wave speed");
    // Against the step that is taken: fmpm may cut it below the scene's cfl.
    const auto free = [](double every) {
        return problems([&](Scene& s) {
            s.method.shape = ShapeKind::ugimp;
            s.method.transfer = transfer(TransferScheme::fmpm, 16);
            s.method.transfer.every_cfl = every;
        });
    };
    expect_one(free(0.15), "/method/transfer/every_cfl", "0.15 is less than a time step, 0.175");
    EXPECT_TRUE(free(0.3).empty());
    EXPECT_TRUE(with(0.6).empty());
    // FLIP has no transfer to make periodic.
    EXPECT_TRUE(problems([](Scene& s) {
                    s.time.step = 0.05;
                    s.method.transfer.every_cfl = 0.1;
                }).empty());
}

TEST(CheckState, ATractionMustHaveAFace) {
    const auto with = [](const Box& box) {
        return problems([&](Scene& s) {
            add_wall(s, "floor", 1, Side::lower, 2);
            TractionSpec t = pull();
            t.within = box;
            s.boundaries.push_back({"pull", t});
        });
    };
    expect_one(with({{7, 0, 0}, {9, 9, 0}}), "/boundaries/1/traction", "body \"a\" has no such face within");
    EXPECT_TRUE(with({{2, 3, 0}, {9, 4, 0}}).empty());
}

TEST(CheckState, AWallMustNotHaveAllMaterialBehindIt) {
    expect_one(problems([](Scene& s) { add_wall(s, "w", 0, Side::upper, 1.5); }), "/boundaries/0/wall/side",
               "side \"lower\" is meant?");
    expect_one(problems<3>([](Scene& s) { add_wall(s, "w", 2, Side::lower, 7); }), "/boundaries/0/wall/side",
               "side \"upper\" is meant?");
    EXPECT_TRUE(problems([](Scene& s) { add_wall(s, "w", 0, Side::lower, 5); }).empty()) << "a part may be behind it";
}

TEST(CheckState, AWallMustGripSomethingOrSomethingMustMove) {
    const auto far = [](Scene& s) { add_wall(s, "w", 1, Side::lower, 0.5, 0, true, 0); };
    const auto expect_grips_nothing = [](const std::vector<Problem>& found) {
        expect_one(found, "/boundaries/0/wall", "the wall grips nothing");
    };
    expect_grips_nothing(problems(far));
    expect_grips_nothing(problems<3>(far));
    expect_grips_nothing(problems([&](Scene& s) { add_wall(s, "w", 1, Side::lower, 0.5, -0.1, true, 0); }));
    EXPECT_TRUE(problems(far, {0, -1, 0}).empty()) << "the body falls on it";
    EXPECT_TRUE(problems([&](Scene& s) { add_wall(s, "w", 1, Side::lower, 0.5, 0.1, true, 0); }).empty())
        << "the wall comes nearer";
    EXPECT_TRUE(problems([&](Scene& s) {
                    far(s);
                    s.gravity = {0, -1, 0};
                }).empty());
    EXPECT_TRUE(problems([&](Scene& s) {
                    far(s);
                    s.boundaries.push_back({"pull", pull()});
                }).empty());
    EXPECT_TRUE(problems([&](Scene& s) {
                    far(s);
                    add_wall(s, "press", 1, Side::upper, 6, TimeFunction({0, 1}, {0, -1}).at(1));
                }).empty())
        << "another wall pushes the body";
}

TEST(CheckState, AVelocityConditionMustHoldNodes) {
    expect_one(problems([](Scene& s) {
                   s.boundaries.push_back({"v", VelocitySpec{{2.2, 2, 2}, {2.8, 3, 3}, {1, 0, 0}, 0.1}});
               }),
               "/boundaries/0/velocity", "the box holds no node: along x nodes lie every 1 m from 0 m");
}

} // namespace
