#pragma once
/// \file plot.h
/// Curves over an axis, as a figure of a paper shows them.

#include <filesystem>
#include <string>
#include <vector>

namespace abut {

class OffscreenContext;

/// A curve through points in their order. It has a gap where a value is not finite, or not positive on a logarithmic
/// axis; a point between two gaps is a dot.
struct PlotCurve {
    std::string name;
    std::vector<double> x, y; ///< as many of each, SI units
    int colour = -1;          ///< number of a body's colour (colours.h); -1: the curve's own number
};

struct PlotAxis {
    std::string quantity; ///< "kinetic energy"
    std::string unit;     ///< SI without a prefix, g for masses: "J", "N s", "m²"; "" for pure numbers
    bool logarithmic = false;
};

struct Plot {
    std::string title; ///< may be empty
    PlotAxis x, y;
    std::vector<PlotCurve> curves;
    int width = 1200, height = 800; ///< [pixels]
};

/// The rectangle of the axes in the picture [pixels from the lower left corner].
struct PlotArea {
    double left = 0, bottom = 0, right = 0, top = 0;
};

/// Draws on white and writes a PNG file, which appears complete or not at all: axes with few ticks and the unit with
/// its SI prefix, curves by colours and dash patterns, a legend of two or more curves where no curve is, or else beside
/// the axes. Texts and lines grow with the picture. The same plot gives the same bytes. Returns where the axes are.
/// Throws std::runtime_error naming file and cause.
PlotArea write_plot(OffscreenContext& context, const Plot& plot, const std::filesystem::path& path);

} // namespace abut
