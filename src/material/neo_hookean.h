#pragma once
#include "particles/particles.h"

#include <Eigen/LU>
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

namespace abut {

/// Deformation of a particle in three dimensions' terms: left Cauchy-Green tensor b = F F^T in Stress<D>'s order and
/// J = det F. Plane strain: b_zz = 1.
template <int D>
struct Strain {
    Stress<D> b;
    double J = 1;
    double trace() const { return b[0] + b[1] + b[2]; }
    /// Largest and smallest principal value of b; in 3D bounds that need no eigenvalues.
    double largest() const {
        if constexpr (D == 2)
            return std::max(0.5 * (b[0] + b[1]) + in_plane_radius(), b[2]);
        else
            return trace();
    }
    double smallest() const {
        if constexpr (D == 2)
            return std::min(0.5 * (b[0] + b[1]) - in_plane_radius(), b[2]);
        else
            return 4 * J * J / (trace() * trace());
    }

private:
    double in_plane_radius() const {
        const double half_difference = 0.5 * (b[0] - b[1]);
        return std::sqrt(half_difference * half_difference + b[3] * b[3]);
    }
};

/// Component by component: see product() in deformation.h.
template <int D>
[[gnu::always_inline]] inline Strain<D> strain_of(const Mat<D>& F) {
    Strain<D> s;
    const auto b = [&](int i, int j) {
        double sum = 0;
        for (int k = 0; k < D; ++k) sum += F(i, k) * F(j, k);
        return sum;
    };
    s.b[0] = b(0, 0);
    s.b[1] = b(1, 1);
    s.b[2] = D == 2 ? 1.0 : b(D - 1, D - 1);
    s.b[3] = b(0, 1);
    if constexpr (D == 2) {
        s.J = F(0, 0) * F(1, 1) - F(0, 1) * F(1, 0);
    } else {
        s.b[4] = b(1, 2);
        s.b[5] = b(0, 2);
        s.J = F.determinant();
    }
    return s;
}

/// p I + g b.
template <int D>
[[gnu::always_inline]] inline Stress<D> isotropic_plus(double p, double g, const Stress<D>& b) {
    Stress<D> result;
    for (int c = 0; c < static_cast<int>(b.size()); ++c) result[c] = g * b[c] + (c < 3 ? p : 0.0);
    return result;
}

/// Compressible neo-Hookean solid, W = λ/2 ((J² − 1)/2 − ln J) + G/2 (I₁ − 3 − 2 ln J) (FMPM paper Eq. 6).
struct NeoHookean {
    double lambda; ///< [Pa]
    double G;      ///< [Pa]

    /// τ = λ/2 (J² − 1) I + G (b − I).
    template <int D>
    [[gnu::always_inline]] Stress<D> kirchhoff(const Strain<D>& s) const {
        return isotropic_plus<D>(0.5 * lambda * (s.J * s.J - 1) - G, G, s.b);
    }

    /// Strain energy per undeformed volume [J/m^3].
    template <int D>
    double energy(const Strain<D>& s) const {
        const double log_J = std::log(s.J);
        return 0.5 * lambda * (0.5 * (s.J * s.J - 1) - log_J) + 0.5 * G * (s.trace() - 3 - 2 * log_J);
    }

    /// Upper bound of ρ0 c² over all directions [Pa]. The acoustic tensor of W along a unit vector n of the deformed
    /// body gives ρ0 c² = λ/2 (J² + 1) + G (1 + n·b·n) for the longitudinal wave.
    template <int D>
    [[gnu::always_inline]] double stiffness(const Strain<D>& s) const {
        return 0.5 * lambda * (s.J * s.J + 1) + G * (1 + s.largest());
    }
};

/// J^(−2/3) to round-off: Newton's iteration for J^(−1/3) from a guess by the exponent bits (3 % off); half the cost of
/// std::cbrt, which is a tenth of a single-body step.
inline double inverse_cube_root_squared(double J) {
    auto y = std::bit_cast<double>(0x553ef0ff289dd796 - std::bit_cast<std::uint64_t>(J) / 3);
    for (int i = 0; i < 4; ++i) y *= 4.0 / 3 - J / 3 * y * y * y;
    return y * y;
}

/// W = G/2 (I₁ / J^(2/3) − 3) + K/2 ((J² − 1)/2 − ln J) (contact paper Eq. 18).
struct NeoHookeanIsochoric {
    double K; ///< [Pa]
    double G; ///< [Pa]

    /// τ = K/2 (J² − 1) I + G J^(−2/3) dev b.
    template <int D>
    [[gnu::always_inline]] Stress<D> kirchhoff(const Strain<D>& s) const {
        const double g = G * inverse_cube_root_squared(s.J);
        return isotropic_plus<D>(0.5 * K * (s.J * s.J - 1) - g * s.trace() / 3, g, s.b);
    }

    /// Strain energy per undeformed volume [J/m^3].
    template <int D>
    double energy(const Strain<D>& s) const {
        return 0.5 * G * (s.trace() * inverse_cube_root_squared(s.J) - 3) +
               0.5 * K * (0.5 * (s.J * s.J - 1) - std::log(s.J));
    }

    /// Upper bound of ρ0 c² over all directions [Pa]. In the plane of a unit vector n of the deformed body and t normal
    /// to it the acoustic tensor is, with g = G J^(−2/3),
    ///   nn: K/2 (J² + 1) + g (5/9 I₁ − 1/3 n·b·n),   nt: −2/3 g t·b·n,   tt: g n·b·n;
    /// its larger eigenvalue is bounded with the extreme values of n·b·n and of t·b·n. At rest: K + 4G/3.
    template <int D>
    [[gnu::always_inline]] double stiffness(const Strain<D>& s) const {
        const double g = G * inverse_cube_root_squared(s.J);
        const double largest = s.largest();
        const double smallest = s.smallest();
        const double nn = 0.5 * K * (s.J * s.J + 1) + g * (5.0 / 9 * s.trace() - smallest / 3);
        const double tt = g * largest;
        const double nt = g * (largest - smallest) / 3;
        return 0.5 * (nn + tt) + std::sqrt(0.25 * (nn - tt) * (nn - tt) + nt * nt);
    }
};

} // namespace abut
