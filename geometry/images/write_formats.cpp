#include "geometry/images/write_formats.h"

#include "geometry/images/c_library.h"
#include "geometry/images/open_tiff.h"

#include <fmt/format.h>
#include <png.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <fstream>
#include <stdexcept>
#include <vector>

namespace abut::formats {

namespace {

using Bytes = std::vector<std::uint8_t>;

[[noreturn]] void fail() {
    throw std::runtime_error("the disk is full or cannot be written to");
}

std::size_t values_per_row(const Image& image) {
    return static_cast<std::size_t>(image.width) * image.channels;
}

/// A row of values, in the machine's byte order.
void pack_row(const Image& image, int row, std::uint8_t* target) {
    const std::uint16_t* values = image.pixels.data() + values_per_row(image) * row;
    if (image.bits == 16)
        std::memcpy(target, values, values_per_row(image) * 2);
    else
        std::transform(values, values + values_per_row(image), target,
                       [](std::uint16_t value) { return static_cast<std::uint8_t>(value); });
}

// === PNG

/// Where libpng writes to, and where it jumps to on errors.
struct Target {
    std::ofstream stream;
    std::jmp_buf escape{};
};

void take_bytes(png_structp png, png_bytep bytes, std::size_t count) {
    auto& target = *static_cast<Target*>(png_get_io_ptr(png));
    if (!target.stream.write(reinterpret_cast<const char*>(bytes), static_cast<std::streamsize>(count)))
        png_error(png, "cannot write");
}
void flush(png_structp) {}
[[noreturn]] void escape(png_structp png, png_const_charp) {
    std::longjmp(static_cast<Target*>(png_get_error_ptr(png))->escape, 1); // NOLINT(cert-err52-cpp)
}
void ignore(png_structp, png_const_charp) {}

/// libpng's state for one picture.
class Png {
public:
    explicit Png(Target& target)
        : write_(png_create_write_struct(PNG_LIBPNG_VER_STRING, &target, escape, ignore)),
          info_(write_ == nullptr ? nullptr : png_create_info_struct(write_)) {
        if (info_ == nullptr) throw std::runtime_error("out of memory");
    }
    ~Png() { png_destroy_write_struct(&write_, &info_); }
    Png(const Png&) = delete;
    Png& operator=(const Png&) = delete;
    png_structp write() const { return write_; }
    png_infop info() const { return info_; }

private:
    png_structp write_;
    png_infop info_;
};

} // namespace

void write_png(const Image& image, const std::filesystem::path& file) {
    Target target{std::ofstream(file, std::ios::binary)};
    const Png png(target);
    Bytes row(values_per_row(image) * (image.bits / 8));
    const bool whole = completes(target.escape, [&] {
        png_set_write_fn(png.write(), &target, take_bytes, flush);
        png_set_user_limits(png.write(), PNG_UINT_31_MAX, PNG_UINT_31_MAX);
        png_set_IHDR(png.write(), png.info(), image.width, image.height, image.bits,
                     image.channels == 1 ? PNG_COLOR_TYPE_GRAY : PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE,
                     PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
        png_write_info(png.write(), png.info());
        if (image.bits == 16 && std::endian::native == std::endian::little) png_set_swap(png.write());
        for (int y = 0; y < image.height; ++y) {
            pack_row(image, y, row.data());
            png_write_row(png.write(), row.data());
        }
        png_write_end(png.write(), nullptr);
    });
    target.stream.close();
    if (!whole || !target.stream) fail();
}

// === BMP

void write_bmp(const Image& image, const std::filesystem::path& file) {
    const std::size_t stride = (static_cast<std::size_t>(image.width) * 3 + 3) / 4 * 4;
    constexpr std::size_t header = 14 + 40;
    const std::size_t size = header + stride * image.height;
    if (size > 0xffffffffU) throw std::runtime_error("the picture is too large for BMP; write PNG or TIFF");
    Bytes start{'B', 'M'};
    const auto push = [&](std::size_t value, int count) { // little-endian
        for (int i = 0; i < count; ++i) start.push_back(static_cast<std::uint8_t>(value >> (8 * i)));
    };
    push(size, 4);
    push(0, 4);
    push(header, 4);
    push(40, 4);
    push(image.width, 4);
    push(image.height, 4); // above 0: the lowest row comes first
    push(1, 2);
    push(24, 2);
    push(0, 4); // uncompressed
    push(stride * image.height, 4);
    for (int unused = 0; unused < 4; ++unused) push(0, 4); // resolution and palette
    std::ofstream stream(file, std::ios::binary);
    const auto write = [&](const Bytes& bytes) {
        stream.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    };
    write(start);
    Bytes line(stride, 0);
    for (int row = image.height - 1; row >= 0; --row) {
        for (int column = 0; column < image.width; ++column) {
            const std::array<int, 3> rgb = image.rgb(column, row);
            for (std::size_t c = 0; c < 3; ++c)
                line[3 * static_cast<std::size_t>(column) + c] = static_cast<std::uint8_t>(rgb[2 - c]);
        }
        write(line);
    }
    stream.close();
    if (!stream) fail();
}

// === TIFF

namespace {

void write_page(TIFF* tiff, const Image& image) {
    TIFFSetField(tiff, TIFFTAG_IMAGEWIDTH, static_cast<std::uint32_t>(image.width));
    TIFFSetField(tiff, TIFFTAG_IMAGELENGTH, static_cast<std::uint32_t>(image.height));
    TIFFSetField(tiff, TIFFTAG_BITSPERSAMPLE, image.bits);
    TIFFSetField(tiff, TIFFTAG_SAMPLESPERPIXEL, image.channels);
    TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC, image.channels == 1 ? PHOTOMETRIC_MINISBLACK : PHOTOMETRIC_RGB);
    TIFFSetField(tiff, TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG);
    TIFFSetField(tiff, TIFFTAG_ORIENTATION, ORIENTATION_TOPLEFT);
    TIFFSetField(tiff, TIFFTAG_COMPRESSION, COMPRESSION_LZW);
    TIFFSetField(tiff, TIFFTAG_ROWSPERSTRIP, TIFFDefaultStripSize(tiff, 0));
    Bytes row(values_per_row(image) * (image.bits / 8));
    for (int y = 0; y < image.height; ++y) {
        pack_row(image, y, row.data());
        if (TIFFWriteScanline(tiff, row.data(), static_cast<std::uint32_t>(y), 0) != 1) fail();
    }
}

} // namespace

void write_tiff(int slices, const std::function<Image(int slice)>& slice, const std::filesystem::path& file) {
    Image image = slice(0);
    check_image(image);
    const int width = image.width, height = image.height, bits = image.bits;
    // LZW can make 1.5 times as much of data that does not repeat; a classic TIFF ends at 4 GB.
    const double most_bytes = 1.5 * slices * static_cast<double>(image.pixels.size()) * bits / 8 + 1e3 * slices;
    const Tiff tiff = open_tiff_quietly(file, most_bytes < 4e9 ? "w" : "w8");
    if (!tiff) fail();
    for (int number = 0; number < slices; ++number) {
        if (number > 0) {
            image = slice(number);
            check_image(image);
        }
        if (image.width != width || image.height != height || image.bits != bits)
            throw std::runtime_error(fmt::format("slice {} differs in size or depth from slice 0", number));
        if (slices > 1) TIFFSetField(tiff.get(), TIFFTAG_SUBFILETYPE, FILETYPE_PAGE);
        write_page(tiff.get(), image);
        if (TIFFWriteDirectory(tiff.get()) != 1) fail();
    }
}

} // namespace abut::formats
