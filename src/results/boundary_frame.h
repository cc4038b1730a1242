#pragma once
#include "results/frame.h"
#include "step/state.h"

namespace abut {

/// Where the boundaries of a scene are and what they do, for a look before a run: a wall is a line (3D: a rectangle)
/// across the grid's box, a velocity condition the edges of its box, a traction the faces of the particles that carry
/// it, at their undeformed places. Arrays of cells: `boundary` (number in the scene; names in the words
/// `boundary_names`), `axis` (across which a wall or a face lies; -1 for velocity conditions), `velocity` at the
/// state's time [m/s], zero for tractions, and `traction` [Pa], pressure included, zero for all others.
template <int D>
CellFrame boundary_frame(const State<D>& state);

} // namespace abut
