#pragma once
#include "geometry/shapes/outline.h"

#include <string>
#include <vector>

namespace abut {

/// The outlines of an SVG document, see read_path_file(). \throws std::runtime_error that continues `path "FILE": `
std::vector<Outline2D> svg_outlines(const std::string& document);

} // namespace abut
