#pragma once
#include "grid/tile.h"
#include "particles/particles.h"

#include <cmath>

namespace abut {

/// The nodes that one particle sees, with their shape functions S and gradient shape functions G [1/m]; nodes as
/// places in the window of the particle's tile. For shapes that are expanded on the spot, always N nodes.
template <int D, int N>
struct Stencil {
    int node[N];
    double S[N];
    double G[D][N];
};

/// Where a shape writes the stencil of one particle in the store: as many entries as its count() says. T is the hoop
/// shape function of axisymmetric analyses, N_i / r averaged over the particle [1/m]; else null.
template <int D>
struct StencilEntries {
    std::int32_t* node;
    double* S;
    double* G[D];
    double* T;
};

/// How a shape integrates over the face of a particle's domain along each edge of the face: with the same points as
/// over the domain, so that a uniform stress and the traction that goes with it are in equilibrium on the grid, also at
/// the corners of a body.
enum class FaceRule {
    center,  ///< as a particle without extent
    corners, ///< linear between them, as CPDI
    simpson  ///< exact for linear and quadratic grid functions, as GIMP
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

constexpr int power(int base, int exponent) {
    return exponent == 0 ? 1 : base * power(base, exponent - 1);
}

/// x, rounded to a double here. Compilers contract a b − c to one operation with a single rounding or don't, as they
/// inline, and the node where a stencil begins must be the same wherever it is found: else one of a particle on a grid
/// line lies outside the window.
[[gnu::always_inline]] inline double settled(double x) {
#if defined(__x86_64__)
    asm("" : "+x"(x));
#elif defined(__aarch64__)
    asm("" : "+w"(x));
#else
    volatile double rounded = x;
    x = rounded;
#endif
    return x;
}

/// No domain is taken to reach farther [cells]: nodes beyond could not be counted by an int, and a domain that reaches
/// beyond the grid is refused wherever it ends.
constexpr double farthest = 1e8;

/// Largest integer not above x; as fast as a conversion. \pre |x| < 2^31
inline int floor_int(double x) {
    const int i = static_cast<int>(x);
    return i - (x < i);
}

} // namespace abut
