#pragma once
/// \file outline.h
/// Closed outlines of straight pieces: checks, and the solid inside.

#include "geometry/shapes/solid.h"

#include <string>
#include <vector>

namespace abut {

using Outline2D = std::vector<PlanePoint>;

/// Without points that repeat the one before (or, at the end, the first).
Outline2D without_repeats(const Outline2D& points);

/// Area within one outline [m^2].
double area_of(const Outline2D& points);

/// \throws std::runtime_error when one of the outlines has fewer than 3 corners, no area, coordinates that are no
/// numbers, crosses or touches itself, or two outlines cross; says which ("outline 3", or names[2]) and where
void check_outlines(const std::vector<Outline2D>& outlines, const std::vector<std::string>& names = {});

/// What lies inside an odd number of outlines. Lines through corners count each side once.
Solid solid_of_outlines(const std::vector<Outline2D>& outlines);

} // namespace abut
