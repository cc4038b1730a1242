#pragma once
/// \file label_volume.h
/// What each pixel of a picture or a stack is, in the axes of the scene.

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace abut {

/// A number per pixel. x runs fastest and to the right, then y upwards, then z (one slice in plane scenes).
struct LabelVolume {
    std::array<int, 3> size{};       ///< pixels along x, y, z
    std::vector<std::int32_t> label; ///< 0 void, k > 0: body k - 1 (or what else it is said to be)

    std::size_t index(int i, int j, int k) const { return (static_cast<std::size_t>(k) * size[1] + j) * size[0] + i; }
    std::int32_t at(int i, int j, int k) const { return label[index(i, j, k)]; }
};

} // namespace abut
