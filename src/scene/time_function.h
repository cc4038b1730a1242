#pragma once
#include <utility>
#include <vector>

namespace abut {

/// A quantity as a function of time: linear between points, constant before the first and after the last one. A single
/// point is a constant; a triangular pulse is three points (it begins and ends with 0).
struct TimeFunction {
    std::vector<double> time{0.0}; ///< ascending [s]
    std::vector<double> value{0.0};

    TimeFunction() = default;
    TimeFunction(double constant) : value{constant} {} // NOLINT: a constant is a function of time
    TimeFunction(std::vector<double> times, std::vector<double> values)
        : time(std::move(times)), value(std::move(values)) {}
    /// Rises from 0 at `start` to `peak` at start + width/2 and falls back to 0 at start + width (FMPM paper §3.3).
    static TimeFunction pulse(double start, double width, double peak) {
        return {{start, start + width / 2, start + width}, {0, peak, 0}};
    }

    double at(double t) const;
    /// ∫ from 0 to t.
    double integral(double t) const;
    double smallest() const;
    double largest() const;
    bool is_constant() const { return value.size() == 1; }
    /// 0 at all times.
    bool is_zero() const { return smallest() == 0 && largest() == 0; }
};

} // namespace abut
