// Through libpng itself: VTK 9.1's reader crashes the program on damaged files.
#include "geometry/images/c_library.h"
#include "geometry/images/formats.h"

#include <png.h>
#include <zlib.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <stdexcept>

namespace abut::formats {

namespace {

std::uint32_t big_endian(const std::uint8_t* data) {
    return (std::uint32_t{data[0]} << 24) | (std::uint32_t{data[1]} << 16) | (std::uint32_t{data[2]} << 8) | data[3];
}

constexpr std::size_t header_end = 8 + 8 + 13;

/// Checks that the chunks are all there and undamaged. \return bytes of compressed pixels
std::size_t check_chunks(const Bytes& bytes) {
    std::size_t data = 0;
    bool has_palette = false, ended = false;
    for (std::size_t at = 8; !ended;) {
        if (bytes.size() - at < 12) throw std::runtime_error("is incomplete: the PNG file ends too early");
        const std::size_t length = big_endian(&bytes[at]);
        if (length > bytes.size() - at - 12) throw std::runtime_error("is incomplete: the PNG file ends too early");
        const auto is = [&](const char* name) { return std::memcmp(&bytes[at + 4], name, 4) == 0; };
        if (crc32(0, &bytes[at + 4], static_cast<uInt>(length + 4)) != big_endian(&bytes[at + 8 + length]))
            throw std::runtime_error("is damaged: a PNG check sum is wrong");
        if (is("acTL")) throw std::runtime_error("is an animated PNG; save one of its frames as a picture");
        if (is("IDAT")) data += length;
        has_palette = has_palette || is("PLTE");
        ended = is("IEND");
        at += 12 + length;
    }
    if (data == 0) throw std::runtime_error("is damaged: the PNG file has no pixel data");
    if (bytes[25] == PNG_COLOR_TYPE_PALETTE && !has_palette)
        throw std::runtime_error("is damaged: the PNG file lacks its palette");
    return data;
}

/// Where libpng reads from, and where it jumps to on errors.
struct Source {
    const Bytes& bytes;
    std::size_t at = 0;
    std::jmp_buf escape{};
};

void give_bytes(png_structp png, png_bytep target, std::size_t count) {
    auto& source = *static_cast<Source*>(png_get_io_ptr(png));
    if (count > source.bytes.size() - source.at) png_error(png, "end of file");
    std::memcpy(target, source.bytes.data() + source.at, count);
    source.at += count;
}

[[noreturn]] void escape(png_structp png, png_const_charp) {
    std::longjmp(static_cast<Source*>(png_get_error_ptr(png))->escape, 1); // NOLINT(cert-err52-cpp)
}
void ignore(png_structp, png_const_charp) {}

/// libpng's state for one picture.
class Png {
public:
    explicit Png(Source& source)
        : read_(png_create_read_struct(PNG_LIBPNG_VER_STRING, &source, escape, ignore)),
          info_(read_ == nullptr ? nullptr : png_create_info_struct(read_)) {
        if (info_ == nullptr) throw std::runtime_error("cannot be read: out of memory");
    }
    ~Png() { png_destroy_read_struct(&read_, &info_, nullptr); }
    Png(const Png&) = delete;
    Png& operator=(const Png&) = delete;
    png_structp read() const { return read_; }
    png_infop info() const { return info_; }

private:
    png_structp read_;
    png_infop info_;
};

void read_header(Source& source, const Png& png) {
    png_set_read_fn(png.read(), &source, give_bytes);
    png_set_user_limits(png.read(), PNG_UINT_31_MAX, PNG_UINT_31_MAX); // ours are stricter
    // Nothing but the pixels, the palette and its transparency.
    png_set_keep_unknown_chunks(png.read(), PNG_HANDLE_CHUNK_NEVER, nullptr, -1);
    png_read_info(png.read(), png.info());
    if (png_get_color_type(png.read(), png.info()) == PNG_COLOR_TYPE_PALETTE)
        png_set_packing(png.read()); // a byte for each number of a colour
    else
        png_set_expand(png.read()); // fewer bits to 8, tRNS to alpha
    if constexpr (std::endian::native == std::endian::little) png_set_swap(png.read());
    png_set_interlace_handling(png.read());
    png_read_update_info(png.read(), png.info());
}

/// Puts colours for their numbers. libpng itself shows numbers that are not in the palette black.
Image with_palette(const Image& numbers, const Png& png) {
    png_colorp colours = nullptr;
    png_bytep alpha = nullptr;
    int count = 0, alpha_count = 0;
    png_get_PLTE(png.read(), png.info(), &colours, &count);
    if (png_get_tRNS(png.read(), png.info(), &alpha, &alpha_count, nullptr) == 0) alpha_count = 0;
    Image image{numbers.width, numbers.height, alpha_count > 0 ? 4 : 3, {}};
    image.pixels.reserve(numbers.pixels.size() * image.channels);
    for (const std::uint16_t number : numbers.pixels) {
        if (number >= count) throw std::runtime_error("is damaged: a pixel's colour is not in the palette");
        const png_color& colour = colours[number];
        image.pixels.insert(image.pixels.end(), {colour.red, colour.green, colour.blue});
        if (alpha_count > 0) image.pixels.push_back(number < alpha_count ? alpha[number] : 255);
    }
    return image;
}

void copy_row(const std::uint8_t* row, std::size_t values, int bits, std::uint16_t* target) {
    if (bits == 16)
        std::memcpy(target, row, values * sizeof(std::uint16_t));
    else
        std::copy_n(row, values, target);
}

} // namespace

PictureSize png_size(const Bytes& start) {
    if (start.size() < header_end) throw std::runtime_error("is incomplete: the PNG file ends too early");
    if (std::memcmp(&start[8], "\0\0\0\x0dIHDR", 8) != 0)
        throw std::runtime_error("is damaged: the PNG file has no header");
    const std::int64_t width = big_endian(&start[16]), height = big_endian(&start[20]);
    check_pixels(width, height);
    return {static_cast<int>(width), static_cast<int>(height), start[24] == 16 ? 16 : 8};
}

Image read_png(const Bytes& bytes) {
    const PictureSize size = png_size(bytes);
    const std::size_t data = check_chunks(bytes);
    constexpr int channels_of[] = {1, 0, 3, 1, 2, 0, 4, 0}; // by colour type
    check_ratio(packed_bytes(size.width, size.height, std::min<int>(bytes[24], 16) * channels_of[bytes[25] & 7]),
                static_cast<double>(data), deflate_ratio);

    Source source{bytes};
    const Png png(source);
    if (!completes(source.escape, [&] { read_header(source, png); }))
        throw std::runtime_error("is damaged or incomplete");
    Image image{size.width, size.height, png_get_channels(png.read(), png.info()), {}, size.bits};
    const std::size_t values = static_cast<std::size_t>(image.width) * image.channels;
    const std::size_t row_bytes = png_get_rowbytes(png.read(), png.info());
    if (row_bytes != values * (image.bits / 8)) throw std::runtime_error("is a kind of PNG that cannot be read");
    image.pixels.resize(values * image.height);
    // The passes of an interlaced picture fill all its rows bit by bit.
    const bool interlaced = bytes[28] != PNG_INTERLACE_NONE;
    const int passes = interlaced ? PNG_INTERLACE_ADAM7_PASSES : 1;
    Bytes rows(interlaced ? row_bytes * image.height : row_bytes);
    const bool whole = completes(source.escape, [&] {
        for (int pass = 0; pass < passes; ++pass)
            for (int row = 0; row < image.height; ++row) {
                std::uint8_t* line = rows.data() + (interlaced ? row_bytes * row : 0);
                png_read_row(png.read(), line, nullptr);
                if (pass + 1 == passes) copy_row(line, values, image.bits, image.pixels.data() + values * row);
            }
        png_read_end(png.read(), nullptr);
    });
    if (!whole) throw std::runtime_error("is damaged or incomplete");
    if (bytes[25] == PNG_COLOR_TYPE_PALETTE) return with_palette(image, png);
    return image;
}

} // namespace abut::formats
