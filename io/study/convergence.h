#pragma once
/// \file convergence.h
/// Orders of convergence.

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace abut {

/// What a value converges to as a size goes to 0.
struct Extrapolation {
    std::optional<double> value; ///< at size 0
    std::optional<double> order; ///< f(h) = value + C h^order
    std::string note;            ///< why one of them is missing
};

/// Richardson extrapolation of the three finest of f(h), for any ratios of sizes: the order p solves
/// (f1 − f2)/(f2 − f3) = (h1^p − h2^p)/(h2^p − h3^p) (Celik et al., J. Fluids Eng. 130 (2008) 078001, Eqs. 3-5).
/// Nothing where the values don't converge: they oscillate, or their differences don't shrink.
/// \param sizes descending, all > 0
Extrapolation extrapolate(std::span<const double> sizes, std::span<const double> values);

/// Slope of log |value| over log size by least squares, of the values that aren't 0; nothing if they are fewer than
/// two.
std::optional<double> fit_order(std::span<const double> sizes, std::span<const double> values);

} // namespace abut
