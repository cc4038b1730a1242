#pragma once
#include "grid/velocity_fields.h"
#include "shape/dispatch.h"

#include <vector>

namespace abut {

/// The slots that one particle adds to or reads, with shape functions and gradients; what every kernel loops over.
template <int D>
struct StencilView {
    int count;
    const std::int32_t* slot;
    const double* S;
    const double* G[D];
};

/// Stencils of all particles, made once a step, for shapes whose expansion costs more than reading it back (CPDI).
template <int D>
struct StencilStore {
    std::vector<std::size_t> first; ///< of each particle's entries; one more at the end
    std::vector<std::int32_t> slot;
    std::vector<double> S;
    std::vector<double> G[D];
};

/// Gives one particle's stencil to a kernel: from the store for stored shapes, else expanded on the spot.
template <int D, class Shape>
class StencilSource {
public:
    StencilSource(const Grid<D>& grid, const Particles<D>& particles, const VelocityFields<D>& fields,
                  const StencilStore<D>& store, const Tile<D>& tile)
        : grid_(grid), particles_(particles), store_(store), tile_(tile), table_(fields.table.data() + tile.slots) {}

    StencilView<D> of(std::int32_t p) {
        StencilView<D> view{};
        if constexpr (Shape::stored) {
            const std::size_t first = store_.first[p];
            view.count = static_cast<int>(store_.first[p + 1] - first);
            view.slot = store_.slot.data() + first;
            view.S = store_.S.data() + first;
            for (int a = 0; a < D; ++a) view.G[a] = store_.G[a].data() + first;
        } else {
            Shape::expand(grid_, domain_of(particles_, p), tile_.window, stencil_);
            for (int k = 0; k < Shape::template max_nodes<D>; ++k) slot_[k] = table_[stencil_.node[k]];
            view.count = Shape::template max_nodes<D>;
            view.slot = slot_;
            view.S = stencil_.S;
            for (int a = 0; a < D; ++a) view.G[a] = stencil_.G[a];
        }
        return view;
    }

private:
    const Grid<D>& grid_;
    const Particles<D>& particles_;
    const StencilStore<D>& store_;
    const Tile<D>& tile_;
    const std::int32_t* table_;
    Stencil<D, Shape::template max_nodes<D>> stencil_;
    std::int32_t slot_[Shape::template max_nodes<D>];
};

} // namespace abut
