// Which format a file is of, by its first bytes, and the checks that all readers share.
#include "geometry/images/formats.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <stdexcept>
#include <string>
#include <string_view>

namespace abut::formats {

namespace {

using namespace std::string_view_literals;

struct Signature {
    std::size_t at;
    std::string_view bytes;
    std::string_view name;
};

/// Formats that people try, and that we do not read.
constexpr Signature others[] = {
    {0, "GIF8"sv, "GIF picture"},           {0, "%PDF"sv, "PDF document"},
    {8, "WEBP"sv, "WebP picture"},          {128, "DICM"sv, "DICOM file"},
    {0, "8BPS"sv, "Photoshop file"},        {0, "NRRD"sv, "NRRD volume"},
    {4, "jP  \r\n"sv, "JPEG 2000 picture"}, {0, "\xff\x4f\xff\x51"sv, "JPEG 2000 picture"},
    {4, "ftypheic"sv, "HEIC picture"},      {4, "ftypavif"sv, "AVIF picture"},
    {0, "\x89HDF"sv, "HDF5 file"},          {0, "# vtk DataFile"sv, "legacy VTK file"},
    {344, "n+1\0"sv, "NIfTI volume"},       {344, "ni1\0"sv, "NIfTI volume"},
    {0, "\x1f\x8b"sv, "gzip-packed file"},  {0, "PK\x03\x04"sv, "ZIP archive"},
};

} // namespace

Bytes bytes_of(const std::filesystem::path& file, std::size_t most) {
    namespace fs = std::filesystem;
    std::error_code error;
    const fs::file_status status = fs::status(file, error);
    if (!fs::exists(status)) throw std::runtime_error("does not exist");
    if (fs::is_directory(status)) throw std::runtime_error("is a folder, not a file");
    if (!fs::is_regular_file(status)) throw std::runtime_error("is not an ordinary file");
    std::ifstream stream(file, std::ios::binary);
    if (!stream) throw std::runtime_error("cannot be opened for reading");
    const std::uintmax_t size = fs::file_size(file, error);
    if (error) throw std::runtime_error("cannot be read");
    if (size == 0) throw std::runtime_error("is empty (0 bytes)");
    Bytes bytes(static_cast<std::size_t>(std::min<std::uintmax_t>(size, most)));
    stream.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    if (stream.bad() || static_cast<std::size_t>(stream.gcount()) != bytes.size())
        throw std::runtime_error("cannot be read");
    return bytes;
}

Format format_of(const std::filesystem::path& file) {
    const Bytes start = bytes_of(file, 4096);
    const std::string_view text(reinterpret_cast<const char*>(start.data()), start.size());
    if (text.starts_with("\x89PNG\r\n\x1a\n"sv)) return Format::png;
    if (text.starts_with("\xff\xd8\xff"sv)) return Format::jpeg;
    for (const std::string_view tiff : {"II*\0"sv, "MM\0*"sv, "II+\0"sv, "MM\0+"sv})
        if (text.starts_with(tiff)) return Format::tiff;
    if (text.starts_with("BM"sv)) return Format::bmp;
    if (text.find("<VTKFile"sv) != std::string_view::npos) {
        if (text.find("\"ImageData\""sv) != std::string_view::npos ||
            text.find("'ImageData'"sv) != std::string_view::npos)
            return Format::vti;
        throw std::runtime_error("is a VTK file of another kind; save it as image data (.vti)");
    }
    for (const Signature& other : others)
        if (text.size() > other.at && text.substr(other.at).starts_with(other.bytes))
            throw std::runtime_error(fmt::format("is a {}; save it as PNG or TIFF", other.name));
    if (text.find("<svg"sv) != std::string_view::npos) throw std::runtime_error("is an SVG drawing; save it as PNG");
    throw std::runtime_error("is not a PNG, BMP, TIFF, JPEG or VTI picture");
}

void check_pixels(std::int64_t width, std::int64_t height) {
    if (width <= 0 || height <= 0) throw std::runtime_error("has no pixels (its width or height is 0)");
    if (width > most_pixels / height)
        throw std::runtime_error(fmt::format(
            "claims {} x {} pixels; at most {} in all can be read; cut it or shrink it", width, height, most_pixels));
}

double packed_bytes(double width, double height, int bits_per_pixel) {
    return height * std::ceil(width * bits_per_pixel / 8);
}

void check_ratio(double unpacked, double packed, double ratio) {
    if (unpacked > packed * ratio)
        throw std::runtime_error("is damaged or incomplete: a file of this size cannot hold the pixels that it claims");
}

} // namespace abut::formats
