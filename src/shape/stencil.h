#pragma once
#include "grid/tile.h"
#include "particles/particles.h"

#include <cmath>

namespace abut {

/// The nodes that one particle sees, with their shape functions S and gradient shape functions G [1/m]; nodes as
/// places in the window of the particle's tile.
template <int D, int MaxNodes>
struct Stencil {
    int count = MaxNodes;
    int node[MaxNodes];
    double S[MaxNodes];
    double G[D][MaxNodes];
};

/// What a shape reads of one particle.
template <int D>
struct Domain {
    const Vec<D>& position;
    const Mat<D>& deformation_gradient;
    const Vec<D>& half_size;
};

template <int D>
inline Domain<D> domain_of(const Particles<D>& particles, std::size_t p) {
    return {particles.position[p], particles.deformation_gradient[p], particles.half_size[p]};
}

/// Shape functions and derivatives along one axis for K neighbouring nodes from `base` on.
template <int K>
struct AxisFactors {
    int base;
    double w[K];
    double dw[K]; ///< [1/m]
};

/// Tensor product of factors along the axes.
template <int D, int K, int N>
inline void expand_product(const AxisFactors<K> (&f)[D], const Window<D>& window, Stencil<D, N>& s) {
    if constexpr (D == 2) {
        const int row = window.extent(0);
        const int first = (f[1].base - window.lower[1]) * row + f[0].base - window.lower[0];
        for (int j = 0, k = 0; j < K; ++j)
            for (int i = 0; i < K; ++i, ++k) {
                s.node[k] = first + j * row + i;
                s.S[k] = f[0].w[i] * f[1].w[j];
                s.G[0][k] = f[0].dw[i] * f[1].w[j];
                s.G[1][k] = f[0].w[i] * f[1].dw[j];
            }
    } else {
        const int row = window.extent(0);
        const int plane = row * window.extent(1);
        const int first =
            (f[2].base - window.lower[2]) * plane + (f[1].base - window.lower[1]) * row + f[0].base - window.lower[0];
        for (int l = 0, k = 0; l < K; ++l)
            for (int j = 0; j < K; ++j)
                for (int i = 0; i < K; ++i, ++k) {
                    s.node[k] = first + l * plane + j * row + i;
                    s.S[k] = f[0].w[i] * f[1].w[j] * f[2].w[l];
                    s.G[0][k] = f[0].dw[i] * f[1].w[j] * f[2].w[l];
                    s.G[1][k] = f[0].w[i] * f[1].dw[j] * f[2].w[l];
                    s.G[2][k] = f[0].w[i] * f[1].w[j] * f[2].dw[l];
                }
    }
}

constexpr int power(int base, int exponent) {
    return exponent == 0 ? 1 : base * power(base, exponent - 1);
}

/// Largest integer not above x; as fast as a conversion.
inline int floor_int(double x) {
    const int i = static_cast<int>(x);
    return i - (x < i);
}

} // namespace abut
