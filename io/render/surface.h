#pragma once
/// \file surface.h
/// Which particles of a body are not hidden within it.

#include "io/render/domains.h"

#include <vector>

namespace abut {

/// Particles that lack a neighbour of their body on at least one of their six sides, in the frame's order: what can be
/// seen of full bodies. Neighbours are found in the undeformed bodies, from the array `displacement` (3), and must
/// still be where the particle's deformed faces are, so that the sides of cracks count as seen. Without `displacement`
/// or `body` all particles.
std::vector<std::size_t> surface_particles(const PointFrame& frame, const Domains& domains);

} // namespace abut
