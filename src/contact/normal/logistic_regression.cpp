#include "contact/normal/logistic_regression.h"

#include <bit>
#include <cmath>
#include <cstdint>

namespace abut {

namespace {

constexpr double penalty = 1e-7;   // λ of the normal's components, in units of Δx²
constexpr double tolerance = 1e-5; // ε of 1 − n·n'
constexpr int most_iterations = 15;

using PackBits = std::int64_t __attribute__((vector_size(32)));

inline Pack all(double value) {
    return Pack{value, value, value, value};
}

/// e^x for x in [-700, 0], four at a time, relative error below 1e-13: x = k ln 2 + r, Taylor series of e^r, 2^k by the
/// exponent bits.
inline Pack exponential(Pack x) {
    const Pack shifter = all(0x1.8p52); // rounds to integer and leaves it in the low bits
    const Pack shifted = x * 1.4426950408889634 + shifter;
    const Pack k = shifted - shifter;
    const Pack r = (x - k * 0x1.62e42fefa39efp-1) - k * 0x1.abc9e3b39803fp-56;
    Pack e = all(1.0 / 39916800);
    for (const double c :
         {1.0 / 3628800, 1.0 / 362880, 1.0 / 40320, 1.0 / 5040, 1.0 / 720, 1.0 / 120, 1.0 / 24, 1.0 / 6, 0.5, 1.0, 1.0})
        e = e * r + c;
    const PackBits bits = std::bit_cast<PackBits>(shifted) << 52;
    const PackBits scaled = std::bit_cast<PackBits>(e) + bits;
    return std::bit_cast<Pack>(scaled);
}

/// Solves the symmetric positive system A x = b in place by L D L^T. \return false if a pivot vanishes
template <int N>
bool solve(double (&A)[N][N], double (&b)[N]) {
    for (int j = 0; j < N; ++j) {
        const double scale = A[j][j];
        for (int k = 0; k < j; ++k) A[j][j] -= A[j][k] * A[j][k] * A[k][k];
        if (!(A[j][j] > 1e-14 * scale)) return false;
        for (int i = j + 1; i < N; ++i) {
            for (int k = 0; k < j; ++k) A[i][j] -= A[i][k] * A[j][k] * A[k][k];
            A[i][j] /= A[j][j];
        }
    }
    for (int i = 0; i < N; ++i)
        for (int k = 0; k < i; ++k) b[i] -= A[i][k] * b[k];
    for (int i = 0; i < N; ++i) b[i] /= A[i][i];
    for (int i = N - 1; i >= 0; --i)
        for (int k = i + 1; k < N; ++k) b[i] -= A[k][i] * b[k];
    return true;
}

inline double sum(const Pack& p) {
    return (p[0] + p[1]) + (p[2] + p[3]);
}

/// One iteration of Eq. (21): φ += (JᵀWJ + Λ)⁻¹ (JᵀW (c − f) − Λφ). With t = f(x·φ) = tanh(x·φ/2) the scaled logistic
/// function and ψ = (1 − t²)/2 its derivative, J_pj = ψ x_pj (Eq. 53-56).
///
/// Our own addition: the matrix, but not the vector, gets Σ w ψ² s² on the diagonal of the normal's components, s²
/// being the variance of a particle's own domain. It slows the steps (Levenberg and Marquardt) without moving the
/// solution. Nodes just beyond the free side of two bodies see only the outermost row of particles: nearly collinear
/// points, which the undamped first step separates by the accidental differences of their places across the row, giving
/// a normal along the interface from which the iteration doesn't recover. A particle's place is not known better than
/// its size. \return false if φ is left as it was
template <int D>
bool iterate(const Cloud<D>& cloud, double lambda, bool linear, double (&phi)[D + 1]) {
    constexpr int N = D + 1;
    Pack matrix[N][N] = {};
    Pack vector[N] = {};
    for (std::size_t q = 0; q < cloud.c.size(); ++q) {
        Pack x[N];
        for (int a = 0; a < D; ++a) x[a] = cloud.x[a][q];
        x[D] = all(1);
        Pack psi = all(0.5);
        Pack f = all(0);
        if (!linear) {
            Pack z = all(phi[D]);
            for (int a = 0; a < D; ++a) z += phi[a] * x[a];
            const Pack magnitude = z < 0 ? -z : z;
            const Pack e = exponential(magnitude > 700 ? all(-700) : -magnitude);
            const Pack t = (1 - e) / (1 + e);
            f = z < 0 ? -t : t;
            psi = 2 * e / ((1 + e) * (1 + e));
        }
        const Pack w = cloud.weight[q];
        const Pack residual = w * psi * (cloud.c[q] - f);
        const Pack weight = w * psi * psi;
        for (int i = 0; i < N; ++i) {
            vector[i] += residual * x[i];
            for (int j = 0; j <= i; ++j) matrix[i][j] += weight * x[i] * x[j];
        }
    }
    double A[N][N];
    double b[N];
    const double damping = cloud.spread * sum(matrix[D][D]);
    for (int i = 0; i < N; ++i) {
        b[i] = sum(vector[i]) - (i < D ? lambda * phi[i] : 0);
        for (int j = 0; j <= i; ++j) A[i][j] = sum(matrix[i][j]) + (i == j && i < D ? lambda + damping : 0);
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
    const double length = n.norm();
    return length > 0 ? Vec<D>(n / length) : Vec<D>::Zero();
}

} // namespace

template <int D>
Regression<D> logistic_regression(const Cloud<D>& cloud) {
    Regression<D> result;
    double phi[D + 1] = {};
    // From φ = 0 the first iteration is linear regression with four times the penalty (notes 3.22).
    if (!iterate<D>(cloud, penalty, true, phi)) return result;
    result.normal = normal_of<D>(phi);
    for (result.iterations = 1; result.iterations < most_iterations;) {
        if (!iterate<D>(cloud, penalty, false, phi)) break;
        ++result.iterations;
        const Vec<D> previous = result.normal;
        result.normal = normal_of<D>(phi);
        if (1 - result.normal.dot(previous) < tolerance) break;
    }
    result.found = result.normal.squaredNorm() > 0.5;
    return result;
}

template Regression<2> logistic_regression<2>(const Cloud<2>&);
template Regression<3> logistic_regression<3>(const Cloud<3>&);

} // namespace abut
