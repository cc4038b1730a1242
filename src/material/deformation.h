#pragma once
#include "math/linear_algebra.h"

#include <cmath>

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

/// A B, component by component: the factors are in registers, and Eigen's vector code would go through memory to
/// gather them (a third of the particle update).
[[gnu::always_inline]] inline Mat<2> product(const Mat<2>& A, const Mat<2>& B) {
    Mat<2> result;
    for (int i = 0; i < 2; ++i)
        for (int j = 0; j < 2; ++j) result(i, j) = A(i, 0) * B(0, j) + A(i, 1) * B(1, j);
    return result;
}

} // namespace abut
