#pragma once
/// \file build_model.h
/// From a scene to its initial particles.

#include "geometry/model_report.h"
#include "particles/model.h"
#include "scene/scene.h"

#include <string>

namespace abut {

/// Makes the particles of every body and image of a scene, for the cells of effective_cell().
/// Bodies: those of scene.bodies in their order, then those of the images in the order in which label_image() finds
/// them. A name that comes again, in bodies, legends or images, adds particles to the same body; its material, its
/// velocity and its initial state must then be the same. Two-dimensional scenes: z of positions and half sizes is 0.
/// \param scene_name path of the scene file: the label of messages, and relative files are relative to its folder
/// \param report gets areas, widths and notes, which cost some time; null: not wanted
/// \throws SceneError with all that is wrong: files that cannot be read or used, colours the legend does not cover,
/// bodies without particles, of the other dimension, outside the grid, on top of one another (unless scene.overlap says
/// who gives way), smaller than a cell; names of contact laws and tractions that no body has; no particles at all.
Model build_model(const Scene& scene, const std::string& scene_name, ModelReport* report = nullptr);

} // namespace abut
