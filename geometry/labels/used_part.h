#pragma once
/// \file used_part.h
/// Which pixels of a file an image of a scene uses.

#include "geometry/images/image.h"
#include "scene/scene.h"

#include <array>
#include <cstdint>

namespace abut {

/// First and last column, row and slice, both included.
using UsedPart = std::array<std::array<int, 2>, 3>;

/// The part that crop and slice name, all if they name none.
/// \throws std::runtime_error where they name what is not there, saying what is; in plane scenes also for a stack
/// without `slice`; for more pixels than numbers of 32 bits count (most_used_pixels)
UsedPart used_part(const ImageSpec& spec, int dimension, const StackInfo& info);

inline constexpr std::int64_t most_used_pixels = (std::int64_t{1} << 31) - 1;

/// The connectivity of components: as given, or 4 or 6.
/// \throws std::runtime_error where it does not fit the dimension
int used_connectivity(const ImageSpec& spec, int dimension);

} // namespace abut
