#pragma once
#include "step/state.h"

namespace abut {

/// How often the step just made visited each particle to bring something to the grid or back: a cost of the method that
/// doesn't depend on the machine.
template <int D>
int sweeps_of_step(const State<D>& state) {
    const Effects& effects = state.effects;
    int sweeps = 2;                        // momenta and forces in one sweep; the particles' update
    if (effects.stress_first) sweeps += 2; // the stress update, and forces in a sweep of their own
    if (state.filters()) sweeps += effects.extra_orders;
    if (effects.reextrapolate) sweeps += 2; // momenta anew, and the stress update
    return sweeps;
}

} // namespace abut
