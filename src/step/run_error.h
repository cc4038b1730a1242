#pragma once
#include "step/state.h"

#include <stdexcept>
#include <string>

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
    rigid_left_grid,  ///< a rigid body, as its motion is prescribed
};

/// A run went wrong. what() tells step, time, body, particle, position and what is wrong.
class RunError : public std::runtime_error {
public:
    RunError(Trouble trouble, const std::string& message) : std::runtime_error(message), trouble_(trouble) {}
    Trouble trouble() const { return trouble_; }

private:
    Trouble trouble_;
};

/// "step 12, time 3.1e-06 s, particle 17 of body "grain" at (x, y) m: WHAT".
template <int D>
std::string describe_failure(const State<D>& state, std::int32_t particle, const std::string& what);

} // namespace abut
