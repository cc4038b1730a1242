#pragma once
/// \file read_frame.h
/// Result files back as frames, for pictures and comparisons.

#include "results/frame.h"

#include <filesystem>
#include <string>
#include <vector>

namespace abut {

/// Reads a .vtu or .vtp file: points and point arrays (whole numbers as int32, the rest as double), words and time.
/// With `wanted`, only the point arrays of these names are read; names the file lacks are passed over. Throws
/// std::runtime_error naming the file if it is missing or broken.
PointFrame read_points(const std::filesystem::path& path, const std::vector<std::string>& wanted = {});

/// Reads a .vti file; otherwise as read_points.
GridFrame read_grid(const std::filesystem::path& path, const std::vector<std::string>& wanted = {});

} // namespace abut
