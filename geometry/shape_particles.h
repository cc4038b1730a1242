#pragma once
/// \file shape_particles.h
/// Boxes, disks, ellipses and balls to particles.

#include "scene/scene.h"

#include <variant>
#include <vector>

namespace abut {

/// The particles of a shape, all of one size.
struct ShapeParticles {
    Vector half_size{};           ///< [m]; z is 0 in two dimensions
    std::vector<Vector> position; ///< centres [m]; z is 0 in two dimensions
    double angle = 0;             ///< by which each is turned counter-clockwise about its centre [rad]
};

/// Whether a shape exists in 2 or 3 dimensions: disks and ellipses are plane, balls are not, boxes are either.
bool exists_in(const ShapeSpec& shape, int dimension);

/// Fills a shape with particles of about cell / particles_per_cell.
/// Box: round(edge * particles_per_cell / cell) particles per axis, but so many that none is wider than a cell, from
/// its own lower corner, so that its area or volume is exact; in a turned box along its own edges. Disk, ellipse and
/// ball: the places of the grid's particle lattice (anchored at the grid's lower corner) whose centres lie inside or on
/// the outline; possibly none. Also places outside the grid. x runs fastest. \param dimension 2 or 3; \throws
/// std::invalid_argument for a shape that does not exist in it
ShapeParticles shape_particles(const ShapeSpec& shape, int particles_per_cell, const GridSpec& grid, int dimension);

} // namespace abut
