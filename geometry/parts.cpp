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
            count += part.position.size();
            const Vector reach = turned_reach(part.half_size, part.angle);
            for (std::size_t axis = 0; axis < 3; ++axis) width_[axis] = std::max(width_[axis], 2 * reach[axis]);
        }
        entries_.reserve(count);
        for (std::size_t part = 0; part < parts.size(); ++part)
            for (std::size_t k = 0; k < parts[part].position.size(); ++k)
                entries_.push_back(
                    {bin(parts[part].position[k]), static_cast<std::uint32_t>(part), static_cast<std::uint32_t>(k)});
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

bool covers(const Part& part, std::size_t particle, const Vector& point) {
    const Vector& x = part.position[particle];
    Vector offset{point[0] - x[0], point[1] - x[1], point[2] - x[2]};
    if (part.angle != 0) offset = turned(offset, -part.angle); // along the particle's own edges
    for (std::size_t axis = 0; axis < 3; ++axis)
        if (part.half_size[axis] > 0 && // not z of plane particles
            std::abs(offset[axis]) >= part.half_size[axis] * (1 - round_off))
            return false;
    return true;
}

} // namespace

void check_inside(const std::vector<Part>& parts, const GridSpec& grid, std::vector<Problem>& problems) {
    for (const Part& part : parts) {
        const auto is_outside = [&](const Vector& point) {
            for (std::size_t axis = 0; axis < 3; ++axis) { // in two dimensions z is 0 everywhere
                const double slack = round_off * (grid.upper[axis] - grid.lower[axis]);
                if (point[axis] < grid.lower[axis] - slack || point[axis] > grid.upper[axis] + slack) return true;
            }
            return false;
        };
        const auto outside = std::count_if(part.position.begin(), part.position.end(), is_outside);
        if (outside > 0)
            problems.push_back(
                {part.pointer, fmt::format("body \"{}\" lies partly outside the grid: {} of its {}", part.body_name,
                                           outside, count_text(part.position.size(), "particle"))});
    }
}

void check_overlap(const std::vector<Part>& parts, std::vector<Problem>& problems) {
    if (parts.size() < 2) return;
    const Bins bins(parts);
    // Per two parts (earlier, later): the particles of the later one that coincide with some of the earlier one.
    std::map<std::pair<std::size_t, std::size_t>, std::set<std::size_t>> coinciding;
    bins.for_each_close_pair([&](std::size_t part, std::size_t k, std::size_t other, std::size_t particle) {
        if (covers(parts[other], particle, parts[part].position[k]))
            coinciding[std::minmax(part, other)].insert(other > part ? particle : k);
    });
    for (const auto& [pair, particles] : coinciding) {
        const Part& earlier = parts[pair.first];
        const Part& later = parts[pair.second];
        problems.push_back({later.pointer, fmt::format("body \"{}\" claims a place that body \"{}\" has already ({}): "
                                                       "{} of its {} coincide{}",
                                                       later.body_name, earlier.body_name, earlier.pointer,
                                                       particles.size(), count_text(later.position.size(), "particle"),
                                                       particles.size() == 1 ? "s" : "")});
    }
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
