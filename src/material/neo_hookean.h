#pragma once
#include "material/strain.h"

#include <bit>
#include <cmath>
#include <cstdint>

namespace abut {

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

    /// Stretch across the plane for which τ_zz = 0: z² (λ/2 J₂² + G) = λ/2 + G, with J₂ = det F of the plane.
    double stretch_without_stress(const Strain<2>& s, double z) const {
        const double in_plane = s.J / z;
        return std::sqrt((0.5 * lambda + G) / (0.5 * lambda * in_plane * in_plane + G));
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

    /// Stretch z across the plane for which τ_zz = K/2 (J² − 1) + g (2/3 z² − (b_xx + b_yy)/3) = 0, g = G J^(−2/3), by
    /// Newton's method from the stretch before. τ_zz grows with z: dτ_zz/d ln z = K J² + g (8/9 z² + 2/9 (b_xx +
    /// b_yy)).
    double stretch_without_stress(const Strain<2>& s, double z) const {
        const double in_plane = s.J / z;
        const double trace = s.b[0] + s.b[1];
        for (int i = 0; i < 50; ++i) {
            const double J = in_plane * z;
            const double g = G * inverse_cube_root_squared(J);
            const double stress = 0.5 * K * (J * J - 1) + g * (2 * z * z - trace) / 3;
            const double slope = K * J * J + g * (8 * z * z + 2 * trace) / 9;
            const double change = stress / slope;
            z *= std::exp(-std::clamp(change, -1.0, 1.0));
            if (std::abs(change) < 1e-15) break;
        }
        return z;
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
