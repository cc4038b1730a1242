#include "geometry/images/image.h"

#include "geometry/images/formats.h"

#include <fmt/format.h>

#include <cstring>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string_view>

namespace abut {

namespace {

formats::Bytes bytes_of(const std::filesystem::path& file) {
    namespace fs = std::filesystem;
    std::error_code error;
    const fs::file_status status = fs::status(file, error);
    if (!fs::exists(status)) throw std::runtime_error("does not exist");
    if (fs::is_directory(status)) throw std::runtime_error("is a folder, not a file");
    std::ifstream stream(file, std::ios::binary);
    if (!stream) throw std::runtime_error("cannot be opened for reading");
    formats::Bytes bytes{std::istreambuf_iterator<char>(stream), {}};
    if (stream.bad()) throw std::runtime_error("cannot be read");
    if (bytes.empty()) throw std::runtime_error("is empty (0 bytes)");
    return bytes;
}

bool starts_with(const formats::Bytes& bytes, std::string_view signature) {
    return bytes.size() >= signature.size() && std::memcmp(bytes.data(), signature.data(), signature.size()) == 0;
}

Image decode(const std::filesystem::path& file, const formats::Bytes& bytes) {
    using namespace std::string_view_literals;
    if (starts_with(bytes, "\x89PNG\r\n\x1a\n"sv)) {
        formats::check_png(bytes);
        return formats::read_png(file);
    }
    if (starts_with(bytes, "\xff\xd8\xff"sv)) return formats::read_jpeg(file);
    if (starts_with(bytes, "II*\0"sv) || starts_with(bytes, "MM\0*"sv) || starts_with(bytes, "II+\0"sv) ||
        starts_with(bytes, "MM\0+"sv))
        return formats::read_tiff(file);
    if (starts_with(bytes, "BM"sv)) return formats::read_bmp(bytes);
    throw std::runtime_error("is not a PNG, BMP, TIFF or JPEG picture");
}

/// Drops an alpha channel that says nothing; the particles need to know each pixel's colour for certain.
Image without_alpha(const Image& image) {
    if (image.channels == 1 || image.channels == 3) return image;
    Image opaque{image.width, image.height, image.channels - 1, {}};
    const std::size_t count = image.pixels.size() / image.channels;
    opaque.pixels.reserve(count * opaque.channels);
    std::size_t transparent = 0;
    for (std::size_t pixel = 0; pixel < count; ++pixel) {
        const std::uint16_t* channel = &image.pixels[pixel * image.channels];
        opaque.pixels.insert(opaque.pixels.end(), channel, channel + opaque.channels);
        if (channel[opaque.channels] != 255) ++transparent;
    }
    if (transparent > 0)
        throw std::runtime_error(fmt::format("has transparency at {} pixel{}; flatten it (remove its alpha channel)",
                                             transparent, transparent == 1 ? "" : "s"));
    return opaque;
}

} // namespace

Image read_image(const std::filesystem::path& file) {
    try {
        return without_alpha(decode(file, bytes_of(file)));
    } catch (const std::runtime_error& error) {
        throw std::runtime_error(fmt::format("image \"{}\" {}", file.string(), error.what()));
    }
}

} // namespace abut
