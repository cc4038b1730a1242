#pragma once
#include "step/state.h"

namespace abut {

/// Which bodies at which nodes may be in contact: groups and points, without normals.
template <int D>
void find_groups(State<D>& state);

/// The particles that each group sees (contact paper §3.1).
template <int D>
void gather_clouds(State<D>& state);

/// Volumes with their gradients, positions and displacements at contact nodes (contact paper Eq. 11; notes 2.3-2.6).
template <int D>
void extrapolate_contact_fields(State<D>& state);

/// Volumes Ω = Σ S V (lane 0) [m^3] and their gradients g = Σ G V [m^2] of all slots at contact nodes, for whoever
/// wants them outside the step.
template <int D>
std::vector<Pack> volume_gradients(State<D>& state);

/// Normal of every point (contact paper §3.1 and Eq. 13; notes 3.2-3.4); zero where there is none.
template <int D>
void find_normals(State<D>& state);

/// Separation of every point along its normal (contact paper Eq. 16, 22-24; notes 3.6); infinite without a normal.
template <int D>
void find_separations(State<D>& state);

} // namespace abut
