#pragma once
/// \file regress.h
/// What the regressions share: the sums over a cloud, four points at a time, the step and the iteration.

#include "contact/normal/regression.h"
#include "contact/normal/unit.h"

#include <bit>
#include <cmath>
#include <cstdint>

namespace abut {

inline constexpr double regression_penalty = 1e-7;   // λ of the normal's components, in units of Δx²
inline constexpr double regression_tolerance = 1e-5; // ε of 1 − n·n'
inline constexpr int most_iterations = 15;

inline Wide all(double value) {
    return Wide{} + value;
}

inline double sum(const Wide& w) {
    return (w[0] + w[1]) + (w[2] + w[3]);
}

/// e^x for x in [-700, 0], four at a time, relative error below 1e-13: x = k ln 2 + r, Taylor series of e^r, 2^k by
/// the exponent bits.
inline Wide exponential(Wide x) {
    using Bits = std::int64_t __attribute__((vector_size(32)));
    const Wide shifter = all(0x1.8p52); // rounds to integer and leaves it in the low bits
    const Wide shifted = x * 1.4426950408889634 + shifter;
    const Wide k = shifted - shifter;
    const Wide r = (x - k * 0x1.62e42fefa39efp-1) - k * 0x1.abc9e3b39803fp-56;
    Wide e = all(1.0 / 39916800);
    for (const double c :
         {1.0 / 3628800, 1.0 / 362880, 1.0 / 40320, 1.0 / 5040, 1.0 / 720, 1.0 / 120, 1.0 / 24, 1.0 / 6, 0.5, 1.0, 1.0})
        e = e * r + c;
    const Bits bits = std::bit_cast<Bits>(shifted) << 52;
    const Bits scaled = std::bit_cast<Bits>(e) + bits;
    return std::bit_cast<Wide>(scaled);
}

/// The scaled logistic function f = 2/(1 + e^−z) − 1 and its derivative ψ (contact paper Eq. 20, 53).
struct Logistic {
    Wide f, psi;
};
inline Logistic logistic(Wide z) {
    const Wide magnitude = z < 0 ? -z : z;
    const Wide e = exponential(magnitude > 700 ? all(-700) : -magnitude);
    const Wide share = 1 / (1 + e);
    const Wide t = (1 - e) * share;
    return {z < 0 ? -t : t, 2 * e * share * share};
}

/// What a point adds to the step's matrix (times x xᵀ) and vector (times x).
struct Terms {
    Wide matrix, vector;
};

/// The terms of the logistic regressions at φ = 0: linear regression with four times the penalty (notes 3.22, 3.44).
struct LinearTerms {
    static Terms at(Wide /*z*/, Wide c) { return {all(0.25), 0.5 * c}; }
};

/// Solves the symmetric positive system A x = b in place by L D L^T. \return false if a pivot vanishes
template <int N>
[[gnu::always_inline]] inline bool solve(double (&A)[N][N], double (&b)[N]) {
    double inverse[N];
    for (int j = 0; j < N; ++j) {
        double scaled[N];
        double pivot = A[j][j];
        for (int k = 0; k < j; ++k) {
            scaled[k] = A[j][k] * A[k][k];
            pivot -= A[j][k] * scaled[k];
        }
        if (!(pivot > 1e-14 * A[j][j])) return false;
        A[j][j] = pivot;
        inverse[j] = 1 / pivot;
        for (int i = j + 1; i < N; ++i) {
            for (int k = 0; k < j; ++k) A[i][j] -= A[i][k] * scaled[k];
            A[i][j] *= inverse[j];
        }
    }
    for (int i = 0; i < N; ++i)
        for (int k = 0; k < i; ++k) b[i] -= A[i][k] * b[k];
    for (int i = 0; i < N; ++i) b[i] *= inverse[i];
    for (int i = N - 1; i >= 0; --i)
        for (int k = i + 1; k < N; ++k) b[i] -= A[k][i] * b[k];
    return true;
}

/// One step of Eq. (21): φ += (Σ w M x xᵀ + Λ)⁻¹ (Σ w v x − Λφ), M and v being a regression's terms.
///
/// Our own addition: the matrix, but not the vector, gets s² Σ w M on the diagonal of the normal's components, s² being
/// the variance of a particle's own domain. It slows the steps (Levenberg and Marquardt) without moving the solution;
/// the first step, linear regression, is then that over all points of the particles' domains rather than over their
/// centres. Nodes just beyond the free side of two bodies see only the outermost row of particles: nearly collinear
/// points, which the undamped first step separates by the accidental differences of their places across the row, giving
/// a normal along the interface from which the iteration doesn't recover. A particle's place is not known better than
/// its size. \return false if φ is left as it was
template <int D, class Function>
[[gnu::always_inline]] inline bool iterate(const Cloud<D>& cloud, double (&phi)[D + 1]) {
    constexpr int N = D + 1;
    Wide matrix[N][N] = {};
    Wide vector[N] = {};
    for (int q = 0; q < cloud.blocks(); ++q) {
        Wide x[N];
        for (int a = 0; a < D; ++a) x[a] = cloud.block(cloud.x[a], q);
        x[D] = all(1);
        Wide z = all(phi[D]);
        for (int a = 0; a < D; ++a) z += phi[a] * x[a];
        const Terms terms = Function::at(z, cloud.block(cloud.c, q));
        const Wide w = cloud.block(cloud.weight, q);
        const Wide residual = w * terms.vector;
        const Wide weight = w * terms.matrix;
        for (int i = 0; i < N; ++i) {
            vector[i] += residual * x[i];
            const Wide weighted = weight * x[i];
            for (int j = 0; j <= i; ++j) matrix[i][j] += weighted * x[j];
        }
    }
    double A[N][N];
    double b[N];
    const double damping = cloud.spread * sum(matrix[D][D]);
    for (int i = 0; i < N; ++i) {
        b[i] = sum(vector[i]) - (i < D ? regression_penalty * phi[i] : 0);
        for (int j = 0; j <= i; ++j) A[i][j] = sum(matrix[i][j]) + (i == j && i < D ? regression_penalty + damping : 0);
    }
    if (!solve(A, b)) return false;
    for (int i = 0; i < N; ++i)
        if (!std::isfinite(b[i])) return false;
    for (int i = 0; i < N; ++i) phi[i] += b[i];
    return true;
}

template <int D>
Vec<D> normal_of(const double (&phi)[D + 1]) {
    Vec<D> n;
    for (int a = 0; a < D; ++a) n[a] = phi[a];
    return unit<D>(n);
}

/// Linear regression as the first iterate. \return false if there is no plane: points of one class alone, both classes
/// in the same places, though round-off may give one (1e-9 of a normal), or a singular matrix
template <int D>
bool first_iterate(const Cloud<D>& cloud, double (&phi)[D + 1], Regression<D>& result) {
    constexpr double least = 1e-7; // |φ| of a normal [1/cell]
    const bool both_classes = cloud.size_b > 0 && cloud.size_b < cloud.size;
    if (!both_classes || !iterate<D, LinearTerms>(cloud, phi)) return false;
    double squares = 0;
    for (int a = 0; a < D; ++a) squares += phi[a] * phi[a];
    if (!(squares > least * least)) return false;
    result.normal = normal_of<D>(phi);
    result.iterations = 1;
    result.found = result.normal.squaredNorm() > 0.5;
    return true;
}

/// Linear regression, then steps of the function until the normal stands still; two at least: the first may leave a
/// linear normal by chance that the next turns by 20 degrees (few points on one side).
template <int D, class Function>
Regression<D> regress(const Cloud<D>& cloud) {
    Regression<D> result;
    double phi[D + 1] = {};
    if (!first_iterate(cloud, phi, result)) return result;
    while (result.iterations < most_iterations) {
        if (!iterate<D, Function>(cloud, phi)) break;
        ++result.iterations;
        const Vec<D> previous = result.normal;
        result.normal = normal_of<D>(phi);
        if (result.iterations > 2 && 1 - result.normal.dot(previous) < regression_tolerance) break;
    }
    result.found = result.normal.squaredNorm() > 0.5;
    return result;
}

} // namespace abut
