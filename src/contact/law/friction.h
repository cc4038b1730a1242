#pragma once
#include "contact/law/slide.h"

#include <cmath>
#include <limits>

namespace abut {

/// S_slide = 0.
struct Frictionless {
    static constexpr bool needs_area = false;
    double slide(double, double) const { return 0; }
};

/// No sliding while pressed together: S_slide is never reached.
struct Stick {
    static constexpr bool needs_area = false;
    double slide(double, double) const { return std::numeric_limits<double>::infinity(); }
};

/// Coulomb friction, S_slide = µ N with µ = µ_k + (µ_s − µ_k) e^(−k/v_d): the static coefficient holds at rest and
/// decays to the kinetic one with the sliding speed k; with v_d = 0 at once.
struct Friction {
    double kinetic = 0;
    double at_rest = 0;
    double decay_velocity = 0; ///< v_d [m/s]

    static constexpr bool needs_area = false;
    double slide(double N, double k) const {
        if (at_rest == kinetic || k == 0) return at_rest * N;
        if (decay_velocity == 0) return kinetic * N;
        return (kinetic + (at_rest - kinetic) * std::exp(-k / decay_velocity)) * N;
    }
};

} // namespace abut
