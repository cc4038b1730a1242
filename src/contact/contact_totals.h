#pragma once
#include "step/state.h"

namespace abut {

/// Contact area of two bodies at a node from their volume gradients: the shape functions' integral over the interface.
/// By Gauss's theorem Σ V ∇S is the integral of S n over a body's whole surface, and what is not interface is mostly
/// perpendicular to it or far from the node [m^2].
template <int D>
double contact_area(const Vec<D>& gradient_a, const Vec<D>& gradient_b, const Vec<D>& normal) {
    return std::abs(0.5 * (gradient_a - gradient_b).dot(normal));
}

/// Area and displacement discontinuity of every point, for the laws that need them and for pairs.csv when it is due
/// (State::wants_areas).
template <int D>
void find_areas_and_displacements(State<D>& state);

/// Closes the contact of a step: its works go to the ledger, its impulses to the pairs and the rigid bodies.
template <int D>
void settle_contact(State<D>& state);

} // namespace abut
