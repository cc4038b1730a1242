#pragma once
#include <array>

namespace abut {

/// Three components, SI units; z is 0 in two-dimensional scenes.
using Vector = std::array<double, 3>;

enum class Analysis {
    plane_strain,
    plane_stress, ///< the stretch across the plane is such that there is no stress across it
    axisymmetric, ///< x is the radius r, y the axis z; a body is the full ring, 2π around
    three_d
};

/// Number of space dimensions of an analysis.
constexpr int dimension(Analysis analysis) {
    return analysis == Analysis::three_d ? 3 : 2;
}

enum class Side { lower, upper };

struct GridSpec {
    Vector cell{};  ///< wanted cell size per axis [m]; the box is divided in the nearest whole number of cells
    Vector lower{}; ///< lower corner of the box [m]
    Vector upper{}; ///< upper corner of the box [m]
};

} // namespace abut
