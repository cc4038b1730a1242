#pragma once
#include "scene/space.h"

namespace abut {

/// What may go wrong in a run.
enum class Trouble {
    left_grid,        ///< a particle
    domain_left_grid, ///< that of a particle which is still inside
    crossed_axis,     ///< a ring
    too_fast,         ///< a particle above State::speed_limit
    not_a_number,     ///< velocity, position, deformation or stress of a particle: NaN or infinite
    inside_out,       ///< det F <= 0
    stretched,        ///< ten thousandfold, or over dozens of cells
    step_too_large,   ///< a fixed step above the stable one
    step_vanished,    ///< the step no longer advances the time
    energy_growth,    ///< energy out of nothing
    rigid_left_grid,  ///< a rigid body, as its motion is prescribed; the last one: checkpoints hold these numbers
};

/// The trouble after which a run last halved its time step, to tell whether it comes back.
struct Setback {
    Trouble trouble{};
    double time = 0; ///< [s]
    Vector place{};  ///< of the particle gone wrong [m]
    int returns = 0; ///< how often it has come back to this time and place, each time with half the time step
};

} // namespace abut
