#pragma once
/// \file specification_sections.h
/// The parts of the table of keys; read them through scene_keys().

#include "io/scene/specification.h"

namespace abut {

/// A word as JSON text.
inline std::string quoted(const std::string& word) {
    return '"' + word + '"';
}

/// Kinds of shapes: of which exactly one stands where shape_keys() are.
const std::vector<std::string>& shape_kinds();

/// Words as JSON texts.
inline std::vector<std::string> quoted_all(std::vector<std::string> words) {
    for (std::string& word : words) word = abut::quoted(word); // not std::quoted
    return words;
}

/// Analyses of two dimensions, and three.
inline const OnlyWith only_in_plane{"/analysis", quoted_all({"plane-strain", "plane-stress", "axisymmetric"})};
inline const OnlyWith only_in_3d{"/analysis", quoted_all({"3d"})};

std::vector<Key> general_keys();                      ///< the scene, grid, time, method, gravity
std::vector<Key> output_keys();                       ///< output
std::vector<Key> matter_keys();                       ///< materials, shapes, bodies, images
std::vector<Key> shape_keys(const std::string& path); ///< of a shape that stands at `path`, one key each kind
std::vector<Key> shapes_keys();                       ///< shapes by name
std::vector<Key> image_keys();                        ///< images and their legends, without what bodies share
std::vector<Key> law_keys(const std::string& path);   ///< of a contact law that stands at `path`
std::vector<Key> contact_keys();                      ///< contact and its laws
std::vector<Key> boundary_keys();                     ///< walls, velocities, tractions

} // namespace abut
