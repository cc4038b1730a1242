#include "grid/velocity_fields.h"

#include <numeric>

namespace abut {

namespace {

/// Where a node lies: number of its block in the grid, place in the block.
template <int D>
struct Place {
    int block;
    int local;
};

template <int D>
Place<D> place_of(const Grid<D>& grid, const Index<D>& node) {
    int block = 0;
    int local = 0;
    for (int a = D - 1; a >= 0; --a) {
        block = block * grid.blocks[a] + node[a] / block_edge;
        local = local * block_edge + node[a] % block_edge;
    }
    return {block, local};
}

} // namespace

template <int D>
void number_slots(const Grid<D>& grid, Tiling<D>& tiling, VelocityFields<D>& fields) {
    constexpr int block_nodes = static_cast<int>(nodes_per_block<D>);

    // Occupied blocks of nodes, in ascending order.
    std::vector<std::int32_t> block_index(grid.block_count(), -1);
    for (const Tile<D>& tile : tiling.tiles) {
        Window<D> blocks;
        for (int a = 0; a < D; ++a) {
            blocks.lower[a] = tile.window.lower[a] / block_edge;
            blocks.upper[a] = tile.window.upper[a] / block_edge;
        }
        for_each_node(blocks, [&](const Index<D>& block) { block_index[grid.block_number(block)] = 0; });
    }
    fields.blocks.clear();
    for (int b = 0; b < grid.block_count(); ++b) {
        if (block_index[b] < 0) continue;
        block_index[b] = static_cast<std::int32_t>(fields.blocks.size());
        typename VelocityFields<D>::Block block{};
        block.first_node = grid.block_at(b);
        for (int& i : block.first_node) i *= block_edge;
        fields.blocks.push_back(block);
    }

    // Fields in ascending order, so that "the last field that came by" tells whether a tile is the first of its field
    // at a node: neighbouring tiles of one field share nodes.
    std::vector<std::int32_t> by_field(tiling.tiles.size());
    std::iota(by_field.begin(), by_field.end(), 0);
    std::stable_sort(by_field.begin(), by_field.end(),
                     [&](int a, int b) { return tiling.tiles[a].field < tiling.tiles[b].field; });

    const std::size_t node_count = fields.blocks.size() * block_nodes;
    std::vector<std::int32_t> last_field(node_count, -1);
    std::vector<std::int32_t> count(node_count, 0);
    const auto node_number = [&](const Index<D>& node) {
        const Place<D> place = place_of<D>(grid, node);
        return static_cast<std::size_t>(block_index[place.block]) * block_nodes + place.local;
    };
    std::size_t table_size = 0;
    for (const std::int32_t t : by_field) {
        Tile<D>& tile = tiling.tiles[t];
        tile.slots = table_size;
        table_size += tile.window.size();
        for_each_node(tile.window, [&](const Index<D>& node) {
            const std::size_t n = node_number(node);
            if (last_field[n] != tile.field) {
                last_field[n] = tile.field;
                ++count[n];
            }
        });
    }

    std::int32_t slot = 0;
    fields.contact_nodes.clear();
    for (std::size_t b = 0; b < fields.blocks.size(); ++b) {
        auto& block = fields.blocks[b];
        for (int local = 0; local < block_nodes; ++local) {
            const std::int32_t here = count[b * block_nodes + local];
            block.first_slot[local] = slot;
            if (here > 1) fields.contact_nodes.push_back({block.node(local), slot, here});
            slot += here;
        }
        block.first_slot[block_nodes] = slot;
    }

    fields.field.assign(slot, -1);
    fields.table.resize(table_size);
    std::fill(last_field.begin(), last_field.end(), -1);
    std::vector<std::int32_t> filled(node_count, 0);
    for (const std::int32_t t : by_field) {
        Tile<D>& tile = tiling.tiles[t];
        tile.contact = false;
        std::size_t entry = tile.slots;
        for_each_node(tile.window, [&](const Index<D>& node) {
            const std::size_t n = node_number(node);
            const std::int32_t first = fields.blocks[n / block_nodes].first_slot[n % block_nodes];
            if (last_field[n] != tile.field) {
                last_field[n] = tile.field;
                fields.field[first + filled[n]++] = tile.field;
            }
            fields.table[entry++] = first + filled[n] - 1;
            tile.contact |= count[n] > 1;
        });
    }
}

template void number_slots<2>(const Grid<2>&, Tiling<2>&, VelocityFields<2>&);
template void number_slots<3>(const Grid<3>&, Tiling<3>&, VelocityFields<3>&);

} // namespace abut
