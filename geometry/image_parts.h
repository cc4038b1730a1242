#pragma once
/// \file image_parts.h
/// A picture of a scene to parts of the model, with all that can be wrong with it.

#include "geometry/parts.h"
#include "scene/problem.h"
#include "scene/scene.h"

#include <string>
#include <vector>

namespace abut {

/// Reads the picture and makes one part per body of its legend (Part::body is left at 0). Reports a picture that cannot
/// be read, that sticks out of the grid by more than half a pixel, whose colours the legend does not cover, and bodies
/// that get no particles or are smaller than a cell.
/// \param pointer of the image in the scene, e.g. "/images/0"
/// \param scene_name path of the scene file; relative picture files are relative to its folder
std::vector<Part> image_parts(const ImageSpec& spec, const GridSpec& grid, const std::string& pointer,
                              const std::string& scene_name, std::vector<Problem>& problems);

} // namespace abut
