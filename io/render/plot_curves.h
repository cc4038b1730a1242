#pragma once
/// \file plot_curves.h
/// Curves in pixels: as few points as show them, and their dashes.

#include "io/render/picture.h"
#include "io/render/plot.h"
#include "io/render/plot_axis.h"

#include <span>
#include <vector>

namespace abut {

/// Successive points without a gap.
using PixelRun = std::vector<Pixel>;

/// A curve as drawn in `area`, run by run. Of successive points in one column of pixels the first, the lowest, the
/// highest and the last remain, so no peak is lost.
std::vector<PixelRun> curve_pixels(const PlotCurve& curve, const PlotScale& x, const PlotScale& y,
                                   const PlotArea& area);

/// Cuts runs into dashes along their length. \param pattern lengths of dash, gap, dash, gap, … [pixels]; empty: solid
std::vector<PixelRun> dashed(const std::vector<PixelRun>& runs, std::span<const double> pattern);

/// Whether a curve comes into a rectangle.
bool crosses(const std::vector<PixelRun>& runs, const PlotArea& rectangle);

} // namespace abut
