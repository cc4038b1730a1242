#pragma once
#include "math/linear_algebra.h"
#include "scene/scene.h"

namespace abut {

constexpr int block_edge = 4; ///< cells along the edge of a block
/// Cells that are added around the scene's box, so that particles at its faces find all nodes they see.
constexpr int grid_margin = 4;

/// A point of the integer lattice of nodes, cells or blocks.
template <int D>
using Index = std::array<int, D>;

/// The background grid: a box of equal cells. Nodes are numbered per axis from 0 at `origin`, which lies `grid_margin`
/// cells outside the scene's box.
template <int D>
struct Grid {
    Vec<D> origin;       ///< position of node 0 [m]
    Vec<D> cell;         ///< [m]
    Vec<D> inverse_cell; ///< [1/m]
    Index<D> cells;      ///< of the scene's box
    Index<D> blocks;     ///< that cover box and margin

    double length() const { return cell.minCoeff(); } ///< the Δx of the papers [m]
    Vec<D> node_position(const Index<D>& node) const {
        Vec<D> x;
        for (int a = 0; a < D; ++a) x[a] = origin[a] + node[a] * cell[a];
        return x;
    }
    /// Position in units of cells from `origin`.
    Vec<D> lattice_position(const Vec<D>& x) const { return (x - origin).cwiseProduct(inverse_cell); }
    Vec<D> lower() const { return node_position(filled<D>(grid_margin)); }
    Vec<D> upper() const {
        Index<D> last;
        for (int a = 0; a < D; ++a) last[a] = grid_margin + cells[a];
        return node_position(last);
    }
    /// Whether a place lies in the box, or beyond a face by less than a cell: particles at a wall may pass it by a
    /// little. False for a place that is not a number.
    bool contains(const Vec<D>& x) const {
        const Vec<D> lattice = lattice_position(x);
        for (int a = 0; a < D; ++a)
            if (!(lattice[a] > grid_margin - 1 && lattice[a] < grid_margin + cells[a] + 1)) return false;
        return true;
    }
    int block_count() const {
        int n = 1;
        for (int count : blocks) n *= count;
        return n;
    }
    /// Number of a block, x fastest.
    int block_number(const Index<D>& block) const {
        int n = block[D - 1];
        for (int a = D - 2; a >= 0; --a) n = n * blocks[a] + block[a];
        return n;
    }
    Index<D> block_at(int number) const {
        Index<D> block;
        for (int a = 0; a < D; ++a) {
            block[a] = number % blocks[a];
            number /= blocks[a];
        }
        return block;
    }

private:
    template <int N>
    static Index<N> filled(int value) {
        Index<N> index;
        index.fill(value);
        return index;
    }
};

/// The grid of a scene: its box in the nearest whole number of cells per axis.
template <int D>
Grid<D> make_grid(const GridSpec& spec);

} // namespace abut
