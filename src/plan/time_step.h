#pragma once
#include "scene/scene.h"

namespace abut {

/// Largest stable time step of a scene's method as a multiple of cell size / wave speed; 1 but for fmpm.
///
/// FMPM(k) takes (1 − (1 − λ)^k) / λ as much acceleration from a grid mode as the lumped mass matrix, λ the mode's
/// eigenvalue of S+ S. At the nodes that a body barely reaches λ is small, and the factor comes to k. Such a mode keeps
/// next to nothing of its velocity in a step, which halves what (ω Δt)² may be: (ω Δt)² < 2 (1 + kλ) with ω² = k K/m for
/// small λ (u ← (1 − (1 − λ)^k) u + a Δt is damped), not 4. With S the shape function there and G its gradient K/m is
/// c² G² / S; with uGIMP and particles of half a cell G² / S tends to 4 / Δx², so that Δt < Δx / (c √(2k)). Other shapes
/// have smaller gradients there (CPDI's, and the splines', tend to 0) and larger limits.
/// The factors are measured, the largest steps without a gain of energy, rounded down: 3000 random scenes of bodies one
/// to three cells thick, k = 2 to 8 (tests/stability/random_scene.h). Bodies of many cells bear a sixth more.
double cfl_limit(const Scene& scene);

/// Largest stiffness of a contact law's springs, across or along the interface; 0 if it has none [Pa/m].
double largest_stiffness(const LawSpec& law);

/// Largest time step that carries springs of a stiffness D at nodes that two bodies of the lightest material share
/// evenly, where the reduced mass is ρ Δx³/4 and the area Δx²: κ Δt < π/2, hence Δt < (π/2) √(ρ Δx / 4D)
/// (notes 5.35-5.38, which take the mass of one body, twice as much). At nodes with less mass springs are too stiff for
/// such a step as well, and the bodies stick there [s].
double interface_step_limit(const Scene& scene, double stiffness);

/// The scene's time step while its materials are at rest [s].
double initial_step(const Scene& scene);

} // namespace abut
