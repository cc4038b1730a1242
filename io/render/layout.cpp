#include "io/render/layout.h"

#include "io/results/si_prefix.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace abut {
namespace {

// Sizes in units of Layout::unit.
constexpr double margin = 26, top = 66, bottom = 62, gap = 24;
constexpr double font = 18, title_font = 21;
constexpr double bar_width = 22, tick_length = 5, tick_gap = 10;
constexpr double swatch = 18, swatch_gap = 10, legend_line = 28;
constexpr Rgb ink{40, 40, 40}, faint{110, 110, 110};

/// Lines one pixel wide stay so along pixel centres.
double pixel_centre(double x) {
    return std::floor(x) + 0.5;
}

double text_height(double size) {
    return 0.72 * size;
} // of capitals and digits

/// The text without its end, if it would be wider than `room`.
std::string shortened(const std::string& text, double size, bool bold, double room) {
    if (text_width(text, size, bold) <= room) return text;
    for (std::size_t length = text.size(); length-- > 1;) {
        if ((static_cast<unsigned char>(text[length]) & 0xc0) == 0x80) continue; // inside a UTF-8 character
        std::string shorter = text.substr(0, length) + "...";
        if (text_width(shorter, size, bold) <= room) return shorter;
    }
    return {};
}

/// The title of the colour bar in one line, or in two if it is long.
std::vector<std::string> bar_title(const ColourScale& scale, double unit) {
    if (scale.unit.empty()) return {scale.quantity};
    const std::string line = fmt::format("{} [{}]", scale.quantity, scale.unit);
    if (text_width(line, font * unit) <= 150 * unit) return {line};
    return {scale.quantity, fmt::format("[{}]", scale.unit)};
}

constexpr double legend_text_room = 200;

std::string more(std::size_t count) {
    return fmt::format("and {} more", count);
}

} // namespace

double panel_width(const ColourScale& scale, double unit) {
    double width = 0;
    for (const auto& [value, label] : scale.ticks)
        width = std::max(width, (bar_width + tick_length + tick_gap) * unit + text_width(label, font * unit));
    for (const std::string& line : bar_title(scale, unit)) width = std::max(width, text_width(line, font * unit));
    return gap * unit + width;
}

double panel_width(const std::vector<LegendItem>& legend, double unit) {
    double width = legend.size() > 5 ? text_width(more(legend.size()), font * unit) : 0; // the last line may be this
    for (const LegendItem& item : legend)
        width = std::max(width, std::min(legend_text_room * unit, text_width(item.text, font * unit)));
    return legend.empty() ? 0 : (gap + swatch + swatch_gap) * unit + width;
}

Layout make_layout(const Bounds& bounds, int width, int height, double panel) {
    Layout layout;
    const double unit = layout.unit = width / 1000.0;
    const double room = std::max(0.2 * width, width - 2 * margin * unit - panel);
    const double bands = (top + bottom) * unit;
    const double plot_height = std::clamp(room / seen_aspect(bounds), 220 * unit, 2.0 * width);
    layout.width = width;
    layout.height = height > 0 ? height : static_cast<int>(std::lround(plot_height + bands));

    const double y0 = bottom * unit, y1 = std::max(y0 + 10, layout.height - top * unit);
    const View largest = fitted_view(bounds, {margin * unit, y0}, {margin * unit + room, y1});
    Pixel lower{INFINITY, INFINITY}, upper{-INFINITY, -INFINITY};
    for (const auto& corner : corners_of(bounds)) {
        const Pixel p = largest.pixel(corner.data());
        for (std::size_t k = 0; k < 2; ++k) {
            lower[k] = std::min(lower[k], pixel_centre(p[k]));
            upper[k] = std::max(upper[k], pixel_centre(p[k]));
        }
    }
    layout.plot_lower = lower;
    layout.plot_upper = upper;
    layout.bounds = bounds;
    layout.view = fitted_view(bounds, lower, upper);
    return layout;
}

void add_title(Picture& picture, const Layout& layout, const std::string& title, const std::string& time) {
    const double unit = layout.unit, size = title_font * unit;
    const double y = layout.height - (top - 22) * unit;
    const double left = margin * unit, right = std::max(layout.plot_upper[0], layout.width * 0.5);
    picture.labels.push_back({time, {right, y}, size, Align::right, false, ink});
    const double room = right - left - text_width(time, size) - 2 * gap * unit;
    picture.labels.push_back({shortened(title, size, true, room), {left, y}, size, Align::left, true, ink});
}

void add_scale_bar(Picture& picture, const Layout& layout) {
    const double unit = layout.unit;
    const double length = round_down_nicely(0.25 * (layout.plot_upper[0] - layout.plot_lower[0]) / layout.view.scale);
    const SiPrefix prefix = length < 1 ? si_prefix(length) : SiPrefix{};
    const Pixel from{layout.plot_lower[0], pixel_centre(30 * unit)};
    const Pixel to{pixel_centre(from[0] + length * layout.view.scale), from[1]};
    add_line(picture.quads, from, to, 2 * unit, ink);
    for (const Pixel& end : {from, to})
        add_line(picture.quads, {end[0], end[1] - 5 * unit}, {end[0], end[1] + 5 * unit}, 2 * unit, ink);
    picture.labels.push_back(
        {fmt::format("{:g} {}m", length / prefix.factor, prefix.symbol == "u" ? "µ" : prefix.symbol),
         {to[0] + 12 * unit, from[1] - text_height(font * unit) / 2},
         font * unit,
         Align::left,
         false,
         ink});
}

double add_colour_bar(Picture& picture, const Layout& layout, const ColourScale& scale, double below) {
    const double unit = layout.unit, size = font * unit;
    const double left = pixel_centre(layout.plot_upper[0] + gap * unit), right = pixel_centre(left + bar_width * unit);
    double y = layout.plot_upper[1] - text_height(size);
    for (const std::string& line : bar_title(scale, unit)) {
        picture.labels.push_back({line, {left, y}, size, Align::left, false, ink});
        y -= 1.35 * size;
    }
    // A bar as high as the scene gets unwieldy in tall pictures.
    // Tips at its ends stand for values beyond.
    const double tip = std::round(0.7 * bar_width * unit);
    if (scale.above) y -= tip;
    if (scale.below) below += tip;
    const double high = pixel_centre(y),
                 low = pixel_centre(std::max(layout.plot_lower[1] + below + 4 * unit, high - 520 * unit));
    const int steps = std::max(1, static_cast<int>(std::lround(high - low))); // both on pixel centres
    for (int step = 0; step < steps; ++step)
        picture.quads.add_rectangle({left, low + step}, {right, low + step + 1},
                                    map_colour(scale.map, (step + 0.5) / (high - low)));
    for (const bool upper : {false, true}) {
        const double end = upper ? high : low;
        if (!(upper ? scale.above : scale.below)) {
            add_line(picture.quads, {left, end}, {right, end}, unit, faint);
            continue;
        }
        const Pixel peak{(left + right) / 2, end + (upper ? tip : -tip)};
        picture.quads.add({left, end}, {right, end}, peak, peak, map_colour(scale.map, upper ? 1 : 0));
        add_line(picture.quads, {left, end}, peak, unit, faint);
        add_line(picture.quads, {right, end}, peak, unit, faint);
    }
    for (const double x : {left, right}) add_line(picture.quads, {x, low}, {x, high}, unit, faint);
    for (const auto& [value, label] : scale.ticks) {
        const double at = low + (value - scale.lower) / (scale.upper - scale.lower) * (high - low);
        add_line(picture.quads, {right, at}, {right + tick_length * unit, at}, unit, faint);
        picture.labels.push_back({label,
                                  {right + (tick_length + tick_gap / 2) * unit, at - text_height(size) / 2},
                                  size,
                                  Align::left,
                                  false,
                                  ink});
    }
    return scale.below ? low - tip : low;
}

void add_legend(Picture& picture, const Layout& layout, const std::vector<LegendItem>& legend) {
    const double unit = layout.unit, size = font * unit;
    const double left = std::round(layout.plot_upper[0] + gap * unit);
    const auto lines = static_cast<std::size_t>((layout.plot_upper[1] - layout.plot_lower[1]) / (legend_line * unit));
    const std::size_t shown = legend.size() <= lines ? legend.size() : std::max<std::size_t>(lines, 1) - 1;
    double y = layout.plot_upper[1] - swatch * unit;
    for (std::size_t i = 0; i < shown; ++i, y -= legend_line * unit) {
        picture.quads.add_rectangle({left, y}, {left + swatch * unit, y + swatch * unit}, legend[i].colour);
        picture.labels.push_back({shortened(legend[i].text, size, false, legend_text_room * unit),
                                  {left + (swatch + swatch_gap) * unit, y + (swatch * unit - text_height(size)) / 2},
                                  size,
                                  Align::left,
                                  false,
                                  ink});
    }
    if (shown < legend.size())
        picture.labels.push_back({more(legend.size() - shown),
                                  {left, y + (swatch * unit - text_height(size)) / 2},
                                  size,
                                  Align::left,
                                  false,
                                  faint});
}

} // namespace abut
