#pragma once
#include <algorithm>
#include <cmath>

namespace abut {

// Distance of a body's edge beyond the node, d, from the extrapolated position of its particles, x >= 0, both along n
// and in cells, for the body that lies beyond (b). For body a both turn round: d_a(x) = −d(−x). All fits are of uGIMP
// extrapolation of a body that fills half the space, in its undeformed state.

/// Power law for two particles per cell along an axis (notes 3.51).
inline double power_law(double x, double exponent) {
    return 2 * std::pow(std::max(x, 0.0) / 1.25, exponent) - 1;
}

/// Two particles per cell: as long as the node sees one layer of particles only, the edge lies half a particle before
/// their centres, exactly (notes 3.52).
inline double two_per_cell(double x) {
    return x > 0.75 ? x - 0.25 : 1.5 * std::pow(4 * std::max(x, 0.0) / 3, 0.5546) - 1;
}

/// One particle per cell (notes 3.55).
inline double one_per_cell(double x) {
    return x > 0.5 ? x - 0.5 : std::pow(2 * std::max(x, 0.0), 0.5387) - 1;
}

/// Fitted position: δ = d_b − d_a by the power law (notes 3.48).
/// \param apparent_a (x_a − x_i)·n of the extrapolated position of a [cells]; likewise b
/// \return separation [cells]
inline double fitted_position(double apparent_a, double apparent_b, double exponent) {
    return power_law(apparent_b, exponent) + power_law(-apparent_a, exponent);
}

} // namespace abut
