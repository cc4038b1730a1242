#pragma once
#include "grid/grid.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <vector>

namespace abut {

/// A box of nodes, both ends included.
template <int D>
struct Window {
    Index<D> lower;
    Index<D> upper;

    static Window empty() {
        Window w;
        w.lower.fill(std::numeric_limits<int>::max());
        w.upper.fill(std::numeric_limits<int>::min());
        return w;
    }
    int extent(int axis) const { return upper[axis] - lower[axis] + 1; }
    int size() const {
        int n = 1;
        for (int a = 0; a < D; ++a) n *= extent(a);
        return n;
    }
    /// Place of a node in this window, x fastest.
    int local(const Index<D>& node) const {
        int n = node[D - 1] - lower[D - 1];
        for (int a = D - 2; a >= 0; --a) n = n * extent(a) + (node[a] - lower[a]);
        return n;
    }
    void include(const Window& other) {
        for (int a = 0; a < D; ++a) {
            lower[a] = std::min(lower[a], other.lower[a]);
            upper[a] = std::max(upper[a], other.upper[a]);
        }
    }
    bool operator==(const Window&) const = default;
};

/// Calls visit(node) for the nodes of a window, x fastest.
template <int D, class Visit>
void for_each_node(const Window<D>& window, Visit&& visit) {
    Index<D> node = window.lower;
    for (;;) {
        visit(node);
        int a = 0;
        while (a < D && ++node[a] > window.upper[a]) {
            node[a] = window.lower[a];
            ++a;
        }
        if (a == D) return;
    }
}

/// The particles of one body in one block: consecutive in the particle store. All nodes that they see lie in `window`.
template <int D>
struct Tile {
    int block = 0; ///< number of the block at the last sort; particles may have drifted out of it since
    std::int32_t body = 0;
    std::int32_t field = 0;           ///< velocity field: the body with contact; all bodies share field 0 without
    std::int32_t first = 0, last = 0; ///< particles [first, last)
    Window<D> window;
    std::size_t slots = 0; ///< where this tile's slot table starts in VelocityFields::table
    bool contact = false;  ///< a node of the window sees two or more bodies
};

/// Tiles [first, last) of one block, in the order of bodies.
struct BlockTiles {
    int block = 0;
    std::int32_t first = 0, last = 0;
};

/// The particles' division into tiles and the colours in which threads may work on them.
template <int D>
struct Tiling {
    std::vector<Tile<D>> tiles;
    std::vector<BlockTiles> blocks;
    /// Blocks of one colour share no node, so that threads may add to the nodes of different blocks at once. Within a
    /// colour blocks are in ascending order; colours follow one another: sums are made in the same order whatever the
    /// number of threads.
    std::vector<std::vector<std::int32_t>> colours;
    int stride = 0; ///< blocks between two of one colour, per axis

    /// Blocks between two of one colour so that no two windows of a colour overlap.
    int needed_stride(const Grid<D>& grid) const;
    void make_colours(const Grid<D>& grid, int new_stride);
};

} // namespace abut
