#pragma once
/// \file build_model.h
/// From a scene to its initial particles.

#include "particles/model.h"
#include "scene/scene.h"

#include <string>

namespace abut {

/// Makes the particles of every body and picture of a scene, for the cells of effective_cell().
/// Bodies: those of scene.bodies in their order, then those of the pictures in the order in which the legends first
/// name them. A name that comes again, in bodies, legends or pictures, adds particles to the same body; its material
/// and its velocity (value, gradient and centre) must then be the same. Two-dimensional scenes: z of positions and half
/// sizes is 0. Three-dimensional scenes have no pictures.
/// \param scene_name path of the scene file: the label of messages, and relative picture files are relative to its
/// folder
/// \throws SceneError with all that is wrong: pictures that cannot be read, colours the legend does not cover, bodies
/// without particles, of the other dimension, outside the grid, on top of one another, of pictures and smaller than a
/// cell; no particles at all.
Model build_model(const Scene& scene, const std::string& scene_name);

} // namespace abut
