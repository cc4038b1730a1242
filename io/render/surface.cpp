#include "io/render/surface.h"

#include "io/render/values.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>

namespace abut {
namespace {

/// A particle at its place in the undeformed lattice of its body.
struct Place {
    std::array<int, 4> key; ///< body, z, y, x
    std::size_t particle;
};

/// All particles in the order of their places. A body of several parts may have several lattices; it is then the first
/// particle's for all, and neighbours of other lattices may not be found.
std::vector<Place> places_of(const Domains& domains, const double* displacement, const std::vector<double>& body) {
    std::map<double, std::size_t> first_of_body;
    std::vector<Place> places;
    places.reserve(domains.size());
    const auto undeformed = [&](std::size_t p, std::size_t k) {
        return domains.centre(p)[k] - displacement[3 * p + k];
    };
    for (std::size_t p = 0; p < domains.size(); ++p) {
        const std::size_t first = first_of_body.try_emplace(body[p], p).first->second;
        Place place{{static_cast<int>(body[p]), 0, 0, 0}, p};
        for (std::size_t k = 0; k < 3; ++k)
            place.key[3 - k] = static_cast<int>(
                std::lround((undeformed(p, k) - undeformed(first, k)) / (2 * domains.half_size(first)[k])));
        places.push_back(place);
    }
    std::sort(places.begin(), places.end(), [](const Place& a, const Place& b) { return a.key < b.key; });
    return places;
}

/// Whether the upper (sign 1) or lower (-1) face of a deformed domain and the other face of its neighbour's lie
/// together, to a share of the edge between them.
bool still_meet(const Domains& domains, std::size_t p, std::size_t neighbour, std::size_t axis, int sign) {
    constexpr double share = 0.2;
    const Vector3 edge = domains.half_edges(p)[axis], other = domains.half_edges(neighbour)[axis];
    double gap = 0, length = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const double d = domains.centre(neighbour)[k] - domains.centre(p)[k] - sign * (edge[k] + other[k]);
        gap += d * d;
        length += 4 * edge[k] * edge[k];
    }
    return gap < share * share * length;
}

} // namespace

std::vector<std::size_t> surface_particles(const PointFrame& frame, const Domains& domains) {
    const double* displacement = reals_of(frame, "displacement", 3);
    const Array* body = find_array(frame, "body");
    std::vector<std::size_t> seen;
    if (!displacement || !body || !domains.in_space()) {
        seen.resize(domains.size());
        std::iota(seen.begin(), seen.end(), std::size_t{0});
        return seen;
    }
    const std::vector<Place> places = places_of(domains, displacement, values_of(*body, -1));
    std::vector<int> neighbours(domains.size(), 0);
    for (std::size_t axis = 0; axis < 3; ++axis)
        for (const int sign : {-1, 1}) {
            auto cursor = places.begin(); // neighbours come in the order of the particles themselves
            for (const Place& place : places) {
                auto wanted = place.key;
                wanted[3 - axis] += sign;
                while (cursor != places.end() && cursor->key < wanted) ++cursor;
                if (cursor != places.end() && cursor->key == wanted)
                    neighbours[place.particle] += still_meet(domains, place.particle, cursor->particle, axis, sign);
            }
        }
    for (std::size_t p = 0; p < domains.size(); ++p)
        if (neighbours[p] < 6) seen.push_back(p);
    return seen;
}

} // namespace abut
