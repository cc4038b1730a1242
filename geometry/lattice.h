#pragma once
/// \file lattice.h
/// The lattice of places that particles are put in.

#include "grid/effective_cell.h"
#include "scene/scene.h"

#include <array>
#include <cmath>
#include <cstdint>

namespace abut {

/// Number of a place along each axis.
using Place = std::array<std::int32_t, 3>;

/// Places: equal boxes side by side, without end. Axes beyond its dimension have the one place 0 and no extent.
struct Lattice {
    std::size_t dimension = 2;
    Vector lower{}; ///< an outer corner of place (0, 0, 0), not its centre [m]
    Vector edge{};  ///< of a place [m]

    double centre(std::size_t axis, std::int32_t place) const {
        return axis < dimension ? lower[axis] + (place + 0.5) * edge[axis] : 0;
    }
    Vector centre(const Place& place) const { return {centre(0, place[0]), centre(1, place[1]), centre(2, place[2])}; }
    Vector half_size() const { return {edge[0] / 2, edge[1] / 2, edge[2] / 2}; }
    /// Area or volume of a place [m^2, m^3].
    double content() const { return edge[0] * edge[1] * (dimension == 3 ? edge[2] : 1); }
    double shortest_edge() const {
        double shortest = edge[0];
        for (std::size_t axis = 1; axis < dimension; ++axis) shortest = std::min(shortest, edge[axis]);
        return shortest;
    }
    /// The place that holds a coordinate.
    std::int32_t place(std::size_t axis, double x) const {
        return axis < dimension ? static_cast<std::int32_t>(std::floor((x - lower[axis]) / edge[axis])) : 0;
    }
    bool operator==(const Lattice&) const = default;
};

/// The lattice that all bodies share: cells of the grid divided by particles_per_cell, from the grid's lower corner.
inline Lattice grid_lattice(const GridSpec& grid, int particles_per_cell, std::size_t dimension) {
    const Vector cell = effective_cell(grid);
    Lattice lattice{dimension, {}, {}};
    for (std::size_t axis = 0; axis < dimension; ++axis) {
        lattice.lower[axis] = grid.lower[axis];
        lattice.edge[axis] = cell[axis] / particles_per_cell;
    }
    return lattice;
}

/// A lattice of about the same edges that fits a box: it begins at its lower corner and ends at its upper one. No edge
/// is wider than the cell along its axis, also where one particle a cell is rounded down: ugimp needs that.
inline Lattice fitted_lattice(const Lattice& wanted, const Vector& cell, const Vector& lower, const Vector& upper) {
    Lattice lattice{wanted.dimension, {}, {}};
    for (std::size_t axis = 0; axis < lattice.dimension; ++axis) {
        const double edge = upper[axis] - lower[axis];
        const double fewest = std::max(1.0, std::ceil(edge / cell[axis] - 1e-9));
        lattice.lower[axis] = lower[axis];
        lattice.edge[axis] = edge / std::max(fewest, std::round(edge / wanted.edge[axis]));
    }
    return lattice;
}

} // namespace abut
