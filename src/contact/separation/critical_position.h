#pragma once

namespace abut {

/// Critical position: (x_b − x_a)·n less a constant offset (contact paper Eq. 16; notes 3.50, 3.54). Right for one
/// place of the edges between the nodes and one number of particles per cell: 0.8 for two along an axis, 1.07 for one.
/// \param apparent_a (x_a − x_i)·n of the extrapolated position of a [cells]; likewise b
/// \return separation [cells]
inline double critical_position(double apparent_a, double apparent_b, double offset) {
    return apparent_b - apparent_a - offset;
}

} // namespace abut
