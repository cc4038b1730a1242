#pragma once
/// \file image_formats.h
/// Inside of read_image(): one reader per format. Each throws std::runtime_error with a message that continues the
/// sentence `image "NAME" ...`, and returns 1 to 4 channels (2 and 4: the last one is alpha), top row first.

#include "geometry/images/image.h"

#include <cstdint>
#include <filesystem>
#include <vector>

namespace abut::formats {

using Bytes = std::vector<std::uint8_t>;

/// Throws unless the bytes are a PNG file whose chunks are all there and undamaged, of at most 8 bits per channel.
/// To be called before read_png(): VTK's reader crashes the program on a truncated or damaged PNG file.
void check_png(const Bytes& bytes);

Image read_png(const std::filesystem::path& file);
Image read_jpeg(const std::filesystem::path& file);
Image read_tiff(const std::filesystem::path& file);
Image read_bmp(const Bytes& bytes);

} // namespace abut::formats
