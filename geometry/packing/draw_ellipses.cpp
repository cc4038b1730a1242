#include "geometry/packing/draw_ellipses.h"

#include "geometry/packing/ellipse_contact.h"
#include "geometry/packing/ellipse_packing.h"
#include "geometry/packing/random.h"
#include "geometry/packing/shades.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <stdexcept>

namespace abut {

namespace {

constexpr int darkest = 10, brightest = 240;

void require(bool holds, const char* message) {
    if (!holds) throw std::invalid_argument(message);
}

void check(const EllipseDrawing& drawing) {
    require(drawing.width > 0 && drawing.height > 0, "width and height must be at least 1 pixel");
    require(drawing.bodies > 0, "there must be at least 1 body");
    require(drawing.shades > 0 && drawing.shades <= 100, "shades must be 1 to 100");
    require(drawing.min_aspect >= 1 && drawing.max_aspect >= drawing.min_aspect,
            "aspects must be at least 1, the largest not below the smallest");
    require(drawing.min_size > 0 && drawing.max_size >= drawing.min_size,
            "sizes must be larger than 0, the largest not below the smallest");
    require(drawing.area_fraction > 0 && drawing.area_fraction < 1, "the area fraction must lie between 0 and 1");
    require(drawing.gap >= 0, "the gap must not be negative");
    require(drawing.neighbour_distance >= 0, "the neighbour distance must not be negative");
    require(drawing.background >= 0 && drawing.background <= 255, "the background must be a grey from 0 to 255");
}

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

/// Label of each pixel, rows from the top: k + 1 where its centre lies in ellipse k, else 0.
std::vector<int> rasterize(const std::vector<Ellipse>& ellipses, int width, int height) {
    std::vector<int> label(static_cast<std::size_t>(width) * height, 0);
    for (std::size_t k = 0; k < ellipses.size(); ++k) {
        const Ellipse& ellipse = ellipses[k];
        const std::array<double, 2> extent = half_extent(ellipse);
        const double c = std::cos(ellipse.angle), s = std::sin(ellipse.angle);
        const auto pixel = [](double at, int count) {
            return std::clamp(static_cast<int>(std::floor(at)), 0, count - 1);
        };
        for (int up = pixel(ellipse.center[1] - extent[1], height); up <= pixel(ellipse.center[1] + extent[1], height);
             ++up) {
            for (int right = pixel(ellipse.center[0] - extent[0], width);
                 right <= pixel(ellipse.center[0] + extent[0], width); ++right) {
                const double x = right + 0.5 - ellipse.center[0], y = up + 0.5 - ellipse.center[1];
                const double u = (c * x + s * y) / ellipse.semi_axes[0], v = (c * y - s * x) / ellipse.semi_axes[1];
                if (u * u + v * v <= 1)
                    label[static_cast<std::size_t>(height - 1 - up) * width + right] = static_cast<int>(k) + 1;
            }
        }
    }
    return label;
}

} // namespace

DrawnImage draw_ellipses(const EllipseDrawing& drawing) {
    check(drawing);
    DrawnImage drawn;
    drawn.background = drawing.background;
    drawn.shades = greys(std::min(drawing.shades, drawing.bodies), drawing.background);
    drawn.ellipses = pack_ellipses({static_cast<double>(drawing.width), static_cast<double>(drawing.height),
                                    drawing.bodies, drawing.min_aspect, drawing.max_aspect, drawing.min_size,
                                    drawing.max_size, drawing.area_fraction, drawing.gap, drawing.seed});

    const std::vector<int> label = rasterize(drawn.ellipses, drawing.width, drawing.height);
    std::vector<std::size_t> pixels_of(drawn.ellipses.size() + 1, 0);
    for (const int each : label) ++pixels_of[each];
    if (std::find(pixels_of.begin() + 1, pixels_of.end(), 0u) != pixels_of.end())
        throw std::runtime_error("an ellipse is smaller than a pixel; ask for a larger picture or fewer bodies");

    Random random(drawing.seed + 1); // not the stream that places the ellipses
    const Neighbours neighbours =
        neighbours_of(label, drawing.width, drawing.height, drawing.bodies, drawing.neighbour_distance);
    for (const int choice : choose_shades(neighbours, static_cast<int>(drawn.shades.size()), random))
        drawn.shade.push_back(drawn.shades[choice]);

    drawn.image = {drawing.width, drawing.height, 1, {}};
    for (const int each : label)
        drawn.image.pixels.push_back(static_cast<std::uint8_t>(each == 0 ? drawing.background : drawn.shade[each - 1]));
    drawn.area_fraction = 1 - static_cast<double>(pixels_of[0]) / static_cast<double>(label.size());
    return drawn;
}

std::string legend_json(const DrawnImage& drawn, const std::string& material) {
    std::string text = "\"legend\": [\n";
    for (std::size_t k = 0; k < drawn.shades.size(); ++k)
        text += fmt::format("  {{ \"grey\": {}, \"body\": \"grain-{:02}\", \"material\": \"{}\" }},\n", drawn.shades[k],
                            k + 1, material);
    return text + fmt::format("  {{ \"grey\": {}, \"void\": true }}\n]", drawn.background);
}

} // namespace abut
