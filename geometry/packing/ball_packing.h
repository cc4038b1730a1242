#pragma once
/// \file ball_packing.h
/// Random dense packings of disks (D = 2) and balls (D = 3).

#include "geometry/packing/near_pairs.h"

#include <cstdint>
#include <vector>

namespace abut {

/// What to pack. Lengths in any one unit.
template <int D>
struct BallRequest {
    PointD<D> box{};           ///< all lie inside [0, box]
    std::vector<double> sizes; ///< radii relative to each other
    double fraction = 0;       ///< of the box that they fill
    double gap = 0;            ///< least distance between two
    std::uint64_t seed = 1;
};

template <int D>
struct PackedBalls {
    std::vector<PointD<D>> centres; ///< in the order of the sizes
    std::vector<double> radii;
};

/// Places small balls at random and lets them grow in stages; after each, those that overlap push each other apart
/// until none do. The same request gives the same packing on every machine. \throws std::runtime_error when the
/// fraction is not reached; what() tells how far it came
template <int D>
PackedBalls<D> pack_balls(const BallRequest<D>& request);

/// Number of pairs that are at most `distance` apart.
template <int D>
std::size_t count_contacts(const PackedBalls<D>& balls, const PointD<D>& box, double distance);

} // namespace abut
