#pragma once
#include "step/state.h"

#include <string>
#include <vector>

namespace abut {

/// One task of the time step.
template <int D>
struct Task {
    std::string name;
    std::string reason; ///< why this scene needs it
    void (*run)(State<D>&);
    double seconds = 0; ///< wall time since the start of the run
};

/// The tasks that a scene calls for, in their order.
template <int D>
std::vector<Task<D>> step_tasks(const Scene& scene);

/// Time that the fastest wave of the present state takes to cross a cell [s].
template <int D>
double crossing_time(const State<D>& state);

/// Largest stable time step of the present state: the crossing time, less for some methods (cfl_limit()) [s].
template <int D>
double stable_step(const State<D>& state);

/// The next time step: the scene's fixed step, or its cfl times the crossing time but not above the stable step; halved
/// for each of State::step_reductions; shorter if the run would otherwise pass `until`.
/// \throws RunError if the fixed step is above the stable one
template <int D>
double next_step(const State<D>& state, double until);

/// Advances the state by one step of size State::dt and adds the time each task took.
template <int D>
void advance(State<D>& state, std::vector<Task<D>>& tasks);

} // namespace abut
