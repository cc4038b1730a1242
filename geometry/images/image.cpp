#include "geometry/images/image.h"

#include "geometry/images/formats.h"
#include "geometry/images/numbered_files.h"

#include <fmt/format.h>

#include <new>
#include <stdexcept>
#include <string>
#include <utility>

namespace abut {

namespace {

using formats::Format;
using formats::PictureSize;
using formats::SliceReader;

/// Puts the name of the file before the message of an error.
template <class Act>
auto naming(const std::filesystem::path& file, const Act& act) {
    try {
        return act();
    } catch (const std::bad_alloc&) {
        throw std::runtime_error(fmt::format("image \"{}\" is too large for this computer's memory", file.string()));
    } catch (const std::exception& error) {
        throw std::runtime_error(fmt::format("image \"{}\" {}", file.string(), error.what()));
    }
}

/// Drops an alpha channel that says nothing; the particles need to know each pixel's colour for certain.
void drop_alpha(Image& image) {
    if (image.channels == 1 || image.channels == 3) return;
    const std::size_t stored = image.channels, kept = stored - 1;
    const std::size_t count = image.pixels.size() / stored;
    const int opaque = (1 << image.bits) - 1;
    std::size_t transparent = 0;
    for (std::size_t pixel = 0; pixel < count; ++pixel) {
        for (std::size_t c = 0; c < kept; ++c) image.pixels[pixel * kept + c] = image.pixels[pixel * stored + c];
        // The alpha of this pixel is overwritten by later ones only.
        if (image.pixels[pixel * stored + kept] != opaque) ++transparent;
    }
    if (transparent > 0)
        throw std::runtime_error(fmt::format("has transparency at {} pixel{}; flatten it (remove its alpha channel)",
                                             transparent, transparent == 1 ? "" : "s"));
    image.channels = static_cast<int>(kept);
    image.pixels.resize(count * kept);
}

StackInfo info_of(const std::filesystem::path& file) {
    constexpr std::size_t header = 256; // longer than those of PNG and BMP
    const auto single = [](const PictureSize& size) { return StackInfo{size.width, size.height, 1, size.bits, {}}; };
    switch (formats::format_of(file)) {
    case Format::png:
        return single(formats::png_size(formats::bytes_of(file, header)));
    case Format::bmp:
        return single(formats::bmp_size(formats::bytes_of(file, header)));
    case Format::jpeg:
        return single(formats::jpeg_size(formats::bytes_of(file)));
    case Format::tiff:
        return formats::tiff_info(file);
    case Format::vti:
        return formats::vti_info(file);
    }
    throw std::logic_error("unknown picture format");
}

SliceReader open(const std::filesystem::path& file) {
    switch (formats::format_of(file)) {
    case Format::png:
        return [file](int) { return formats::read_png(formats::bytes_of(file)); };
    case Format::bmp:
        return [file](int) { return formats::read_bmp(formats::bytes_of(file)); };
    case Format::jpeg:
        return [file](int) { return formats::read_jpeg(formats::bytes_of(file)); };
    case Format::tiff:
        return formats::open_tiff(file);
    case Format::vti:
        return formats::open_vti(file);
    }
    throw std::logic_error("unknown picture format");
}

void check_single(const StackInfo& info) {
    if (info.slices > 1)
        throw std::runtime_error(
            fmt::format("is a stack of {} slices; for a plane scene, choose one by \"slice\"", info.slices));
}

Image read_single(const std::filesystem::path& file) {
    return naming(file, [&] {
        check_single(info_of(file));
        Image image = open(file)(0);
        drop_alpha(image);
        return image;
    });
}

/// Size and depth of the first file, after making sure that all others have the same.
StackInfo info_of_numbered(const std::filesystem::path& pattern, const std::vector<std::filesystem::path>& files) {
    const auto single_info = [](const std::filesystem::path& file) {
        return naming(file, [&] {
            StackInfo info = info_of(file);
            check_single(info);
            return info;
        });
    };
    StackInfo stack = single_info(files.front());
    for (const std::filesystem::path& file : files) {
        const StackInfo info = single_info(file);
        if (info.width != stack.width || info.height != stack.height || info.bits != stack.bits)
            throw std::runtime_error(fmt::format(
                "image \"{}\" is a stack of unequal slices: {} has {} x {} pixels of {} bits, {} has {} x {} "
                "of {} bits",
                pattern.string(), file.filename().string(), info.width, info.height, info.bits,
                files.front().filename().string(), stack.width, stack.height, stack.bits));
    }
    stack.slices = static_cast<int>(files.size());
    stack.spacing.reset(); // from file to file it is not known
    return stack;
}

std::vector<std::filesystem::path> files_of(const std::filesystem::path& pattern) {
    return naming(pattern, [&] { return numbered_files(pattern); });
}

} // namespace

Image read_image(const std::filesystem::path& file) {
    if (!has_star(file)) return read_single(file);
    const std::vector<std::filesystem::path> files = files_of(file);
    naming(file, [&] { check_single({0, 0, static_cast<int>(files.size()), 8, {}}); });
    return read_single(files.front());
}

StackInfo read_stack_info(const std::filesystem::path& file) {
    if (!has_star(file)) return naming(file, [&] { return info_of(file); });
    return info_of_numbered(file, files_of(file));
}

void read_stack(const std::filesystem::path& file, int first, int last,
                const std::function<void(int slice, const Image& image)>& visit) {
    const int slices = read_stack_info(file).slices;
    if (first < 0 || last < first || last >= slices)
        throw std::runtime_error(
            fmt::format("image \"{}\" has the slices 0 to {}, not {} to {}", file.string(), slices - 1, first, last));
    if (has_star(file)) {
        const std::vector<std::filesystem::path> files = files_of(file);
        for (int slice = first; slice <= last; ++slice) visit(slice, read_single(files.at(slice)));
        return;
    }
    const SliceReader read = naming(file, [&] { return open(file); });
    for (int slice = first; slice <= last; ++slice) {
        const Image image = naming(file, [&] {
            Image pixels = read(slice);
            drop_alpha(pixels);
            return pixels;
        });
        visit(slice, image); // whose errors are not the file's
    }
}

} // namespace abut
