#pragma once
/// \file name_bodies.h
/// From the colours of an image to its bodies: one kind of pixels per body name, colour or entry.

#include "geometry/labels/label_image.h"
#include "geometry/labels/legend.h"

#include <cstdint>
#include <string>
#include <vector>

namespace abut {

/// A kind of pixels that are not told apart when speckles are looked for.
struct PixelKind {
    int entry = 0;            ///< of the legend
    std::array<int, 3> rgb{}; ///< BodiesBy::colour
};

/// Kinds of pixels in the order of their labels, and what each colour is.
struct PixelKinds {
    std::vector<PixelKind> kinds;        ///< of label 1, 2, …
    std::vector<std::int32_t> of_colour; ///< label of each colour of a table; 0: void or unmatched
};

/// legend: a kind per body name in order of first appearance; colour: a kind per colour, ascending; component: a kind
/// per entry.
/// \throws std::runtime_error for more than most_bodies colours
PixelKinds pixel_kinds(const ImageSpec& spec, const std::vector<ColourTable::Colour>& colours,
                       const std::vector<int>& entry_of_colour);

/// Names of bodies by colour: see label_image(). Kinds without pixels have been left out.
std::vector<std::string> names_by_colour(const std::vector<PixelKind>& kinds, const std::vector<LegendEntry>& legend);

/// Names of bodies by component, of the given entries.
std::vector<std::string> names_by_component(const std::vector<int>& entries, const std::vector<LegendEntry>& legend);

} // namespace abut
