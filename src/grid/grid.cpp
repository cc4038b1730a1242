#include "grid/grid.h"

#include "grid/effective_cell.h"

#include <cmath>

namespace abut {

template <int D>
Grid<D> make_grid(const GridSpec& spec) {
    Grid<D> grid;
    const Vector cell = effective_cell(spec);
    for (int a = 0; a < D; ++a) {
        grid.cell[a] = cell[a];
        grid.inverse_cell[a] = 1 / cell[a];
        grid.cells[a] = static_cast<int>(std::lround((spec.upper[a] - spec.lower[a]) / cell[a]));
        grid.origin[a] = spec.lower[a] - grid_margin * cell[a];
        grid.blocks[a] = (grid.cells[a] + 2 * grid_margin + 1 + block_edge - 1) / block_edge;
    }
    return grid;
}

template Grid<2> make_grid<2>(const GridSpec&);
template Grid<3> make_grid<3>(const GridSpec&);

} // namespace abut
