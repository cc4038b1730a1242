#pragma once
#include "math/linear_algebra.h"

namespace abut {

/// Separation of bodies that touch in their undeformed places: δ_n = (Δx_b − Δx_a)·n (notes 3.45, 3.46). Right while
/// displacements are small; blind to gaps at the start.
/// \param moment_a - | mass times extrapolated displacement of body a; likewise b
template <int D>
double displacement_separation(const Pack& moment_a, double mass_a, const Pack& moment_b, double mass_b,
                               const Vec<D>& normal) {
    return vector_of<D>(moment_b / mass_b - moment_a / mass_a).dot(normal);
}

} // namespace abut
