#pragma once
/// \file linear_algebra.h
/// Small dense algebra of fixed size: names for Eigen's types, and the 4-lane pack of the inner loops.

#include <Eigen/Core>

#include <array>

namespace abut {

template <int D>
using Vec = Eigen::Matrix<double, D, 1>;
template <int D>
using Mat = Eigen::Matrix<double, D, D>;

/// Four doubles that one vector register holds. Node quantities are packs: lane 0 a scalar (mass, or unused), lanes
/// 1 to 3 the components of a vector. A 2D scene leaves lane 3 zero; that costs no time on a 256-bit machine and lets
/// one kernel serve both dimensions.
using Pack = double __attribute__((vector_size(32)));

/// Pack of a scalar and a vector.
template <int D>
inline Pack pack(double scalar, const Vec<D>& vector) {
    Pack result{scalar, vector[0], vector[1], 0.0};
    if constexpr (D == 3) result[3] = vector[2];
    return result;
}

/// The vector lanes of a pack.
template <int D>
inline Vec<D> vector_of(const Pack& p) {
    if constexpr (D == 2)
        return {p[1], p[2]};
    else
        return {p[1], p[2], p[3]};
}

template <int D>
inline Vec<D> to_vec(const std::array<double, 3>& v) {
    if constexpr (D == 2)
        return {v[0], v[1]};
    else
        return {v[0], v[1], v[2]};
}

template <int D>
inline std::array<double, 3> to_array(const Vec<D>& v) {
    if constexpr (D == 2)
        return {v[0], v[1], 0.0};
    else
        return {v[0], v[1], v[2]};
}

/// Scalar product of the vector lanes.
inline double dot(const Pack& a, const Pack& b) {
    const Pack product = a * b;
    return product[1] + product[2] + product[3];
}

} // namespace abut
