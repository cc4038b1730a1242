#pragma once
/// \file image.h
/// Pictures as plain values: reading PNG, BMP, TIFF, JPEG and VTI, single or as stacks; writing PNG, BMP and TIFF.

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <vector>

namespace abut {

/// A picture of 8 or 16 bits per channel, grey (1 channel) or RGB (3 channels). Rows run from the top of the picture as
/// every viewer shows it to the bottom, pixels of a row from left to right:
/// pixels[(row * width + column) * channels].
struct Image {
    int width = 0, height = 0;         ///< [pixels]
    int channels = 0;                  ///< 1 grey, 3 RGB
    std::vector<std::uint16_t> pixels; ///< 0 .. 2^bits - 1
    int bits = 8;                      ///< 8 or 16

    /// Colour of a pixel; grey pixels have three equal components.
    std::array<int, 3> rgb(int column, int row) const {
        const std::size_t first = (static_cast<std::size_t>(row) * width + column) * channels;
        if (channels == 1) return {pixels[first], pixels[first], pixels[first]};
        return {pixels[first], pixels[first + 1], pixels[first + 2]};
    }
};

/// What a stack of pictures holds. A single picture is a stack of one slice.
struct StackInfo {
    int width = 0, height = 0, slices = 0;        ///< [pixels]
    int bits = 8;                                 ///< 8 or 16
    std::optional<std::array<double, 3>> spacing; ///< size of a pixel that the file itself states (VTI)
};

/// Largest number of pixels of one slice that is read: 2^28.
inline constexpr std::int64_t most_pixels = std::int64_t{1} << 28;

/// Reads a PNG, BMP, TIFF, JPEG or VTI picture, told apart by their contents, not by their names. Palettes become RGB.
/// A fourth channel that is opaque everywhere is dropped. VTI: one point or cell array of 1 or 3 components of integers
/// from 0 to 65535; its lowest row of y is the last row of the picture, as ParaView shows it. \throws
/// std::runtime_error when the file is missing, damaged, incomplete, of another format (GIF is named), of another
/// depth, CMYK, animated, transparent somewhere, a stack, run-length compressed BMP, empty, or larger than most_pixels;
/// what() says which and what to do. Nothing is allocated that the file cannot hold.
Image read_image(const std::filesystem::path& file);

/// What a stack holds, without its pixels.
/// \param file a multi-page TIFF, a VTI volume, a single picture, or a name with one "*" for the number of a slice:
/// all files of that folder that match, by their numbers ("ct_*.png": ct_0001.png, ct_0002.png, …; any number of
/// digits) \throws std::runtime_error as read_image(); also when no file matches, a number is missing between the first
/// and the last (names it), two files have the same number, or slices differ in size or depth (names the files)
StackInfo read_stack_info(const std::filesystem::path& file);

/// Reads slices first .. last of a stack in order, one in memory at a time.
/// \param visit called with the number of each slice, from 0, and its pixels
/// \throws std::runtime_error as read_stack_info()
void read_stack(const std::filesystem::path& file, int first, int last,
                const std::function<void(int slice, const Image& image)>& visit);

/// Writes a picture as PNG, BMP (8 bits only) or TIFF, by the file's extension. The file appears whole or not at all:
/// it is written under a temporary name and then renamed. \throws std::runtime_error for another extension, or when the
/// file cannot be written (no such folder, disk full).
void write_image(const Image& image, const std::filesystem::path& file);

/// Writes a stack as a TIFF file of several pages (LZW compressed), slice by slice; the file appears whole or not at
/// all. \param slice makes each page \throws std::runtime_error as write_image()
void write_stack(int slices, const std::function<Image(int slice)>& slice, const std::filesystem::path& file);

} // namespace abut
