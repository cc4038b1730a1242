#pragma once
/// \file kempe.h
/// Colouring of large graphs.

#include "geometry/packing/shades.h"

#include <optional>
#include <vector>

namespace abut {

/// Colours bodies in the order of smallest degree last; where no colour is left, swaps two colours along Kempe chains
/// (all that hangs together in these two) until one is. Planar graphs and four colours: found practically always.
/// Afterwards all colours are used about equally often. Nothing when no colouring was found: there may still be one.
std::optional<std::vector<int>> kempe_colouring(const Neighbours& neighbours, int colours, Random& random);

} // namespace abut
