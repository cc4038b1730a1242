#pragma once
#include "particles/particles.h"

namespace abut {

/// Initial stress of a solid: τ = τ(law) + F S Fᵀ with S fixed in the material, which derives from the energy
/// W + S : E, E = ½(FᵀF − I) (Green's strain): it turns and stretches with the material, and does no net work in a
/// closed cycle. At F = I it is the Cauchy stress S. In the plane S_zz is stretched by `across`.

/// A tensor in Stress<D>'s order as a matrix of the plane, or of space.
template <int D>
Mat<D> matrix_of(const Stress<D>& s) {
    Mat<D> m;
    if constexpr (D == 2)
        m << s[0], s[3], s[3], s[1];
    else
        m << s[0], s[3], s[5], s[3], s[1], s[4], s[5], s[4], s[2];
    return m;
}

/// F S Fᵀ [Pa].
template <int D>
Stress<D> pushed_forward(const Stress<D>& S, const Mat<D>& F, double across) {
    const Mat<D> m = F * matrix_of<D>(S) * F.transpose();
    Stress<D> s;
    s[0] = m(0, 0);
    s[1] = m(1, 1);
    s[3] = m(0, 1);
    if constexpr (D == 2) {
        s[2] = across * across * S[2];
    } else {
        s[2] = m(2, 2);
        s[4] = m(1, 2);
        s[5] = m(0, 2);
    }
    return s;
}

/// S : E = ½ (tr F S Fᵀ − tr S) [J/m^3].
template <int D>
double prestress_energy(const Stress<D>& S, const Mat<D>& F, double across) {
    const Stress<D> s = pushed_forward<D>(S, F, across);
    return 0.5 * (s[0] + s[1] + s[2] - S[0] - S[1] - S[2]);
}

} // namespace abut
