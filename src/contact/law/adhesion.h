#pragma once
#include "contact/law/friction.h"

namespace abut {

/// Bodies that touch hold together like one up to a strength. In tension the traction may reach (T/T_s)² + (S/S_s)² =
/// 1; under pressure, where friction helps, S <= S_s + µ N. Beyond that they slide or part by Coulomb's law in this
/// step. The bond has no memory: bodies that come to rest on one another hold again.
/// In the first pass Δp(0) is the difference of two extrapolations and knows nothing of the time step: it is weighed
/// over the time in which a wave crosses a cell, so that it counts as the stress ρ c Δv of bodies that are torn apart,
/// and the forces of the step are added, so that what the second pass will let go is not held here.
struct Adhesion {
    double strength = 0;       ///< T_s [Pa]
    double shear_strength = 0; ///< S_s [Pa]
    double reach = 0;          ///< separation within which bodies count as touching [cells]
    Friction friction{};
    static constexpr bool needs_area = true;

    bool holds(double tension, double shear) const {
        if (tension <= 0) return shear <= shear_strength - friction.kinetic * tension;
        if (tension > strength || shear > shear_strength) return false;
        const double t = tension / strength;
        const double s = shear > 0 ? shear / shear_strength : 0;
        return t * t + s * s <= 1;
    }
};

template <int D>
Vec<D> law_impulse(const Adhesion& law, const Meeting<D>& at) {
    if (!(at.separation < law.reach * at.cell)) return Vec<D>::Zero();
    const Vec<D> needed =
        at.second_pass ? Vec<D>(at.stick / at.dt) : Vec<D>(at.stick / std::max(at.dt, at.crossing) + at.force);
    const double normal = needed.dot(at.normal);
    const double tangential = (needed - normal * at.normal).norm();
    if (at.area > 0 && law.holds(normal / at.area, tangential / at.area)) return at.stick;
    return law_impulse(law.friction, at);
}

} // namespace abut
