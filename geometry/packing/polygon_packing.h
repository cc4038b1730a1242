#pragma once
/// \file polygon_packing.h
/// Polygonal grains that fill a box, with gaps of one width between them.

#include "geometry/packing/size_distribution.h"
#include "scene/scene.h"

#include <cstdint>
#include <vector>

namespace abut {

/// What to pack. Lengths in any one unit.
struct PolygonRequest {
    double width = 0, height = 0; ///< of the box
    int bodies = 0;
    SizeDistribution sizes;   ///< of √area before the gaps are cut out
    double area_fraction = 1; ///< of the box that they fill; 1: no gaps
    double gap = 0;           ///< least width of the gaps
    std::uint64_t seed = 1;
};

struct PackedPolygons {
    std::vector<Polygon> polygons;            ///< convex, counter-clockwise, the largest first
    std::vector<std::vector<int>> neighbours; ///< of each: those across its sides, ascending
    double gap = 0;                           ///< width of the gaps
};

/// The Laguerre diagram of packed disks, with weights such that each cell has the wanted area, and gaps cut out between
/// the cells so that the fraction is met; at the walls there is no gap. \throws std::runtime_error when that cannot be
PackedPolygons pack_polygons(const PolygonRequest& request);

} // namespace abut
