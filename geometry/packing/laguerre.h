#pragma once
/// \file laguerre.h
/// Laguerre (power, weighted Voronoi) diagrams in a box.

#include "scene/scene.h"

#include <vector>

namespace abut {

/// A side of a cell: all of the cell has x·normal ≤ offset.
struct CellSide {
    PlanePoint normal{}; ///< of length 1
    double offset = 0;
    int neighbour = -1; ///< across the side; -1: the box ends there
};

/// A convex polygon; side k goes from point k to the next.
struct LaguerreCell {
    std::vector<PlanePoint> points; ///< counter-clockwise; none: there is no cell
    std::vector<CellSide> sides;
};

/// The cells of the points x with |x − c|² − w least, within [0, width] × [0, height].
/// \param weights w, as squares of radii: cells of disks that don't overlap contain them
std::vector<LaguerreCell> laguerre_cells(double width, double height, const std::vector<PlanePoint>& centres,
                                         const std::vector<double>& weights);

/// The part of a cell that is at least `distance` away from the sides it shares with others.
LaguerreCell inset(const LaguerreCell& cell, double distance);

/// Area within a closed outline, positive when it runs counter-clockwise.
double signed_area(const std::vector<PlanePoint>& points);

} // namespace abut
