#pragma once
/// \file pack_scene.h
/// Scene files of packed grains.

#include "geometry/packing/pack.h"

#include <string>

namespace abut {

/// A small scene file with the grains as shapes; reading its numbers gives them exactly.
/// \param pixel length of one pixel [m] \param title what made it, for its title
std::string scene_of(const PackedGrains& packed, double pixel, const std::string& material, const std::string& title);

} // namespace abut
