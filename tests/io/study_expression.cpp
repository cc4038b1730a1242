/// Expressions against the compiler's arithmetic.
#include "expression/expression.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace abut {
namespace {

using testing::HasSubstr;

TEST(StudyExpression, ComputesWithNamedVariables) {
    const Expression expression("norm(ball.vx, 2*ball.vy) + c*sin(pi*t) - (t > 1 ? 7 : e)",
                                {"t", "ball.vx", "unused", "ball.vy"}, {{"c", 2.5}});
    EXPECT_EQ(expression.used(), (std::vector<std::size_t>{0, 1, 3}));
    for (const double t : {0.25, 2.0}) {
        const std::array<double, 4> values{t, 3.0, 99.0, -2.0};
        const double expected =
            std::sqrt(9.0 + 16.0) + 2.5 * std::sin(std::numbers::pi * t) - (t > 1 ? 7 : std::numbers::e);
        EXPECT_DOUBLE_EQ(expression(values), expected);
    }
}

TEST(StudyExpression, NamesOfTheCallerHideConstants) {
    EXPECT_EQ(Expression("e + pi", {"e"}, {{"pi", 4}})(std::array{1.5}), 5.5);
    EXPECT_EQ(Expression("a", {"a"}, {{"a", 4}})(std::array{1.5}), 1.5);
}

TEST(StudyExpression, MovesWithItsVariables) {
    Expression first("2*x", {"x"});
    const Expression second = std::move(first);
    EXPECT_EQ(second(std::array{21.0}), 42);
}

std::string complaint(const std::string& text) {
    try {
        Expression(text, {"total_energy", "t", "left.vx"}, {{"modulus", 3}});
    } catch (const std::runtime_error& error) {
        return error.what();
    }
    return "";
}

TEST(StudyExpression, SaysWhatIsWrongAndWhere) {
    EXPECT_THAT(complaint("1 - total_enrgy"),
                HasSubstr("unknown name \"total_enrgy\"; did you mean \"total_energy\"?"));
    EXPECT_THAT(complaint("2*moduls"), HasSubstr("did you mean \"modulus\""));
    EXPECT_THAT(complaint("2*lft.vx"), HasSubstr("did you mean \"left.vx\""));
    EXPECT_THAT(complaint("2*"), HasSubstr("at its end"));
    EXPECT_THAT(complaint("(t + 1"), HasSubstr("\"(t + 1\""));
    EXPECT_THAT(complaint("t, 1"), HasSubstr("2 expressions"));
    EXPECT_NE(complaint(""), "");
    EXPECT_EQ(complaint("t"), "");
}

TEST(StudyExpression, NamesForIt) {
    EXPECT_EQ(expression_name("force_left wall_x"), "force_left_wall_x");
    EXPECT_EQ(expression_name("grain-01"), "grain_01");
    EXPECT_EQ(expression_name("1st"), "_1st");
    EXPECT_EQ(expression_name("a.b"), "a.b");
    EXPECT_EQ(expression_name(""), "_");
}

} // namespace
} // namespace abut
