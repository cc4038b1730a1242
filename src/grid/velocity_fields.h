#pragma once
#include "grid/tile.h"

#include <vector>

namespace abut {

template <int D>
constexpr std::size_t nodes_per_block = block_edge* nodes_per_block<D - 1>;
template <>
inline constexpr std::size_t nodes_per_block<0> = 1;

/// A node that sees two or more bodies: its slots are [first, first + count).
template <int D>
struct ContactNode {
    Index<D> node;
    std::int32_t first = 0;
    std::int32_t count = 0;
};

/// The velocity fields in use: one *slot* for each pair of a node and a body that sees it (without contact, all
/// bodies share one field). Slots are numbered block by
/// block, node by node, body by body; empty space has none, and their number grows with the bodies that meet, not with
/// nodes times bodies.
template <int D>
struct VelocityFields {
    /// An occupied block of nodes.
    struct Block {
        Index<D> first_node;
        std::array<std::int32_t, nodes_per_block<D> + 1>
            first_slot; ///< of each node, x fastest; last: end of the block
        Index<D> node(int local) const {
            Index<D> result = first_node;
            for (int a = 0; a < D; ++a, local /= block_edge) result[a] += local % block_edge;
            return result;
        }
    };
    std::vector<Block> blocks;
    std::vector<std::int32_t> field; ///< of each slot: the body, or 0 without contact
    std::vector<std::int32_t> table; ///< slot of each node of each tile's window, at Tile::slots
    std::vector<ContactNode<D>> contact_nodes;

    std::size_t size() const { return field.size(); }
};

/// Numbers the slots that the tiles' windows need, and marks the tiles that touch contact nodes.
template <int D>
void number_slots(const Grid<D>& grid, Tiling<D>& tiling, VelocityFields<D>& fields);

} // namespace abut
