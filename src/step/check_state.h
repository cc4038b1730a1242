#pragma once
#include "scene/problem.h"
#include "step/state.h"

#include <vector>

namespace abut {

/// What is wrong with a scene that only shows once its particles are there, at the start of a run: a fixed time step
/// above the stable one, periodic transfers more often than steps, tractions without a face, walls with all material
/// behind them or nothing in reach.
template <int D>
std::vector<Problem> check_state(State<D>& state);

} // namespace abut
