/// Orders of convergence of sequences whose order is known.
#include "io/study/convergence.h"
#include "io/study/results.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace abut {
namespace {

TEST(StudyConvergence, FindsOrderAndLimit) {
    for (const double order : {0.5, 1.0, 2.0, 3.7})
        for (const std::vector<double>& sizes :
             {std::vector<double>{4, 2, 1}, {9, 3, 1}, {5, 2.5, 2, 1}, {1e-3, 0.9e-3, 0.5e-3}}) {
            std::vector<double> values;
            for (const double h : sizes) values.push_back(-2.5 + 0.3 * std::pow(h / sizes[0], order));
            const Extrapolation found = extrapolate(sizes, values);
            ASSERT_TRUE(found.value && found.order) << found.note;
            EXPECT_NEAR(*found.order, order, 1e-7);
            EXPECT_NEAR(*found.value, -2.5, 1e-9);
        }
}

TEST(StudyConvergence, KnowsWhatDoesNotConverge) {
    const std::vector<double> sizes{4, 2, 1};
    EXPECT_THAT(extrapolate(sizes, std::vector<double>{1, 2, 1.5}).note, testing::HasSubstr("oscillate"));
    EXPECT_THAT(extrapolate(sizes, std::vector<double>{1, 2, 3}).note, testing::HasSubstr("limit"));
    EXPECT_THAT(extrapolate(sizes, std::vector<double>{1, 2, 4}).note, testing::HasSubstr("limit"));
    EXPECT_THAT(extrapolate(std::vector<double>{2, 1}, std::vector<double>{1, 2}).note, testing::HasSubstr("three"));
    EXPECT_THAT(extrapolate(sizes, std::vector<double>{2, 2, 3}).note, testing::HasSubstr("limit"));
    EXPECT_THAT(extrapolate(sizes, std::vector<double>{1, NAN, 3}).note, testing::HasSubstr("limit"));
    const Extrapolation still = extrapolate(sizes, std::vector<double>{1, 3, 3});
    EXPECT_EQ(still.value, 3);
    EXPECT_FALSE(still.order);
}

TEST(StudyConvergence, FitsAnOrder) {
    const std::vector<double> sizes{8, 4, 3, 1};
    std::vector<double> values;
    for (const double h : sizes) values.push_back(-0.1 * std::pow(h, 1.5));
    EXPECT_NEAR(*fit_order(sizes, values), 1.5, 1e-12);
    values[1] = 0; // no logarithm
    EXPECT_NEAR(*fit_order(sizes, values), 1.5, 1e-12);
    // Least squares over log h = 0, 1, 2, log f = 0, 1, 4: slope 2.
    const std::vector<double> h{std::exp(2.0), std::exp(1.0), 1}, f{std::exp(4.0), std::exp(1.0), 1};
    EXPECT_NEAR(*fit_order(h, f), 2, 1e-12);
    EXPECT_FALSE(fit_order(std::vector<double>{1}, std::vector<double>{1}));
    EXPECT_FALSE(fit_order(std::vector<double>{1, 1}, std::vector<double>{1, 2}));
}

TEST(StudyConvergence, SpreadOfRepeats) {
    const Spread spread = spread_of({5, 1, 2, 9});
    EXPECT_EQ(spread.median, 3.5);
    EXPECT_EQ(spread.low, 1.75);
    EXPECT_EQ(spread.high, 6);
    EXPECT_EQ(spread.deviation, 2); // of 1.5, 2.5, 1.5, 5.5
    EXPECT_EQ(spread.values, (std::vector<double>{5, 1, 2, 9}));
    EXPECT_EQ(spread_of({7}).deviation, 0);
    EXPECT_EQ(spread_of({}).median, 0);
}

} // namespace
} // namespace abut
