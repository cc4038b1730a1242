#include "io/render/contact_arrows.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <stdexcept>

namespace abut {
namespace {

// Sizes in units of Layout::unit.
constexpr double arrow_length = 25, shaft = 4.5, head_length = 11, head_width = 12, edge = 1.2, thin = 1.6;
constexpr double key_font = 16, key_line = 26, key_gap = 10;
constexpr Rgb ink{40, 40, 40};

const Array& contact_array(const PointFrame& contact, const char* name, int components) {
    const Array* array = find_array(contact, name);
    if (!array || array->components != components)
        throw std::runtime_error(fmt::format("contact.pvd: its files lack the array \"{}\"", name));
    return *array;
}

/// The least distance of nodes along an axis: the cell's size where pairs have neighbours; infinite for a single node.
double node_spacing(const PointFrame& contact) {
    double spacing = INFINITY;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        std::vector<double> places;
        for (std::size_t i = axis; i < contact.points.size(); i += 3) places.push_back(contact.points[i]);
        if (places.empty()) return INFINITY;
        std::sort(places.begin(), places.end());
        const double round_off = 1e-9 * std::max(std::abs(places.front()), std::abs(places.back()));
        for (std::size_t i = 1; i < places.size(); ++i)
            if (const double gap = places[i] - places[i - 1]; gap > round_off) spacing = std::min(spacing, gap);
    }
    return spacing;
}

/// Along `u` (unit vector), filled; `grown` by so much on all sides.
void add_bold(Quads& quads, const Pixel& from, const Pixel& u, double length, double unit, double grown, Rgb colour) {
    const double head = std::min(head_length * unit, length), half = shaft * unit / 2 + grown;
    const double wing = head_width * unit / 2;
    const auto at = [&](double along, double across) {
        return Pixel{from[0] + along * u[0] - across * u[1], from[1] + along * u[1] + across * u[0]};
    };
    const double neck = length - head;
    if (neck > 0) quads.add(at(-grown, -half), at(neck, -half), at(neck, half), at(-grown, half), colour);
    // The offset of a triangle's sides by `grown`.
    const double slope = std::hypot(head, wing), tip = grown * slope / wing, corner = grown * (slope + wing) / head;
    quads.add(at(neck - grown, -wing - corner), at(length + tip, 0), at(length + tip, 0),
              at(neck - grown, wing + corner), colour);
}

/// Likewise, of lines, with an open head.
void add_thin(Quads& quads, const Pixel& from, const Pixel& u, double length, double unit, double width, Rgb colour) {
    const double head = std::min(0.7 * head_length * unit, length), wing = 0.35 * head_width * unit;
    const Pixel tip{from[0] + length * u[0], from[1] + length * u[1]};
    add_line(quads, from, tip, width, colour);
    for (const double side : {-1.0, 1.0})
        add_line(quads, tip, {tip[0] - head * u[0] - side * wing * u[1], tip[1] - head * u[1] + side * wing * u[0]},
                 width, colour);
}

void add_arrow_of_pair(Quads& quads, const Pixel& from, const Pixel& u, double length, double unit, bool touching,
                       Rgb colour) {
    if (touching) {
        add_bold(quads, from, u, length, unit, edge * unit, ink);
        add_bold(quads, from, u, length, unit, 0, colour);
    } else {
        add_thin(quads, from, u, length, unit, (thin + 1.4) * unit, {255, 255, 255}); // stands out on every body
        add_thin(quads, from, u, length, unit, thin * unit, colour);
    }
}

} // namespace

std::vector<double> separations_in_contact(const PointFrame& contact) {
    const auto touching = values_of(contact_array(contact, "in_contact", 1), -1);
    std::vector<double> separations = values_of(contact_array(contact, "separation", 1), -1);
    std::size_t kept = 0;
    for (std::size_t i = 0; i < touching.size(); ++i)
        if (touching[i] == 1) separations[kept++] = separations[i];
    separations.resize(kept);
    return separations;
}

ColourScale separation_scale(Range range, bool exact) {
    if (range && !exact) { // both signs, also where all pairs are apart
        const double size = std::max(std::abs(range->first), std::abs(range->second));
        range = std::pair(-size, size);
    }
    ColourScale scale = colour_scale({"separation", 1, std::vector<double>{}}, -1, range, exact);
    scale.map = ColourMap::diverging;
    return scale;
}

void add_normals(Picture& picture, const PointFrame& contact, const Layout& layout) {
    const auto& n = std::get<0>(contact_array(contact, "normal", 3).values);
    const auto touching = values_of(contact_array(contact, "in_contact", 1), -1);
    for (std::size_t i = 0; i < touching.size(); ++i)
        if (touching[i] == 1)
            add_arrow(picture.quads, layout.view.pixel(&contact.points[3 * i]), layout.view.direction(&n[3 * i]),
                      24 * layout.unit, 2 * layout.unit, {20, 20, 20});
}

void add_separations(Picture& picture, const PointFrame& contact, const Layout& layout, const ColourScale& scale) {
    const auto& n = std::get<0>(contact_array(contact, "normal", 3).values);
    const auto touching = values_of(contact_array(contact, "in_contact", 1), -1);
    const auto separation = values_of(contact_array(contact, "separation", 1), -1);
    // Sizes of arrows shrink with their length, but not to where nothing is seen of them.
    const double longest = arrow_length * layout.unit;
    const double length = std::clamp(node_spacing(contact) * layout.view.scale, 0.4 * longest, longest);
    const double unit = layout.unit * length / longest;
    for (const double kind : {0.0, 1.0}) // pairs in contact cover those apart
        for (std::size_t i = 0; i < touching.size(); ++i) {
            if (touching[i] != kind) continue;
            const Pixel d = layout.view.direction(&n[3 * i]);
            const double seen = std::hypot(d[0], d[1]) / layout.view.scale; // 1 across the line of sight
            if (!(seen > 1e-6)) continue;
            const Pixel u{d[0] / layout.view.scale / seen, d[1] / layout.view.scale / seen};
            add_arrow_of_pair(picture.quads, layout.view.pixel(&contact.points[3 * i]), u, length * std::min(1.0, seen),
                              unit, kind == 1, scale.colour(separation[i]));
        }
}

double arrow_key_width(double unit) {
    return (24 + arrow_length + key_gap) * unit + text_width("in contact", key_font * unit);
}

void add_arrow_key(Picture& picture, const Layout& layout, double top) {
    const double unit = layout.unit, left = std::round(layout.plot_upper[0] + 24 * unit);
    double y = top - (key_line + 10) * unit;
    constexpr Rgb grey{150, 150, 150};
    for (const bool touching : {true, false}) {
        add_arrow_of_pair(picture.quads, {left, y}, {1, 0}, arrow_length * unit, unit, touching, grey);
        picture.labels.push_back({touching ? "in contact" : "apart",
                                  {left + (arrow_length + key_gap) * unit, y - 0.36 * key_font * unit},
                                  key_font * unit,
                                  Align::left,
                                  false,
                                  ink});
        y -= key_line * unit;
    }
}

} // namespace abut
