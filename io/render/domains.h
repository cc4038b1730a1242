#pragma once
/// \file domains.h
/// The deformed domains of a frame's particles.

#include "io/render/view.h"
#include "results/frame.h"

#include <array>
#include <optional>

namespace abut {

using Vector3 = std::array<double, 3>;

/// Parallelepipeds, x ± F·(rx, 0, 0) ± F·(0, ry, 0) ± F·(0, 0, rz), from the arrays `half_size` (3) and
/// `deformation_gradient` (9, row by row; the identity if it is missing); parallelograms where rz is 0. Refers to the
/// frame's memory.
class Domains {
public:
    /// None if the frame has no `half_size`.
    static std::optional<Domains> of(const PointFrame& frame);

    std::size_t size() const { return size_; }
    const double* centre(std::size_t particle) const { return points_ + 3 * particle; } ///< [m]
    /// F·(rx, 0, 0) and so on, the halves of the deformed edges [m].
    std::array<Vector3, 3> half_edges(std::size_t particle) const;
    /// Undeformed [m].
    const double* half_size(std::size_t particle) const { return half_size_ + 3 * particle; }
    /// Whether any of them has a thickness, as in three-dimensional scenes.
    bool in_space() const;
    /// Makes the box contain the domains.
    void extend(Bounds& bounds) const;

private:
    const double *points_ = nullptr, *half_size_ = nullptr, *gradient_ = nullptr;
    std::size_t size_ = 0;
};

/// A real array's values if it is there with so many components, else null.
const double* reals_of(const PointFrame& frame, const char* name, int components);

} // namespace abut
