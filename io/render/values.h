#pragma once
/// \file values.h
/// One number per particle out of a frame's arrays, and how such numbers are shown: unit, range, ticks, colours.

#include "io/render/colours.h"
#include "results/frame.h"

#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace abut {

/// The array of this name, or null.
const Array* find_array(const PointFrame& frame, const std::string& name);

/// Component `component` of each tuple; with -1 its magnitude (of symmetric tensors the Frobenius norm), or the value
/// itself if there is only one component.
std::vector<double> values_of(const Array& array, int component);

/// Smallest and largest finite value, empty if there is none.
using Range = std::optional<std::pair<double, double>>;
Range range_of(std::span<const double> values);
/// From the smallest value, or if that is negative from the one below which 100 − `percentile` per cent are, to the one
/// below which `percentile` per cent are.
Range range_of(const std::vector<double>& values, double percentile);
Range joined(const Range& a, const Range& b);

/// How values become colours and how the colour bar reads.
struct ColourScale {
    std::string quantity;        ///< "von Mises stress"
    std::string unit;            ///< "GPa"; "" for pure numbers and unknown units
    double lower = 0, upper = 1; ///< in the array's own unit (SI)
    ColourMap map = ColourMap::sequential;
    bool below = false, above = false; ///< whether there are values beyond the ends, which have the ends' colours
    std::vector<std::pair<double, std::string>> ticks; ///< value in the array's unit, and its label

    Rgb colour(double value) const { return map_colour(map, (value - lower) / (upper - lower)); }
};

/// A scale for component `component` of an array. With `exact` the range is used as it is; otherwise it is rounded
/// outwards to what reads well: from zero if all values have one sign, symmetric about zero if both signs matter.
ColourScale colour_scale(const Array& array, int component, Range range, bool exact);

/// Numbers 1, 2 or 5 times a power of ten: the largest not above, and the smallest not below `value` (> 0).
double round_down_nicely(double value);
double round_up_nicely(double value);

} // namespace abut
