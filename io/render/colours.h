#pragma once
/// \file colours.h
/// Colours of bodies and of values.

#include <array>
#include <cstdint>

namespace abut {

using Rgb = std::array<std::uint8_t, 3>;

/// A colour for body number `body`: 24 that are told apart easily, then again in a darker and a lighter shade. Bodies
/// of neighbouring numbers get very different hues.
Rgb body_colour(int body);

/// The colour mixed with white: 0 leaves it, 1 is white.
Rgb lighter(Rgb colour, double amount);

enum class ColourMap {
    sequential, ///< viridis: equal steps look equal, also in grey and to the colour-blind
    diverging   ///< blue over light grey to red, for values around zero
};

/// The colour at `fraction` of the range, clamped to 0..1; not-a-number is magenta, to be noticed.
Rgb map_colour(ColourMap map, double fraction);

} // namespace abut
