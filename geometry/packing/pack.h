#pragma once
/// \file pack.h
/// Random packings of grains in a box (command pack).

#include "geometry/packing/size_distribution.h"
#include "scene/scene.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace abut {

enum class GrainKind { disks, ellipses, polygons, balls };

/// \throws std::invalid_argument for a word that names none of them
GrainKind parse_grain_kind(std::string_view word);

std::string word(GrainKind kind);

/// What to pack. Lengths in pixels.
struct PackRequest {
    GrainKind kind = GrainKind::ellipses;
    int width = 280, height = 560;
    int depth = 0; ///< of balls; else 0
    int bodies = 20;
    double area_fraction = 0.55; ///< of the box that grains fill; of balls: by volume
    SizeDistribution sizes;
    double min_aspect = 1, max_aspect = 2.5; ///< of ellipses: longer over shorter semi-axis
    double gap = 0;                          ///< least distance between two
    std::uint64_t seed = 1;
};

/// Largest number of grains.
inline constexpr int most_grains = 100000;

struct PackedGrains {
    GrainKind kind = GrainKind::ellipses;
    int width = 0, height = 0, depth = 0; ///< of the box
    /// Disk, Ellipse, Polygon or Ball; from the lower left (back) corner of the box, y up. The largest first.
    std::vector<ShapeSpec> grains;
    double fraction = 0;      ///< of the box, from the shapes
    std::size_t contacts = 0; ///< disks and balls: pairs at most 1 % of the mean diameter further apart than the gap
    double polygon_gap = 0;   ///< polygons: width of the gaps
};

/// Packs grains that don't overlap; the same request gives the same packing on every machine.
/// \throws std::invalid_argument when a value makes no sense; std::runtime_error when the fraction is not reached
PackedGrains pack_grains(const PackRequest& request);

} // namespace abut
