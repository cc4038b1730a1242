#pragma once
/// \file effective_cell.h
/// The cells a grid box really gets: the wanted size, adjusted so that a whole number of cells fits.

#include "scene/scene.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace abut {

/// Number of cells per axis: the nearest whole number to (upper - lower) / cell, at least 1. An axis without extent or
/// without a cell size (z of two-dimensional scenes) counts as 1.
inline std::array<int, 3> cell_counts(const GridSpec& grid) {
    std::array<int, 3> counts{1, 1, 1};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double extent = grid.upper[axis] - grid.lower[axis];
        if (grid.cell[axis] > 0 && extent > 0)
            counts[axis] = std::max(1, static_cast<int>(std::lround(extent / grid.cell[axis])));
    }
    return counts;
}

/// Cell size per axis [m] that divides the box in cell_counts() cells; an axis without extent keeps the wanted size.
inline Vector effective_cell(const GridSpec& grid) {
    const std::array<int, 3> counts = cell_counts(grid);
    Vector cell = grid.cell;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double extent = grid.upper[axis] - grid.lower[axis];
        if (extent > 0) cell[axis] = extent / counts[axis];
    }
    return cell;
}

} // namespace abut
