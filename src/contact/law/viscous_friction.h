#pragma once
#include "contact/law/friction.h"

namespace abut {

/// A film between the bodies: S_slide = µ N + η k, η the film's viscosity over its thickness.
struct ViscousFriction {
    double coefficient = 0;
    double viscosity = 0; ///< η [Pa s/m]

    static constexpr bool needs_area = true;
    double slide(double N, double k) const { return coefficient * N + viscosity * k; }
    Friction in_first_pass() const { return {coefficient, coefficient, 0}; }
};

} // namespace abut
