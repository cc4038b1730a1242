#pragma once
/// \file specification_sections.h
/// The parts of the table of keys; read them through scene_keys().

#include "io/scene/specification.h"

namespace abut {

/// A word as JSON text.
inline std::string quoted(const std::string& word) {
    return '"' + word + '"';
}

std::vector<Key> general_keys();  ///< the scene, grid, time, method, gravity, output
std::vector<Key> matter_keys();   ///< materials, bodies, images
std::vector<Key> contact_keys();  ///< contact and its laws
std::vector<Key> boundary_keys(); ///< walls

} // namespace abut
