#pragma once
/// \file size_distribution.h
/// How large grains are compared with each other.

#include "geometry/packing/random.h"

#include <string>
#include <string_view>
#include <vector>

namespace abut {

/// Relative sizes. The size of a grain is √(a b) of an ellipse, the radius of a disk or ball, √area of a polygon.
struct SizeDistribution {
    enum class Kind {
        equal,
        uniform,  ///< between `min` and `max`
        lognormal ///< the logarithm is normally distributed with the deviation `sigma`
    };
    Kind kind = Kind::uniform;
    double min = 0.6, max = 1.4;
    double sigma = 0;

    /// A random size, the same on every machine.
    double sample(Random& random) const;
};

/// Sizes of `count` grains, the largest first.
std::vector<double> sample_sizes(const SizeDistribution& sizes, int count, Random& random);

/// Reads "equal", "uniform:MIN,MAX" or "lognormal:SIGMA". \throws std::invalid_argument for anything else
SizeDistribution parse_sizes(std::string_view text);

/// \throws std::invalid_argument unless 0 < min ≤ max and 0 ≤ sigma ≤ 1.
void check_sizes(const SizeDistribution& sizes);

} // namespace abut
