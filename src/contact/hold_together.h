#pragma once
/// \file hold_together.h
/// XPIC and FMPM go several times from the grid to the particles and back (v ← S+ S v), each body by itself, and so
/// take apart again what contact has put together. The contact paper adds m_(k−1)^-1 Δp for that (Eq. 37-44); its own
/// Eq. 47 says that perfect interfaces still differ from one velocity field. The difference is energy: with P what the
/// first pass makes of the velocities, the filter in particle space is 1 − (1 − S S+)^(k−1) (1 − S P S+). The two
/// factors don't commute, and their product may leave particles with more energy than they had: 10 % in 34 steps in one
/// of 3000 random scenes with `perfect`, all of which the filter had put in.
///
/// So what the first pass holds together is held in every sweep: P S+ S instead of S+ S. Where P is an orthogonal
/// projection in the metric of the masses (no velocity to each other, or none along the normal) the filter becomes
///   1 − (1 − S P S+)^k,
/// whose eigenvalues lie in [0, 1] and whose eigenvectors are orthogonal: it never gives energy. Perfect interfaces are
/// exactly one velocity field then. What is no projection, the friction of sliding bodies, stays in Δv.

#include "step/state.h"

namespace abut {

/// Notes what the first pass holds together (ContactPoint::held), and leaves only the rest of its Δv. FMPM holds
/// perfect interfaces alone: its velocities are those of the end of the step, whose contact forces it filters too.
/// \param velocity after the first pass, masses in lane 0
template <int D>
void find_holds(State<D>& state, const std::vector<Pack>& velocity, std::vector<Pack>& delta);

/// Leaves of a Δv what is no work of the holds found before.
template <int D>
void drop_held_part(State<D>& state, const std::vector<Pack>& velocity, std::vector<Pack>& delta);

/// P: takes from nodal momenta what would part held bodies; the momentum of all together stays.
/// \param masses in lane 0 \param velocity whose components rigid bodies hold
template <int D>
void hold_together(const State<D>& state, const std::vector<Pack>& masses, const std::vector<Pack>& velocity,
                   std::vector<Pack>& momentum);

} // namespace abut
