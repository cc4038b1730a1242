#include "geometry/image_particles.h"

#include "grid/effective_cell.h"

#include <algorithm>
#include <cmath>

namespace abut {

namespace {

/// The pixels that a lattice place covers along one axis, and the share of its edge that each of them takes.
struct Span {
    int first_pixel = 0;
    std::vector<double> share;
};

/// Lattice places along one axis that touch the picture.
struct AxisCover {
    std::vector<double> centre; ///< [m]
    std::vector<Span> span;
};

AxisCover cover_axis(double grid_lower, double particle, int places, double image_lower, double pixel, int pixels) {
    AxisCover cover;
    const double image_upper = image_lower + pixels * pixel;
    // Both ends in double: a picture far outside the grid must not overflow an int.
    const double first = std::max(0.0, std::floor((image_lower - grid_lower) / particle));
    const double end = std::min<double>(places, std::ceil((image_upper - grid_lower) / particle));
    if (!(first < end)) return cover;
    for (int place = static_cast<int>(first); place < end; ++place) {
        // Edges of the place, counted in pixels from the picture's lower edge.
        const double a = (grid_lower + place * particle - image_lower) / pixel;
        const double b = (grid_lower + (place + 1) * particle - image_lower) / pixel;
        const int from = std::max(0, static_cast<int>(std::floor(a)));
        const int to = std::min(pixels, static_cast<int>(std::ceil(b)));
        if (from >= to) continue;
        Span span{from, {}};
        for (int k = from; k < to; ++k)
            span.share.push_back(std::max(0.0, std::min(b, k + 1.0) - std::max(a, static_cast<double>(k))) / (b - a));
        cover.centre.push_back(grid_lower + (place + 0.5) * particle);
        cover.span.push_back(std::move(span));
    }
    return cover;
}

/// Areas of the labels within one place. Only the labels it meets are touched, so that thousands of bodies cost
/// nothing.
class AreaPerLabel {
public:
    explicit AreaPerLabel(std::size_t labels) : area_(labels, 0.0) {}

    void add(int label, double area) {
        if (area_[label] == 0) met_.push_back(label);
        area_[label] += area;
    }

    /// The label of the largest area of a place of area 1, 0 for void. Empties the store.
    int take_majority() {
        double covered = 0;
        for (const int label : met_) covered += area_[label];
        area_[0] += std::max(0.0, 1.0 - covered); // beyond the picture
        double largest = area_[0];
        for (const int label : met_) largest = std::max(largest, area_[label]);
        constexpr double tie = 1e-9; // larger than round-off, smaller than any intended difference
        int winner = 0;
        for (const int label : met_)
            if (label > 0 && area_[label] >= largest - tie && (winner == 0 || label < winner)) winner = label;
        for (const int label : met_) area_[label] = 0;
        area_[0] = 0;
        met_.clear();
        return winner;
    }

private:
    std::vector<double> area_;
    std::vector<int> met_;
};

} // namespace

std::array<double, 2> pixel_size(const ImageSpec& spec, int width, int height) {
    if (spec.pixel[0] > 0 && spec.pixel[1] > 0) return {spec.pixel[0], spec.pixel[1]};
    return {spec.size[0] / width, spec.size[1] / height};
}

ImageParticles image_particles(const ImageSpec& spec, const LabelledPicture& image, const GridSpec& grid) {
    const Vector cell = effective_cell(grid);
    const std::array<int, 3> cells = cell_counts(grid);
    const std::array<double, 2> pixel = pixel_size(spec, image.width, image.height);
    const int per_cell = spec.particles_per_cell;
    const double edge_x = cell[0] / per_cell, edge_y = cell[1] / per_cell;
    const AxisCover x = cover_axis(grid.lower[0], edge_x, cells[0] * per_cell, spec.lower[0], pixel[0], image.width);
    const AxisCover y = cover_axis(grid.lower[1], edge_y, cells[1] * per_cell, spec.lower[1], pixel[1], image.height);

    ImageParticles result;
    result.half_size = {edge_x / 2, edge_y / 2, 0};
    result.position.resize(image.bodies.size());
    AreaPerLabel areas(image.bodies.size() + 1);
    for (std::size_t j = 0; j < y.span.size(); ++j) {
        for (std::size_t i = 0; i < x.span.size(); ++i) {
            for (std::size_t l = 0; l < y.span[j].share.size(); ++l) {
                const int from_below = y.span[j].first_pixel + static_cast<int>(l);
                const int row = spec.first_row_is_up ? image.height - 1 - from_below : from_below;
                const int* label = &image.label[static_cast<std::size_t>(row) * image.width + x.span[i].first_pixel];
                for (std::size_t k = 0; k < x.span[i].share.size(); ++k)
                    areas.add(label[k], x.span[i].share[k] * y.span[j].share[l]);
            }
            const int winner = areas.take_majority();
            if (winner > 0) result.position[winner - 1].push_back({x.centre[i], y.centre[j], 0});
        }
    }
    return result;
}

} // namespace abut
