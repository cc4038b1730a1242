#pragma once
/// \file neighbours.h
/// The neighbours of a pixel of a raster that is met in no particular order.

#include "geometry/labels/components.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace abut {

/// Neighbours within a raster of a certain size, of fewer than 2^32 places.
class Neighbours {
public:
    Neighbours(const std::array<int, 3>& size, int connectivity)
        : size_(size), axes_(connectivity == 4 || connectivity == 8 ? 2 : 3), steps_(neighbour_steps(connectivity)) {
        for (const auto& [dx, dy, dz] : steps_)
            offset_.push_back((static_cast<std::ptrdiff_t>(dz) * size[1] + dy) * size[0] + dx);
    }

    /// Calls visit(place) for each neighbour of a place, in scanning order.
    template <class Visit>
    void visit(std::size_t place, const Visit& visit_one) const {
        const auto nx = static_cast<std::uint32_t>(size_[0]), ny = static_cast<std::uint32_t>(size_[1]);
        const std::uint32_t row = static_cast<std::uint32_t>(place) / nx; // division of 64 bits is much slower
        const std::array<int, 3> at{static_cast<int>(place - row * std::size_t{nx}), static_cast<int>(row % ny),
                                    static_cast<int>(row / ny)};
        bool inner = true;
        for (std::size_t axis = 0; axis < axes_; ++axis) inner = inner && at[axis] > 0 && at[axis] + 1 < size_[axis];
        for (std::size_t k = 0; k < steps_.size(); ++k) {
            if (!inner && !is_inside(at, steps_[k])) continue;
            visit_one(static_cast<std::size_t>(static_cast<std::ptrdiff_t>(place) + offset_[k]));
        }
    }

private:
    bool is_inside(const std::array<int, 3>& at, const std::array<int, 3>& step) const {
        for (std::size_t axis = 0; axis < 3; ++axis)
            if (at[axis] + step[axis] < 0 || at[axis] + step[axis] >= size_[axis]) return false;
        return true;
    }

    std::array<int, 3> size_{};
    std::size_t axes_ = 3; ///< along which steps go
    std::vector<std::array<int, 3>> steps_;
    std::vector<std::ptrdiff_t> offset_;
};

} // namespace abut
