#include "geometry/model_report.h"

#include "geometry/labels/distance.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace abut {

namespace {

/// Places of a body as a raster of points at their centres and half-way between them, so that bodies of an even number
/// of places have a middle too. A point is inside if all places that touch it are. Very large bodies are taken at the
/// centres only.
struct Raster {
    std::array<int, 3> size{};
    std::array<double, 3> spacing{}; ///< [m]
    int per_place = 2;               ///< points along an edge
    std::vector<bool> inside;

    std::size_t index(int i, int j, int k) const { return (static_cast<std::size_t>(k) * size[1] + j) * size[0] + i; }
    bool has(int i, int j, int k) const {
        return i >= 0 && j >= 0 && k >= 0 && i < size[0] && j < size[1] && k < size[2];
    }
};

struct Bounds3 {
    Place first{}, last{};
};

Bounds3 bounds_of(const std::vector<const Part*>& parts) {
    constexpr auto most = std::numeric_limits<std::int32_t>::max();
    Bounds3 bounds{{most, most, most}, {-most, -most, -most}};
    for (const Part* part : parts)
        for (const Place& place : part->place)
            for (std::size_t a = 0; a < 3; ++a) {
                bounds.first[a] = std::min(bounds.first[a], place[a]);
                bounds.last[a] = std::max(bounds.last[a], place[a]);
            }
    return bounds;
}

Raster raster_of(const std::vector<const Part*>& parts) {
    const Lattice& lattice = parts.front()->lattice;
    const Bounds3 bounds = bounds_of(parts);
    std::array<int, 3> count{1, 1, 1};
    double points = 1;
    for (std::size_t a = 0; a < lattice.dimension; ++a) {
        count[a] = bounds.last[a] - bounds.first[a] + 1;
        points *= 2.0 * count[a] + 1;
    }
    Raster raster;
    raster.per_place = points < 3e7 ? 2 : 1;
    for (std::size_t a = 0; a < 3; ++a) {
        raster.size[a] = a < lattice.dimension ? raster.per_place * count[a] + 1 + (raster.per_place == 1 ? 1 : 0) : 1;
        raster.spacing[a] = a < lattice.dimension ? lattice.edge[a] / raster.per_place : lattice.edge[0];
    }
    // How many of the places around each point the body has.
    std::vector<std::uint8_t> touching(static_cast<std::size_t>(raster.size[0]) * raster.size[1] * raster.size[2], 0);
    const int reach = raster.per_place == 2 ? 1 : 0;
    for (const Part* part : parts)
        for (std::size_t p = 0; p < part->size(); ++p) {
            if (part->fraction_of(p) < 0.5) continue;
            std::array<int, 3> c{0, 0, 0};
            for (std::size_t a = 0; a < lattice.dimension; ++a)
                c[a] = raster.per_place * (part->place[p][a] - bounds.first[a]) + 1;
            const int depth = lattice.dimension == 3 ? reach : 0;
            for (int k = c[2] - depth; k <= c[2] + depth; ++k)
                for (int j = c[1] - reach; j <= c[1] + reach; ++j)
                    for (int i = c[0] - reach; i <= c[0] + reach; ++i) ++touching[raster.index(i, j, k)];
        }
    raster.inside.assign(touching.size(), false);
    for (int k = 0; k < raster.size[2]; ++k)
        for (int j = 0; j < raster.size[1]; ++j)
            for (int i = 0; i < raster.size[0]; ++i) {
                int needed = 1; // a point between places touches 2 along each axis on which it is even
                if (raster.per_place == 2) {
                    needed *= (i % 2 == 0) ? 2 : 1;
                    needed *= (j % 2 == 0) ? 2 : 1;
                    if (lattice.dimension == 3) needed *= (k % 2 == 0) ? 2 : 1;
                }
                raster.inside[raster.index(i, j, k)] = touching[raster.index(i, j, k)] >= needed;
            }
    return raster;
}

/// Offsets of about `reach` points in the directions of a compass.
std::vector<std::array<int, 3>> compass(double reach, bool space) {
    std::vector<std::array<int, 3>> offsets;
    if (!space) {
        for (int k = 0; k < 16; ++k)
            offsets.push_back({static_cast<int>(std::lround(reach * std::cos(k * std::numbers::pi / 8))),
                               static_cast<int>(std::lround(reach * std::sin(k * std::numbers::pi / 8))), 0});
        return offsets;
    }
    for (int k = -1; k <= 1; ++k)
        for (int j = -1; j <= 1; ++j)
            for (int i = -1; i <= 1; ++i) {
                const double length = std::sqrt(i * i + j * j + k * k);
                if (length == 0) continue;
                offsets.push_back({static_cast<int>(std::lround(reach * i / length)),
                                   static_cast<int>(std::lround(reach * j / length)),
                                   static_cast<int>(std::lround(reach * k / length))});
            }
    return offsets;
}

/// Twice the smallest distance to the outside at points from which it grows nowhere [m].
double thinnest_of(const std::vector<const Part*>& parts) {
    const Raster raster = raster_of(parts);
    std::vector<float> distance = squared_distance_to_outside(raster.inside, raster.size, raster.spacing,
                                                              {true, true, parts.front()->lattice.dimension == 3});
    for (float& d : distance) d = std::sqrt(d);
    const bool space = parts.front()->lattice.dimension == 3;
    // From the next point, so that the middle of narrow bodies is found, to three places, where steps of the outline
    // are seen no more, but bars of that length still are.
    std::vector<std::array<int, 3>> offsets;
    for (const double reach : {1.0, 2.0, 4.0, 3.0 * raster.per_place})
        for (const std::array<int, 3>& offset : compass(reach, space)) offsets.push_back(offset);
    constexpr double slope_at_corners = 0.2; // it is sin 45° towards the inside of a right angle, 0 along a bar
    double thinnest = std::numeric_limits<double>::infinity();
    for (int k = 0; k < raster.size[2]; ++k)
        for (int j = 0; j < raster.size[1]; ++j)
            for (int i = 0; i < raster.size[0]; ++i) {
                const double here = distance[raster.index(i, j, k)];
                if (!(here > 0) || here >= thinnest) continue;
                const bool grows = std::any_of(offsets.begin(), offsets.end(), [&](const std::array<int, 3>& d) {
                    if (!raster.has(i + d[0], j + d[1], k + d[2])) return false;
                    const double way =
                        std::hypot(d[0] * raster.spacing[0], d[1] * raster.spacing[1], d[2] * raster.spacing[2]);
                    return distance[raster.index(i + d[0], j + d[1], k + d[2])] - here > slope_at_corners * way;
                });
                if (!grows) thinnest = here;
            }
    if (!std::isfinite(thinnest)) return 0;
    // Points between places lie on the outline; without them it is half a place beyond the last centre.
    return raster.per_place == 2 ? 2 * thinnest : 2 * thinnest - raster.spacing[0];
}

} // namespace

double thinnest_width(const std::vector<const Part*>& parts, double cell) {
    std::vector<std::vector<const Part*>> groups; // that share a lattice
    for (const Part* part : parts) {
        if (part->size() == 0) continue;
        const auto same = std::find_if(groups.begin(), groups.end(), [&](const std::vector<const Part*>& group) {
            return part->turn == 0 && group.front()->turn == 0 && group.front()->lattice == part->lattice;
        });
        if (same == groups.end())
            groups.push_back({part});
        else
            same->push_back(part);
    }
    double thinnest = std::numeric_limits<double>::infinity();
    for (const std::vector<const Part*>& group : groups) thinnest = std::min(thinnest, thinnest_of(group));
    return std::isfinite(thinnest) ? thinnest / cell : 0;
}

} // namespace abut
