#include "geometry/labels/used_part.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace abut {

namespace {

std::string size_text(const StackInfo& info) {
    return fmt::format("{} x {} pixels{}", info.width, info.height,
                       info.slices > 1 ? fmt::format(" in {} slices", info.slices) : "");
}

/// The slice of a plane scene.
int only_slice(const ImageSpec& spec, const StackInfo& info) {
    if (!spec.slice && info.slices > 1)
        throw std::runtime_error(fmt::format("is a stack of {} slices; name the one to use: \"slice\" from 0 to {}",
                                             info.slices, info.slices - 1));
    const int slice = spec.slice.value_or(0);
    if (slice < 0 || slice >= info.slices)
        throw std::runtime_error(info.slices == 1
                                     ? fmt::format("has one slice, 0; \"slice\" is {}", slice)
                                     : fmt::format("has slices 0 to {}; \"slice\" is {}", info.slices - 1, slice));
    return slice;
}

void check_crop(const std::array<int, 2>& range, int count, const char* what, const StackInfo& info) {
    if (range[0] > range[1])
        throw std::runtime_error(fmt::format("cannot be cropped to {}s {} to {}: the last comes before the first", what,
                                             range[0], range[1]));
    if (range[0] < 0 || range[1] >= count)
        throw std::runtime_error(fmt::format("cannot be cropped to {}s {} to {}: it has {}, so {}s go from 0 to {}",
                                             what, range[0], range[1], size_text(info), what, count - 1));
}

} // namespace

UsedPart used_part(const ImageSpec& spec, int dimension, const StackInfo& info) {
    const std::array<int, 3> count{info.width, info.height, info.slices};
    if (*std::min_element(count.begin(), count.end()) < 1) throw std::runtime_error("has no pixels");
    constexpr std::array<const char*, 3> what{"column", "row", "slice"};
    UsedPart used{};
    for (std::size_t a = 0; a < 3; ++a) {
        used[a] = {0, count[a] - 1};
        if (!spec.crop || static_cast<int>(a) >= dimension) continue;
        if ((*spec.crop)[a][1] == -1) continue; // all
        used[a] = (*spec.crop)[a];
        check_crop(used[a], count[a], what[a], info);
    }
    if (dimension == 2) used[2].fill(only_slice(spec, info));
    if (dimension == 3 && spec.slice)
        throw std::runtime_error("needs no \"slice\" in a 3D scene: all slices are used, or those of \"crop\"");
    std::int64_t pixels = 1;
    for (const auto& [first, last] : used) {
        const std::int64_t extent = std::int64_t{last} - first + 1;
        if (pixels > most_used_pixels / extent)
            throw std::runtime_error(fmt::format("has {}: more than the {} pixels that can be used; crop it, or "
                                                 "make it coarser",
                                                 size_text(info), most_used_pixels));
        pixels *= extent;
    }
    return used;
}

int used_connectivity(const ImageSpec& spec, int dimension) {
    const int given = spec.connectivity;
    if (given == 0) return dimension == 2 ? 4 : 6;
    if (dimension == 2 && given != 4 && given != 8)
        throw std::runtime_error(
            fmt::format("has pixels with 4 or 8 neighbours in a plane; connectivity is {}", given));
    if (dimension == 3 && given != 6 && given != 18 && given != 26)
        throw std::runtime_error(
            fmt::format("has pixels with 6, 18 or 26 neighbours in 3D; connectivity is {}", given));
    return given;
}

} // namespace abut
