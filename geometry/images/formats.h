#pragma once
/// \file formats.h
/// Inside of read_image() and read_stack(): one reader per format. Each throws std::runtime_error with a message that
/// continues the sentence `image "NAME" ...`, and returns 1 to 4 channels (2 and 4: the last one is alpha), top row
/// first.

#include "geometry/images/image.h"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <limits>
#include <vector>

namespace abut::formats {

using Bytes = std::vector<std::uint8_t>;

enum class Format { png, bmp, jpeg, tiff, vti };

/// Tells a format by the contents of the file. \throws std::runtime_error that names another known format
Format format_of(const std::filesystem::path& file);

/// The first bytes of a file, at most \p most.
Bytes bytes_of(const std::filesystem::path& file, std::size_t most = std::numeric_limits<std::size_t>::max());

/// \throws std::runtime_error for a picture without pixels or with more than most_pixels
void check_pixels(std::int64_t width, std::int64_t height);

/// Bytes of one of the channels' rows, in numbers that no header can make overflow.
double packed_bytes(double width, double height, int bits_per_pixel);

/// \throws std::runtime_error when \p unpacked bytes cannot come out of \p packed ones.
/// \param ratio the most that one packed byte can become
void check_ratio(double unpacked, double packed, double ratio);
inline constexpr double deflate_ratio = 1032; ///< 258 bytes from 2 bits

/// Size and depth of a picture (8 or 16 bits) from the start of its file, before anything is allocated for its pixels.
struct PictureSize {
    int width = 0, height = 0; ///< [pixels]
    int bits = 8;
    bool operator==(const PictureSize&) const = default;
};
PictureSize png_size(const Bytes& start);
PictureSize bmp_size(const Bytes& start);
PictureSize jpeg_size(const Bytes& bytes);

Image read_png(const Bytes& bytes);
Image read_bmp(const Bytes& bytes);
Image read_jpeg(const Bytes& bytes);

/// Reads one slice of an opened stack; going up slice by slice is fast.
using SliceReader = std::function<Image(int slice)>;

StackInfo tiff_info(const std::filesystem::path& file);
SliceReader open_tiff(const std::filesystem::path& file);

StackInfo vti_info(const std::filesystem::path& file);
SliceReader open_vti(const std::filesystem::path& file);

} // namespace abut::formats
