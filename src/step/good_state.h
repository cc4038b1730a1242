#pragma once
#include "step/state.h"

namespace abut {

/// What of a state a run can go on from, bit for bit, as visit_state() lists it: particles in their order with their
/// tiles, sums of the ledger and of the rows under way, the clock.
template <int D>
State<D> kept_copy(const State<D>& state);

/// Brings a state of the same run back to where kept_copy() was made.
template <int D>
void go_back(const State<D>& kept, State<D>& state);

} // namespace abut
