#include "io/render/render_series.h"

#include "io/render/domains.h"
#include "io/render/layout.h"
#include "io/render/offscreen_context.h"
#include "io/render/series_source.h"
#include "io/render/solids.h"
#include "io/results/si_prefix.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numeric>
#include <stdexcept>

namespace abut {
namespace {

constexpr std::size_t legend_limit = 40; // more bodies than this are not named

/// How all pictures of a series look.
struct Style {
    Layout layout;
    std::optional<ColourScale> scale; ///< none: coloured by body
    std::vector<LegendItem> legend;
    std::string title;
    double end_time = 0;
    double spacing = 0; ///< of the particles [m]
};

RenderOptions with_preset(RenderOptions options) {
    if (options.preset.empty()) return options;
    if (std::find(render_presets().begin(), render_presets().end(), options.preset) == render_presets().end())
        throw RenderRequestError(no_such("preset", options.preset, render_presets()));
    options.array = options.preset == "pressure"    ? "pressure"
                    : options.preset == "von-mises" ? "von_mises_stress"
                    : options.preset == "velocity"  ? "velocity"
                                                    : "body";
    options.component = -1;
    options.normals = options.preset == "normals";
    return options;
}

std::vector<int> chosen_frames(const RenderOptions& options, const PvdSeries& series) {
    const int count = static_cast<int>(series.entries.size());
    if (options.last_only) return {count - 1};
    if (options.frames) {
        for (const int frame : *options.frames)
            if (frame < 0 || frame >= count)
                throw RenderRequestError(
                    fmt::format("{}: no frame {}; there are 0 to {}", series.path.string(), frame, count - 1));
        return *options.frames;
    }
    std::vector<int> all(static_cast<std::size_t>(count));
    std::iota(all.begin(), all.end(), 0);
    return all;
}

Rgb shown_body_colour(int body, const RenderOptions& options) {
    return options.normals ? lighter(body_colour(body), 0.45) : body_colour(body); // arrows stand out on pale bodies
}

std::vector<LegendItem> legend_of(const PointFrame& frame, const RenderOptions& options) {
    std::vector<LegendItem> legend;
    for (const Words& words : frame.words)
        if (words.name == "body_names" && words.values.size() <= legend_limit)
            for (std::size_t i = 0; i < words.values.size(); ++i)
                legend.push_back({words.values[i], shown_body_colour(static_cast<int>(i), options)});
    return legend;
}

/// A box a little larger than the points; never without extent.
Bounds around(Bounds bounds) {
    if (!(bounds.lower[0] <= bounds.upper[0])) return {{0, 0, 0}, {1, 1, 0}}; // no points at all
    double size = 0;
    for (std::size_t k = 0; k < 3; ++k) size = std::max(size, bounds.upper[k] - bounds.lower[k]);
    const double pad = size > 0 ? 0.05 * size : 1;
    for (std::size_t k = 0; k < (bounds.flat() && size > 0 ? 2u : 3u); ++k) {
        bounds.lower[k] -= pad;
        bounds.upper[k] += pad;
    }
    return bounds;
}

double dot_spacing(const PointFrame& frame, const Bounds& bounds) {
    if (const Array* volume = find_array(frame, "volume"); volume && !bounds.flat()) {
        const auto values = values_of(*volume, -1);
        if (!values.empty()) return std::cbrt(values[values.size() / 2]);
    }
    // Nothing tells how large a plane particle is: as if they filled the box.
    const double area = (bounds.upper[0] - bounds.lower[0]) * (bounds.upper[1] - bounds.lower[1]);
    return std::sqrt(area / static_cast<double>(std::max<std::size_t>(1, frame.points.size() / 3)));
}

bool is_in_space(const PointFrame& frame) {
    const std::optional<Domains> domains = Domains::of(frame);
    return domains && domains->in_space();
}

void extend(Bounds& bounds, const PointFrame& frame, bool with_domains) {
    for (std::size_t i = 0; i < frame.points.size(); ++i) {
        bounds.lower[i % 3] = std::min(bounds.lower[i % 3], frame.points[i]);
        bounds.upper[i % 3] = std::max(bounds.upper[i % 3], frame.points[i]);
    }
    if (const auto domains = Domains::of(frame); with_domains && domains) domains->extend(bounds);
}

/// The array that colours the particles. \param where for messages
const Array& chosen_array(const PointFrame& frame, const RenderOptions& options, const std::string& where) {
    const Array* array = find_array(frame, options.array);
    if (!array)
        throw RenderRequestError(fmt::format("{}: {}", where, no_such("array", options.array, array_names(frame))));
    if (options.component >= array->components)
        throw RenderRequestError(fmt::format("{}: array \"{}\" has components 0 to {}, not {}", where, options.array,
                                             array->components - 1, options.component));
    return *array;
}

bool by_body(const RenderOptions& options) {
    return options.array == "body";
}

/// The style of pictures that show `bounds`, and values in `range`, where they are not those of bodies.
Style make_style(const PointFrame& first, const Array& array, const Bounds& bounds, const Range& range,
                 const RenderOptions& options) {
    Style style;
    const double unit = options.width / 1000.0;
    double panel = 0;
    if (by_body(options)) {
        style.legend = legend_of(first, options);
        panel = panel_width(style.legend, unit);
    } else {
        style.scale = colour_scale(array, options.component, range, options.range.has_value());
        panel = panel_width(*style.scale, unit);
    }
    style.layout = make_layout(bounds, options.width, options.height, panel);
    style.spacing = dot_spacing(first, bounds);
    return style;
}

constexpr Bounds nothing{{INFINITY, INFINITY, INFINITY}, {-INFINITY, -INFINITY, -INFINITY}};

/// Looks at the first frame, and at all where the range of values or the bounds need it.
Style make_style(const SeriesSource& source, const RenderOptions& options, const std::vector<int>& frames) {
    const PointFrame first = source.particles(frames.front(), {});
    const Array& array = chosen_array(first, options, source.series.path.string());
    // A box of space that is mostly empty would leave little of the picture to the bodies: there the picture shows the
    // box that they need, in the plane that of the grid.
    const bool in_space = is_in_space(first);
    std::optional<Bounds> bounds;
    if (!in_space) bounds = source.grid_bounds();
    Range range = options.range;
    if (!bounds || (!by_body(options) && !range)) {
        Bounds points = nothing;
        for (const int index : frames) {
            std::vector<std::string> wanted{options.array};
            if (in_space) wanted.insert(wanted.end(), {"half_size", "deformation_gradient"});
            const PointFrame frame = source.particles(index, wanted);
            extend(points, frame, in_space);
            if (const Array* values = find_array(frame, options.array); values && !options.range)
                range = joined(range, range_of(values_of(*values, options.component)));
        }
        if (!bounds) bounds = around(points);
    }
    Style style = make_style(first, array, *bounds, range, options);
    style.title = source.title();
    style.end_time = source.series.entries.back().time;
    return style;
}

void add_particles(Picture& picture, const PointFrame& frame, const Style& style, const RenderOptions& options) {
    const std::size_t count = frame.points.size() / 3;
    std::vector<double> body(count, 0);
    if (const Array* array = find_array(frame, "body")) body = values_of(*array, -1);
    std::vector<Rgb> colours(count);
    if (style.scale) {
        const auto values = values_of(*find_array(frame, options.array), options.component);
        std::transform(values.begin(), values.end(), colours.begin(), [&](double v) { return style.scale->colour(v); });
    } else {
        std::transform(body.begin(), body.end(), colours.begin(),
                       [&](double b) { return shown_body_colour(static_cast<int>(b), options); });
    }
    // Body after body, whatever the particles' order: bodies that overlap then cover one another and don't blend.
    std::vector<std::size_t> order(count);
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return body[a] < body[b]; });

    const View& view = style.layout.view;
    const bool flat = style.layout.bounds.flat();
    if (options.domains && flat && add_domains(picture.quads, frame, view, colours, order)) return;
    if (options.domains && !flat && add_solids(picture.faces, frame, view, colours)) return;
    add_dots(picture.dots, frame, view, colours, order);
    picture.dots.diameter = (flat ? 0.9 : 1.25) * style.spacing * view.scale;
    picture.dots.shaded = !flat;
}

void add_normals(Picture& picture, const PointFrame& contact, const Layout& layout) {
    const Array *normal = find_array(contact, "normal"), *in_contact = find_array(contact, "in_contact");
    if (!normal || !in_contact || normal->components != 3 || normal->values.index() != 0)
        throw std::runtime_error("contact.pvd: its files lack the arrays \"normal\" and \"in_contact\"");
    const double* n = std::get<0>(normal->values).data();
    const auto touching = values_of(*in_contact, -1);
    for (std::size_t i = 0; i < touching.size(); ++i)
        if (touching[i] == 1)
            add_arrow(picture.quads, layout.view.pixel(&contact.points[3 * i]), layout.view.direction(n + 3 * i),
                      24 * layout.unit, 2 * layout.unit, {20, 20, 20});
}

/// \param contact the contact pairs, if their normals are wanted
Picture compose(const PointFrame& frame, const PointFrame* contact, const std::string& time, const Style& style,
                const RenderOptions& options) {
    const Layout& layout = style.layout;
    Picture picture;
    picture.width = layout.width;
    picture.height = layout.height;
    add_particles(picture, frame, style, options);
    constexpr Rgb outline{130, 130, 130};
    if (layout.bounds.flat()) {
        add_outline(picture.quads, layout.bounds, layout.view, layout.unit, outline);
    } else {
        add_box(picture.faces, layout.bounds, layout.view, layout.unit, outline);
        add_axes(picture, layout.view, {layout.plot_upper[0] - 40 * layout.unit, 22 * layout.unit}, layout.unit,
                 {40, 40, 40});
    }
    if (contact) add_normals(picture, *contact, layout);
    if (style.scale) add_colour_bar(picture, layout, *style.scale);
    add_legend(picture, layout, style.legend);
    add_scale_bar(picture, layout);
    add_title(picture, layout, style.title, time);
    return picture;
}

Picture compose(const SeriesSource& source, int index, const Style& style, const RenderOptions& options) {
    const PointFrame frame =
        source.particles(index, {options.array, "body", "half_size", "deformation_gradient", "volume", "displacement"});
    if (style.scale && !find_array(frame, options.array))
        throw std::runtime_error(fmt::format("frame {}: no array \"{}\"", index, options.array));
    std::string time =
        "t = " + format_time(source.series.entries[static_cast<std::size_t>(index)].time, style.end_time);
    if (time.ends_with(" us")) time.replace(time.size() - 2, 1, "µ");
    if (!options.normals) return compose(frame, nullptr, time, style, options);
    const PointFrame contact = source.contact(index);
    return compose(frame, &contact, time, style, options);
}

void check_size(const RenderOptions& options) {
    const auto unfit = [](int size) { return size < 100 || size > 8192; };
    if (unfit(options.width) || (options.height != 0 && unfit(options.height)))
        throw RenderRequestError("the width and height of pictures must be from 100 to 8192 pixels");
}

} // namespace

const std::vector<std::string>& render_presets() {
    static const std::vector<std::string> names{"bodies", "pressure", "von-mises", "velocity", "normals"};
    return names;
}

void render_frame(const PointFrame& frame, const Bounds& grid, const std::string& title, const RenderOptions& given,
                  const std::filesystem::path& file) {
    const RenderOptions options = with_preset(given);
    check_size(options);
    const Array& array = chosen_array(frame, options, file.string());
    Bounds bounds = grid;
    if (is_in_space(frame)) {
        bounds = nothing;
        extend(bounds, frame, true);
        bounds = around(bounds);
    }
    Range range = options.range;
    if (!by_body(options) && !range) range = range_of(values_of(array, options.component));
    Style style = make_style(frame, array, bounds, range, options);
    style.title = title;
    OffscreenContext context;
    write_png(context, compose(frame, nullptr, "", style, options), file);
}

std::vector<std::filesystem::path> render_series(const std::filesystem::path& result_dir, const RenderOptions& given) {
    const RenderOptions options = with_preset(given);
    check_size(options);
    const SeriesSource source = open_series(result_dir, options.normals);
    const std::vector<int> frames = chosen_frames(options, source.series);
    if (frames.empty()) return {};
    const Style style = make_style(source, options, frames);

    const auto name = options.preset.empty() ? options.array : options.preset;
    const auto folder = options.output.empty() ? result_dir / "frames" / name : options.output;
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error) throw std::runtime_error(fmt::format("{}: {}", folder.string(), error.message()));
    OffscreenContext context;
    std::vector<std::filesystem::path> files;
    for (const int index : frames) {
        files.push_back(folder / fmt::format("frame_{:05}.png", index));
        write_png(context, compose(source, index, style, options), files.back());
    }
    return files;
}

} // namespace abut
