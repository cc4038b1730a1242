#pragma once
#include "scene/scene.h"

namespace abut {

/// Largest stable time step of a scene's method as a multiple of cell size / wave speed; 1 but for fmpm.
///
/// FMPM(k) takes (1 − (1 − λ)^k) / λ as much acceleration from a grid mode as the lumped mass matrix, λ the mode's
/// eigenvalue of S+ S. At the nodes that a body barely reaches λ is small, and the factor comes to k. With S the shape
/// function there and G its gradient, the strain of the next step then grows as k (c Δt)² G² / S: with uGIMP and
/// particles of half a cell, G² / S tends to 4 / Δx², so that Δt < Δx / (c √k). Other shapes have smaller gradients
/// there (CPDI's, and the splines', tend to 0) and larger limits.
/// The factors are measured (two-block impact of the FMPM paper, k = 2 to 32): the largest steps without a gain of
/// energy, rounded down; see examples/two-block-impact.
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
