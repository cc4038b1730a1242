#pragma once
/// \file ellipse_relaxation.h
/// Packings of many ellipses.

#include "geometry/packing/ellipse_packing.h"

namespace abut {

/// As pack_ellipses(), by growth in stages; after each, ellipses that overlap push and turn each other until none do.
std::vector<Ellipse> relax_ellipses(const PackingRequest& request);

} // namespace abut
