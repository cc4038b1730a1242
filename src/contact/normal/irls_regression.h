#pragma once
#include "contact/normal/regression.h"

namespace abut {

/// Logistic regression by maximum likelihood, solved by iteratively reweighted least squares (notes 3.4.6): minimizes
///   Ω = −Σ (m log f + (1 − m) log (1 − f)) + Σ λ φ²,  f = 1/(1 + e^(−x·φ)),  m = 0 or 1.
/// Penalties and stopping as for logistic_regression, which "converges a little better" (notes 3.4.6).
/// \param cloud positions in cells
template <int D>
Regression<D> irls_regression(const Cloud<D>& cloud);

} // namespace abut
