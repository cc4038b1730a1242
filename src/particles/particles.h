#pragma once
#include "math/linear_algebra.h"
#include "particles/model.h"

#include <cstdint>
#include <vector>

namespace abut {

/// Symmetric Kirchhoff stress: xx yy zz xy in plane analyses, xx yy zz xy yz xz in 3D [Pa].
template <int D>
using Stress = Eigen::Matrix<double, D == 2 ? 4 : 6, 1>;

/// The material points, one array a field, kept in the order of blocks, bodies and cells (see sort.h).
/// Plane analyses hold the in-plane part of the deformation gradient; axisymmetric particles are full rings.
template <int D>
struct Particles {
    std::vector<Vec<D>> position;             ///< [m]
    std::vector<Vec<D>> velocity;             ///< [m/s]
    std::vector<Mat<D>> deformation_gradient; ///< F
    std::vector<Stress<D>> stress;            ///< Kirchhoff stress τ = Jσ [Pa]
    std::vector<double> mass;                 ///< [kg]
    std::vector<double> volume;               ///< undeformed, V0 [m^3]
    std::vector<Vec<D>> half_size;            ///< half edges of the undeformed domain [m]
    /// Stretch across the plane (plane stress) or around the axis (axisymmetric); else empty.
    std::vector<double> across;
    std::vector<Stress<D>> prestress; ///< S of bodies with an initial stress, see material/prestress.h; else empty [Pa]
    std::vector<std::int32_t> body;
    std::vector<std::int32_t> id; ///< index in the Model, which never changes

    std::size_t size() const { return position.size(); }
    /// Stretch across the plane or around the axis; 1 in plane strain.
    double across_of(std::size_t p) const { return across.empty() ? 1.0 : across[p]; }
};

/// Calls visit(name, array) with each array that a run changes; of several stores of one kind with the arrays of all:
/// visit(name, array, array). Arrays that a scene doesn't need are empty.
template <class Visit, class... Stores>
void visit_changing(Visit&& visit, Stores&... stores) {
    visit("position", stores.position...);
    visit("velocity", stores.velocity...);
    visit("deformation_gradient", stores.deformation_gradient...);
    visit("stress", stores.stress...);
    visit("across", stores.across...);
}

/// Likewise with each array of what a particle keeps for good: only their order changes.
template <class Visit, class... Stores>
void visit_lasting(Visit&& visit, Stores&... stores) {
    visit("mass", stores.mass...);
    visit("volume", stores.volume...);
    visit("half_size", stores.half_size...);
    visit("prestress", stores.prestress...);
    visit("body", stores.body...);
    visit("id", stores.id...);
}

/// Bytes that one particle takes in Particles<D>.
template <int D>
constexpr std::size_t bytes_per_particle() {
    return sizeof(Vec<D>) * 3 + sizeof(Mat<D>) + sizeof(Stress<D>) + 2 * sizeof(double) + 2 * sizeof(std::int32_t);
}

/// Particles without strain, but turned as the model says, with their body's velocity, in the model's order.
template <int D>
Particles<D> make_particles(const Model& model, const Scene& scene);

} // namespace abut
