#include "particles/sort.h"

#include "shape/stencil.h"

#include <algorithm>

namespace abut {

namespace {

template <class T>
void permute(std::vector<T>& values, const std::vector<std::int32_t>& order) {
    std::vector<T> sorted(values.size());
    for (std::size_t i = 0; i < order.size(); ++i) sorted[i] = values[order[i]];
    values.swap(sorted);
}

struct Key {
    std::int32_t block;
    std::int32_t body;
    std::int32_t cell; ///< within the block
    std::int32_t particle;
    auto operator<=>(const Key&) const = default; // `particle` last: keeps the order within a cell
};

template <int D>
Key key_of(const Particles<D>& particles, const Grid<D>& grid, std::int32_t p) {
    const Vec<D> x = grid.lattice_position(particles.position[p]);
    Index<D> block;
    int cell = 0;
    for (int a = D - 1; a >= 0; --a) {
        const int c = floor_int(x[a]);
        block[a] = c / block_edge;
        cell = cell * block_edge + c % block_edge;
    }
    return {grid.block_number(block), particles.body[p], cell, p};
}

} // namespace

template <int D>
Tiling<D> sort_particles(Particles<D>& particles, const Grid<D>& grid, bool field_per_body) {
    const auto n = static_cast<std::int32_t>(particles.size());
    std::vector<Key> keys(n);
    for (std::int32_t p = 0; p < n; ++p) keys[p] = key_of(particles, grid, p);
    std::sort(keys.begin(), keys.end());

    std::vector<std::int32_t> order(n);
    for (std::int32_t i = 0; i < n; ++i) order[i] = keys[i].particle;
    const auto sort = [&](const char*, auto& values) {
        if (!values.empty()) permute(values, order);
    };
    visit_changing(sort, particles);
    visit_lasting(sort, particles);

    Tiling<D> tiling;
    for (std::int32_t i = 0; i < n; ++i) {
        if (i == 0 || keys[i].block != keys[i - 1].block)
            tiling.blocks.push_back({keys[i].block, static_cast<std::int32_t>(tiling.tiles.size()), 0});
        if (i == 0 || keys[i].block != keys[i - 1].block || keys[i].body != keys[i - 1].body) {
            Tile<D> tile;
            tile.block = keys[i].block;
            tile.body = keys[i].body;
            tile.field = field_per_body ? tile.body : 0;
            tile.first = i;
            tiling.tiles.push_back(tile);
            tiling.blocks.back().last = static_cast<std::int32_t>(tiling.tiles.size());
        }
        tiling.tiles.back().last = i + 1;
    }
    return tiling;
}

template Tiling<2> sort_particles<2>(Particles<2>&, const Grid<2>&, bool);
template Tiling<3> sort_particles<3>(Particles<3>&, const Grid<3>&, bool);

} // namespace abut
