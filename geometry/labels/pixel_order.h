#pragma once
/// \file pixel_order.h
/// Where the pixels of a file lie in the axes of the scene.

#include "scene/scene.h"

#include <array>
#include <cstddef>

namespace abut {

/// The pixel of column c, row r and slice s of the part of a file that is used has the place
/// first + c step[0] + r step[1] + s step[2] in a LabelVolume of this size.
struct PixelOrder {
    std::array<int, 3> size{}; ///< pixels along x, y, z
    std::ptrdiff_t first = 0;
    std::array<std::ptrdiff_t, 3> step{};
    std::array<int, 3> axis{}; ///< of the scene, along which columns, rows and slices run
};

/// How flips and turns act: first the picture is placed without them: columns along x, rows along y (downwards from the
/// top, or upwards from the bottom if first_row_is_up is false), slices along z. Then it is mirrored: flip[0] left and
/// right, flip[1] top and bottom, flip[2] front and back. Then it is turned as a whole about turn_axis by
/// quarter_turns, counter-clockwise for who looks against the axis: about z, x goes to y; about x, y to z; about y, z
/// to x.
/// \param size columns, rows and slices that are used
PixelOrder pixel_order(const ImageSpec& spec, const std::array<int, 3>& size);

} // namespace abut
