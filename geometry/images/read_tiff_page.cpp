// Strips and tiles to pixels. libtiff's own conversion to RGBA gives 8 bits only.
#include "geometry/images/tiff_page.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <stdexcept>

namespace abut::formats {

namespace {

/// A strip or a tile: where it lies in the picture as stored, and its unpacked bytes.
struct Piece {
    int column = 0, row = 0, columns = 0, rows = 0; ///< the part that lies inside the picture
    int samples = 0;                                ///< values per pixel: all, or 1 of a plane
    int first_sample = 0;
    std::size_t row_bytes = 0;
    const std::uint8_t* data = nullptr;
};

/// Puts stored values where they belong in the picture.
class Canvas {
public:
    Canvas(TIFF* tiff, const TiffPage& page)
        : page_(page), most_((1 << page.bits) - 1), image{page.size().width,
                                                          page.size().height,
                                                          page.channels(),
                                                          {},
                                                          page.size().bits} {
        if (page.palette() && TIFFGetField(tiff, TIFFTAG_COLORMAP, palette_.data(), &palette_[1], &palette_[2]) != 1)
            throw std::runtime_error("is damaged: the TIFF file lacks its palette");
        if (page.palette()) { // old files count to 255, not to 65535
            const auto small = [&](const std::uint16_t* map) {
                return std::all_of(map, map + most_ + 1, [](std::uint16_t value) { return value < 256; });
            };
            palette_shift_ = std::all_of(palette_.begin(), palette_.end(), small) ? 0 : 8;
        }
        image.pixels.resize(static_cast<std::size_t>(image.width) * image.height * image.channels);
    }

    void paint(const Piece& piece) {
        for (int row = 0; row < piece.rows; ++row) {
            const std::uint8_t* line = piece.data + piece.row_bytes * row;
            std::size_t value = 0;
            for (int column = 0; column < piece.columns; ++column) {
                std::uint16_t* pixel = &image.pixels[place(piece.column + column, piece.row + row) * image.channels];
                for (int sample = 0; sample < piece.samples; ++sample)
                    put(pixel, piece.first_sample + sample, stored(line, value++));
            }
        }
    }

private:
    TiffPage page_;
    int most_; ///< largest stored value
    std::array<std::uint16_t*, 3> palette_{};
    int palette_shift_ = 0;

public:
    Image image;

private:
    /// Number of the pixel in the picture as it is shown.
    std::size_t place(int column, int row) const {
        const int right = page_.width - 1 - column, below = page_.height - 1 - row;
        const auto at = [&](int x, int y) { return static_cast<std::size_t>(y) * image.width + x; };
        switch (page_.orientation) {
        case ORIENTATION_TOPRIGHT:
            return at(right, row);
        case ORIENTATION_BOTRIGHT:
            return at(right, below);
        case ORIENTATION_BOTLEFT:
            return at(column, below);
        case ORIENTATION_LEFTTOP:
            return at(row, column);
        case ORIENTATION_RIGHTTOP:
            return at(below, column);
        case ORIENTATION_RIGHTBOT:
            return at(below, right);
        case ORIENTATION_LEFTBOT:
            return at(row, right);
        default:
            return at(column, row);
        }
    }

    int stored(const std::uint8_t* line, std::size_t index) const {
        if (page_.bits == 8) return line[index];
        if (page_.bits == 16) { // libtiff has brought it into the machine's order
            std::uint16_t value = 0;
            std::memcpy(&value, line + 2 * index, 2);
            return value;
        }
        const std::size_t bit = index * page_.bits;
        const int used = static_cast<int>(bit % 8) + page_.bits;
        const int two_bytes = (line[bit / 8] << 8) | (used > 8 ? line[bit / 8 + 1] : 0);
        return (two_bytes >> (16 - used)) & most_;
    }

    void put(std::uint16_t* pixel, int sample, int value) const {
        const auto spread = [&] { // 0 .. 2^bits - 1 to 0 .. 255
            return static_cast<std::uint16_t>(page_.bits < 8 ? (value * 510 + most_) / (2 * most_) : value);
        };
        if (page_.palette() && sample == 0) {
            for (std::size_t c = 0; c < 3; ++c)
                pixel[c] = static_cast<std::uint16_t>(palette_[c][value] >> palette_shift_);
        } else if (page_.palette()) {
            pixel[3] = spread();
        } else {
            if (page_.photometric == PHOTOMETRIC_MINISWHITE && sample == 0) value = most_ - value;
            pixel[sample] = spread();
        }
    }
};

[[noreturn]] void fail() {
    throw std::runtime_error("is damaged or incomplete");
}

void paint_tiles(TIFF* tiff, const TiffPage& page, Canvas& canvas) {
    std::uint32_t width = 0, height = 0;
    TIFFGetField(tiff, TIFFTAG_TILEWIDTH, &width);
    TIFFGetField(tiff, TIFFTAG_TILELENGTH, &height);
    Piece tile;
    tile.samples = page.separate ? 1 : page.samples;
    tile.row_bytes = (static_cast<std::size_t>(width) * tile.samples * page.bits + 7) / 8;
    if (TIFFTileSize64(tiff) != tile.row_bytes * height) fail();
    Bytes data(tile.row_bytes * height);
    tile.data = data.data();
    for (int plane = 0; plane < (page.separate ? page.samples : 1); ++plane) {
        tile.first_sample = plane;
        // In 64 bits: a tile may be wider than the picture by more than an int holds.
        for (std::int64_t row = 0; row < page.height; row += height)
            for (std::int64_t column = 0; column < page.width; column += width) {
                const std::uint32_t number =
                    TIFFComputeTile(tiff, static_cast<std::uint32_t>(column), static_cast<std::uint32_t>(row), 0,
                                    static_cast<std::uint16_t>(plane));
                const auto size = static_cast<tmsize_t>(data.size());
                if (TIFFReadEncodedTile(tiff, number, data.data(), size) != size) fail();
                tile.column = static_cast<int>(column);
                tile.row = static_cast<int>(row);
                tile.columns = static_cast<int>(std::min<std::int64_t>(width, page.width - column));
                tile.rows = static_cast<int>(std::min<std::int64_t>(height, page.height - row));
                canvas.paint(tile);
            }
    }
}

void paint_strips(TIFF* tiff, const TiffPage& page, Canvas& canvas) {
    std::uint32_t height = 0;
    TIFFGetFieldDefaulted(tiff, TIFFTAG_ROWSPERSTRIP, &height);
    if (height == 0) fail();
    height = std::min(height, static_cast<std::uint32_t>(page.height));
    Piece strip;
    strip.columns = page.width;
    strip.samples = page.separate ? 1 : page.samples;
    strip.row_bytes = (static_cast<std::size_t>(page.width) * strip.samples * page.bits + 7) / 8;
    if (TIFFVStripSize64(tiff, height) != strip.row_bytes * height) fail();
    Bytes data(strip.row_bytes * height);
    strip.data = data.data();
    for (int plane = 0; plane < (page.separate ? page.samples : 1); ++plane) {
        strip.first_sample = plane;
        for (std::int64_t row = 0; row < page.height; row += height) {
            const std::uint32_t number =
                TIFFComputeStrip(tiff, static_cast<std::uint32_t>(row), static_cast<std::uint16_t>(plane));
            strip.row = static_cast<int>(row);
            strip.rows = static_cast<int>(std::min<std::int64_t>(height, page.height - row));
            const auto size = static_cast<tmsize_t>(strip.row_bytes * strip.rows);
            if (TIFFReadEncodedStrip(tiff, number, data.data(), size) != size) fail();
            canvas.paint(strip);
        }
    }
}

} // namespace

Image read_tiff_page(TIFF* tiff, const TiffPage& page) {
    if (page.photometric == PHOTOMETRIC_YCBCR) // only of JPEG, whose decoder converts
        TIFFSetField(tiff, TIFFTAG_JPEGCOLORMODE, JPEGCOLORMODE_RGB);
    Canvas canvas(tiff, page);
    if (TIFFIsTiled(tiff))
        paint_tiles(tiff, page, canvas);
    else
        paint_strips(tiff, page, canvas);
    return std::move(canvas.image);
}

} // namespace abut::formats
