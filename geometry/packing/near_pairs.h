#pragma once
/// \file near_pairs.h
/// Which of many round things are near each other, by a grid of cells.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace abut {

template <int D>
using PointD = std::array<double, D>;

/// All pairs whose centres are nearer than the sum of their reaches and `margin`, always in the same order.
/// \param box centres lie in [0, box]
template <int D>
std::vector<std::array<int, 2>> near_pairs(const std::vector<PointD<D>>& centres, const std::vector<double>& reach,
                                           const PointD<D>& box, double margin) {
    const double largest = reach.empty() ? 0 : *std::max_element(reach.begin(), reach.end());
    const double wanted = 2 * largest + margin;
    const double most = std::ceil(std::pow(static_cast<double>(centres.size()) + 1, 1.0 / D)) + 1; // cells per axis
    std::array<int, D> cells{};
    std::size_t count = 1;
    for (int axis = 0; axis < D; ++axis) {
        cells[axis] = static_cast<int>(std::clamp(std::floor(box[axis] / wanted), 1.0, 2 * most));
        count *= cells[axis];
    }
    const auto cell_of = [&](const PointD<D>& x) {
        std::array<int, D> cell{};
        for (int axis = 0; axis < D; ++axis)
            cell[axis] = std::clamp(static_cast<int>(x[axis] / box[axis] * cells[axis]), 0, cells[axis] - 1);
        return cell;
    };
    const auto number = [&](const std::array<int, D>& cell) {
        std::size_t result = 0;
        for (int axis = D - 1; axis >= 0; --axis) result = result * cells[axis] + cell[axis];
        return result;
    };
    std::vector<std::vector<int>> inside(count);
    for (std::size_t k = 0; k < centres.size(); ++k) inside[number(cell_of(centres[k]))].push_back(static_cast<int>(k));

    std::vector<std::array<int, 2>> pairs;
    int around = 1;
    for (int axis = 0; axis < D; ++axis) around *= 3;
    for (std::size_t k = 0; k < centres.size(); ++k) {
        const std::array<int, D> own = cell_of(centres[k]);
        for (int code = 0; code < around; ++code) {
            std::array<int, D> cell = own;
            bool exists = true;
            for (int axis = 0, rest = code; axis < D; ++axis, rest /= 3) {
                cell[axis] += rest % 3 - 1;
                exists = exists && cell[axis] >= 0 && cell[axis] < cells[axis];
            }
            if (!exists) continue;
            for (const int other : inside[number(cell)]) {
                if (other <= static_cast<int>(k)) continue;
                double square = 0;
                for (int axis = 0; axis < D; ++axis)
                    square += (centres[k][axis] - centres[other][axis]) * (centres[k][axis] - centres[other][axis]);
                const double limit = reach[k] + reach[other] + margin;
                if (square < limit * limit) pairs.push_back({static_cast<int>(k), other});
            }
        }
    }
    return pairs;
}

} // namespace abut
