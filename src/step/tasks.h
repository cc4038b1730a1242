#pragma once
/// \file tasks.h
/// The tasks of a time step in the order in which a step may need them (design.md §5). step.cpp picks those that a
/// scene calls for.

#include "step/state.h"

namespace abut {

/// Sorts the particles if they have drifted, finds the nodes that each tile sees, numbers the slots.
template <int D>
void find_velocity_fields(State<D>& state);

/// Expands the stencils of all particles, for shapes that are dear to expand.
template <int D>
void store_stencils(State<D>& state);

/// p^α0 = S^T P and m^α = S^T M (contact paper Eq. 5).
template <int D>
void extrapolate_momenta(State<D>& state);

/// f^α = −G^T V0 τ (FMPM paper Table 1, task 2).
template <int D>
void extrapolate_forces(State<D>& state);

/// Both extrapolations in one sweep: with stress updated last, the forces need nothing of this step.
template <int D>
void extrapolate_momenta_and_forces(State<D>& state);

/// v^α0 = p^α0 / m^α (contact paper Eq. 5).
template <int D>
void find_velocities(State<D>& state);

/// p^α+ = p^α + f^α Δt with gravity (contact paper Eq. 30; notes 2.13).
template <int D>
void update_momenta(State<D>& state);

/// Walls set the velocities at the end of the step (notes 2.7-2.12).
template <int D>
void impose_walls(State<D>& state);

/// Closes the momentum update: work of walls, gravity and contact goes to the ledger.
template <int D>
void settle_works(State<D>& state);

/// m_k^-1 p^α − m_(k−1)^-1 Δp^α by k − 1 gather-scatter sweeps (contact paper Eq. 39-44; FMPM paper Eq. 5).
template <int D>
void filter_velocities(State<D>& state);

/// Particle velocity and position by the transfer's own rule (FMPM paper §2.3), with USL also stress and deformation
/// from the velocities at the end of the step.
template <int D>
void update_particles(State<D>& state);

/// Stress and deformation from the velocities at the start of the step, walls imposed (USF).
template <int D>
void update_stress_first(State<D>& state);

} // namespace abut
