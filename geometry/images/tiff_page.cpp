// The kinds of TIFF: by name what we do not read, and what a file of its size can hold.
#include "geometry/images/tiff_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace abut::formats {

namespace {

int tag(TIFF* tiff, std::uint32_t name) {
    std::uint16_t value = 0;
    TIFFGetFieldDefaulted(tiff, name, &value);
    return value;
}

/// The most bytes of pixels that a byte in the file can become.
double largest_ratio(int compression, const TiffPage& page) {
    switch (compression) {
    case COMPRESSION_NONE:
        return 1;
    case COMPRESSION_PACKBITS:
    case COMPRESSION_NEXT:
    case COMPRESSION_THUNDERSCAN:
        return 64; // 128 bytes from 2; 63 pixels of 2 or 4 bits from 1
    case COMPRESSION_LZW:
        return 4096; // a code of 9 bits or more is a string shorter than the table
    case COMPRESSION_DEFLATE:
    case COMPRESSION_ADOBE_DEFLATE:
        return deflate_ratio;
    case COMPRESSION_JPEG:
        return 1024.0 * page.samples; // as in read_jpeg.cpp
    case COMPRESSION_LZMA:
    case COMPRESSION_ZSTD:
    // Pieces of one colour take next to nothing in these; larger ones than this nobody makes.
    case COMPRESSION_WEBP:
    case COMPRESSION_LERC:
        return 65536;
    case COMPRESSION_OJPEG:
        throw std::runtime_error("is a TIFF of an old kind of JPEG compression; save it with LZW or uncompressed");
    // A blank row takes a bit; wider ones than this nobody makes.
    case COMPRESSION_CCITTRLE:
    case COMPRESSION_CCITTRLEW:
    case COMPRESSION_CCITTFAX3:
    case COMPRESSION_CCITTFAX4:
        return std::clamp(page.width, 256, 65536);
    case COMPRESSION_JBIG: // libtiff 4.5 decodes as many pixels as the compressed data claims, without end
    default:
        throw std::runtime_error("is a TIFF of an unusual compression; save it with LZW or uncompressed");
    }
}

void check_kind(TIFF* tiff, const TiffPage& page, int compression) {
    switch (tag(tiff, TIFFTAG_SAMPLEFORMAT)) {
    case SAMPLEFORMAT_INT:
        throw std::runtime_error("has signed numbers; save it with 8 or 16 bits, unsigned");
    case SAMPLEFORMAT_IEEEFP:
        throw std::runtime_error("has floating point numbers; save it with 8 or 16 bits, unsigned");
    case SAMPLEFORMAT_COMPLEXINT:
    case SAMPLEFORMAT_COMPLEXIEEEFP:
        throw std::runtime_error("has complex numbers; save it with 8 or 16 bits, unsigned");
    default:
        break;
    }
    if (page.bits < 1 || (page.bits > 8 && page.bits != 16))
        throw std::runtime_error(fmt::format("has {} bits per channel; save it with 8 or 16", page.bits));
    if (page.photometric == PHOTOMETRIC_SEPARATED) throw std::runtime_error("has CMYK colours; save it as RGB");
    const bool grey = page.photometric == PHOTOMETRIC_MINISBLACK || page.photometric == PHOTOMETRIC_MINISWHITE;
    const bool rgb = page.photometric == PHOTOMETRIC_RGB ||
                     (page.photometric == PHOTOMETRIC_YCBCR && compression == COMPRESSION_JPEG && !page.separate &&
                      page.samples == 3 && page.bits == 8);
    if (!grey && !rgb && !page.palette())
        throw std::runtime_error("is a TIFF of unusual colours (neither grey nor RGB nor a palette); save it as RGB");
    if (page.palette() && page.bits > 8) throw std::runtime_error("has a palette of 16 bits; save it as RGB");
    const int colours = rgb ? 3 : 1;
    if (page.samples != colours && page.samples != colours + 1)
        throw std::runtime_error(fmt::format("has {} channels; save it as grey or RGB", page.samples));
}

} // namespace

TiffPage tiff_page(TIFF* tiff, double file_size) {
    std::uint32_t width = 0, height = 0;
    TIFFGetField(tiff, TIFFTAG_IMAGEWIDTH, &width);
    TIFFGetField(tiff, TIFFTAG_IMAGELENGTH, &height);
    std::uint16_t photometric = 0;
    if (TIFFGetField(tiff, TIFFTAG_PHOTOMETRIC, &photometric) != 1)
        throw std::runtime_error("is damaged: the TIFF file does not say what its numbers mean");
    check_pixels(width, height);
    TiffPage page;
    page.width = static_cast<int>(width);
    page.height = static_cast<int>(height);
    page.bits = tag(tiff, TIFFTAG_BITSPERSAMPLE);
    page.samples = tag(tiff, TIFFTAG_SAMPLESPERPIXEL);
    page.photometric = photometric;
    page.orientation = std::clamp(tag(tiff, TIFFTAG_ORIENTATION), ORIENTATION_TOPLEFT, ORIENTATION_LEFTBOT);
    page.separate = page.samples > 1 && tag(tiff, TIFFTAG_PLANARCONFIG) == PLANARCONFIG_SEPARATE;
    const int compression = tag(tiff, TIFFTAG_COMPRESSION);
    check_kind(tiff, page, compression);
    const double unpacked = page.separate ? page.samples * packed_bytes(width, height, page.bits)
                                          : packed_bytes(width, height, page.bits * page.samples);
    check_ratio(unpacked, file_size, largest_ratio(compression, page));
    // Bounds the buffer for a tile, which may be larger than the picture.
    if (TIFFIsTiled(tiff)) {
        std::uint32_t tile_width = 0, tile_height = 0;
        TIFFGetField(tiff, TIFFTAG_TILEWIDTH, &tile_width);
        TIFFGetField(tiff, TIFFTAG_TILELENGTH, &tile_height);
        check_pixels(tile_width, tile_height);
        check_ratio(packed_bytes(tile_width, tile_height, page.bits), file_size, largest_ratio(compression, page));
    }
    return page;
}

} // namespace abut::formats
