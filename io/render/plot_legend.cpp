#include "io/render/plot_legend.h"

#include <algorithm>
#include <cmath>

namespace abut {
namespace {

/// The rectangle moved to have its lower left corner at (x, y).
PlotArea moved(const PlotArea& place, double x, double y) {
    return {x, y, x + place.right - place.left, y + place.top - place.bottom};
}

} // namespace

PlotLegend legend_size(const std::vector<std::string>& names, double font, double height) {
    const double entries = static_cast<double>(std::max<std::size_t>(1, names.size()));
    PlotLegend legend;
    legend.font = std::max(7.0, std::floor(std::min(font, height / entries / 1.3)));
    legend.line = 1.3 * legend.font;
    legend.symbol = 2.6 * legend.font;
    legend.space = 0.5 * legend.font;
    double widest = 0;
    for (const std::string& name : names) widest = std::max(widest, text_width(name, legend.font));
    legend.place = {0, 0, std::ceil(legend.symbol + legend.space + widest), std::ceil(entries * legend.line)};
    return legend;
}

bool place_inside(PlotLegend& legend, const std::vector<PixelRun>& curves, const PlotArea& axes) {
    const double inset = 0.6 * legend.font;
    const double right = axes.right - inset - legend.place.right, top = axes.top - inset - legend.place.top;
    const double left = axes.left + inset, bottom = axes.bottom + inset;
    if (right < left || top < bottom) return false;
    for (const double up : {1.0, 0.0, 0.5, 0.75, 0.25})
        for (const double across : {1.0, 0.0, 0.5, 0.75, 0.25}) {
            const PlotArea place = moved(legend.place, left + across * (right - left), bottom + up * (top - bottom));
            const double room = 0.4 * legend.font;
            if (crosses(curves, {place.left - room, place.bottom - room, place.right + room, place.top + room}))
                continue;
            legend.place = place;
            return true;
        }
    return false;
}

void place_beside(PlotLegend& legend, const PlotArea& axes) {
    legend.place = moved(legend.place, axes.right + legend.font, axes.top - (legend.place.top - legend.place.bottom));
}

} // namespace abut
