#include "geometry/labels/distance.h"

#include <algorithm>
#include <limits>

namespace abut {

namespace {

/// The squared distances along one line of the raster: for each place the minimum over sources of
/// value + (distance along the line)², as the lower envelope of parabolas. The square of the spacing is rounded to 24
/// bits: products with squares of numbers of places are then exact, and results the same with and without fused
/// multiply-add.
class Line {
public:
    Line(int places, double spacing, bool border_is_outside)
        : squared_spacing_(static_cast<float>(spacing * spacing)), border_(border_is_outside), value(places),
          label(places) {
        sources_.reserve(static_cast<std::size_t>(places) + 2);
    }

    /// Replaces `value`, distances within the axes that went before, by those with this axis. What lies beyond the ends
    /// of a run of equal label is at least as far away as the ends.
    void transform() {
        const int places = static_cast<int>(value.size());
        for (int first = 0; first < places;) {
            int end = first + 1;
            while (end < places && label[end] == label[first]) ++end;
            if (label[first] != 0) transform_run(first, end);
            first = end;
        }
    }

private:
    struct Source {
        double place = 0, value = 0;
        double from = 0; ///< place from which it is the lowest
    };

    void transform_run(int first, int end) {
        sources_.clear();
        if (first > 0 || border_) add(first - 1, 0);
        for (int place = first; place < end; ++place)
            if (value[place] < std::numeric_limits<double>::infinity()) add(place, value[place]);
        if (end < static_cast<int>(value.size()) || border_) add(end, 0);
        if (sources_.empty()) return;
        std::size_t lowest = 0;
        for (int place = first; place < end; ++place) {
            while (lowest + 1 < sources_.size() && sources_[lowest + 1].from <= place) ++lowest;
            const double distance = place - sources_[lowest].place;
            value[place] = distance * distance * squared_spacing_ + sources_[lowest].value;
        }
    }

    void add(int at, double own_value) {
        const double place = at, w = squared_spacing_;
        double from = -std::numeric_limits<double>::infinity();
        while (!sources_.empty()) {
            const Source& last = sources_.back();
            from = ((own_value + place * place * w) - (last.value + last.place * last.place * w)) /
                   (2 * w * (place - last.place));
            if (from > last.from) break;
            sources_.pop_back(); // nowhere the lowest
            from = -std::numeric_limits<double>::infinity();
        }
        sources_.push_back({place, own_value, from});
    }

    double squared_spacing_ = 1; ///< holds a float
    bool border_ = false;
    std::vector<Source> sources_;

public:
    std::vector<double> value;
    std::vector<std::int32_t> label;
};

/// \param label_at label of a place of the raster
template <class LabelAt>
std::vector<float> squared_distances(const std::array<int, 3>& size, const std::array<double, 3>& spacing,
                                     const std::array<bool, 3>& border_is_outside, const LabelAt& label_at) {
    const std::size_t count = static_cast<std::size_t>(size[0]) * size[1] * size[2];
    std::vector<float> squared(count);
    for (std::size_t p = 0; p < count; ++p)
        squared[p] = label_at(p) == 0 ? 0.0F : std::numeric_limits<float>::infinity();
    std::size_t stride = 1;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto places = static_cast<std::size_t>(size[axis]);
        if (places > 1 || border_is_outside[axis]) {
            Line line(size[axis], spacing[axis], border_is_outside[axis]);
            for (std::size_t block = 0; block < count; block += stride * places) {
                for (std::size_t start = block; start < block + stride; ++start) {
                    for (std::size_t k = 0; k < places; ++k) {
                        line.value[k] = squared[start + k * stride];
                        line.label[k] = label_at(start + k * stride);
                    }
                    line.transform();
                    for (std::size_t k = 0; k < places; ++k)
                        squared[start + k * stride] = static_cast<float>(line.value[k]);
                }
            }
        }
        stride *= places;
    }
    return squared;
}

} // namespace

std::vector<float> squared_distance_to_others(const LabelVolume& volume, const std::array<double, 3>& spacing,
                                              const std::array<bool, 3>& border_is_outside) {
    return squared_distances(volume.size, spacing, border_is_outside, [&](std::size_t p) { return volume.label[p]; });
}

std::vector<float> squared_distance_to_outside(const std::vector<bool>& inside, const std::array<int, 3>& size,
                                               const std::array<double, 3>& spacing,
                                               const std::array<bool, 3>& border_is_outside) {
    return squared_distances(size, spacing, border_is_outside,
                             [&](std::size_t p) { return static_cast<std::int32_t>(inside[p]); });
}

} // namespace abut
