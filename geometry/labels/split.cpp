#include "geometry/labels/split.h"

#include "geometry/labels/distance.h"
#include "geometry/labels/neighbours.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>

namespace abut {

namespace {

using Pixel = std::uint32_t;
constexpr Pixel none = std::numeric_limits<Pixel>::max();

/// Pixels with distances larger than 0 from the largest distance to the smallest, equal ones in scanning order. The
/// bits of floats that are not negative have the order of their values: a radix sort with digits of 11 bits.
std::vector<Pixel> by_falling_distance(const std::vector<float>& squared) {
    constexpr std::uint32_t digits = 2048;
    const auto digit = [&](Pixel p, int pass) {
        return digits - 1 - ((std::bit_cast<std::uint32_t>(squared[p]) >> (11 * pass)) & (digits - 1));
    };
    std::vector<Pixel> order;
    order.reserve(static_cast<std::size_t>(
        std::count_if(squared.begin(), squared.end(), [](float distance) { return distance > 0; })));
    for (std::size_t p = 0; p < squared.size(); ++p)
        if (squared[p] > 0) order.push_back(static_cast<Pixel>(p));
    std::vector<Pixel> sorted(order.size());
    for (int pass = 0; pass < 3; ++pass) {
        std::vector<std::size_t> start(digits + 1, 0);
        for (const Pixel p : order) ++start[digit(p, pass) + 1];
        for (std::size_t k = 0; k < digits; ++k) start[k + 1] += start[k];
        for (const Pixel p : order) sorted[start[digit(p, pass)]++] = p;
        order.swap(sorted);
    }
    return order;
}

/// The distinct distances, falling, and the place of each pixel's distance among them.
struct Levels {
    std::vector<double> distance;
    std::vector<std::uint32_t> of_pixel; ///< none where the distance is 0
};

Levels levels_of(const std::vector<float>& squared, const std::vector<Pixel>& order) {
    Levels levels;
    levels.of_pixel.assign(squared.size(), none);
    float last = -1;
    for (const Pixel p : order) {
        if (squared[p] != last) {
            last = squared[p];
            levels.distance.push_back(std::sqrt(static_cast<double>(last)));
        }
        levels.of_pixel[p] = static_cast<std::uint32_t>(levels.distance.size() - 1);
    }
    return levels;
}

/// The highest pixels of the parts. Water falls from the highest level: each pixel that it uncovers joins the islands
/// beside it, and where several meet, those with lower peaks end. Those that stood out far enough are parts.
std::vector<Pixel> markers_of(const LabelVolume& components, const Neighbours& neighbours, const Levels& levels,
                              const std::vector<Pixel>& order, double depth) {
    std::vector<Pixel> parent(components.label.size(), none); // none: under water. The root of an island is its peak
    const auto root = [&](Pixel p) {
        while (parent[p] != p) {
            parent[p] = parent[parent[p]];
            p = parent[p];
        }
        return p;
    };
    const auto is_higher = [&](Pixel a, Pixel b) {
        return levels.of_pixel[a] != levels.of_pixel[b] ? levels.of_pixel[a] < levels.of_pixel[b] : a < b;
    };
    std::vector<Pixel> markers;
    for (const Pixel p : order) {
        const double level = levels.distance[levels.of_pixel[p]];
        Pixel island = p;
        parent[p] = p;
        neighbours.visit(p, [&](std::size_t q) {
            if (parent[q] == none || components.label[q] != components.label[p]) return;
            Pixel other = root(static_cast<Pixel>(q));
            if (other == island) return;
            if (is_higher(other, island)) std::swap(other, island);
            if (levels.distance[levels.of_pixel[other]] - level >= depth) markers.push_back(other);
            parent[other] = island;
        });
    }
    for (const Pixel p : order)
        if (parent[p] == p) markers.push_back(p); // the highest of its component
    std::sort(markers.begin(), markers.end());
    return markers;
}

/// Pixels waiting at each level, first in, first out. Each pixel comes in once.
class Queues {
public:
    /// \param next memory for as many numbers as there are pixels
    Queues(std::size_t levels, std::vector<Pixel> next)
        : first_(levels, none), last_(levels, none), next_(std::move(next)) {}

    void push(std::uint32_t level, Pixel p) {
        next_[p] = none;
        (first_[level] == none ? first_[level] : next_[last_[level]]) = p;
        last_[level] = p;
    }
    bool is_empty(std::uint32_t level) const { return first_[level] == none; }
    Pixel pop(std::uint32_t level) {
        const Pixel p = first_[level];
        first_[level] = next_[p];
        return p;
    }

private:
    std::vector<Pixel> first_, last_, next_;
};

} // namespace

std::vector<std::int32_t> split_at_necks(Components& components, int connectivity, const std::array<double, 3>& spacing,
                                         double depth) {
    LabelVolume& volume = components.volume;
    const double unit = *std::min_element(spacing.begin(), spacing.end());
    std::vector<float> squared =
        squared_distance_to_others(volume, {spacing[0] / unit, spacing[1] / unit, spacing[2] / unit});
    std::vector<Pixel> order = by_falling_distance(squared);
    if (order.empty() || std::isinf(squared[order.front()])) { // no body, or one that has no outside
        std::vector<std::int32_t> same(static_cast<std::size_t>(components.count));
        std::iota(same.begin(), same.end(), 1);
        return same;
    }
    const Levels levels = levels_of(squared, order);
    squared = std::vector<float>(); // "= {}" would keep the memory
    const Neighbours neighbours(volume.size, connectivity);
    const std::vector<Pixel> markers = markers_of(volume, neighbours, levels, order, depth);

    order.resize(volume.label.size()); // its memory serves once more
    Queues waiting(levels.distance.size(), std::move(order));
    std::vector<std::int32_t> component_of_part;
    // A pixel's component is overwritten by its part, with a minus sign, when it comes to it.
    const auto take = [&](std::uint32_t level, std::size_t p, std::int32_t part) {
        volume.label[p] = -part;
        waiting.push(std::max(level, levels.of_pixel[p]), static_cast<Pixel>(p));
    };
    for (const Pixel marker : markers) {
        component_of_part.push_back(volume.label[marker]);
        take(0, marker, static_cast<std::int32_t>(component_of_part.size()));
    }
    for (std::uint32_t level = 0; level < levels.distance.size(); ++level) {
        while (!waiting.is_empty(level)) {
            const Pixel p = waiting.pop(level);
            const std::int32_t part = -volume.label[p];
            const std::int32_t component = component_of_part[static_cast<std::size_t>(part - 1)];
            neighbours.visit(p, [&](std::size_t q) {
                if (volume.label[q] == component) take(level, q, part);
            });
        }
    }
    for (std::int32_t& label : volume.label) label = -label;
    std::vector<std::int32_t> component_of_number;
    for (const std::int32_t part : number_in_scanning_order(volume))
        component_of_number.push_back(component_of_part[static_cast<std::size_t>(part - 1)]);
    components.count = static_cast<std::int32_t>(component_of_number.size());
    return component_of_number;
}

} // namespace abut
