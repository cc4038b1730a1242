#pragma once
#include "material/strain.h"

#include <Eigen/LU>

namespace abut {

/// Principal square root V of b = F F^T, the left stretch tensor.
/// In the plane, by Cayley and Hamilton: V = (b + √(det b) I) / √(tr b + 2 √(det b)).
inline Stress<2> left_stretch(const Strain<2>& s) {
    const double root = std::sqrt(s.b[0] * s.b[1] - s.b[3] * s.b[3]);
    const double scale = 1 / std::sqrt(s.b[0] + s.b[1] + 2 * root);
    return {(s.b[0] + root) * scale, (s.b[1] + root) * scale, std::sqrt(s.b[2]), s.b[3] * scale};
}

/// In space, by Newton's iteration in the stable form of Denman and Beavers, which converges quadratically for every
/// positive definite b and is exact to round-off after a few steps for small strains.
inline Stress<3> left_stretch(const Strain<3>& s) {
    Mat<3> V;
    V << s.b[0], s.b[3], s.b[5], s.b[3], s.b[1], s.b[4], s.b[5], s.b[4], s.b[2];
    Mat<3> inverse = Mat<3>::Identity();
    for (int i = 0; i < 50; ++i) {
        const Mat<3> next = 0.5 * (V + inverse.inverse());
        inverse = (0.5 * (inverse + V.inverse())).eval();
        const double change = (next - V).cwiseAbs().maxCoeff();
        V = next;
        if (!(change > 1e-15 * V.trace())) break;
    }
    Stress<3> result;
    result << V(0, 0), V(1, 1), V(2, 2), V(0, 1), V(1, 2), V(0, 2);
    return result;
}

/// Product of two symmetric tensors that commute, which is symmetric.
template <int D>
[[gnu::always_inline]] inline Stress<D> commuting_product(const Stress<D>& a, const Stress<D>& b) {
    Stress<D> c;
    if constexpr (D == 2) {
        c << a[0] * b[0] + a[3] * b[3], a[3] * b[3] + a[1] * b[1], a[2] * b[2], a[0] * b[3] + a[3] * b[1];
    } else {
        c << a[0] * b[0] + a[3] * b[3] + a[5] * b[5], a[3] * b[3] + a[1] * b[1] + a[4] * b[4],
            a[5] * b[5] + a[4] * b[4] + a[2] * b[2], a[0] * b[3] + a[3] * b[1] + a[5] * b[4],
            a[3] * b[5] + a[1] * b[4] + a[4] * b[2], a[0] * b[5] + a[3] * b[4] + a[5] * b[2];
    }
    return c;
}

/// Small-strain isotropic linear elasticity, with rotation split off exactly: the strain is V − I, V the left stretch
/// of F = V R, so that a body may turn as far as it likes without stress. From W = G |V − I|² + λ/2 tr(V − I)², hence
/// with an energy; for small strains σ = 2G ε + λ tr ε I.
struct LinearElastic {
    double lambda; ///< [Pa]
    double G;      ///< [Pa]

    /// τ = (2G (V − I) + λ tr(V − I) I) V.
    template <int D>
    [[gnu::always_inline]] Stress<D> kirchhoff(const Strain<D>& s) const {
        const Stress<D> V = left_stretch(s);
        Stress<D> nominal = 2 * G * V;
        const double spherical = lambda * (V[0] + V[1] + V[2] - 3) - 2 * G;
        for (int c = 0; c < 3; ++c) nominal[c] += spherical;
        return commuting_product<D>(nominal, V);
    }

    /// Strain energy per undeformed volume [J/m^3].
    template <int D>
    double energy(const Strain<D>& s) const {
        const Stress<D> V = left_stretch(s);
        const double trace = V[0] + V[1] + V[2] - 3;
        double squares = 0;
        for (int c = 0; c < static_cast<int>(V.size()); ++c) {
            const double e = c < 3 ? V[c] - 1 : V[c];
            squares += (c < 3 ? 1 : 2) * e * e;
        }
        return G * squares + 0.5 * lambda * trace * trace;
    }

    /// Stretch across the plane for which τ_zz = 0: 2G (z − 1) + λ tr(V − I) = 0.
    double stretch_without_stress(const Strain<2>& s, double) const {
        const Stress<2> V = left_stretch(s);
        return 1 - lambda * (V[0] + V[1] - 2) / (lambda + 2 * G);
    }

    /// ρ0 c² of the fastest wave [Pa]: the longitudinal one along the largest principal stretch v, v² ∂²W/∂v². Shear
    /// waves are slower as long as strains are moderate, the only ones this law is meant for.
    template <int D>
    [[gnu::always_inline]] double stiffness(const Strain<D>& s) const {
        return (lambda + 2 * G) * std::max(1.0, s.largest());
    }
};

} // namespace abut
