#include "io/render/compose.h"

#include "io/render/contact_arrows.h"
#include "io/render/domains.h"
#include "io/render/preset.h"
#include "io/render/solids.h"
#include "io/results/si_prefix.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

namespace abut {
namespace {

constexpr std::size_t legend_limit = 40; // more bodies than this are not named

Rgb shown_body_colour(int body, const RenderOptions& options) {
    if (options.separations) return lighter(body_colour(body), 0.7);
    return options.normals ? lighter(body_colour(body), 0.45) : body_colour(body); // arrows stand out on pale bodies
}

std::vector<LegendItem> legend_of(const PointFrame& frame, const RenderOptions& options,
                                  const std::optional<std::set<int>>& bodies) {
    std::vector<LegendItem> legend;
    for (const Words& words : frame.words)
        if (words.name == "body_names" && (bodies ? bodies->size() : words.values.size()) <= legend_limit)
            for (int i = 0; i < static_cast<int>(words.values.size()); ++i)
                if (!bodies || bodies->count(i) > 0)
                    legend.push_back({words.values[static_cast<std::size_t>(i)], shown_body_colour(i, options)});
    return legend;
}

double dot_spacing(const PointFrame& frame, const Bounds& bounds) {
    if (const Array* volume = find_array(frame, "volume"); volume && !bounds.flat()) {
        const auto values = values_of(*volume, -1);
        if (!values.empty()) return std::cbrt(values[values.size() / 2]);
    }
    if (const double* half_size = reals_of(frame, "half_size", 3); half_size && !frame.points.empty())
        return 2 * *std::max_element(half_size, half_size + 3);
    // Nothing tells how large a plane particle is: as if they filled the box.
    const double area = (bounds.upper[0] - bounds.lower[0]) * (bounds.upper[1] - bounds.lower[1]);
    return std::sqrt(area / static_cast<double>(std::max<std::size_t>(1, frame.points.size() / 3)));
}

void add_particles(Picture& picture, const PointFrame& frame, const Look& look, const RenderOptions& options) {
    const std::size_t count = frame.points.size() / 3;
    std::vector<double> body(count, 0);
    if (const Array* array = find_array(frame, "body")) body = values_of(*array, -1);
    std::vector<Rgb> colours(count);
    if (look.scale) {
        const Array* array = find_array(frame, options.array);
        if (!array) throw std::runtime_error("no array \"" + options.array + "\"");
        const auto values = values_of(*array, options.component);
        std::transform(values.begin(), values.end(), colours.begin(), [&](double v) { return look.scale->colour(v); });
    } else {
        std::transform(body.begin(), body.end(), colours.begin(),
                       [&](double b) { return shown_body_colour(static_cast<int>(b), options); });
    }
    // Body after body, whatever the particles' order: bodies that overlap then cover one another and don't blend.
    std::vector<std::size_t> order(count);
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return body[a] < body[b]; });

    const View& view = look.layout.view;
    const bool flat = look.layout.bounds.flat();
    if (options.particles == ParticleStyle::domains) {
        if (flat && add_domains(picture.quads, frame, view, colours, order)) return;
        if (!flat && add_solids(picture.faces, frame, view, colours)) return;
    }
    if (options.particles == ParticleStyle::ellipses && add_ellipses(picture.quads, frame, view, colours, order))
        return;
    add_dots(picture.dots, frame, view, colours, order);
    picture.dots.diameter = (flat ? 0.9 : 1.25) * look.spacing * view.scale;
    picture.dots.shaded = !flat;
}

/// Covers what lies outside the plot: parts of particles and arrows at the edge of a region.
void cover_outside(Picture& picture, const Layout& layout) {
    constexpr Rgb white{255, 255, 255};
    const double w = layout.width, h = layout.height;
    const auto &lower = layout.plot_lower, &upper = layout.plot_upper;
    picture.quads.add_rectangle({0, 0}, {lower[0], h}, white);
    picture.quads.add_rectangle({upper[0], 0}, {w, h}, white);
    picture.quads.add_rectangle({0, 0}, {w, lower[1]}, white);
    picture.quads.add_rectangle({0, upper[1]}, {w, h}, white);
}

} // namespace

std::vector<std::string> needed_arrays(const RenderOptions& options) {
    return {options.array, "body", "half_size", "deformation_gradient", "volume", "displacement"};
}

bool is_in_space(const PointFrame& frame) {
    const std::optional<Domains> domains = Domains::of(frame);
    return domains && domains->in_space();
}

Bounds nothing() {
    return {{INFINITY, INFINITY, INFINITY}, {-INFINITY, -INFINITY, -INFINITY}};
}

void extend(Bounds& bounds, const PointFrame& frame, bool with_domains) {
    for (std::size_t i = 0; i < frame.points.size(); ++i) {
        bounds.lower[i % 3] = std::min(bounds.lower[i % 3], frame.points[i]);
        bounds.upper[i % 3] = std::max(bounds.upper[i % 3], frame.points[i]);
    }
    if (const auto domains = Domains::of(frame); with_domains && domains) domains->extend(bounds);
}

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

ShownValues shown_values(const PointFrame& frame, const PointFrame* contact, const RenderOptions& options) {
    ShownValues shown;
    std::vector<double> values;
    if (options.separations && contact) {
        values = separations_in_contact(*contact);
        shown.all = range_of(values_of(*find_array(*contact, "separation"), -1));
    } else if (const Array* array = by_body(options) ? nullptr : find_array(frame, options.array)) {
        values = values_of(*array, options.component);
        shown.all = range_of(values);
    }
    shown.range = options.percentile ? range_of(values, *options.percentile) : range_of(values);
    return shown;
}

ShownValues joined(const ShownValues& a, const ShownValues& b) {
    return {joined(a.range, b.range), joined(a.all, b.all)};
}

Look make_look(const PointFrame& first, const Bounds& bounds, const ShownValues& values, const RenderOptions& options,
               const std::string& where, const std::optional<std::set<int>>& bodies) {
    const Array& array = chosen_array(first, options, where);
    if (options.particles == ParticleStyle::ellipses && !bounds.flat())
        throw RenderRequestError("ellipses are drawn in plane scenes only; in 3D there are domains and dots");
    Look look;
    const double unit = options.width / 1000.0;
    double panel = 0;
    const bool exact = options.range.has_value();
    // Separations, where no pair is in contact: those of all pairs.
    const Range range = exact ? Range(options.range) : values.range ? values.range : values.all;
    if (options.separations) look.separation = separation_scale(range, exact);
    if (!by_body(options)) look.scale = colour_scale(array, options.component, range, exact);
    if (std::optional<ColourScale>& scale = options.separations ? look.separation : look.scale; scale && values.all) {
        scale->below = values.all->first < scale->lower;
        scale->above = values.all->second > scale->upper;
    }
    if (options.legend) {
        if (look.separation) {
            panel = std::max(panel_width(*look.separation, unit), arrow_key_width(unit));
        } else if (look.scale) {
            panel = panel_width(*look.scale, unit);
        } else {
            look.legend = legend_of(first, options, bodies);
            panel = panel_width(look.legend, unit);
        }
    }
    look.layout = make_layout(bounds, options.width, options.height, panel);
    look.spacing = dot_spacing(first, bounds);
    return look;
}

Picture compose(const PointFrame& frame, const PointFrame* contact, std::optional<double> time, const Look& look,
                const RenderOptions& options) {
    const Layout& layout = look.layout;
    Picture picture;
    picture.width = layout.width;
    picture.height = layout.height;
    add_particles(picture, frame, look, options);
    if (contact && look.separation)
        add_separations(picture, *contact, layout, *look.separation);
    else if (contact)
        add_normals(picture, *contact, layout);
    constexpr Rgb outline{130, 130, 130};
    if (layout.bounds.flat()) {
        if (!options.region.empty()) cover_outside(picture, layout);
        add_outline(picture.quads, layout.bounds, layout.view, layout.unit, outline);
    } else {
        add_box(picture.faces, layout.bounds, layout.view, layout.unit, outline);
        add_axes(picture, layout.view, {layout.plot_upper[0] - 40 * layout.unit, 22 * layout.unit}, layout.unit,
                 {40, 40, 40});
    }
    if (options.legend && look.separation) {
        add_arrow_key(picture, layout, add_colour_bar(picture, layout, *look.separation, 70 * layout.unit));
    } else if (options.legend && look.scale) {
        add_colour_bar(picture, layout, *look.scale);
    }
    add_legend(picture, layout, look.legend);
    add_scale_bar(picture, layout);
    std::string label;
    if (time) {
        label = "t = " + format_time(*time, look.end_time);
        if (label.ends_with(" us")) label.replace(label.size() - 2, 1, "µ");
    }
    add_title(picture, layout, look.title, label);
    return picture;
}

} // namespace abut
