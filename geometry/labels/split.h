#pragma once
/// \file split.h
/// Bodies that touch, divided at their necks.

#include "geometry/labels/components.h"

#include <array>
#include <cstdint>
#include <vector>

namespace abut {

/// Divides each component where it is necked, by the watershed of the distance to its outside. Each pixel of a
/// component comes to exactly one part; parts are numbered from 1 in scanning order. The image's border is not outside:
/// a body that the image cuts off is as thick there as within.
///
/// Markers are maxima of the distance that stand out by at least `depth` above the highest saddle on the way to a
/// higher one: the largest ball inside a part has a radius larger by `depth` or more than the largest ball that passes
/// the neck (between centres of pixels: up to about 2 pixels less than for the smooth shape). They are found exactly,
/// by flooding from high to low with a union-find structure. From them the parts grow pixel by pixel in the order of
/// falling distance; pixels of equal distance in the order in which they are reached. Deterministic. Time grows with
/// the number of pixels; memory: 16 bytes per pixel, the components included.
///
/// \param connectivity of pixels, as that of the components
/// \param spacing size of a pixel along each axis; only the ratios matter. The unit of depth is the smallest of them.
/// \param depth larger than 0 [pixels]. At 0.5 the pixels' own roughness makes parts; 0.75 to 1.5 found every grain of
/// the stacks of tests/geometry/labels_ct.cpp.
/// \return the number of the component that each part was of
std::vector<std::int32_t> split_at_necks(Components& components, int connectivity, const std::array<double, 3>& spacing,
                                         double depth);

} // namespace abut
