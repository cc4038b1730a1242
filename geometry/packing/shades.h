#pragma once
/// \file shades.h
/// Shades for neighbouring bodies: a colouring of a graph.

#include "geometry/packing/random.h"

#include <vector>

namespace abut {

/// For each body the numbers of its neighbours (symmetric).
using Neighbours = std::vector<std::vector<int>>;

/// Bodies of a label map (0 is void, k > 0 is body k - 1) that have pixels at most `distance` pixels apart, measured
/// between pixel centres.
Neighbours neighbours_of(const std::vector<int>& label, int width, int height, int bodies, double distance);

/// Gives each body one of `shades` shades (0 ..), neighbours always different ones, all about equally often; every
/// shade is used if there are enough bodies. \throws std::runtime_error when there is no such choice, or none was found
/// in reasonable time.
std::vector<int> choose_shades(const Neighbours& neighbours, int shades, Random& random);

} // namespace abut
