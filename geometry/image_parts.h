#pragma once
/// \file image_parts.h
/// An image of a scene to parts of the model, with all that can be wrong with it.

#include "geometry/parts.h"
#include "scene/problem.h"
#include "scene/scene.h"

#include <string>
#include <vector>

namespace abut {

/// A part, and the legend entry that its body comes from.
struct ImagePart {
    Part part;
    std::size_t entry = 0;
};

/// Reads an image and makes one part per body (Part::body is left at 0; Part::exact is the area or volume of its
/// pixels). Reports an image that cannot be read, that sticks out of the grid by more than half a pixel, whose colours
/// the legend does not cover, and bodies that get no particles or are smaller than a cell. \param index of the image in
/// scene.images \param scene_name path of the scene file; relative files are relative to its folder \param notes
/// speckles
std::vector<ImagePart> image_parts(const Scene& scene, std::size_t index, const std::string& scene_name,
                                   std::vector<std::string>& notes, std::vector<Problem>& problems);

} // namespace abut
