#include "grid/tile.h"

namespace abut {

template <int D>
int Tiling<D>::needed_stride(const Grid<D>& grid) const {
    // A window reaches `below` nodes below its block's first and `above` nodes beyond its block's last. Windows of two
    // blocks s apart are disjoint if edge - 1 + above < s edge - below.
    int result = 2;
    for (int a = 0; a < D; ++a) {
        int below = 0;
        int above = 0;
        for (const Tile<D>& tile : tiles) {
            const int first_node = grid.block_at(tile.block)[a] * block_edge;
            below = std::max(below, first_node - tile.window.lower[a]);
            above = std::max(above, tile.window.upper[a] - (first_node + block_edge - 1));
        }
        result = std::max(result, (below + above + block_edge - 1) / block_edge + 1);
    }
    return result;
}

template <int D>
void Tiling<D>::make_colours(const Grid<D>& grid, int new_stride) {
    stride = new_stride;
    int count = 1;
    for (int a = 0; a < D; ++a) count *= stride;
    colours.assign(count, {});
    for (std::size_t b = 0; b < blocks.size(); ++b) {
        const Index<D> block = grid.block_at(blocks[b].block);
        int colour = 0;
        for (int a = D - 1; a >= 0; --a) colour = colour * stride + block[a] % stride;
        colours[colour].push_back(static_cast<std::int32_t>(b));
    }
    std::erase_if(colours, [](const auto& colour) { return colour.empty(); });
}

template struct Tiling<2>;
template struct Tiling<3>;

} // namespace abut
