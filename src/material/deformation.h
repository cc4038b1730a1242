#pragma once
#include "math/linear_algebra.h"

#include <cmath>
#include <limits>

namespace abut {

/// exp(A) of a 2×2 matrix (FMPM paper Table 1, task 5: dF = exp(∇v Δt)). By Cayley and Hamilton, with A = a I + B,
/// tr B = 0 and B² = s I: exp A = e^a (cosh √s I + sinh √s / √s B), trigonometric for s < 0.
[[gnu::always_inline]] inline Mat<2> exponential(const Mat<2>& A) {
    const double a = 0.5 * (A(0, 0) + A(1, 1));
    const double b = 0.5 * (A(0, 0) - A(1, 1));
    const double s = b * b + A(0, 1) * A(1, 0);
    double c = 0; // cosh √s
    double q = 0; // sinh √s / √s
    if (std::abs(s) < 0.25) {
        // Taylor series in s; the first term left out is below 1e-16.
        c = 1 + s / 2 * (1 + s / 12 * (1 + s / 30 * (1 + s / 56 * (1 + s / 90 * (1 + s / 132 * (1 + s / 182))))));
        q = 1 + s / 6 * (1 + s / 20 * (1 + s / 42 * (1 + s / 72 * (1 + s / 110 * (1 + s / 156 * (1 + s / 210))))));
    } else if (s > 0) {
        const double root = std::sqrt(s);
        c = std::cosh(root);
        q = std::sinh(root) / root;
    } else {
        const double root = std::sqrt(-s);
        c = std::cos(root);
        q = std::sin(root) / root;
    }
    const double e = std::exp(a);
    Mat<2> result;
    result(0, 0) = e * (c + q * b);
    result(0, 1) = e * q * A(0, 1);
    result(1, 0) = e * q * A(1, 0);
    result(1, 1) = e * (c - q * b);
    return result;
}

/// exp(A) of a 3×3 matrix: its Taylor series, every power of A brought back to A², A and I by Cayley and Hamilton,
/// A³ = I₁ A² − I₂ A + I₃ I, so that the series is one of three numbers. Large A are halved first and the result
/// squared.
inline Mat<3> exponential(const Mat<3>& A) {
    const double size = A.cwiseAbs().rowwise().sum().maxCoeff();
    if (!(size < 700)) return Mat<3>::Constant(std::numeric_limits<double>::quiet_NaN()); // e^size overflows
    if (size > 1) {
        const Mat<3> half = exponential(Mat<3>(0.5 * A));
        return half * half;
    }
    const Mat<3> A2 = A * A;
    const double I1 = A.trace();
    const double I2 = 0.5 * (I1 * I1 - A2.trace());
    const double I3 = A(0, 0) * (A(1, 1) * A(2, 2) - A(1, 2) * A(2, 1)) -
                      A(0, 1) * (A(1, 0) * A(2, 2) - A(1, 2) * A(2, 0)) +
                      A(0, 2) * (A(1, 0) * A(2, 1) - A(1, 1) * A(2, 0));
    // A^n / n! = p A² + q A + r I, from n = 2 on.
    double p = 0.5;
    double q = 0;
    double r = 0;
    double sum_p = p;
    double sum_q = 1;
    double sum_r = 1;
    constexpr int most_terms = 20; // 1/20! is below round-off for size 1
    for (int n = 3; n <= most_terms; ++n) {
        const double next_p = (I1 * p + q) / n;
        const double next_q = (r - I2 * p) / n;
        r = I3 * p / n;
        p = next_p;
        q = next_q;
        sum_p += p;
        sum_q += q;
        sum_r += r;
        if (std::abs(p) * size * size + std::abs(q) * size + std::abs(r) < 1e-18) break;
    }
    Mat<3> result = sum_p * A2 + sum_q * A;
    result.diagonal().array() += sum_r;
    return result;
}

/// A B, component by component: the factors are in registers, and Eigen's vector code would go through memory to
/// gather them (a third of the particle update).
template <int D>
[[gnu::always_inline]] inline Mat<D> product(const Mat<D>& A, const Mat<D>& B) {
    Mat<D> result;
    for (int i = 0; i < D; ++i)
        for (int j = 0; j < D; ++j) {
            double sum = A(i, 0) * B(0, j);
            for (int k = 1; k < D; ++k) sum += A(i, k) * B(k, j);
            result(i, j) = sum;
        }
    return result;
}

} // namespace abut
