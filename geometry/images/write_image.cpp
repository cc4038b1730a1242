#include "geometry/images/image.h"

#include "geometry/images/write_formats.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <fstream>
#include <stdexcept>
#include <string>

#include <unistd.h>

namespace abut {

namespace {

/// Removes a file when it goes out of scope; after a successful rename there is none.
struct RemoveAtEnd {
    std::filesystem::path file;
    ~RemoveAtEnd() {
        std::error_code ignored;
        std::filesystem::remove(file, ignored);
    }
};

std::string extension_of(const std::filesystem::path& file) {
    std::string extension = file.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return std::tolower(c); });
    return extension == ".tiff" ? ".tif" : extension;
}

[[noreturn]] void fail(const std::filesystem::path& file, const std::string& reason) {
    throw std::runtime_error(fmt::format("cannot write \"{}\": {}", file.string(), reason));
}

/// Lets \p write make the file under another name, and then renames it.
void write_whole(const std::filesystem::path& file, const std::function<void(const std::filesystem::path&)>& write) {
    // Beside the target, so that the rename stays within one file system.
    const RemoveAtEnd temporary{file.string() + fmt::format(".{}.part", getpid())};
    if (!std::ofstream(temporary.file)) fail(file, "no such folder, or no permission");
    try {
        write(temporary.file);
        std::filesystem::rename(temporary.file, file);
    } catch (const std::exception& error) {
        fail(file, error.what());
    }
}

} // namespace

void formats::check_image(const Image& image) {
    if (image.width <= 0 || image.height <= 0) throw std::runtime_error("the picture has no pixels");
    if ((image.channels != 1 && image.channels != 3) || (image.bits != 8 && image.bits != 16) ||
        image.pixels.size() != static_cast<std::size_t>(image.width) * image.height * image.channels)
        throw std::runtime_error("the picture is neither grey nor RGB of 8 or 16 bits");
    if (image.bits == 8 &&
        std::any_of(image.pixels.begin(), image.pixels.end(), [](auto value) { return value > 255; }))
        throw std::runtime_error("the picture has a number above 255, more than 8 bits hold");
}

void write_image(const Image& image, const std::filesystem::path& file) {
    const std::string extension = extension_of(file);
    if (extension != ".png" && extension != ".bmp" && extension != ".tif")
        fail(file, "the name must end in .png, .bmp or .tif");
    if (extension == ".bmp" && image.bits != 8)
        fail(file, fmt::format("BMP holds 8 bits, the picture has {}; write PNG or TIFF", image.bits));
    write_whole(file, [&](const std::filesystem::path& temporary) {
        formats::check_image(image);
        if (extension == ".png")
            formats::write_png(image, temporary);
        else if (extension == ".bmp")
            formats::write_bmp(image, temporary);
        else
            formats::write_tiff(
                1, [&](int) { return image; }, temporary);
    });
}

void write_stack(int slices, const std::function<Image(int slice)>& slice, const std::filesystem::path& file) {
    if (extension_of(file) != ".tif") fail(file, "the name of a stack must end in .tif or .tiff");
    if (slices < 1) fail(file, "a stack has at least 1 slice");
    write_whole(file, [&](const std::filesystem::path& temporary) { formats::write_tiff(slices, slice, temporary); });
}

} // namespace abut
