#pragma once
#include "step/state.h"

#include <tuple>

namespace abut {

/// Calls visit(name, member) with everything of a state that a run can go on from, bit for bit; all else is made anew
/// from it or follows from the scene. What goes back to a state (good_state.h) and checkpoints both go by this list.
/// Of several states with the members of all: visit(name, member, member). Numbers that belong together come as a tuple
/// of references. Particles come first, their tiles next.
template <class Visit, class... States>
void visit_state(Visit&& visit, States&... states) {
    visit("particles", states.particles...);
    visit("tiles", states.tiling...);
    visit("clock", std::tie(states.time, states.dt, states.largest_wave_speed, states.since_transfer)...);
    visit("step", states.step...);
    visit("transfers", states.transfers...);
    visit("step_reductions", states.step_reductions...);
    visit("setback", states.setback...);
    visit("ledger", states.ledger...);
    visit("energy_watch", states.energy_watch...);
    visit("boundary_impulses", states.boundaries...);
    visit("pairs", states.pair_totals...);
    visit("rigid", states.rigid_totals...);
}

} // namespace abut
