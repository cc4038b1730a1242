#pragma once
#include "step/state.h"

namespace abut {

/// First contact pass: corrects the velocities extrapolated to the grid, v^α = v^α0 + Δv^α (contact paper Eq. 26), and
/// keeps Δv^α if a filter will want it. Changes NodeArrays::velocity.
template <int D>
void first_contact_pass(State<D>& state);

/// Second contact pass, after the momentum update (contact paper Eq. 31); the contact force of the step. Separations
/// are carried to the end of the step (notes 3.56). Velocity conditions are imposed again, unless they are to act
/// after the full mass matrix only. Changes NodeArrays::end_velocity.
template <int D>
void second_contact_pass(State<D>& state);

/// The first pass for any velocities (mass in lane 0), with the normals and separations found before; leaves the
/// impulses of the step as they are (notes 2.8).
/// \param change Δv, or null
template <int D>
void correct_for_contact(State<D>& state, std::vector<Pack>& velocity, std::vector<Pack>* change);

} // namespace abut
