#pragma once
/// \file layout.h
/// Where things stand in a picture: the scene, a panel to its right (colour bar or legend), title and time above, a
/// scale bar below.

#include "io/render/values.h"
#include "io/render/view.h"

#include <string>
#include <vector>

namespace abut {

struct LegendItem {
    std::string text;
    Rgb colour;
};

/// What a series of pictures has in common. Sizes are in pixels; `unit` is a thousandth of the width.
struct Layout {
    int width = 0, height = 0;
    double unit = 1;
    Pixel plot_lower{}, plot_upper{}; ///< the scene's rectangle
    Bounds bounds;
    View view;
};

/// Width of the panel with the colour bar, or with the legend, at a picture's `unit` [pixels].
double panel_width(const ColourScale& scale, double unit);
double panel_width(const std::vector<LegendItem>& legend, double unit);

/// Lays out a picture of `width`; with `height` 0 the height follows from the scene's proportions, within limits.
Layout make_layout(const Bounds& bounds, int width, int height, double panel);

void add_title(Picture& picture, const Layout& layout, const std::string& title, const std::string& time);
void add_scale_bar(Picture& picture, const Layout& layout);
/// \param below height left free under the bar [pixels] \return where it ends below [pixels]
double add_colour_bar(Picture& picture, const Layout& layout, const ColourScale& scale, double below = 0);
/// Items for which the height has no room are counted in a last line.
void add_legend(Picture& picture, const Layout& layout, const std::vector<LegendItem>& legend);

} // namespace abut
