#pragma once
/// \file plot_legend.h
/// Where the names of curves stand.

#include "io/render/plot_curves.h"

#include <string>
#include <vector>

namespace abut {

/// A legend: one line for each curve, a sample of its line and then its name [pixels].
struct PlotLegend {
    PlotArea place;
    double font = 0;   ///< size
    double line = 0;   ///< height of an entry
    double symbol = 0; ///< length of a sample
    double space = 0;  ///< between sample and name
};

/// A legend not placed yet: its lower left corner is (0, 0). The text is made smaller where `height` asks for it.
PlotLegend legend_size(const std::vector<std::string>& names, double font, double height);

/// Places it within the axes where no curve is; false if there is no such place.
bool place_inside(PlotLegend& legend, const std::vector<PixelRun>& curves, const PlotArea& axes);

/// Places it to the right of the axes.
void place_beside(PlotLegend& legend, const PlotArea& axes);

} // namespace abut
