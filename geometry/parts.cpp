#include "geometry/parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <set>

namespace abut {

namespace {

constexpr double round_off = 1e-9; ///< relative to the length at hand

/// All particles of all parts, in square-ish bins that no particle domain exceeds.
class Bins {
public:
    explicit Bins(const std::vector<Part>& parts) {
        for (const Part& part : parts)
            for (std::size_t axis = 0; axis < 2; ++axis)
                width_[axis] = std::max(width_[axis], 2 * part.half_size[axis]);
        for (std::size_t part = 0; part < parts.size(); ++part)
            for (std::size_t k = 0; k < parts[part].position.size(); ++k) {
                const auto [x, y] = bin(parts[part].position[k]);
                entries_.push_back({y, x, static_cast<std::uint32_t>(part), static_cast<std::uint32_t>(k)});
            }
        std::sort(entries_.begin(), entries_.end());
    }

    /// Calls visit(part, particle) for every particle of the 3 × 3 bins around a point.
    template <class Visit>
    void near(const Vector& point, Visit&& visit) const {
        const auto [x, y] = bin(point);
        for (std::int64_t row = y - 1; row <= y + 1; ++row) {
            auto entry = std::lower_bound(entries_.begin(), entries_.end(), Entry{row, x - 1, 0, 0});
            for (; entry != entries_.end() && entry->y == row && entry->x <= x + 1; ++entry)
                visit(entry->part, entry->particle);
        }
    }

private:
    struct Entry {
        std::int64_t y, x;
        std::uint32_t part, particle;
        auto operator<=>(const Entry&) const = default;
    };

    std::pair<std::int64_t, std::int64_t> bin(const Vector& point) const {
        return {static_cast<std::int64_t>(std::floor(point[0] / width_[0])),
                static_cast<std::int64_t>(std::floor(point[1] / width_[1]))};
    }

    std::array<double, 2> width_{0, 0};
    std::vector<Entry> entries_;
};

bool covers(const Part& part, std::size_t particle, const Vector& point) {
    for (std::size_t axis = 0; axis < 2; ++axis)
        if (std::abs(point[axis] - part.position[particle][axis]) >= part.half_size[axis] * (1 - round_off))
            return false;
    return true;
}

} // namespace

void check_inside(const std::vector<Part>& parts, const GridSpec& grid, std::vector<Problem>& problems) {
    for (const Part& part : parts) {
        const auto is_outside = [&](const Vector& point) {
            for (std::size_t axis = 0; axis < 2; ++axis) {
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
    for (std::size_t part = 0; part < parts.size(); ++part) {
        for (std::size_t k = 0; k < parts[part].position.size(); ++k) {
            const Vector& centre = parts[part].position[k];
            bins.near(centre, [&](std::size_t other, std::size_t particle) {
                if (other == part || !covers(parts[other], particle, centre)) return;
                coinciding[std::minmax(part, other)].insert(other > part ? particle : k);
            });
        }
    }
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

std::string count_text(std::size_t count, const std::string& noun) {
    return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

} // namespace abut
