#pragma once
#include "contact/law/friction.h"

namespace abut {

/// A film between the bodies: S_slide = µ N + η k, η the film's viscosity over its thickness. It shears as long as the
/// bodies are near, pressed together or not: bodies that rest on each other touch with interruptions, which µ N doesn't
/// mind since the mean of N is right.
struct ViscousFriction {
    double coefficient = 0;
    double viscosity = 0; ///< η [Pa s/m]
    double reach = 0;     ///< separation within which the film holds [cells]

    static constexpr bool needs_area = true;
    double slide(double N, double k) const { return coefficient * N + viscosity * k; }
    Friction in_first_pass() const { return {coefficient, coefficient, 0}; }
};

template <int D>
Vec<D> law_impulse(const ViscousFriction& law, const Meeting<D>& at) {
    if (!(at.separation < law.reach * at.cell)) return Vec<D>::Zero();
    return slide_under(law, at, at.touching() ? std::max(0.0, at.compression()) : 0.0);
}

} // namespace abut
