#include "geometry/packing/shades.h"

#include "geometry/packing/kempe.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <set>
#include <stdexcept>

namespace abut {

namespace {

/// Depth-first search; the next body is always the one with the fewest shades left (Brélaz's DSATUR).
class Search {
public:
    Search(const Neighbours& neighbours, int shades)
        : neighbours_(neighbours), shade_(neighbours.size(), none), uses_(shades, 0) {}

    bool solve(std::size_t coloured = 0) {
        if (coloured == neighbours_.size()) return true;
        if (++steps_ > most_steps) {
            gave_up_ = true;
            return false;
        }
        const std::size_t body = hardest();
        std::vector<int> order = free_shades(body);
        std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return uses_[a] < uses_[b]; });
        bool tried_unused = false; // unused shades are all alike: one try is enough
        for (const int shade : order) {
            if (uses_[shade] == 0 && tried_unused) continue;
            tried_unused = tried_unused || uses_[shade] == 0;
            shade_[body] = shade;
            ++uses_[shade];
            if (solve(coloured + 1)) return true;
            if (gave_up_) return false;
            --uses_[shade];
            shade_[body] = none;
        }
        return false;
    }

    const std::vector<int>& shades() const { return shade_; }
    bool gave_up() const { return gave_up_; }

private:
    std::vector<int> free_shades(std::size_t body) const {
        std::vector<char> taken(uses_.size(), 0);
        for (const int other : neighbours_[body])
            if (shade_[other] != none) taken[shade_[other]] = 1;
        std::vector<int> result;
        for (std::size_t shade = 0; shade < uses_.size(); ++shade)
            if (!taken[shade]) result.push_back(static_cast<int>(shade));
        return result;
    }

    std::size_t hardest() const {
        std::size_t best = neighbours_.size(), fewest = 0;
        for (std::size_t body = 0; body < neighbours_.size(); ++body) {
            if (shade_[body] != none) continue;
            const std::size_t left = free_shades(body).size();
            if (best == neighbours_.size() || left < fewest ||
                (left == fewest && neighbours_[body].size() > neighbours_[best].size())) {
                best = body;
                fewest = left;
            }
        }
        return best;
    }

    static constexpr int none = -1;
    static constexpr long most_steps = 200000;
    const Neighbours& neighbours_;
    std::vector<int> shade_;
    std::vector<int> uses_; ///< per shade
    long steps_ = 0;
    bool gave_up_ = false; ///< there may be a colouring
};

/// A complete search of few bodies, else Kempe chains.
std::vector<int> any_shades(const Neighbours& neighbours, int shades, Random& random) {
    constexpr std::size_t few = 150; // the search goes as deep as there are bodies
    if (neighbours.size() <= few) {
        Search search(neighbours, shades);
        if (search.solve()) return search.shades();
        if (!search.gave_up())
            throw std::runtime_error(
                fmt::format("{} shades are too few for neighbours to differ; ask for more shades", shades));
    }
    if (const auto found = kempe_colouring(neighbours, shades, random)) return *found;
    throw std::runtime_error(
        fmt::format("found no way to shade neighbours differently with {} shades; ask for more shades", shades));
}

} // namespace

Neighbours neighbours_of(const std::vector<int>& label, int width, int height, int bodies, double distance) {
    std::vector<std::array<int, 2>> offsets;
    const int reach = static_cast<int>(std::floor(distance));
    for (int dy = -reach; dy <= reach; ++dy)
        for (int dx = -reach; dx <= reach; ++dx)
            if (dx * dx + dy * dy <= distance * distance) offsets.push_back({dx, dy});

    const auto at = [&](int x, int y) {
        return x < 0 || y < 0 || x >= width || y >= height ? 0 : label[static_cast<std::size_t>(y) * width + x];
    };
    std::vector<std::set<int>> found(bodies);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const int own = at(x, y);
            // The pixel of a body that is nearest to another body has a neighbour outside.
            if (own == 0 || (at(x - 1, y) == own && at(x + 1, y) == own && at(x, y - 1) == own && at(x, y + 1) == own))
                continue;
            int last = 0;
            for (const auto& [dx, dy] : offsets)
                if (const int other = at(x + dx, y + dy); other != 0 && other != own && other != last) {
                    last = other;
                    found[own - 1].insert(other - 1);
                    found[other - 1].insert(own - 1);
                }
        }
    }
    Neighbours result;
    for (const std::set<int>& each : found) result.emplace_back(each.begin(), each.end());
    return result;
}

std::vector<int> choose_shades(const Neighbours& neighbours, int shades, Random& random) {
    std::vector<int> result = any_shades(neighbours, shades, random);
    // The search hands them out in the order of its choices; mix them, so that a shade says nothing about the place.
    std::vector<int> mixed(shades);
    std::iota(mixed.begin(), mixed.end(), 0);
    for (int k = shades - 1; k > 0; --k) std::swap(mixed[k], mixed[random.below(k + 1)]);
    for (int& shade : result) shade = mixed[shade];
    return result;
}

} // namespace abut
