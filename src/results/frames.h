#pragma once
#include "results/frame.h"
#include "step/state.h"

namespace abut {

/// Makes node and contact arrays fit the particles as they are now, without advancing them; call it before making
/// frames. Contact forces stay those of the last step. Running on afterwards gives the same results as if this had not
/// been called.
template <int D>
void look(State<D>& state);

/// All particles in the model's order (contract §3).
template <int D>
PointFrame particle_frame(const State<D>& state);

/// Nodes of the scene's box.
template <int D>
GridFrame grid_frame(const State<D>& state);

/// The same nodes without any array: the grid of a scene that has not been run.
template <int D>
GridFrame empty_grid_frame(const State<D>& state);

/// A point for each pair of bodies at a contact node, normals and separations of the present particles, forces of
/// the last step. `area` is the
/// node's share of the interface, ½ (g_a − g_b)·n with g the volume gradients (contact paper Eq. 11): by the
/// divergence theorem g_i is the integral of N_i n dS over a body's surface, so the areas add up to the interface's.
template <int D>
PointFrame contact_frame(State<D>& state);

} // namespace abut
