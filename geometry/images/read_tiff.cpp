// Through libtiff itself: VTK 9.1's reader returns some kinds of TIFF upside down and others (bilevel, CMYK, alpha)
// wrong.
#include "geometry/images/open_tiff.h"
#include "geometry/images/tiff_page.h"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <fstream>
#include <memory>
#include <stdexcept>
#include <string_view>

namespace abut::formats {

namespace {

/// The pages of a TIFF file that are slices, one after the other.
class Pages {
public:
    explicit Pages(const std::filesystem::path& file) : file_(file), size_(std::filesystem::file_size(file)) {
        rewind();
    }
    Pages(const Pages&) = delete;
    Pages& operator=(const Pages&) = delete;

    void rewind() {
        // What libtiff allocates: tables of a directory, a strip as it is stored, and rows for its decoders.
        constexpr std::ptrdiff_t for_rows = std::ptrdiff_t{1} << 26;
        tiff_ = open_tiff_quietly(file_, "rm", for_rows + static_cast<std::ptrdiff_t>(16 * size_), &guessed_);
        if (!tiff_) throw std::runtime_error("is damaged or incomplete");
        slice_ = -1;
        begun_ = false;
    }

    /// Goes to the next page that is a slice. \return false after the last
    bool next() {
        do {
            if (begun_ && TIFFLastDirectory(tiff_.get())) {
                check_end();
                return false;
            }
            if (begun_ && !TIFFReadDirectory(tiff_.get())) throw std::runtime_error("is damaged or incomplete");
            begun_ = true;
        } while (thumbnail_or_mask());
        ++slice_;
        return true;
    }

    TIFF* tiff() const { return tiff_.get(); }
    int slice() const { return slice_; } ///< -1 before the first
    TiffPage page() const { return tiff_page(tiff_.get(), static_cast<double>(size_)); }
    Image pixels() {
        guessed_ = false;
        Image image = read_tiff_page(tiff_.get(), page());
        if (guessed_) throw std::runtime_error("is damaged or incomplete");
        return image;
    }

private:
    std::filesystem::path file_;
    std::uintmax_t size_;
    bool guessed_ = false; ///< libtiff keeps a pointer to it
    Tiff tiff_;
    int slice_ = -1;
    bool begun_ = false; ///< opening a file reads its first page

    /// libtiff takes a file that is cut off before the place of the next page for one without a next page.
    void check_end() const {
        std::ifstream stream(file_, std::ios::binary);
        const std::uint64_t start = TIFFCurrentDirOffset(tiff_.get());
        stream.seekg(static_cast<std::streamoff>(start));
        const bool big = TIFFIsBigTIFF(tiff_.get()) != 0;
        const std::size_t word = big ? 8 : 2; // of the number of entries
        std::array<char, 8> bytes{};
        stream.read(bytes.data(), static_cast<std::streamsize>(word));
        std::uint64_t entries = 0;
        for (std::size_t k = 0; k < word; ++k) {
            const std::size_t from_low = TIFFIsBigEndian(tiff_.get()) != 0 ? word - 1 - k : k;
            entries |= std::uint64_t{static_cast<std::uint8_t>(bytes[k])} << (8 * from_low);
        }
        const std::uint64_t end = start + word + entries * (big ? 20 : 12) + (big ? 8 : 4);
        if (!stream || entries > size_ || end > size_)
            throw std::runtime_error("is incomplete: the TIFF file ends too early");
    }

    bool thumbnail_or_mask() const {
        std::uint32_t kind = 0;
        TIFFGetFieldDefaulted(tiff_.get(), TIFFTAG_SUBFILETYPE, &kind);
        return (kind & (FILETYPE_REDUCEDIMAGE | FILETYPE_MASK)) != 0;
    }
};

/// ImageJ writes what does not fit into 4 GB as one page, with the other slices behind it where no page points to.
int slices_of_imagej(TIFF* tiff) {
    const char* description = nullptr;
    if (TIFFGetField(tiff, TIFFTAG_IMAGEDESCRIPTION, &description) != 1 || description == nullptr) return 0;
    const std::string_view text = description, key = "\nimages=";
    const std::size_t at = text.find(key);
    int slices = 0;
    if (text.starts_with("ImageJ=") && at != std::string_view::npos)
        std::from_chars(text.data() + at + key.size(), text.data() + text.size(), slices);
    return slices;
}

std::string words(const PictureSize& size) {
    return fmt::format("{} x {} pixels of {} bits", size.width, size.height, size.bits);
}

} // namespace

StackInfo tiff_info(const std::filesystem::path& file) {
    Pages pages(file);
    PictureSize first;
    int announced = 0;
    while (pages.next()) {
        PictureSize size;
        try {
            size = pages.page().size();
        } catch (const std::runtime_error& error) {
            if (pages.slice() == 0) throw;
            throw std::runtime_error(fmt::format("{} (its page {})", error.what(), pages.slice() + 1));
        }
        if (pages.slice() == 0) {
            first = size;
            announced = slices_of_imagej(pages.tiff());
        }
        if (size != first)
            throw std::runtime_error(fmt::format("is a stack of unequal slices: page {} has {}, the first has {}",
                                                 pages.slice() + 1, words(size), words(first)));
    }
    if (pages.slice() < 0) throw std::runtime_error("holds thumbnails or masks only, no picture");
    if (pages.slice() == 0 && announced > 1)
        throw std::runtime_error(
            fmt::format("is a stack of {} slices of which only the first is a TIFF page, as ImageJ "
                        "writes more than 4 GB; save it as an image sequence (numbered files)",
                        announced));
    return {first.width, first.height, pages.slice() + 1, first.bits, {}};
}

SliceReader open_tiff(const std::filesystem::path& file) {
    return [pages = std::make_shared<Pages>(file)](int slice) {
        if (slice <= pages->slice()) pages->rewind();
        while (pages->slice() < slice)
            if (!pages->next()) throw std::runtime_error("is damaged or incomplete");
        return pages->pixels();
    };
}

} // namespace abut::formats
