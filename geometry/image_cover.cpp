#include "geometry/image_cover.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace abut {

namespace {

/// The pixels that a place covers along one axis.
struct Span1D {
    int first_pixel = 0;
    std::vector<double>
        edge; ///< ends of the pieces, from the place's lower side [edges of the place]; one more than pieces
    std::size_t pixels() const { return edge.size() - 1; }
    double share(std::size_t k) const { return edge[k + 1] - edge[k]; }
};

/// Places along one axis that touch the image.
struct AxisCover {
    std::int32_t first_place = 0;
    std::vector<Span1D> span;
};

/// A place's span; without pixels where it does not meet the image.
Span1D span_of(double lower, double edge, double image_lower, double pixel, int pixels) {
    const double a = (lower - image_lower) / pixel; // counted in pixels from the image's lower side
    const double b = (lower + edge - image_lower) / pixel;
    const int from = std::max(0, static_cast<int>(std::floor(std::clamp(a, -1.0, pixels + 1.0))));
    const int to = std::min(pixels, static_cast<int>(std::ceil(std::clamp(b, -1.0, pixels + 1.0))));
    Span1D span{from, {}};
    if (from < to)
        for (int k = from; k <= to; ++k) span.edge.push_back((std::clamp<double>(k, a, b) - a) / (b - a));
    else
        span.edge.push_back(0);
    return span;
}

AxisCover cover_axis(const Lattice& lattice, std::size_t axis, std::int32_t places, const ImageFrame& frame,
                     int pixels) {
    AxisCover cover;
    if (axis >= lattice.dimension) {
        cover.span.push_back({0, {0, 1}});
        return cover;
    }
    const double edge = lattice.edge[axis];
    const double image_lower = frame.lower[axis];
    // Both ends in double: an image far outside the grid must not overflow an int.
    const double first = std::max(0.0, std::floor((image_lower - lattice.lower[axis]) / edge));
    const double end =
        std::min<double>(places, std::ceil((image_lower + pixels * frame.pixel[axis] - lattice.lower[axis]) / edge));
    if (!(first < end)) return cover;
    cover.first_place = static_cast<std::int32_t>(first);
    for (std::int32_t place = cover.first_place; place < end; ++place)
        cover.span.push_back(span_of(lattice.lower[axis] + place * edge, edge, image_lower, frame.pixel[axis], pixels));
    return cover;
}

/// Moments of the labels within one place. Only the labels it meets are touched, so that thousands of bodies cost
/// nothing.
class MomentsPerLabel {
public:
    explicit MomentsPerLabel(std::size_t labels) : moments_(labels) {}

    void add(std::int32_t label, const Vector& lower, const Vector& upper, std::size_t dimension) {
        Moments& moments = moments_[static_cast<std::size_t>(label)];
        if (moments.content == 0) met_.push_back(label);
        moments.add(lower, upper, dimension);
    }

    const std::vector<std::int32_t>& met() const { return met_; }
    const Moments& of(std::int32_t label) const { return moments_[static_cast<std::size_t>(label)]; }

    /// The label of the largest share, 0 for void. Of equal shares the lower one in the place wins (of equally high
    /// ones the left one): what bodies win at their upper and right sides they lose at the others, so that areas are
    /// not biased where pixels fit places by halves. Where that is equal too, the lower label, and void last.
    std::int32_t majority(std::size_t dimension) const {
        Moments rest; // void, and what lies beyond the image
        rest.content = 1;
        for (std::size_t a = 0; a < dimension; ++a) rest.first[a] = 0.5;
        double largest = 0;
        for (const std::int32_t label : met_) {
            if (label == 0) continue;
            largest = std::max(largest, of(label).content);
            rest.content -= of(label).content;
            for (std::size_t a = 0; a < dimension; ++a) rest.first[a] -= of(label).first[a];
        }
        constexpr double tie = 1e-9; // larger than round-off, smaller than any intended difference
        if (largest < rest.content - tie) return 0;
        const Moments* best = nullptr;
        std::int32_t winner = 0;
        const auto try_label = [&](std::int32_t label, const Moments& moments) {
            if (moments.content < largest - tie) return;
            const int order = best ? lower_or_left(moments, *best, dimension) : 1;
            if (order < 0 || (order == 0 && (label == 0 || (winner > 0 && label > winner)))) return;
            best = &moments;
            winner = label;
        };
        for (const std::int32_t label : met_)
            if (label > 0) try_label(label, of(label));
        try_label(0, rest);
        return winner;
    }

    void clear() {
        for (const std::int32_t label : met_) moments_[static_cast<std::size_t>(label)] = {};
        met_.clear();
    }

private:
    /// 1 if the centre of a lies below (behind, to the left of) that of b, -1 if above, 0 if they coincide.
    static int lower_or_left(const Moments& a, const Moments& b, std::size_t dimension) {
        for (std::size_t axis = dimension; axis-- > 0;) {
            const double way = b.first[axis] / b.content - a.first[axis] / a.content;
            if (std::abs(way) > 1e-9) return way > 0 ? 1 : -1;
        }
        return 0;
    }

    std::vector<Moments> moments_;
    std::vector<std::int32_t> met_;
};

/// Calls piece(label, lower, upper) for the pieces of pixels in a place.
template <class Piece>
void for_pieces(const LabelVolume& image, const Span1D& x, const Span1D& y, const Span1D& z, Piece&& piece) {
    if (x.pixels() == 0) return;
    for (std::size_t n = 0; n < z.pixels(); ++n)
        for (std::size_t m = 0; m < y.pixels(); ++m) {
            const std::int32_t* label = &image.label[image.index(x.first_pixel, y.first_pixel + static_cast<int>(m),
                                                                 z.first_pixel + static_cast<int>(n))];
            for (std::size_t l = 0; l < x.pixels(); ++l)
                if (x.share(l) > 0 && y.share(m) > 0 && z.share(n) > 0)
                    piece(label[l], Vector{x.edge[l], y.edge[m], z.edge[n]},
                          Vector{x.edge[l + 1], y.edge[m + 1], z.edge[n + 1]});
        }
}

} // namespace

std::vector<std::vector<Covered>> cover_image(const LabelVolume& image, std::size_t bodies, const ImageFrame& frame,
                                              const Lattice& lattice, const Place& places, Fill fill) {
    const AxisCover x = cover_axis(lattice, 0, places[0], frame, image.size[0]);
    const AxisCover y = cover_axis(lattice, 1, places[1], frame, image.size[1]);
    const AxisCover z = cover_axis(lattice, 2, places[2], frame, image.size[2]);
    std::vector<std::vector<Covered>> result(bodies);
    MomentsPerLabel moments(bodies + 1);
    for (std::size_t k = 0; k < z.span.size(); ++k)
        for (std::size_t j = 0; j < y.span.size(); ++j)
            for (std::size_t i = 0; i < x.span.size(); ++i) {
                const Place place{x.first_place + static_cast<std::int32_t>(i),
                                  y.first_place + static_cast<std::int32_t>(j),
                                  z.first_place + static_cast<std::int32_t>(k)};
                for_pieces(image, x.span[i], y.span[j], z.span[k],
                           [&](std::int32_t label, const Vector& lower, const Vector& upper) {
                               moments.add(label, lower, upper, lattice.dimension);
                           });
                if (fill == Fill::majority) {
                    if (const std::int32_t winner = moments.majority(lattice.dimension); winner > 0)
                        result[static_cast<std::size_t>(winner - 1)].push_back(whole(lattice, place));
                } else {
                    for (const std::int32_t label : moments.met()) {
                        const Moments& m = moments.of(label);
                        if (label == 0 || m.content < least_fraction) continue;
                        result[static_cast<std::size_t>(label - 1)].push_back(
                            m.content > 1 - 1e-12 ? whole(lattice, place) : m.covered(lattice, place));
                    }
                }
                moments.clear();
            }
    return result;
}

std::vector<double> mean_over_places(const LabelVolume& values, const LabelVolume& image, std::int32_t label,
                                     const ImageFrame& frame, const Lattice& lattice,
                                     const std::vector<Place>& places) {
    LabelVolume pixels{values.size, {}}; // numbers of pixels, to look up both images by
    pixels.label.resize(values.label.size());
    std::iota(pixels.label.begin(), pixels.label.end(), 0);
    std::vector<double> means;
    means.reserve(places.size());
    const auto span = [&](std::size_t axis, const Place& place) {
        if (axis >= lattice.dimension) return Span1D{0, {0, 1}};
        return span_of(lattice.lower[axis] + place[axis] * lattice.edge[axis], lattice.edge[axis], frame.lower[axis],
                       frame.pixel[axis], values.size[axis]);
    };
    for (const Place& place : places) {
        std::array<double, 2> sum{}; // over the body's pixels, and over all
        std::array<double, 2> share{};
        for_pieces(pixels, span(0, place), span(1, place), span(2, place),
                   [&](std::int32_t pixel, const Vector& lower, const Vector& upper) {
                       const auto p = static_cast<std::size_t>(pixel);
                       const double size = (upper[0] - lower[0]) * (upper[1] - lower[1]) * (upper[2] - lower[2]);
                       for (std::size_t of = image.label[p] == label ? 0 : 1; of < 2; ++of) {
                           sum[of] += size * values.label[p];
                           share[of] += size;
                       }
                   });
        const std::size_t of = share[0] > 0 ? 0 : 1;
        means.push_back(share[of] > 0 ? sum[of] / share[of] : 0);
    }
    return means;
}

std::int32_t value_at(const LabelVolume& values, const ImageFrame& frame, std::size_t dimension, const Vector& x) {
    std::array<int, 3> pixel{};
    for (std::size_t a = 0; a < dimension; ++a)
        pixel[a] = static_cast<int>(std::clamp(std::floor((x[a] - frame.lower[a]) / frame.pixel[a]), 0.0,
                                               static_cast<double>(values.size[a] - 1)));
    return values.at(pixel[0], pixel[1], pixel[2]);
}

} // namespace abut
