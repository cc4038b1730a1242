#include "geometry/packing/draw_grains.h"

#include "geometry/packing/near_pairs.h"
#include "geometry/packing/random.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace abut {

namespace {

constexpr int darkest = 10, brightest = 240;

} // namespace

void check_style(const DrawingStyle& style) {
    const auto require = [](bool holds, const char* message) {
        if (!holds) throw std::invalid_argument(message);
    };
    require(style.shades > 0 && style.shades <= 100, "shades must be 1 to 100");
    require(!style.neighbour_distance || (*style.neighbour_distance >= 0 && *style.neighbour_distance <= 1000),
            "the neighbour distance must lie between 0 and 1000 pixels");
    require(style.background >= 0 && style.background <= 255, "the background must be a grey from 0 to 255");
}

namespace {

/// Greys evenly spaced; brought out of the background's way.
std::vector<int> greys(int count, int background) {
    std::vector<int> result;
    for (int k = 0; k < count; ++k) {
        const double share = count == 1 ? 0.5 : static_cast<double>(k) / (count - 1);
        result.push_back(static_cast<int>(std::lround(darkest + share * (brightest - darkest))));
    }
    if (std::find(result.begin(), result.end(), background) != result.end())
        throw std::invalid_argument(
            fmt::format("the background {} is also the grey of a body; take 0 or 255", background));
    return result;
}

/// Counts pixels of grains, and refuses those that have none.
double count_pixels(const ShadedGrains& shaded, std::size_t grains, const std::string& name) {
    std::vector<std::size_t> pixels_of(grains + 1, 0);
    for (int slice = 0; slice < shaded.slices; ++slice)
        for (const int each : shaded.labels(slice)) ++pixels_of[each];
    if (std::find(pixels_of.begin() + 1, pixels_of.end(), 0U) != pixels_of.end())
        throw std::runtime_error(
            fmt::format("{} is smaller than a pixel; ask for a larger picture or fewer bodies", name));
    const double all = static_cast<double>(shaded.width) * shaded.height * shaded.slices;
    return 1 - static_cast<double>(pixels_of[0]) / all;
}

Neighbours ball_neighbours(const PackedGrains& packed, double distance) {
    std::vector<PointD<3>> centres;
    std::vector<double> radii;
    for (const ShapeSpec& grain : packed.grains) {
        centres.push_back(std::get<Ball>(grain).center);
        radii.push_back(std::get<Ball>(grain).radius);
    }
    const PointD<3> box{static_cast<double>(packed.width), static_cast<double>(packed.height),
                        static_cast<double>(packed.depth)};
    Neighbours neighbours(centres.size());
    for (const auto& [a, b] : near_pairs<3>(centres, radii, box, distance)) {
        neighbours[a].push_back(b);
        neighbours[b].push_back(a);
    }
    for (auto& each : neighbours) std::sort(each.begin(), each.end());
    return neighbours;
}

std::vector<int> choose(const PackedGrains& packed, const DrawingStyle& style, ShadedGrains& shaded) {
    if (style.all_alike) return std::vector<int>(packed.grains.size(), 0);
    const std::vector<double> distances =
        style.neighbour_distance ? std::vector<double>{*style.neighbour_distance} : std::vector<double>{8, 4, 2, 1};
    const bool balls = packed.kind == GrainKind::balls;
    for (const double distance : distances) {
        Random random(style.seed + 1); // not the stream that places the grains
        const Neighbours neighbours = balls ? ball_neighbours(packed, distance)
                                            : neighbours_of(shaded.labels(0), packed.width, packed.height,
                                                            static_cast<int>(packed.grains.size()), distance);
        try {
            shaded.neighbour_distance = distance;
            return choose_shades(neighbours, static_cast<int>(shaded.shades.size()), random);
        } catch (const std::runtime_error& error) {
            if (distance != distances.back()) continue;
            throw std::runtime_error(
                fmt::format("{} (grains at most {} pixel{} apart count as neighbours{})", error.what(), distance,
                            distance == 1 ? "" : "s",
                            distance > 1 ? "; a smaller --neighbour-distance links fewer across gaps" : ""));
        }
    }
    return {};
}

} // namespace

ShadedGrains shade_grains(const PackedGrains& packed, const DrawingStyle& style) {
    check_style(style);
    ShadedGrains shaded;
    shaded.background = style.background;
    shaded.shades = greys(std::min(style.shades, static_cast<int>(packed.grains.size())), style.background);
    shaded.width = packed.width;
    shaded.height = packed.height;
    shaded.slices = std::max(1, packed.depth);
    shaded.labels = [grains = packed.grains, width = packed.width, height = packed.height](int slice) {
        return rasterize(grains, width, height, slice);
    };
    const std::string name = word(packed.kind);
    shaded.fraction =
        count_pixels(shaded, packed.grains.size(),
                     (packed.kind == GrainKind::ellipses ? "an " : "a ") + name.substr(0, name.size() - 1));
    for (const int choice : choose(packed, style, shaded)) shaded.shade.push_back(shaded.shades[choice]);
    return shaded;
}

Image draw(const ShadedGrains& shaded, int slice) {
    Image image{shaded.width, shaded.height, 1, {}};
    for (const int each : shaded.labels(slice))
        image.pixels.push_back(static_cast<std::uint16_t>(each == 0 ? shaded.background : shaded.shade[each - 1]));
    return image;
}

std::string legend_json(const ShadedGrains& shaded, const std::string& material) {
    const bool shared = shaded.shades.size() < shaded.shade.size();
    std::string text = shared ? "\"bodies\": \"by-component\", \"speckle\": 9,\n\"legend\": [\n" : "\"legend\": [\n";
    for (std::size_t k = 0; k < shaded.shades.size(); ++k)
        text += fmt::format("  {{ \"grey\": {}, \"body\": \"{}\", \"material\": \"{}\" }},\n", shaded.shades[k],
                            shared ? "grain" : fmt::format("grain-{:02}", k + 1), material);
    return text + fmt::format("  {{ \"grey\": {}, \"void\": true }}\n]", shaded.background);
}

} // namespace abut
