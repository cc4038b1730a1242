#include "geometry/labels/legend.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <limits>

namespace abut {

int matching_entry(const std::array<int, 3>& rgb, const std::vector<LegendEntry>& legend) {
    const bool is_grey = rgb[0] == rgb[1] && rgb[1] == rgb[2];
    int best = no_entry, best_in_range = no_entry;
    int least_difference = std::numeric_limits<int>::max(), least_width = std::numeric_limits<int>::max();
    for (std::size_t k = 0; k < legend.size(); ++k) {
        const LegendEntry& entry = legend[k];
        if (entry.grey_range) {
            const auto [lowest, highest] = *entry.grey_range;
            if (!is_grey || rgb[0] < lowest || rgb[0] > highest || highest - lowest >= least_width) continue;
            best_in_range = static_cast<int>(k);
            least_width = highest - lowest;
            continue;
        }
        int difference = 0;
        for (std::size_t channel = 0; channel < 3; ++channel)
            difference = std::max(difference, std::abs(rgb[channel] - entry.rgb[channel]));
        if (difference > entry.tolerance || difference >= least_difference) continue;
        best = static_cast<int>(k);
        least_difference = difference;
    }
    return best != no_entry ? best : best_in_range;
}

std::string colour_name(const std::array<int, 3>& rgb) {
    if (rgb[0] == rgb[1] && rgb[1] == rgb[2]) return fmt::format("grey {}", rgb[0]);
    const int digits = *std::max_element(rgb.begin(), rgb.end()) > 255 ? 4 : 2;
    return fmt::format("#{:0{}x}{:0{}x}{:0{}x}", rgb[0], digits, rgb[1], digits, rgb[2], digits);
}

std::int32_t ColourTable::number(const std::array<int, 3>& rgb) {
    const auto next = static_cast<std::int32_t>(colours_.size());
    std::int32_t* number = nullptr;
    if (rgb[0] == rgb[1] && rgb[1] == rgb[2]) {
        number = &grey_[static_cast<std::size_t>(rgb[0])];
        if (*number < 0) *number = next;
    } else {
        std::uint64_t key = 0;
        for (const int channel : rgb) key = (key << 16) | static_cast<std::uint64_t>(channel);
        number = &other_.try_emplace(key, next).first->second;
    }
    if (*number == next) colours_.push_back({rgb, 0});
    return *number;
}

std::vector<std::int32_t> ColourTable::count(const Image& image, const std::array<int, 2>& columns,
                                             const std::array<int, 2>& rows) {
    std::vector<std::int32_t> numbers;
    numbers.reserve(static_cast<std::size_t>(columns[1] - columns[0] + 1) * (rows[1] - rows[0] + 1));
    std::array<int, 3> last{-1, -1, -1};
    std::int32_t last_number = 0;
    for (int row = rows[0]; row <= rows[1]; ++row) {
        for (int column = columns[0]; column <= columns[1]; ++column) {
            const std::array<int, 3> rgb = image.rgb(column, row);
            if (rgb != last) { // neighbours mostly have the same colour
                last_number = number(rgb);
                last = rgb;
            }
            ++colours_[static_cast<std::size_t>(last_number)].pixels;
            numbers.push_back(last_number);
        }
    }
    return numbers;
}

MatchedColours match_colours(const std::vector<ColourTable::Colour>& colours, const std::vector<LegendEntry>& legend) {
    MatchedColours result;
    result.pixels_of_entry.assign(legend.size(), 0);
    for (const ColourTable::Colour& colour : colours) {
        const int entry = matching_entry(colour.rgb, legend);
        result.entry.push_back(entry);
        if (entry == no_entry)
            result.unmatched.push_back({colour.rgb, colour.pixels});
        else
            result.pixels_of_entry[static_cast<std::size_t>(entry)] += colour.pixels;
    }
    std::sort(result.unmatched.begin(), result.unmatched.end(), [](const UnmatchedColour& a, const UnmatchedColour& b) {
        return a.pixels != b.pixels ? a.pixels > b.pixels : a.rgb < b.rgb;
    });
    return result;
}

} // namespace abut
