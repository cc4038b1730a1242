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
/// what follows # and a first line of names are passed over. SVG: paths, polygons, polylines,
/// rectangles, circles and ellipses with their transforms, filled as SVG fills them, that is closed. Curves become
/// chords at most 1e-5 of their size off, also after uneven transforms (up to 1:10000). What is not displayed does not
/// count; open paths that are not filled are errors. No more than ten million points. The lower left corner of the
/// drawing (its viewBox, else its height) is the origin, so that the drawing is seen as a viewer shows it. \throws
/// std::runtime_error when the file is missing, larger than 64 MiB, not to be understood (names the line or the
/// element) or has no outlines; or holds text, images or references to other elements, which have to be converted to
/// paths, or is clipped or masked
std::vector<Outline2D> read_path_file(const std::filesystem::path& file);

/// The points of the `d` attribute of an SVG path, y downwards, one list per subpath. Points that the one before
/// repeats, but for round-off of relative coordinates (1e-9 of the subpath's size), are left out.
/// \param tolerance of chords, relative to the size of each curve; \param open set if a subpath is neither closed nor
/// ends where it began
std::vector<Outline2D> svg_path_outlines(const std::string& data, double tolerance = 1e-5, bool* open = nullptr);

} // namespace abut
