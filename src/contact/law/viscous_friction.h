#pragma once
#include "contact/law/slide.h"

namespace abut {

/// A film between the bodies: S_slide = µ N + η k, η the film's viscosity over its thickness.
struct ViscousFriction {
    double coefficient = 0;
    double viscosity = 0; ///< η [Pa s/m]

    static constexpr bool needs_area = true;
    double slide(double N, double k) const { return coefficient * N + viscosity * k; }
};

} // namespace abut
