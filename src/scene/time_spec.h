#pragma once
#include <optional>

namespace abut {

/// What a run does when it goes wrong (step/run_error.h).
enum class OnTrouble {
    stop,
    shrink_step, ///< goes back to a good state and on from there with half the time step, a few times
};

/// What no sound run passes; see step/watch.h.
struct LimitsSpec {
    std::optional<double> speed; ///< of a particle [m/s]; not given: see speed_limit()
    double energy_growth = 1;    ///< energy that appeared out of nothing / energy that the scene was given
};

struct TimeSpec {
    double end = 0;             ///< [s]
    double cfl = 0.4;           ///< time step / (cell / wave speed), cut to cfl_limit(); not used when `step` is given
    std::optional<double> step; ///< fixed time step [s]
    OnTrouble on_trouble = OnTrouble::stop;
    LimitsSpec limits;
};

} // namespace abut
