#pragma once
/// \file shape_parts.h
/// Bodies of shapes to parts of the model.

#include "geometry/parts.h"
#include "geometry/shapes/solid.h"
#include "scene/problem.h"

#include <string>
#include <vector>

namespace abut {

/// Makes a part for every body of scene.bodies, in their order (Part::body is left at 0). Reports shapes that can't be
/// made, lie outside the grid, are smaller than a cell, or get no particles. Where bodies overlap and scene.overlap
/// lets one have the place, the others' shapes are cut by its shape.
/// \param scene_name path of the scene file; relative files are relative to its folder
/// \param wants_exact fill Part::exact
/// \param notes repairs of surfaces
std::vector<Part> shape_parts(const Scene& scene, const std::string& scene_name, bool wants_exact,
                              std::vector<std::string>& notes, std::vector<Problem>& problems);

} // namespace abut
