// Through libtiff itself: VTK 9.1's reader returns some kinds of TIFF upside down and others (bilevel, CMYK, alpha)
// wrong.
#include "geometry/images/formats.h"

#include <fmt/format.h>
#include <tiffio.h>

#include <memory>
#include <stdexcept>

namespace abut::formats {

namespace {

/// libtiff prints its errors to stderr; ours go into exceptions instead.
class QuietTiff {
public:
    QuietTiff() : error_(TIFFSetErrorHandler(nullptr)), warning_(TIFFSetWarningHandler(nullptr)) {}
    ~QuietTiff() {
        TIFFSetErrorHandler(error_);
        TIFFSetWarningHandler(warning_);
    }
    QuietTiff(const QuietTiff&) = delete;
    QuietTiff& operator=(const QuietTiff&) = delete;

private:
    TIFFErrorHandler error_, warning_;
};

struct Close {
    void operator()(TIFF* tiff) const { TIFFClose(tiff); }
};

std::uint16_t tag(TIFF* tiff, std::uint32_t name) {
    std::uint16_t value = 0;
    TIFFGetFieldDefaulted(tiff, name, &value);
    return value;
}

} // namespace

Image read_tiff(const std::filesystem::path& file) {
    const QuietTiff quiet;
    const std::unique_ptr<TIFF, Close> tiff(TIFFOpen(file.c_str(), "r"));
    if (!tiff) throw std::runtime_error("is damaged or incomplete");
    const int pages = TIFFNumberOfDirectories(tiff.get());
    if (pages > 1) throw std::runtime_error(fmt::format("is a stack of {} pages; save one page as a picture", pages));

    const int bits = tag(tiff.get(), TIFFTAG_BITSPERSAMPLE);
    if (bits == 16) throw std::runtime_error("has 16 bit; save it with 8 bits per channel");
    if (bits > 8) throw std::runtime_error(fmt::format("has {} bit; save it with 8 bits per channel", bits));
    std::uint32_t width = 0, height = 0;
    TIFFGetField(tiff.get(), TIFFTAG_IMAGEWIDTH, &width);
    TIFFGetField(tiff.get(), TIFFTAG_IMAGELENGTH, &height);
    if (width == 0 || height == 0) throw std::runtime_error("has no pixels (its width or height is 0)");
    char reason[1024] = "";
    if (!TIFFRGBAImageOK(tiff.get(), reason))
        throw std::runtime_error(fmt::format("is a kind of TIFF that cannot be read ({})", reason));

    std::vector<std::uint32_t> raster(static_cast<std::size_t>(width) * height);
    constexpr int stop_on_error = 1;
    if (!TIFFReadRGBAImageOriented(tiff.get(), width, height, raster.data(), ORIENTATION_TOPLEFT, stop_on_error))
        throw std::runtime_error("is damaged or incomplete");

    const int kind = tag(tiff.get(), TIFFTAG_PHOTOMETRIC);
    const bool grey = (kind == PHOTOMETRIC_MINISBLACK || kind == PHOTOMETRIC_MINISWHITE);
    Image image{static_cast<int>(width), static_cast<int>(height), grey ? 2 : 4, {}};
    image.pixels.reserve(raster.size() * image.channels);
    for (const std::uint32_t pixel : raster) {
        image.pixels.push_back(TIFFGetR(pixel));
        if (!grey) {
            image.pixels.push_back(TIFFGetG(pixel));
            image.pixels.push_back(TIFFGetB(pixel));
        }
        image.pixels.push_back(TIFFGetA(pixel));
    }
    return image;
}

} // namespace abut::formats
