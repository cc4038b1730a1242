#pragma once
#include "contact/normal/regression.h"

namespace abut {

/// Plane by least squares with f(x, φ) = x·φ (notes 3.9, 3.17; contact paper, appendix): the first iterate of the other
/// regressions, with their penalties. Tilts where the bodies' particles are not alike on both sides of the node.
/// \param cloud positions in cells
template <int D>
Regression<D> linear_regression(const Cloud<D>& cloud);

} // namespace abut
