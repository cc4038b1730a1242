#pragma once
/// \file shape_particles.h
/// Boxes, disks and ellipses to particles.

#include "scene/scene.h"

#include <variant>
#include <vector>

namespace abut {

/// The particles of a shape, all of one size.
struct ShapeParticles {
    Vector half_size{};           ///< [m]; z is 0
    std::vector<Vector> position; ///< centres [m]
};

/// Fills a shape with particles of about cell / particles_per_cell.
/// Box: round(edge * particles_per_cell / cell) particles per axis, but so many that none is wider than a cell, from
/// its own lower corner, so that its area is exact. Disk and ellipse: the places of the grid's particle lattice
/// (anchored at the grid's lower corner) whose centres lie inside or on the outline; possibly none. Also places outside
/// the grid.
ShapeParticles shape_particles(const std::variant<Box, Disk, Ellipse>& shape, int particles_per_cell,
                               const GridSpec& grid);

} // namespace abut
