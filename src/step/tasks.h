#pragma once
/// \file tasks.h
/// The tasks of a time step in the order in which a step may need them (design.md §5). step.cpp picks those that a
/// scene calls for.

#include "step/state.h"

namespace abut {

/// Sorts the particles if they have drifted, finds the nodes that each tile sees, numbers the slots.
template <int D>
void find_velocity_fields(State<D>& state);

/// Where the particles with tractions are in the store, by their ids; after a sort.
template <int D>
void find_traction_particles(State<D>& state);

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

/// Velocities (mass in lane 0) of momenta (likewise); zero where there is no mass.
void divide_by_mass(const std::vector<Pack>& momentum, std::vector<Pack>& velocity);

/// v^α0 = p^α0 / m^α (contact paper Eq. 5).
template <int D>
void find_velocities(State<D>& state);

/// Finds the slots whose velocities walls and other conditions set in this step.
template <int D>
void find_controls(State<D>& state);

/// Adds the tractions on particle faces to the forces (FMPM paper §2.4).
template <int D>
void apply_tractions(State<D>& state);

/// p^α+ = p^α + f^α Δt with gravity (contact paper Eq. 30; notes 2.13).
template <int D>
void update_momenta(State<D>& state);

/// Walls and other conditions set the velocities at the end of the step (notes 2.7-2.12).
template <int D>
void impose_conditions(State<D>& state);

/// Closes the momentum update: work of boundaries, gravity and contact goes to the ledger.
template <int D>
void settle_works(State<D>& state);

/// m_k^-1 p − m_(k−1)^-1 Δp by k − 1 gather-scatter sweeps (FMPM paper Eq. 1, 5; contact paper Eq. 39-44).
/// \param velocity m^-1 p with the masses in lane 0; \param delta m^-1 Δp, or null
template <int D>
void apply_mass_matrix_inverse(State<D>& state, const std::vector<Pack>& velocity, const std::vector<Pack>* delta,
                               std::vector<Pack>& filtered);

/// Makes pairs in contact approach after the full mass matrix as they do before it: as their law wants (FMPM).
/// \param moves_particles whether what pairs exchange so belongs to the contact forces of the step
template <int D>
void keep_normal_jumps(State<D>& state, const std::vector<Pack>& lumped, std::vector<Pack>& filtered,
                       bool moves_particles);

/// XPIC: filters the velocities at the start of the step. FMPM: v^α+ through the full mass matrix, with velocity
/// conditions by the scene's method (FMPM paper §2.4).
template <int D>
void filter_velocities(State<D>& state);

/// Particle velocity and position by the transfer's own rule (FMPM paper §2.3), with USL also stress and deformation
/// from the velocities at the end of the step.
template <int D>
void update_particles(State<D>& state);

/// Stress and deformation from the velocities at the start of the step, conditions imposed (USF, USAVG).
template <int D>
void update_stress_first(State<D>& state);

/// Stress and deformation from the updated particle velocities, extrapolated anew (USL+, USAVG+; notes 2.8).
template <int D>
void update_stress_again(State<D>& state);

} // namespace abut
