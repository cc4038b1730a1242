#pragma once
/// \file reduce.h
/// One number from many.

#include "io/study/study.h"

#include <span>
#include <stdexcept>
#include <vector>

namespace abut {

/// A metric has no value for a run; what() says why.
class NoValue : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// What a metric makes of values at times: those between `from` and `to`; the last or, interpolated, the one at `at`;
/// means by trapezoids over time. Throws NoValue if there is no value at that time.
/// \param times ascending [s]
double reduce_in_time(const Metric& metric, const std::vector<double>& times, const std::vector<double>& values);

/// The largest magnitude, weighted mean or root of the weighted mean square.
double reduce_weighted(Reduction reduction, std::span<const double> values, std::span<const double> weights);

/// A curve at a time, linear between its points. \param times ascending; t within them
double interpolate(const std::vector<double>& times, const std::vector<double>& values, double t);

/// Times of one moment differ by round-off.
bool same_time(double a, double b);

} // namespace abut
