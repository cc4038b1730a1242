#pragma once
#include "contact/normal/regression.h"

namespace abut {

/// Most probable plane that separates the classes of a cloud (contact paper §3.1 and appendix): linear regression as
/// the first iterate, then non-linear least squares with the logistic function, penalties λ = 1e-7 Δx² (1, 1, 1, 0),
/// until 1 − n·n' < 1e-5 or 15 iterations.
/// \param cloud positions in cells, so that Δx = 1 here
template <int D>
Regression<D> logistic_regression(const Cloud<D>& cloud);

} // namespace abut
