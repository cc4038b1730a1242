#pragma once
/// \file ellipse_packing.h
/// Random dense packings of ellipses that don't overlap.

#include "geometry/packing/size_distribution.h"
#include "scene/scene.h"

#include <cstdint>
#include <vector>

namespace abut {

/// What to pack. Lengths in any one unit (draw_ellipses(): pixels).
struct PackingRequest {
    double width = 0, height = 0; ///< of the box; all ellipses lie inside
    int bodies = 0;
    double min_aspect = 1, max_aspect = 1; ///< longer over shorter semi-axis
    SizeDistribution sizes;                ///< of √(a b)
    double area_fraction = 0;              ///< area of the ellipses over that of the box
    double gap = 0;                        ///< least distance between two ellipses
    std::uint64_t seed = 1;
};

/// Places small ellipses at random and lets them grow while they jiggle and turn (Monte Carlo moves, each kept only if
/// nothing overlaps) until they fill the wanted area fraction; more than 60 are packed by relax_ellipses(). z of
/// centres is 0; y points up; angles counter-clockwise. The same request gives the same packing on every machine.
/// \throws std::runtime_error when the area fraction is not reached; what() tells how far it came.
std::vector<Ellipse> pack_ellipses(const PackingRequest& request);

} // namespace abut
