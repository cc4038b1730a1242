// Our own: VTK 9.1's reader knows neither the headers that GIMP and ImageMagick write (versions 4 and 5) nor 1, 4 and
// 32 bits, reads run-length compressed files as if they were not, and crashes on others.
#include "geometry/images/formats.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <stdexcept>

namespace abut::formats {

namespace {

std::uint32_t little_endian(const Bytes& bytes, std::size_t at, int count) {
    if (at + count > bytes.size()) throw std::runtime_error("is incomplete: the BMP file ends too early");
    std::uint32_t value = 0;
    for (int i = 0; i < count; ++i) value |= std::uint32_t{bytes[at + i]} << (8 * i);
    return value;
}

struct Header {
    std::int64_t width = 0, height = 0; ///< height > 0: the lowest row comes first
    int bits = 0;
    bool alpha = false;
    std::size_t palette = 0;       ///< where it starts
    std::size_t palette_entry = 4; ///< its bytes per colour
    std::size_t palette_size = 0;
    std::size_t data = 0; ///< where the rows start
};

/// Refuses everything that is not 8 bits per channel, uncompressed.
void check_compression(const Bytes& bytes, std::uint32_t size, Header& header) {
    constexpr std::uint32_t none = 0, rle8 = 1, rle4 = 2, masks = 3, alpha_masks = 6;
    const std::uint32_t compression = little_endian(bytes, 30, 4);
    if (compression == rle8 || compression == rle4)
        throw std::runtime_error("is a run-length compressed (RLE) BMP; save it uncompressed, or as PNG");
    const bool has_masks = header.bits == 32 && (compression == masks || compression == alpha_masks);
    if (compression != none && !has_masks)
        throw std::runtime_error("is a BMP of a kind that cannot be read; save it as PNG");
    if (!has_masks) return;
    if (little_endian(bytes, 54, 4) != 0x00ff0000u || little_endian(bytes, 58, 4) != 0x0000ff00u ||
        little_endian(bytes, 62, 4) != 0x000000ffu)
        throw std::runtime_error("is a BMP with unusual channels; save it as PNG");
    header.alpha = (size >= 56 || compression == alpha_masks) && little_endian(bytes, 66, 4) == 0xff000000u;
}

Header read_header(const Bytes& bytes) {
    Header header;
    header.data = little_endian(bytes, 10, 4);
    const std::uint32_t size = little_endian(bytes, 14, 4);
    header.palette = 14 + std::size_t{size};
    if (size == 12) { // OS/2
        header.width = little_endian(bytes, 18, 2);
        header.height = little_endian(bytes, 20, 2);
        header.bits = static_cast<int>(little_endian(bytes, 24, 2));
        header.palette_entry = 3;
    } else if (size >= 40) {
        header.width = static_cast<std::int32_t>(little_endian(bytes, 18, 4));
        header.height = static_cast<std::int32_t>(little_endian(bytes, 22, 4));
        header.bits = static_cast<int>(little_endian(bytes, 28, 2));
        check_compression(bytes, size, header);
        header.palette_size = little_endian(bytes, 46, 4);
    } else {
        throw std::runtime_error("is damaged: its BMP header is of no known kind");
    }
    check_pixels(header.width, std::abs(header.height));
    const int bits = header.bits;
    if (bits != 1 && bits != 4 && bits != 8 && bits != 24 && bits != 32)
        throw std::runtime_error(fmt::format("is a BMP of {} bits per pixel; save it with 8 or 24", bits));
    if (bits <= 8 && (header.palette_size == 0 || header.palette_size > (1u << bits))) header.palette_size = 1u << bits;
    return header;
}

} // namespace

PictureSize bmp_size(const Bytes& start) {
    const Header header = read_header(start);
    return {static_cast<int>(header.width), static_cast<int>(std::abs(header.height)), 8};
}

Image read_bmp(const Bytes& bytes) {
    const Header header = read_header(bytes);
    const std::int64_t rows = std::abs(header.height);
    const std::size_t stride = (static_cast<std::size_t>(header.width) * header.bits + 31) / 32 * 4;
    if (header.data > bytes.size() || stride > (bytes.size() - header.data) / rows)
        throw std::runtime_error("is incomplete: the BMP file ends too early");

    Image image{static_cast<int>(header.width), static_cast<int>(rows), header.alpha ? 4 : 3, {}};
    image.pixels.reserve(static_cast<std::size_t>(image.width) * image.height * image.channels);
    const auto push_colour = [&](const std::uint8_t* bgr) { // stored blue first
        image.pixels.insert(image.pixels.end(), {bgr[2], bgr[1], bgr[0]});
    };
    for (std::int64_t row = 0; row < rows; ++row) {
        const std::int64_t stored_row = header.height > 0 ? rows - 1 - row : row;
        const std::uint8_t* line = bytes.data() + header.data + stride * stored_row;
        for (int column = 0; column < image.width; ++column) {
            if (header.bits <= 8) {
                const std::size_t first_bit = static_cast<std::size_t>(column) * header.bits;
                const unsigned mask = (1u << header.bits) - 1;
                const std::size_t index = (line[first_bit / 8] >> (8 - header.bits - first_bit % 8)) & mask;
                const std::size_t at = header.palette + index * header.palette_entry;
                if (index >= header.palette_size || at + 3 > bytes.size())
                    throw std::runtime_error("is damaged: a pixel's colour is not in the palette");
                push_colour(&bytes[at]);
            } else {
                const std::uint8_t* pixel = line + static_cast<std::size_t>(column) * (header.bits / 8);
                push_colour(pixel);
                if (header.alpha) image.pixels.push_back(pixel[3]);
            }
        }
    }
    return image;
}

} // namespace abut::formats
