#pragma once
#include "grid/tile.h"

namespace abut {

/// Calls work(tile) for every tile, threads sharing the tiles; for work that writes to nothing but the tile's
/// particles.
template <int D, class Work>
void for_each_tile(Tiling<D>& tiling, Work&& work) {
    const auto n = static_cast<std::ptrdiff_t>(tiling.tiles.size());
#pragma omp parallel for schedule(dynamic, 8)
    for (std::ptrdiff_t t = 0; t < n; ++t) work(tiling.tiles[t]);
}

/// Calls work(tile) for every tile, colour by colour; for work that adds to nodes. See Tiling::colours.
template <int D, class Work>
void for_each_tile_by_colour(Tiling<D>& tiling, Work&& work) {
#pragma omp parallel
    for (const auto& colour : tiling.colours) {
        const auto n = static_cast<std::ptrdiff_t>(colour.size());
#pragma omp for schedule(dynamic, 4)
        for (std::ptrdiff_t i = 0; i < n; ++i) {
            const BlockTiles& block = tiling.blocks[colour[i]];
            for (int t = block.first; t < block.last; ++t) work(tiling.tiles[t]);
        }
    }
}

} // namespace abut
