// To go together with image_particles: see legend.h.
#include "geometry/labels/legend.h"

#include <algorithm>
#include <cstdlib>
#include <unordered_map>

namespace abut {

namespace {

int old_matching_entry(const std::array<int, 3>& rgb, const std::vector<LegendEntry>& legend) {
    int best = no_entry;
    int best_difference = 256;
    for (std::size_t entry = 0; entry < legend.size(); ++entry) {
        int difference = 0;
        for (std::size_t channel = 0; channel < 3; ++channel)
            difference = std::max(difference, std::abs(rgb[channel] - legend[entry].rgb[channel]));
        if (difference <= legend[entry].tolerance && difference < best_difference) {
            best = static_cast<int>(entry);
            best_difference = difference;
        }
    }
    return best;
}

/// Label of each legend entry; appends to `bodies` the names it meets for the first time.
std::vector<int> labels_of_entries(const std::vector<LegendEntry>& legend, std::vector<std::string>& bodies) {
    std::vector<int> labels;
    std::unordered_map<std::string, int> known;
    for (const LegendEntry& entry : legend) {
        if (entry.is_void) {
            labels.push_back(0);
            continue;
        }
        const auto [found, is_new] = known.try_emplace(entry.body, static_cast<int>(bodies.size()) + 1);
        if (is_new) bodies.push_back(entry.body);
        labels.push_back(found->second);
    }
    return labels;
}

} // namespace

LabelledPicture label_pixels(const Image& image, const std::vector<LegendEntry>& legend) {
    LabelledPicture result;
    result.width = image.width;
    result.height = image.height;
    result.pixels_of_entry.assign(legend.size(), 0);
    const std::vector<int> label_of_entry = labels_of_entries(legend, result.bodies);

    struct Colour {
        int entry = no_entry;
        std::int64_t pixels = 0;
    };
    std::unordered_map<int, Colour> colours; // each colour is matched once, however many pixels have it
    int last_key = -1;
    Colour* colour = nullptr;
    result.label.reserve(static_cast<std::size_t>(image.width) * image.height);
    for (int row = 0; row < image.height; ++row) {
        for (int column = 0; column < image.width; ++column) {
            const std::array<int, 3> rgb = image.rgb(column, row);
            const int key = (rgb[0] << 16) | (rgb[1] << 8) | rgb[2];
            if (colour == nullptr || key != last_key) { // neighbours mostly have the same colour
                const auto [found, is_new] = colours.try_emplace(key);
                if (is_new) found->second.entry = old_matching_entry(rgb, legend);
                colour = &found->second; // stays valid: a rehash moves no element
                last_key = key;
            }
            ++colour->pixels;
            result.label.push_back(colour->entry == no_entry ? 0 : label_of_entry[colour->entry]);
        }
    }
    for (const auto& [key, found] : colours) {
        if (found.entry == no_entry)
            result.unmatched.push_back({{key >> 16, (key >> 8) & 255, key & 255}, found.pixels});
        else
            result.pixels_of_entry[found.entry] += found.pixels;
    }
    std::sort(result.unmatched.begin(), result.unmatched.end(), [](const UnmatchedColour& a, const UnmatchedColour& b) {
        return a.pixels != b.pixels ? a.pixels > b.pixels : a.rgb < b.rgb;
    });
    return result;
}

} // namespace abut
