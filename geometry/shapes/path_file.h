#pragma once
/// \file path_file.h
/// Outlines from CSV and SVG files.

#include "geometry/shapes/outline.h"

#include <filesystem>
#include <string>
#include <vector>

namespace abut {

/// The outlines of a file, in its own units, y upwards. Told apart by content: what begins with "<" is SVG.
/// CSV: a point a line, x and y separated by comma, semicolon, tab or spaces; an empty line begins another outline;
/// lines that begin with # and a first line that is no number are passed over. SVG: paths, polygons, polylines,
/// rectangles, circles and ellipses with their transforms, filled as SVG fills them, that is closed. Curves become
/// chords at most 1e-5 of their size off. The lower left corner of the drawing (its viewBox, else its height) is the
/// origin, so that the drawing is seen as a viewer shows it. \throws std::runtime_error when the file is missing,
/// larger than 64 MiB, not to be understood (names the line or the element) or has no outlines; or holds text, images
/// or references to other elements, which have to be converted to paths
std::vector<Outline2D> read_path_file(const std::filesystem::path& file);

/// The points of the `d` attribute of an SVG path, y downwards, one list per subpath.
std::vector<Outline2D> svg_path_outlines(const std::string& data);

} // namespace abut
