#pragma once
#include "grid/tile.h"
#include "particles/particles.h"

namespace abut {

/// Brings the particles into the order of blocks, bodies and cells and divides them into tiles (their windows stay
/// empty). The order of particles of the same cell is kept.
/// \param field_per_body each body has a velocity field of its own; else all share one
/// \return the tiling without windows and colours
template <int D>
Tiling<D> sort_particles(Particles<D>& particles, const Grid<D>& grid, bool field_per_body);

} // namespace abut
