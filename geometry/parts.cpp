#include "geometry/parts.h"

#include "scene/turn.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <set>

namespace abut {

namespace {

constexpr double round_off = 1e-9; ///< relative to the length at hand

/// All particles of all parts in bins that no particle domain exceeds, so that domains meet only if their bins do.
class Bins {
public:
    explicit Bins(const std::vector<Part>& parts) {
        std::size_t count = 0;
        for (const Part& part : parts) {
            count += part.size();
            for (const PlacedParticle& particle : part.particle) {
                const Vector reach = turned_reach(particle.half_size, particle.angle);
                for (std::size_t axis = 0; axis < 3; ++axis) width_[axis] = std::max(width_[axis], 2 * reach[axis]);
            }
            // Both particles of one place may lie anywhere in it.
            for (std::size_t axis = 0; axis < part.lattice.dimension; ++axis)
                width_[axis] = std::max(width_[axis], part.lattice.edge[axis]);
        }
        entries_.reserve(count);
        for (std::size_t part = 0; part < parts.size(); ++part)
            for (std::size_t k = 0; k < parts[part].size(); ++k)
                entries_.push_back({bin(parts[part].particle[k].position), static_cast<std::uint32_t>(part),
                                    static_cast<std::uint32_t>(k)});
        std::sort(entries_.begin(), entries_.end(), [](const Entry& a, const Entry& b) { return a.bin < b.bin; });
    }

    /// Calls visit(part, particle, other part, its particle) for every particle and every one of other parts in the
    /// bins around it. The particles are taken in the order of the bins; so is, then, what lies in the row of bins next
    /// to each, and a cursor for each of the rows around moves on through all the entries once: no searching.
    template <class Visit>
    void for_each_close_pair(Visit&& visit) const {
        for (std::int64_t dz = -1; dz <= 1; ++dz)
            for (std::int64_t dy = -1; dy <= 1; ++dy) {
                auto cursor = entries_.begin();
                for (const Entry& entry : entries_) {
                    const auto [z, y, x] = entry.bin;
                    const Bin from{z + dz, y + dy, x - 1}, to{z + dz, y + dy, x + 1};
                    while (cursor != entries_.end() && cursor->bin < from) ++cursor;
                    for (auto other = cursor; other != entries_.end() && other->bin <= to; ++other)
                        if (other->part != entry.part) visit(entry.part, entry.particle, other->part, other->particle);
                }
            }
    }

private:
    using Bin = std::array<std::int64_t, 3>; ///< z, y, x
    struct Entry {
        Bin bin;
        std::uint32_t part, particle;
    };

    Bin bin(const Vector& point) const {
        Bin result{};
        for (std::size_t axis = 0; axis < 3; ++axis)
            if (width_[axis] > 0) result[2 - axis] = static_cast<std::int64_t>(std::floor(point[axis] / width_[axis]));
        return result;
    }

    Vector width_{}; ///< z is 0 in two dimensions [m]
    std::vector<Entry> entries_;
};

bool covers(const PlacedParticle& particle, const Vector& point) {
    const Vector& x = particle.position;
    Vector offset{point[0] - x[0], point[1] - x[1], point[2] - x[2]};
    if (particle.angle != 0) offset = turned(offset, -particle.angle); // along the particle's own edges
    for (std::size_t axis = 0; axis < 3; ++axis)
        if (particle.half_size[axis] > 0 && // not z of plane particles
            std::abs(offset[axis]) >= particle.half_size[axis] * (1 - round_off))
            return false;
    return true;
}

/// Whether the places of two parts are those of one lattice.
bool share_lattice(const Part& a, const Part& b) {
    return a.lattice == b.lattice && a.turn == 0 && b.turn == 0;
}

bool claim_same(const Part& a, std::size_t k, const Part& b, std::size_t l) {
    if (share_lattice(a, b)) {
        constexpr double slack = 0.25; // what join_slivers() may add to both, and the error of places_by_fraction()
        return a.place[k] == b.place[l] && a.fraction_of(k) + b.fraction_of(l) > 1 + slack;
    }
    return covers(a.particle[k], b.particle[l].position) || covers(b.particle[l], a.particle[k].position);
}

/// Keeps the particles for which keep[k] is not 0.
template <class T>
void keep_only(std::vector<T>& values, const std::vector<char>& keep) {
    if (values.empty()) return;
    std::size_t next = 0;
    for (std::size_t k = 0; k < values.size(); ++k)
        if (keep[k]) values[next++] = values[k];
    values.resize(next);
}

} // namespace

void add_particles(Part& part, const std::vector<Covered>& places, bool turned) {
    const bool whole =
        std::all_of(places.begin(), places.end(), [](const Covered& covered) { return covered.fraction == 1; });
    for (const Covered& covered : places) {
        part.place.push_back(covered.place);
        if (!whole) part.fraction.push_back(covered.fraction);
        part.particle.push_back(particle_of(covered, part.lattice, turned));
    }
}

double content_of(const Part& part) {
    double content = 0;
    for (std::size_t k = 0; k < part.size(); ++k) content += part.fraction_of(k);
    return content * part.lattice.content();
}

void check_inside(const std::vector<Part>& parts, const GridSpec& grid, std::vector<Problem>& problems) {
    for (const Part& part : parts) {
        const auto is_outside = [&](const PlacedParticle& particle) {
            for (std::size_t axis = 0; axis < 3; ++axis) { // in two dimensions z is 0 everywhere
                const double slack = round_off * (grid.upper[axis] - grid.lower[axis]);
                const double x = particle.position[axis];
                if (x < grid.lower[axis] - slack || x > grid.upper[axis] + slack) return true;
            }
            return false;
        };
        const auto outside = std::count_if(part.particle.begin(), part.particle.end(), is_outside);
        if (outside > 0)
            problems.push_back(
                {part.pointer, fmt::format("body \"{}\" lies partly outside the grid: {} of its {}", part.body_name,
                                           outside, count_text(part.size(), "particle"))});
    }
}

std::vector<Claim> find_claims(const std::vector<Part>& parts) {
    if (parts.size() < 2) return {};
    const Bins bins(parts);
    std::map<std::pair<std::size_t, std::size_t>, std::set<std::array<std::size_t, 2>>> claims;
    bins.for_each_close_pair([&](std::size_t part, std::size_t k, std::size_t other, std::size_t l) {
        if (part < other && claim_same(parts[part], k, parts[other], l)) claims[{part, other}].insert({l, k});
    });
    std::vector<Claim> result;
    result.reserve(claims.size());
    for (const auto& [pair, particles] : claims)
        result.push_back({pair.first, pair.second, {particles.begin(), particles.end()}});
    return result;
}

void check_overlap(const std::vector<Part>& parts, std::vector<Problem>& problems) {
    for (const Claim& claim : find_claims(parts)) {
        const Part& earlier = parts[claim.earlier];
        const Part& later = parts[claim.later];
        std::size_t count = 0;
        for (std::size_t i = 0; i < claim.particles.size(); ++i)
            count += i == 0 || claim.particles[i][0] != claim.particles[i - 1][0] ? 1 : 0;
        problems.push_back({later.pointer, fmt::format("body \"{}\" claims a place that body \"{}\" has already ({}): "
                                                       "{} of its {} coincide{}",
                                                       later.body_name, earlier.body_name, earlier.pointer, count,
                                                       count_text(later.size(), "particle"), count == 1 ? "s" : "")});
    }
}

std::vector<GivenUp> settle_overlap(std::vector<Part>& parts, Overlap overlap) {
    // The parts in the order in which they may choose.
    if (overlap == Overlap::last) std::reverse(parts.begin(), parts.end());
    std::vector<Claim> claims = find_claims(parts);
    std::stable_sort(claims.begin(), claims.end(), [](const Claim& a, const Claim& b) { return a.later < b.later; });
    std::vector<GivenUp> given_up;
    std::vector<std::vector<char>> keep;
    keep.reserve(parts.size());
    for (const Part& part : parts) keep.emplace_back(part.size(), 1);
    for (const Claim& claim : claims) { // all that an earlier part has given up is known when a later one's turn comes
        const Part& part = parts[claim.later];
        GivenUp gift{claim.later, claim.earlier, 0, 0};
        for (const auto& [k, in_the_way] : claim.particles) {
            if (!keep[claim.later][k] || !keep[claim.earlier][in_the_way]) continue;
            keep[claim.later][k] = 0;
            ++gift.particles;
            gift.content += part.fraction_of(k) * part.lattice.content();
        }
        if (gift.particles > 0) given_up.push_back(gift);
    }
    for (std::size_t k = 0; k < parts.size(); ++k) {
        keep_only(parts[k].place, keep[k]);
        keep_only(parts[k].fraction, keep[k]);
        keep_only(parts[k].temperature, keep[k]);
        keep_only(parts[k].orientation, keep[k]);
        keep_only(parts[k].particle, keep[k]);
    }
    if (overlap == Overlap::last) {
        std::reverse(parts.begin(), parts.end());
        for (GivenUp& gift : given_up) {
            gift.from = parts.size() - 1 - gift.from;
            gift.to = parts.size() - 1 - gift.to;
        }
    }
    return given_up;
}

std::string length_text(double metres) {
    const double size = std::abs(metres);
    if (size >= 1 || size == 0) return fmt::format("{:.4g} m", metres);
    if (size >= 1e-3) return fmt::format("{:.4g} mm", metres * 1e3);
    if (size >= 1e-6) return fmt::format("{:.4g} um", metres * 1e6);
    return fmt::format("{:.4g} nm", metres * 1e9);
}

std::string edges_text(const Vector& half_size) {
    std::string text = length_text(2 * half_size[0]) + " × " + length_text(2 * half_size[1]);
    return half_size[2] > 0 ? text + " × " + length_text(2 * half_size[2]) : text;
}

std::string count_text(std::size_t count, const std::string& noun) {
    return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

} // namespace abut
