#pragma once
/// \file distance.h
/// Exact Euclidean distances on rasters, between centres of pixels.

#include "geometry/labels/label_volume.h"

#include <array>
#include <vector>

namespace abut {

/// Squared distance from the centre of each pixel to the centre of the nearest pixel with another label; 0 for pixels
/// of label 0; infinity where there is no such pixel. Time grows with the number of pixels (Felzenszwalb and
/// Huttenlocher 2012, axis by axis, within runs of equal label). Memory: the result, and one line. In units where
/// spacing is 1, exact up to 2^24; beyond, and with other spacings, correct to the precision of a float.
///
/// \param spacing size of a pixel along each axis, in any unit, larger than 0
/// \param border_is_outside along which axes the pixels that would come next beyond the raster count as another label
std::vector<float> squared_distance_to_others(const LabelVolume& volume, const std::array<double, 3>& spacing,
                                              const std::array<bool, 3>& border_is_outside = {});

/// The same for a raster of places that are inside or not, ordered as in LabelVolume: to the nearest one outside.
std::vector<float> squared_distance_to_outside(const std::vector<bool>& inside, const std::array<int, 3>& size,
                                               const std::array<double, 3>& spacing,
                                               const std::array<bool, 3>& border_is_outside = {});

} // namespace abut
