#pragma once
/// \file compose.h
/// From frames to pictures: the look that pictures of one series share, and each picture.

#include "io/render/layout.h"
#include "io/render/render_series.h"
#include "io/render/values.h"

#include <optional>
#include <set>
#include <string>
#include <vector>

namespace abut {

/// What pictures of one series have in common.
struct Look {
    Layout layout;
    std::optional<ColourScale> scale;      ///< of the particles; none: coloured by body
    std::optional<ColourScale> separation; ///< of arrows at contact pairs
    std::vector<LegendItem> legend;
    std::string title;
    double end_time = 0; ///< of the series [s]; chooses the unit of times
    double spacing = 0;  ///< of the particles [m]
};

/// Point arrays that pictures need.
std::vector<std::string> needed_arrays(const RenderOptions& options);

/// Whether the particles have a thickness.
bool is_in_space(const PointFrame& frame);

/// Bounds that contain nothing yet.
Bounds nothing();

/// Makes the bounds contain the particles; `with_domains` not their centres only.
void extend(Bounds& bounds, const PointFrame& frame, bool with_domains);

/// A box a little larger than the points; never without extent.
Bounds around(Bounds bounds);

/// Values that colours must tell apart: those of the particles, or separations where these are shown.
struct ShownValues {
    /// For the colours: without those that options.percentile leaves out. Of separations, those of pairs in contact;
    /// make_look() takes `all` where there are none.
    Range range;
    Range all;
};
/// None if colours are those of bodies.
ShownValues shown_values(const PointFrame& frame, const PointFrame* contact, const RenderOptions& options);
ShownValues joined(const ShownValues& a, const ShownValues& b);

/// The look of pictures that show `bounds`, with colours for `values`, or for options.range if it is given. \param
/// first any frame of the series \param where for messages \param bodies numbers of those drawn; none: all
Look make_look(const PointFrame& first, const Bounds& bounds, const ShownValues& values, const RenderOptions& options,
               const std::string& where, const std::optional<std::set<int>>& bodies = {});

/// The picture of a frame. \param contact the contact pairs, if they are wanted \param time of the label [s]; none: no
/// label
Picture compose(const PointFrame& frame, const PointFrame* contact, std::optional<double> time, const Look& look,
                const RenderOptions& options);

} // namespace abut
