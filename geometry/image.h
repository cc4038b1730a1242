#pragma once
/// \file image.h
/// Pictures as plain values: reading PNG, BMP, TIFF and JPEG, writing PNG and BMP.

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <vector>

namespace abut {

/// A picture of 8 bits per channel, grey (1 channel) or RGB (3 channels). Rows run from the top of the picture as every
/// viewer shows it to the bottom, pixels of a row from left to right: pixels[(row * width + column) * channels].
struct Image {
    int width = 0, height = 0; ///< [pixels]
    int channels = 0;          ///< 1 grey, 3 RGB
    std::vector<std::uint8_t> pixels;

    /// Colour of a pixel; grey pixels have three equal components.
    std::array<int, 3> rgb(int column, int row) const {
        const std::size_t first = (static_cast<std::size_t>(row) * width + column) * channels;
        if (channels == 1) return {pixels[first], pixels[first], pixels[first]};
        return {pixels[first], pixels[first + 1], pixels[first + 2]};
    }
};

/// Reads a PNG, BMP, TIFF or JPEG picture, told apart by their contents, not by their names. Palettes become RGB. A
/// fourth channel that is opaque everywhere is dropped.
/// \throws std::runtime_error when the file is missing, damaged, of another format, of 16 bits per channel, transparent
/// somewhere, a stack of several pages, or a run-length compressed BMP; what() says which and what to do.
Image read_image(const std::filesystem::path& file);

/// Writes a picture as PNG or BMP, by the file's extension. The file appears whole or not at all: it is written under a
/// temporary name and then renamed.
/// \throws std::runtime_error for another extension, or when the file cannot be written (no such folder, disk full).
void write_image(const Image& image, const std::filesystem::path& file);

} // namespace abut
