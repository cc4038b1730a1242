#pragma once
#include "math/linear_algebra.h"

#include <Eigen/LU>
#include <limits>

namespace abut {

/// Distance from a particle's centre to the edge of its deformed domain along n, the ellipsoid inscribed in the
/// undeformed domain being carried along by F: the extent of that ellipsoid in the direction n,
///   R = |diag(R0) Fᵀ n|.
/// This is not Eq. (25) of the contact paper, 1/R = |diag(R0)⁻¹ F⁻¹ n|, which is the length of the ray along n from
/// the centre to the ellipsoid. Both agree while n is a principal direction of the particle's deformation, but in
/// shear the ray is shorter than the extent: a row of particles sheared along a straight edge would seem to end short
/// of that edge, and bodies would meet late. With the extent the row ends exactly at the edge: an edge of undeformed
/// normal N along an axis lies R0 from the centres and, deformed, has n = F⁻ᵀN/|F⁻ᵀN| and lies R0/|F⁻ᵀN| = |R0 Fᵀn|
/// from them.
template <int D>
double edge_distance(const Mat<D>& F, const Vec<D>& half_size, const Vec<D>& n) {
    return half_size.cwiseProduct(F.transpose() * n).norm();
}

/// The place on that ellipsoid that is farthest along n, x + F diag(R0)² Fᵀ n/R: the derivative of x·n + R by n.
template <int D>
Vec<D> edge_point(const Vec<D>& x, const Mat<D>& F, const Vec<D>& half_size, const Vec<D>& n) {
    const Vec<D> arm = half_size.cwiseProduct(F.transpose() * n);
    return x + F * half_size.cwiseProduct(arm) / arm.norm();
}

/// Eq. (25) as published.
template <int D>
double edge_distance_along_ray(const Mat<D>& F, const Vec<D>& half_size, const Vec<D>& n) {
    return 1 / (F.inverse() * n).cwiseQuotient(half_size).norm();
}

/// Where the particles of both sides of a point end along n (contact paper Eq. 22, 23), and which do; Eq. (24): b − a.
struct Edges {
    double a = -std::numeric_limits<double>::infinity();
    double b = std::numeric_limits<double>::infinity();
    int last_a = -1;
    int first_b = -1;
    void add(bool side_a, double x, double R, int p) {
        if (side_a && x + R > a) {
            a = x + R;
            last_a = p;
        } else if (!side_a && x - R < b) {
            b = x - R;
            first_b = p;
        }
    }
};

} // namespace abut
