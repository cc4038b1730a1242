#pragma once
/// \file polygon_soup.h
/// What a surface file holds, as it stands there: points, and faces that name them.

#include "scene/scene.h"

#include <filesystem>
#include <string_view>
#include <vector>

namespace abut {

struct PolygonSoup {
    std::vector<Vector> points;    ///< in the unit of the file; may hold infinities and NaN
    std::vector<int> corners;      ///< of all faces, one after the other: valid indices of points
    std::vector<std::size_t> ends; ///< where the corners of each face end

    std::size_t faces() const { return ends.size(); }
    std::size_t begin(std::size_t face) const { return face == 0 ? 0 : ends[face - 1]; }
};

/// Reads an STL (text or binary), OFF, PLY (text or binary) or OBJ file, told apart by contents, and by name where
/// these say nothing. Nothing is allocated before the file is known to be long enough to fill it. \throws
/// std::runtime_error naming the file, what is wrong and in which line, face or byte
PolygonSoup read_polygon_soup(const std::filesystem::path& file);

/// The formats, from the bytes of a file. \throws std::runtime_error without the file's name
PolygonSoup read_stl_text(std::string_view bytes);
PolygonSoup read_stl_binary(std::string_view bytes);
PolygonSoup read_off(std::string_view bytes);
PolygonSoup read_obj(std::string_view bytes);
PolygonSoup read_ply(std::string_view bytes);

} // namespace abut
