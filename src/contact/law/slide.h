#pragma once
/// \file slide.h
/// Frictional contact with any law S_slide(N, v) for the sliding traction (contact paper Eq. 8-10). Such a law is a
/// struct with
///   double slide(double N, double k) const;        the traction while sliding at the speed k >= 0 under the pressure N
///   static constexpr bool needs_area;              whether N and S are tractions [Pa]; else contact areas are not
///                                                  known, A_c Δt counts as 1, and both are impulses: good for laws
///                                                  that are proportional to N
/// and, if S is more than proportional to N,
///   auto in_first_pass() const;                    the law without that part. What a film carries is a force of the
///   step:
///                                                  it belongs to the second pass alone, or it would act twice.

#include "contact/law/meeting.h"

#include <algorithm>
#include <cmath>

namespace abut {

/// The sliding speed k in [0, stick/mass] at which S_slide(N, k) A_c Δt = stick − mass k (Eq. 9), 0 if the bodies
/// stick. Found by steps of fixed slope in a bracket, so that S may fall with k. Where S falls faster than stick − mass
/// k there may be several solutions; it is one of them, the same for the same numbers. \param stick tangential impulse
/// that would stop the sliding [N s]; \param area_step A_c Δt
template <class Law>
double sliding_speed(const Law& law, double pressure, double stick, double mass, double area_step) {
    if (law.slide(pressure, 0) * area_step >= stick) return 0;
    double low = 0;
    double high = stick / mass;
    const auto excess = [&](double k) { return stick - mass * k - law.slide(pressure, k) * area_step; };
    // Laws whose traction doesn't depend on the speed are solved by the first guess.
    double k = std::clamp((stick - law.slide(pressure, high) * area_step) / mass, low, high);
    for (int iteration = 0; iteration < 200; ++iteration) {
        const double e = excess(k);
        if (std::abs(e) <= 4e-16 * stick) break;
        (e > 0 ? low : high) = k;
        // A step that would solve a law with S as it is at k; the middle where that leaves the bracket.
        double next = k + e / mass;
        if (!(next > low && next < high) || iteration % 3 == 2) next = 0.5 * (low + high);
        if (next == k || high - low <= 1e-16 * high) break;
        k = next;
    }
    return k;
}

/// Δp' of bodies that are pressed together by a known impulse and may slide.
/// \param pressing N_c A_c Δt >= 0 [N s]; the normal part of Δp' is −pressing n
template <int D, class Law>
Vec<D> slide_under(const Law& law, const Meeting<D>& at, double pressing) {
    if constexpr (requires { law.in_first_pass(); })
        if (!at.second_pass || !(at.area > 0)) return slide_under(law.in_first_pass(), at, pressing);
    const Vec<D> along = at.tangential();
    const double stick = along.norm();
    Vec<D> impulse = -pressing * at.normal;
    if (stick == 0) return impulse;
    const double area_step = Law::needs_area ? at.area * at.dt : 1;
    const double k = sliding_speed(law, pressing / area_step, stick, at.mass, area_step);
    impulse += (1 - at.mass * k / stick) * along;
    return impulse;
}

/// Contact with a sliding law: nothing apart or in tension, else no penetration and what the law says of sliding.
template <int D, class Law>
requires requires(const Law& law) {
    law.slide(0.0, 0.0);
}
Vec<D> law_impulse(const Law& law, const Meeting<D>& at) {
    const double pressing = at.compression();
    if (!at.touching() || pressing <= 0) return Vec<D>::Zero();
    return slide_under(law, at, pressing);
}

} // namespace abut
