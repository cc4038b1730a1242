#pragma once
#include "step/run_error.h"

namespace abut {

/// How often a run may halve its time step after trouble.
constexpr int most_step_reductions = 5;
/// How often the same trouble may come back before a run gives up: it comes whatever the step.
constexpr int most_returns = 2;

/// The setback that an error is, in the state gone wrong. It is the last one (State::setback) come back if it is of the
/// same kind, at a place less than a cell away along each axis and at a time less than two of the steps before they
/// were halved away. A fixed step that is too large, and energy out of nothing, are of the step in any case and never
/// count as come back.
template <int D>
Setback setback_of(const State<D>& state, const RunError& error);

} // namespace abut
