#include "geometry/labels/name_bodies.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <unordered_map>

namespace abut {

namespace {

bool is_grey(const std::array<int, 3>& rgb) {
    return rgb[0] == rgb[1] && rgb[1] == rgb[2];
}

/// Label of each entry: 0 for void.
std::vector<std::int32_t> labels_of_entries(const ImageSpec& spec, std::vector<PixelKind>& kinds) {
    std::vector<std::int32_t> labels;
    std::unordered_map<std::string, std::int32_t> known;
    for (std::size_t k = 0; k < spec.legend.size(); ++k) {
        const LegendEntry& entry = spec.legend[k];
        std::int32_t label = 0;
        if (!entry.is_void) {
            label = static_cast<std::int32_t>(kinds.size()) + 1;
            if (spec.bodies == BodiesBy::legend) label = known.try_emplace(entry.body, label).first->second;
            if (label > static_cast<std::int32_t>(kinds.size())) kinds.push_back({static_cast<int>(k), entry.rgb});
        }
        labels.push_back(label);
    }
    return labels;
}

PixelKinds kinds_by_colour(const ImageSpec& spec, const std::vector<ColourTable::Colour>& colours,
                           const std::vector<int>& entry_of_colour) {
    PixelKinds result;
    result.of_colour.assign(colours.size(), 0);
    std::vector<std::size_t> order(colours.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(),
              [&](std::size_t a, std::size_t b) { return colours[a].rgb < colours[b].rgb; });
    for (const std::size_t colour : order) {
        const int entry = entry_of_colour[colour];
        if (entry == no_entry || spec.legend[static_cast<std::size_t>(entry)].is_void) continue;
        result.kinds.push_back({entry, colours[colour].rgb});
        result.of_colour[colour] = static_cast<std::int32_t>(result.kinds.size());
    }
    if (result.kinds.size() > static_cast<std::size_t>(most_bodies))
        throw std::runtime_error(fmt::format("has {} colours that would each be a body, more than {}: probably a "
                                             "photograph or noise; use bodies by \"legend\" or \"component\"",
                                             result.kinds.size(), most_bodies));
    return result;
}

} // namespace

PixelKinds pixel_kinds(const ImageSpec& spec, const std::vector<ColourTable::Colour>& colours,
                       const std::vector<int>& entry_of_colour) {
    if (spec.bodies == BodiesBy::colour) return kinds_by_colour(spec, colours, entry_of_colour);
    PixelKinds result;
    const std::vector<std::int32_t> label_of_entry = labels_of_entries(spec, result.kinds);
    for (const int entry : entry_of_colour)
        result.of_colour.push_back(entry == no_entry ? 0 : label_of_entry[static_cast<std::size_t>(entry)]);
    return result;
}

std::vector<std::string> names_by_colour(const std::vector<PixelKind>& kinds, const std::vector<LegendEntry>& legend) {
    struct Colours {
        bool all_grey = true;
        int largest = 0; ///< component of a colour
    };
    std::unordered_map<std::string, Colours> of_name;
    for (const PixelKind& kind : kinds) {
        Colours& colours = of_name[legend[static_cast<std::size_t>(kind.entry)].body];
        colours.all_grey = colours.all_grey && is_grey(kind.rgb);
        colours.largest = std::max(colours.largest, *std::max_element(kind.rgb.begin(), kind.rgb.end()));
    }
    std::vector<std::string> names;
    for (const PixelKind& kind : kinds) {
        const std::string& name = legend[static_cast<std::size_t>(kind.entry)].body;
        const Colours& colours = of_name[name];
        const auto& [r, g, b] = kind.rgb;
        if (colours.all_grey) {
            names.push_back(fmt::format("{}-{:0{}}", name, r, fmt::formatted_size("{}", colours.largest)));
        } else {
            const int digits = colours.largest > 255 ? 4 : 2;
            names.push_back(fmt::format("{}-{:0{}x}{:0{}x}{:0{}x}", name, r, digits, g, digits, b, digits));
        }
    }
    return names;
}

std::vector<std::string> names_by_component(const std::vector<int>& entries, const std::vector<LegendEntry>& legend) {
    std::unordered_map<std::string, int> total, so_far;
    for (const int entry : entries) ++total[legend[static_cast<std::size_t>(entry)].body];
    std::vector<std::string> names;
    for (const int entry : entries) {
        const std::string& name = legend[static_cast<std::size_t>(entry)].body;
        names.push_back(fmt::format("{}-{:0{}}", name, ++so_far[name], fmt::formatted_size("{}", total[name])));
    }
    return names;
}

} // namespace abut
