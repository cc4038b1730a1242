#pragma once
/// \file ellipse_contact.h
/// Do two ellipses overlap, and how far from it are they?

#include "scene/scene.h"

#include <array>

namespace abut {

/// What the overlap test needs of an ellipse, worked out once.
struct Outline {
    double x = 0, y = 0; ///< centre
    double xx = 0, xy = 0, yy = 0; ///< M = R diag(a², b²) Rᵀ: the ellipse is { r : (r - centre)ᵀ M⁻¹ (r - centre) ≤ 1 }
    double reach = 0;              ///< the longer semi-axis
};

Outline outline(const Ellipse& ellipse);

/// Outline of the ellipse with semi-axes enlarged so that it contains all that is nearer than half the gap. An ellipse
/// with both semi-axes larger by d reaches h(d) = |(a + d) c, (b + d) s| in the direction (c, s) of its axes, a convex
/// function of d with slope (a c² + b s²) / |a c, b s| ≥ 2 √(a b) / (a + b) at d = 0: hence the factor.
Outline outline_with_gap(Ellipse ellipse, double gap);

/// Value of the contact function, and the λ of the Perram-Wertheim function at which it was found.
struct Closeness {
    double value = 0, lambda = 0.5;
};

/// contact_function() with its λ: the derivatives of the value are those at fixed λ.
Closeness closeness(const Outline& a, const Outline& b, double enough);

/// Square of the factor by which two ellipses, growing in place, can be scaled until they touch (Perram and Wertheim,
/// J. Comput. Phys. 58 (1985) 409): > 1 apart, < 1 overlapping. Never too large by more than round-off. Returns early,
/// with a number of at least `enough`, once the function is certain to be that large.
double contact_function(const Outline& a, const Outline& b, double enough);

/// Half the edges of the smallest upright box around an ellipse.
std::array<double, 2> half_extent(const Ellipse& ellipse);

} // namespace abut
