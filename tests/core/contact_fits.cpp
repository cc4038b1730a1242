/// The fits from extrapolated positions to edges against the extrapolation itself (notes 3.6.2, figures 3.6 to 3.8).

#include "support.h"

#include "contact/separation/critical_position.h"
#include "contact/separation/fitted_position.h"

#include <cstdio>

namespace {

using namespace test;

/// Extrapolated position at a node at 0 of a half space of undeformed particles, `n` per cell, whose edge lies at d and
/// which lies beyond it: x_i = Σ S X / Σ S, S of uGIMP being the mean of the hat function over a particle.
double extrapolated_position(double d, int n) {
    const auto integral = [](double x) {
        x = std::clamp(x, -1.0, 1.0);
        return x < 0 ? (1 + x) * (1 + x) / 2 : 1 - (1 - x) * (1 - x) / 2;
    };
    double moment = 0;
    double mass = 0;
    for (int j = 0; j < 4 * n; ++j) {
        const double lower = d + static_cast<double>(j) / n;
        const double upper = lower + 1.0 / n;
        const double S = (integral(upper) - integral(lower)) * n;
        mass += S;
        moment += S * (lower + upper) / 2;
    }
    return moment / mass;
}

struct Error {
    double largest = 0;
    double rms = 0;
};
/// Of a fit over all places of the edge within a cell of the node.
Error error_of(const std::function<double(double)>& fit, int n) {
    Error e;
    constexpr int steps = 2000;
    for (int i = 0; i < steps; ++i) {
        const double d = -1 + (i + 0.5) * 2 / steps;
        const double error = fit(extrapolated_position(d, n)) - d;
        e.largest = std::max(e.largest, std::abs(error));
        e.rms += error * error / steps;
    }
    e.rms = std::sqrt(e.rms);
    return e;
}

TEST(Fits, AreCloseToTheExtrapolation) {
    const auto power = [](double x) { return power_law(x, 0.58); };
    const auto line = [](double offset) { return [offset](double x) { return x - offset / 2; }; };
    for (int n = 1; n <= 4; ++n) {
        std::printf("[ figures  ] %d per cell, error of the edge's place in cells (largest, rms):", n);
        for (const auto& [name, fit] : std::initializer_list<std::pair<const char*, std::function<double(double)>>>{
                 {"offset 0.8", line(0.8)},
                 {"offset 1.07", line(1.07)},
                 {"power-law", power},
                 {"two-per-cell", two_per_cell},
                 {"one-per-cell", one_per_cell}}) {
            const Error e = error_of(fit, n);
            std::printf(" %s %.3f %.3f;", name, e.largest, e.rms);
        }
        std::printf("\n");
    }
    // Each is the best of all for its number of particles. (The exponents are as published; 0.57 in both fits for two
    // and 0.55 in that for one would be closer.)
    EXPECT_LT(error_of(two_per_cell, 2).largest, 0.03);
    EXPECT_LT(error_of(one_per_cell, 1).largest, 0.02);
    EXPECT_LT(error_of(power, 2).largest, 0.03);
    EXPECT_LT(error_of(two_per_cell, 2).rms, error_of(power, 2).rms);
    EXPECT_LT(error_of(power, 2).rms, error_of(line(0.8), 2).rms);
    EXPECT_LT(error_of(one_per_cell, 1).rms, error_of(line(1.07), 1).rms);
}

TEST(Fits, AreExactWhereOneLayerIsSeen) {
    for (int i = 1; i < 50; ++i) {
        const double share = 0.02 * i;
        // An edge at d sees one layer as long as the next one's lower edge lies beyond the neighbour node.
        const double two = 0.5 + 0.5 * share;
        EXPECT_NEAR(two_per_cell(extrapolated_position(two, 2)), two, 1e-12);
        EXPECT_NEAR(one_per_cell(extrapolated_position(share, 1)), share, 1e-12);
    }
}

TEST(Fits, AreContinuousAndRise) {
    EXPECT_NEAR(two_per_cell(0.75), two_per_cell(std::nextafter(0.75, 1)), 1e-14);
    EXPECT_NEAR(one_per_cell(0.5), one_per_cell(std::nextafter(0.5, 1)), 1e-14);
    for (const auto& fit : {two_per_cell, one_per_cell}) {
        EXPECT_EQ(fit(0), -1);
        EXPECT_EQ(fit(-0.3), -1) << "the whole neighbourhood is filled";
        for (double x = 0; x < 1.4; x += 0.01) EXPECT_LT(fit(x), fit(x + 0.01));
    }
}

/// Touching bodies on a node: what the notes' constants make of it.
TEST(Fits, TouchingBodiesOnANode) {
    const double two = extrapolated_position(0, 2);
    const double one = extrapolated_position(0, 1);
    std::printf("[ figures  ] touching on a node, in cells: x_b - x_a %.4f for two per cell, %.4f for one; fits "
                "give %.4f (power-law), %.4f (two), %.4f (one)\n",
                2 * two, 2 * one, fitted_position(-two, two, 0.58), 2 * two_per_cell(two), 2 * one_per_cell(one));
    EXPECT_NEAR(critical_position(-two, two, 0.8), 0, 0.1);
    EXPECT_NEAR(critical_position(-one, one, 1.07), 0, 0.1);
    EXPECT_NEAR(fitted_position(-two, two, 0.58), 0, 0.05);
}

} // namespace
