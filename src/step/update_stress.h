#pragma once
#include "material/deformation.h"
#include "material/prestress.h"
#include "step/state.h"

#include <cmath>

namespace abut {

/// Velocity gradient of a particle as it is gathered: column a is ∂v/∂x_a; `hoop` is v_r / r of rings.
template <int D>
struct VelocityGradient {
    Pack column[D] = {};
    double hoop = 0;
};

/// dF = exp(∇v Δt) or 1 + ∇v Δt, F ← dF F, stress by the law (FMPM paper Table 1, task 5). Rings stretch around the
/// axis by exp(v_r/r Δt), or 1 + v_r/r Δt; in plane stress the law itself says how far the particle stretches across
/// the plane. \return ρ0 c² of the particle [Pa]; negative: it is turned inside out, absurdly stretched or not a number
template <int D, class Law>
[[gnu::always_inline]] inline double update_stress(Particles<D>& particles, std::int32_t p, const Law& law,
                                                   const VelocityGradient<D>& gradient, double dt,
                                                   DeformationIncrement increment, bool free_across) {
    const bool linear = increment == DeformationIncrement::linear;
    Mat<D> dv;
    for (int a = 0; a < D; ++a)
        for (int i = 0; i < D; ++i) dv(i, a) = gradient.column[a][i + 1] * dt;
    const Mat<D> dF = linear ? Mat<D>(Mat<D>::Identity() + dv) : exponential(dv);
    const Mat<D> F = product<D>(dF, particles.deformation_gradient[p]);
    particles.deformation_gradient[p] = F;
    double across = 1;
    if constexpr (D == 2) {
        if (!particles.across.empty()) {
            const double hoop = gradient.hoop * dt;
            across = particles.across[p] * (linear ? 1 + hoop : std::exp(hoop));
            if (free_across) across = law.stretch_without_stress(strain_of<2>(F, across), across);
            particles.across[p] = across;
        }
    }
    const Strain<D> strain = strain_of<D>(F, across);
    constexpr double absurd = 1e8; // trace of b
    if (!(strain.J > 0 && across > 0 && strain.trace() < absurd)) return -1;
    particles.stress[p] = law.template kirchhoff<D>(strain);
    if (particles.prestress.empty()) return law.template stiffness<D>(strain);
    const Stress<D> initial = pushed_forward<D>(particles.prestress[p], F, across);
    particles.stress[p] += initial;
    return law.template stiffness<D>(strain) + initial.norm(); // waves feel tension as a string does
}

} // namespace abut
