#pragma once
/// Small label volumes for the tests of geometry/labels.

#include "geometry/labels/label_volume.h"
#include "geometry/packing/random.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <vector>

namespace test {

/// A plane volume from its rows as seen: the first is the top one. '.' is 0, digits are themselves.
inline abut::LabelVolume plane(const std::vector<std::string>& rows) {
    abut::LabelVolume volume;
    volume.size = {static_cast<int>(rows[0].size()), static_cast<int>(rows.size()), 1};
    for (auto row = rows.rbegin(); row != rows.rend(); ++row)
        for (const char each : *row) volume.label.push_back(each == '.' ? 0 : each - '0');
    return volume;
}

/// The inverse of plane(); labels beyond 9 go on with a, b, …
inline std::vector<std::string> rows_of(const abut::LabelVolume& volume) {
    std::vector<std::string> rows;
    for (int j = volume.size[1] - 1; j >= 0; --j) {
        rows.emplace_back();
        for (int i = 0; i < volume.size[0]; ++i) {
            const int label = volume.at(i, j, 0);
            rows.back().push_back(static_cast<char>(label == 0 ? '.' : (label < 10 ? '0' + label : 'a' + label - 10)));
        }
    }
    return rows;
}

/// Labels 0 .. labels - 1 at random, each pixel likely (with `sameness`) to be as the one before.
inline abut::LabelVolume random_volume(const std::array<int, 3>& size, int labels, double sameness,
                                       abut::Random& random) {
    abut::LabelVolume volume;
    volume.size = size;
    volume.label.resize(static_cast<std::size_t>(size[0]) * size[1] * size[2]);
    for (std::size_t p = 0; p < volume.label.size(); ++p)
        volume.label[p] = p > 0 && random.unit() < sameness ? volume.label[p - 1] : random.below(labels);
    return volume;
}

struct PixelAt {
    int x = 0, y = 0, z = 0;
};
inline PixelAt pixel_at(const abut::LabelVolume& volume, std::size_t p) {
    const auto nx = static_cast<std::size_t>(volume.size[0]), ny = static_cast<std::size_t>(volume.size[1]);
    return {static_cast<int>(p % nx), static_cast<int>(p / nx % ny), static_cast<int>(p / nx / ny)};
}

/// Whether two pixels are neighbours, by the definition: they differ by at most 1 along each axis, and along no more
/// axes than the connectivity lets them.
inline bool are_neighbours(const PixelAt& a, const PixelAt& b, int connectivity) {
    const int dx = std::abs(a.x - b.x), dy = std::abs(a.y - b.y), dz = std::abs(a.z - b.z);
    if (dx > 1 || dy > 1 || dz > 1 || dx + dy + dz == 0) return false;
    const int farthest = connectivity == 26 ? 3 : (connectivity == 8 || connectivity == 18 ? 2 : 1);
    return dx + dy + dz <= farthest;
}

/// Components by filling from each pixel in scanning order; label 0 with a connectivity of its own, 0: not at all.
inline std::vector<std::int32_t> filled(const abut::LabelVolume& volume, int connectivity, int void_connectivity) {
    std::vector<std::int32_t> number(volume.label.size(), 0);
    std::int32_t count = 0;
    for (std::size_t start = 0; start < number.size(); ++start) {
        const int way = volume.label[start] == 0 ? void_connectivity : connectivity;
        if (number[start] != 0 || way == 0) continue;
        number[start] = ++count;
        std::vector<std::size_t> open{start};
        while (!open.empty()) {
            const std::size_t p = open.back();
            open.pop_back();
            const PixelAt at = pixel_at(volume, p);
            for (int z = std::max(0, at.z - 1); z <= std::min(volume.size[2] - 1, at.z + 1); ++z)
                for (int y = std::max(0, at.y - 1); y <= std::min(volume.size[1] - 1, at.y + 1); ++y)
                    for (int x = std::max(0, at.x - 1); x <= std::min(volume.size[0] - 1, at.x + 1); ++x) {
                        const std::size_t q = volume.index(x, y, z);
                        if (number[q] != 0 || volume.label[q] != volume.label[p]) continue;
                        if (!are_neighbours(at, {x, y, z}, way)) continue;
                        number[q] = count;
                        open.push_back(q);
                    }
        }
    }
    return number;
}

} // namespace test
