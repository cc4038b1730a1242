#include "scene/time_function.h"

#include "support.h"

namespace {

using namespace test;

/// Trapezoids of so small steps that the kinks don't matter.
double integral_by_sum(const TimeFunction& f, double to) {
    constexpr int steps = 200000;
    const double h = to / steps;
    double sum = 0;
    for (int i = 0; i < steps; ++i) sum += f.at((i + 0.5) * h) * h;
    return sum;
}

TEST(TimeFunctions, AConstantIsTheSameAtAllTimes) {
    const TimeFunction f = 2.5;
    EXPECT_TRUE(f.is_constant());
    EXPECT_FALSE(f.is_zero());
    for (const double t : {-3.0, 0.0, 7.0}) {
        EXPECT_EQ(f.at(t), 2.5);
        EXPECT_EQ(f.integral(t), 2.5 * t);
    }
    EXPECT_TRUE(TimeFunction{}.is_zero());
    EXPECT_TRUE(TimeFunction(0.0).is_zero());
}

TEST(TimeFunctions, AreLinearBetweenPointsAndConstantOutside) {
    const TimeFunction f({1, 3, 4}, {10, -2, 6});
    EXPECT_EQ(f.at(-5), 10);
    EXPECT_EQ(f.at(1), 10);
    EXPECT_DOUBLE_EQ(f.at(1.5), 7);
    EXPECT_DOUBLE_EQ(f.at(3), -2);
    EXPECT_DOUBLE_EQ(f.at(3.25), 0);
    EXPECT_EQ(f.at(4), 6);
    EXPECT_EQ(f.at(9), 6);
    EXPECT_EQ(f.smallest(), -2);
    EXPECT_EQ(f.largest(), 10);
    EXPECT_FALSE(f.is_constant());
}

TEST(TimeFunctions, IntegralsCountFromZeroWhereverThePointsBegin) {
    for (const double start : {-7.0, -2.5, -0.5, 0.0, 0.3, 2.0}) {
        const TimeFunction f({start, start + 0.7, start + 2}, {1.5, -2, 4});
        EXPECT_EQ(f.integral(0), 0);
        for (const double t : {-3.0, -0.4, 0.2, 0.9, 1.7, 6.0})
            EXPECT_NEAR(f.integral(t), integral_by_sum(f, t), 2e-9) << "from " << start << " to " << t;
    }
    // By hand: begins before 0, ends after.
    EXPECT_DOUBLE_EQ(TimeFunction({-1, 1}, {0, 2}).integral(3), 0.5 * (1 + 2) + 2 * 2);
    EXPECT_DOUBLE_EQ(TimeFunction({-1, 1}, {0, 2}).integral(-2), -0.5);
    EXPECT_DOUBLE_EQ(TimeFunction({-3, -1}, {5, 2}).integral(4), 8) << "all points lie before 0";
    EXPECT_DOUBLE_EQ(TimeFunction({2, 3}, {5, 7}).integral(1), 5) << "all points lie after";
}

TEST(TimeFunctions, APulseIsATriangle) {
    const TimeFunction f = TimeFunction::pulse(0.5, 2, 3);
    for (const double t : {-1.0, 0.5, 2.5, 8.0}) EXPECT_DOUBLE_EQ(f.at(t), 0) << t;
    EXPECT_DOUBLE_EQ(f.at(1), 1.5);
    EXPECT_DOUBLE_EQ(f.at(1.5), 3);
    EXPECT_DOUBLE_EQ(f.at(2.25), 0.75);
    EXPECT_DOUBLE_EQ(f.integral(0.4), 0);
    EXPECT_DOUBLE_EQ(f.integral(1.5), 1.5);
    EXPECT_DOUBLE_EQ(f.integral(9), 3) << "half of width times peak";
}

} // namespace
