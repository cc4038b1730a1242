#pragma once
/// \file value_image.h
/// A second image of the same frame as that of the bodies, whose greys stand for a quantity.

#include "geometry/labels/label_volume.h"
#include "scene/scene.h"

#include <filesystem>

namespace abut {

/// Greys in the axes of the scene.
struct ValueVolume {
    LabelVolume volume; ///< grey of each pixel
    int highest = 255;  ///< grey that is white: 255 or 65535
};

/// Reads a grey image with the crop, flip, turn and slice of the image of the bodies.
/// \throws std::runtime_error as label_image(), and for colours; what() can stand after "/images/0/temperature/file: "
ValueVolume value_image(const ImageSpec& spec, int dimension, const std::filesystem::path& file);

} // namespace abut
