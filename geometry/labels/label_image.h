#pragma once
/// \file label_image.h
/// From the file of a picture or a stack to bodies: legend, crop, flip, turn, speckles, colours or components.

#include "geometry/labels/label_volume.h"
#include "geometry/labels/legend.h"
#include "scene/scene.h"

#include <filesystem>
#include <string>
#include <vector>

namespace abut {

/// A body of an image.
struct LabelledBody {
    std::string name;
    int entry = 0;           ///< of the legend, which gives material, velocity and so on; the first that names it
    std::int64_t pixels = 0; ///< after speckles were removed
};

/// An image in terms of its bodies.
struct LabelledImage {
    LabelVolume volume; ///< 0 void, k > 0 bodies[k - 1]
    std::vector<LabelledBody> bodies;
    std::vector<std::int64_t> pixels_of_entry; ///< per legend entry, of the part that is used, before speckles are removed
    std::vector<UnmatchedColour> unmatched;    ///< colours that no entry covers, most frequent first; their label is 0
    std::array<double, 3> spacing{};           ///< size of a pixel that the file states [m]; 0: none
    std::int64_t speckle_pixels = 0;           ///< pixels that changed hands
    int speckles = 0;                          ///< components that did
};

/// Reads an image and finds its bodies, in this order: crop, legend, flip, turn, speckles, bodies.
/// Plane scenes: one slice (spec.slice, or the only one). 3D: all slices; the first is the lowest.
/// Body names: BodiesBy::legend: the entry's, in order of first appearance in the legend (also those without pixels).
/// colour: the entry's name, "-" and the grey with as many digits as the largest has, or the six hexadecimal digits, in
/// ascending order of colour. component: the entry's name, "-" and a number from 1 with as many digits as the
/// last needs, counted over all entries of that name, in the order in which x, y, z scanning first meets them.
/// \param file the file to read (spec.file, made absolute)
/// \throws std::runtime_error when the file can't be read, is a stack where one picture is needed, or does not have the
/// pixels that crop or slice name; what() can stand after "/images/0/file: "
LabelledImage label_image(const ImageSpec& spec, int dimension, const std::filesystem::path& file);

/// Greys of a second image.
struct ValueVolume {
    LabelVolume volume;  ///< grey of each pixel
    int highest = 255;   ///< grey that is white: 255 or 65535
};

/// Reads a grey image of the same frame as the image of the bodies: the same crop, flip and turn.
/// \throws std::runtime_error as label_image(), and for colours
ValueVolume value_image(const ImageSpec& spec, int dimension, const std::filesystem::path& file);

} // namespace abut
