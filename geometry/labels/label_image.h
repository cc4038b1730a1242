#pragma once
/// \file label_image.h
/// From the file of a picture or a stack to bodies: legend, crop, flip, turn, speckles, colours or components.

#include "geometry/images/image.h"
#include "geometry/labels/label_volume.h"
#include "geometry/labels/legend.h"
#include "scene/scene.h"

#include <cstdint>
#include <filesystem>
#include <functional>
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
    std::vector<std::int64_t> pixels_of_entry; ///< per legend entry, of what is used, before speckles are removed
    std::vector<UnmatchedColour> unmatched;    ///< colours that no entry covers, most frequent first; their label is 0
    std::array<double, 3> spacing{};           ///< size of a pixel along x, y, z that the file states [m]; 0: none
    std::int64_t speckle_pixels = 0;           ///< pixels that changed hands
    int speckles = 0;                          ///< components that did
};

/// More bodies than this are taken for noise.
inline constexpr std::int32_t most_bodies = 100000;

/// Reads an image and finds its bodies, in this order: crop, legend, flip, turn (see pixel_order()), speckles, bodies.
/// Plane scenes: one slice (spec.slice, or the only one; the crop's slices are not used). 3D: all slices; the first is
/// the lowest.
/// Speckles are connected components of what is one body by the legend: of a body's name (BodiesBy::legend), a colour
/// (colour), or an entry (component); those of void are holes. Components are divided at necks after that.
/// Body names: BodiesBy::legend: the entry's, in order of first appearance in the legend (also those without pixels).
/// colour: the entry's name, "-" and the grey with as many digits as the largest of that name has, or, where not all
/// colours of that name are grey, six hexadecimal digits (twelve where one is beyond 255), in ascending order of
/// colour; only colours that have pixels left. component: the entry's name, "-" and a number from 1 with as many digits
/// as the last needs, counted over all entries of that name, in the order in which x, y, z scanning first meets them.
/// \param file the file to read (spec.file, made absolute)
/// \throws std::runtime_error when the file can't be read, is a stack where one picture is needed, or does not have the
/// pixels that crop or slice name; when connectivity or turn does not fit the dimension, or there are more than
/// most_bodies; what() can stand after "/images/0/file: "
LabelledImage label_image(const ImageSpec& spec, int dimension, const std::filesystem::path& file);

/// Calls `visit` for the slices first .. last in order, as read_stack().
using ReadSlices =
    std::function<void(int first, int last, const std::function<void(int slice, const Image& image)>& visit)>;

/// label_image() of a stack from anywhere. Memory: 16 bytes per pixel that is used while it runs, 4 in the end. Pixels
/// are given memory as their slices come.
LabelledImage label_stack(const ImageSpec& spec, int dimension, const StackInfo& info, const ReadSlices& read);

} // namespace abut
