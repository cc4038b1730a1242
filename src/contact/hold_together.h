#pragma once
/// \file hold_together.h
/// XPIC and FMPM go several times from the grid to the particles and back (v ← S+ S v), each body by itself, and take
/// apart again what contact has put together. The contact paper adds m_(k−1)^-1 Δp for that (Eq. 37-44); its own Eq. 47
/// says that perfect interfaces still differ from one velocity field. The difference is energy. With P what contact
/// makes of the velocities, XPIC's filter on particles is 1 − (1 − S S+)^(k−1) (1 − S P S+): the factors don't commute,
/// and the product may leave particles with more energy than they had (10 % of it in 34 steps of one random scene with
/// `perfect`, all put in by the filter). FMPM multiplies impulses at nodes with little mass by up to k.
///
/// So what contact holds together is held in every sweep: P S+ S instead of S+ S. Where P is an orthogonal projection
/// in the metric of the masses (no velocity to each other, or none along the normal) the filter becomes
///   1 − (1 − S P S+)^k,
/// with eigenvalues in [0, 1] and orthogonal eigenvectors: it never gives energy. Perfect interfaces are exactly one
/// velocity field then. What is no projection, the friction of sliding bodies, stays in Δv.
///
/// In FMPM, which filters what the forces of the step have made of the velocities, walls that push hold likewise.

#include "step/state.h"

namespace abut {

/// Which pass's holds are looked for: after the first one FMPM needs those of perfect interfaces alone, since it
/// filters the velocities of the second.
enum class HoldsOf { perfect, any };

/// Notes what contact holds together (ContactPoint::held), and leaves of the first pass's Δv only the rest.
/// \param velocity after the pass, masses in lane 0
template <int D>
void find_holds(State<D>& state, HoldsOf which, const std::vector<Pack>& velocity, std::vector<Pack>& delta);

/// Leaves of a Δv what is not done by the holds found before.
template <int D>
void drop_held_part(State<D>& state, const std::vector<Pack>& velocity, std::vector<Pack>& delta);

/// P: takes from the nodal momenta of a sweep what would part held bodies, or take a body from a wall.
/// \param masses in lane 0 \param velocity what the sweep began with: rigid bodies and walls hold its components
/// \param last the last sweep of a filter: contact forces and those of walls are what this one exchanges
template <int D>
void hold_together(State<D>& state, const std::vector<Pack>& masses, const std::vector<Pack>& velocity,
                   std::vector<Pack>& momentum, bool last);

} // namespace abut
