#pragma once
/// \file components.h
/// Connected components of a picture or a volume.

#include "geometry/labels/label_volume.h"

#include <array>
#include <cstdint>
#include <vector>

namespace abut {

/// Steps (along x, y, z) from a pixel to its neighbours, in scanning order; the later half is the former, reversed.
/// \param connectivity in the plane 4 (sharing an edge) or 8 (or a corner); in 3D 6 (sharing a face), 18 (or an edge)
/// or 26 (or a corner)
std::vector<std::array<int, 3>> neighbour_steps(int connectivity);

/// The connectivity that goes with it for what lies between: a closed chain of 8-neighbours, but not one of
/// 4-neighbours, keeps 4-neighbours from passing. 4 and 8, 6 and 26, 18 and 6.
int complementary_connectivity(int connectivity);

/// Components of equal label, each with a number from 1 in the order in which scanning (x fastest, then y, then z)
/// first meets them. Two passes with a union-find structure: time grows with the number of pixels. Memory: 4 bytes per
/// pixel for the result, and up to 4 more for pictures of nothing but tiny components.
struct Components {
    LabelVolume volume; ///< number of each pixel's component; 0 in void that was left out
    std::int32_t count = 0;
};

/// \param connectivity of labels other than 0
/// \param void_connectivity of label 0; 0: void is left out and keeps its 0
Components connected_components(const LabelVolume& labels, int connectivity, int void_connectivity = 0);

/// Replaces labels other than 0 by numbers from 1 in the order in which scanning first meets them.
/// \return the former label of each number
std::vector<std::int32_t> number_in_scanning_order(LabelVolume& volume);

} // namespace abut
