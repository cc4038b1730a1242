#pragma once
/// \file plot_axis.h
/// The range, the unit and the ticks of an axis.

#include "io/render/plot.h"

#include <span>
#include <string>
#include <vector>

namespace abut {

struct PlotTick {
    double fraction = 0; ///< of the axis, from its lower end
    std::string label;
};

/// An axis that is decided.
struct PlotScale {
    bool logarithmic = false;
    double factor = 1;           ///< the shown unit in the SI unit
    double lower = 0, upper = 1; ///< in the shown unit; logarithmic: powers of ten in the SI unit
    std::string title;           ///< "time (µs)"
    std::vector<PlotTick> ticks;

    /// Where a value [SI] is on the axis: 0 at its lower and 1 at its upper end; not-a-number if it has no place.
    double fraction(double value) const;
};

/// What an axis is asked to show besides the values.
struct PlotAxisWishes {
    int intervals = 5;   ///< about as many between ticks
    bool margin = false; ///< a little room beyond the values, and zero where it is near
};

/// The scale for all of the values; those that are not finite (or, on a logarithmic axis, not positive) don't count.
PlotScale plot_scale(const PlotAxis& axis, std::span<const std::span<const double>> values,
                     const PlotAxisWishes& wishes);

} // namespace abut
