#include "geometry/labels/components.h"

#include <algorithm>
#include <cstdlib>
#include <stdexcept>

namespace abut {

namespace {

using Steps = std::vector<std::array<int, 3>>;

/// Provisional numbers and which of them are the same component: each points to a smaller one of the same component,
/// the smallest to itself.
class Equivalences {
public:
    std::int32_t add() {
        parent_.push_back(static_cast<std::int32_t>(parent_.size()));
        return parent_.back();
    }
    std::int32_t root(std::int32_t k) {
        while (parent_[k] != k) {
            parent_[k] = parent_[parent_[k]];
            k = parent_[k];
        }
        return k;
    }
    std::int32_t join(std::int32_t a, std::int32_t b) {
        a = root(a);
        b = root(b);
        if (a > b) std::swap(a, b);
        parent_[b] = a;
        return a;
    }
    /// Replaces the structure by final numbers from 1. The smallest provisional number of a component is the one of its
    /// first pixel, so that the order is that of scanning.
    std::int32_t number() {
        std::int32_t count = 0;
        for (std::size_t k = 0; k < parent_.size(); ++k) // parents come before their children
            parent_[k] = parent_[k] == static_cast<std::int32_t>(k) ? ++count : parent_[parent_[k]];
        return count;
    }
    std::int32_t number_of(std::int32_t k) const { return parent_[k]; }

private:
    std::vector<std::int32_t> parent_;
};

/// Steps to the neighbours that scanning has met before, grouped into whole rows.
struct EarlierRow {
    int dy = 0, dz = 0;
    std::vector<int> dx;
};

std::vector<EarlierRow> earlier_rows(int connectivity) {
    Steps steps = neighbour_steps(connectivity);
    steps.resize(steps.size() / 2);
    std::vector<EarlierRow> rows;
    for (const auto& [dx, dy, dz] : steps) {
        if (rows.empty() || rows.back().dy != dy || rows.back().dz != dz) rows.push_back({dy, dz, {}});
        rows.back().dx.push_back(dx);
    }
    return rows;
}

} // namespace

std::vector<std::array<int, 3>> neighbour_steps(int connectivity) {
    const bool plane = connectivity == 4 || connectivity == 8;
    int farthest = 0; // how many axes a step may go along
    if (connectivity == 4 || connectivity == 6) farthest = 1;
    if (connectivity == 8 || connectivity == 18) farthest = 2;
    if (connectivity == 26) farthest = 3;
    if (farthest == 0) throw std::invalid_argument("connectivity must be 4, 8, 6, 18 or 26");
    Steps steps;
    for (int dz = plane ? 0 : -1; dz <= (plane ? 0 : 1); ++dz)
        for (int dy = -1; dy <= 1; ++dy)
            for (int dx = -1; dx <= 1; ++dx) {
                const int axes = std::abs(dx) + std::abs(dy) + std::abs(dz);
                if (axes > 0 && axes <= farthest) steps.push_back({dx, dy, dz});
            }
    return steps;
}

int complementary_connectivity(int connectivity) {
    switch (connectivity) {
    case 4:
        return 8;
    case 8:
        return 4;
    case 6:
        return 26;
    case 18:
    case 26:
        return 6;
    default:
        throw std::invalid_argument("connectivity must be 4, 8, 6, 18 or 26");
    }
}

Components connected_components(const LabelVolume& labels, int connectivity, int void_connectivity) {
    const std::vector<EarlierRow> of_bodies = earlier_rows(connectivity);
    const std::vector<EarlierRow> of_void =
        void_connectivity == 0 ? std::vector<EarlierRow>{} : earlier_rows(void_connectivity);
    const auto [nx, ny, nz] = labels.size;
    Components result;
    result.volume.size = labels.size;
    std::vector<std::int32_t>& number = result.volume.label;
    number.assign(labels.label.size(), -1); // -1: void that is left out
    Equivalences equivalences;
    for (int k = 0; k < nz; ++k) {
        for (int j = 0; j < ny; ++j) {
            const std::size_t row = labels.index(0, j, k);
            for (int i = 0; i < nx; ++i) {
                const std::int32_t label = labels.label[row + i];
                if (label == 0 && void_connectivity == 0) continue;
                std::int32_t own = -1;
                for (const EarlierRow& earlier : label == 0 ? of_void : of_bodies) {
                    const int y = j + earlier.dy, z = k + earlier.dz;
                    if (y < 0 || y >= ny || z < 0) continue;
                    const std::size_t other_row = labels.index(0, y, z);
                    for (const int dx : earlier.dx) {
                        const int x = i + dx;
                        if (x < 0 || x >= nx || labels.label[other_row + x] != label) continue;
                        const std::int32_t other = number[other_row + x];
                        if (own < 0)
                            own = other;
                        else if (own != other)
                            own = equivalences.join(own, other);
                    }
                }
                number[row + i] = own < 0 ? equivalences.add() : own;
            }
        }
    }
    result.count = equivalences.number();
    for (std::int32_t& each : number) each = each < 0 ? 0 : equivalences.number_of(each);
    return result;
}

std::vector<std::int32_t> number_in_scanning_order(LabelVolume& volume) {
    if (volume.label.empty()) return {};
    const auto largest = static_cast<std::size_t>(*std::max_element(volume.label.begin(), volume.label.end()));
    std::vector<std::int32_t> number(largest + 1, 0);
    std::vector<std::int32_t> former;
    for (std::int32_t& label : volume.label) {
        if (label == 0) continue;
        if (number[label] == 0) {
            former.push_back(label);
            number[label] = static_cast<std::int32_t>(former.size());
        }
        label = number[label];
    }
    return former;
}

} // namespace abut
