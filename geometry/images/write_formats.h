#pragma once
/// \file write_formats.h
/// Inside of write_image() and write_stack(): one writer per format.

#include "geometry/images/image.h"

#include <cstdint>
#include <filesystem>
#include <functional>

namespace abut::formats {

/// \throws std::runtime_error unless the pixels are as many as width, height and channels say, and fit into the bits
void check_image(const Image& image);

/// Each writes a whole file. \throws std::runtime_error that says why it cannot be written
void write_png(const Image& image, const std::filesystem::path& file);
void write_bmp(const Image& image, const std::filesystem::path& file);
void write_tiff(int slices, const std::function<Image(int slice)>& slice, const std::filesystem::path& file);

} // namespace abut::formats
