#include "step/setback.h"

#include <cmath>

namespace abut {

template <int D>
Setback setback_of(const State<D>& state, const RunError& error) {
    Setback setback{error.trouble(), state.time, to_array<D>(state.particles.position[error.particle()]), 0};
    const bool of_the_step = setback.trouble == Trouble::step_too_large || setback.trouble == Trouble::energy_growth;
    if (!state.setback || of_the_step || state.setback->trouble != setback.trouble) return setback;
    const Setback& last = *state.setback;
    const double step_before = 2 * state.dt;
    bool same = std::abs(setback.time - last.time) < 2 * step_before;
    for (int a = 0; a < D; ++a) same = same && std::abs(setback.place[a] - last.place[a]) < state.scene.grid.cell[a];
    if (same) setback.returns = last.returns + 1;
    return setback;
}

template Setback setback_of<2>(const State<2>&, const RunError&);
template Setback setback_of<3>(const State<3>&, const RunError&);

} // namespace abut
