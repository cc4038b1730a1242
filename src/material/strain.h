#pragma once
#include "particles/particles.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace abut {

/// Deformation of a particle in three dimensions' terms: left Cauchy-Green tensor b = F F^T in Stress<D>'s order and
/// J = det F. Plane analyses: b_zz is the square of the stretch across the plane.
template <int D>
struct Strain {
    Stress<D> b;
    double J = 1;
    double trace() const { return b[0] + b[1] + b[2]; }
    /// Largest and smallest principal value of b; in 3D bounds that need no eigenvalues: mean ± √(2/3) |dev b|, which
    /// are exact at rest.
    double largest() const {
        if constexpr (D == 2)
            return std::max(0.5 * (b[0] + b[1]) + in_plane_radius(), b[2]);
        else
            return trace() / 3 + deviator();
    }
    double smallest() const {
        if constexpr (D == 2)
            return std::min(0.5 * (b[0] + b[1]) - in_plane_radius(), b[2]);
        else
            return std::max(trace() / 3 - deviator(), 4 * J * J / (trace() * trace()));
    }

private:
    double deviator() const {
        const double mean = trace() / 3;
        double squares = 0;
        for (int c = 0; c < static_cast<int>(b.size()); ++c) {
            const double d = c < 3 ? b[c] - mean : b[c];
            squares += (c < 3 ? 1 : 2) * d * d;
        }
        return std::sqrt(2.0 / 3 * squares);
    }
    double in_plane_radius() const {
        const double half_difference = 0.5 * (b[0] - b[1]);
        return std::sqrt(half_difference * half_difference + b[3] * b[3]);
    }
};

/// \param across stretch across the plane, or around the axis; 1 in plane strain, not used in 3D
// Component by component: see product() in deformation.h.
template <int D>
[[gnu::always_inline]] inline Strain<D> strain_of(const Mat<D>& F, [[maybe_unused]] double across = 1) {
    Strain<D> s;
    const auto b = [&](int i, int j) {
        double sum = 0;
        for (int k = 0; k < D; ++k) sum += F(i, k) * F(j, k);
        return sum;
    };
    s.b[0] = b(0, 0);
    s.b[1] = b(1, 1);
    s.b[3] = b(0, 1);
    if constexpr (D == 2) {
        s.b[2] = across * across;
        s.J = (F(0, 0) * F(1, 1) - F(0, 1) * F(1, 0)) * across;
    } else {
        s.b[2] = b(2, 2);
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

} // namespace abut
