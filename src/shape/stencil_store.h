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
    const double* T; ///< hoop shape functions of rings [1/m], else null
};

/// Stencils of all particles, made once a step, for shapes whose expansion costs more than reading it back.
template <int D>
struct StencilStore {
    std::vector<Window<D>> window;  ///< of each particle's nodes, found with those of the tiles
    std::vector<std::size_t> first; ///< of each particle's entries; one more at the end
    std::vector<std::int32_t> slot;
    std::vector<double> S;
    std::vector<double> G[D];
    std::vector<double> T; ///< rings only
};

/// Gives one particle's stencil to a kernel: from the store for StoredStencils, else expanded on the spot.
template <int D, class Source>
class StencilSource;

template <int D, bool Ring>
class StencilSource<D, StoredStencils<Ring>> {
public:
    StencilSource(const Grid<D>&, const Particles<D>&, const VelocityFields<D>&, const StencilStore<D>& store,
                  const Tile<D>&)
        : store_(store) {}

    StencilView<D> of(std::int32_t p) const {
        StencilView<D> view{};
        const std::size_t first = store_.first[p];
        view.count = static_cast<int>(store_.first[p + 1] - first);
        view.slot = store_.slot.data() + first;
        view.S = store_.S.data() + first;
        for (int a = 0; a < D; ++a) view.G[a] = store_.G[a].data() + first;
        if constexpr (Ring) view.T = store_.T.data() + first;
        return view;
    }
    StencilView<D> values_of(std::int32_t p) const { return of(p); }

private:
    const StencilStore<D>& store_;
};

template <int D, class Shape>
class StencilSource<D, ExpandedStencils<Shape>> {
public:
    StencilSource(const Grid<D>& grid, const Particles<D>& particles, const VelocityFields<D>& fields,
                  const StencilStore<D>&, const Tile<D>& tile)
        : grid_(grid), particles_(particles), tile_(tile), table_(fields.table.data() + tile.slots) {}

    StencilView<D> of(std::int32_t p) {
        expand_product<D, Shape::axis_nodes>(factors_of<Shape>(grid_, domain_of(particles_, p)), tile_.window,
                                             stencil_);
        for (int k = 0; k < nodes; ++k) slot_[k] = table_[stencil_.node[k]];
        StencilView<D> view{};
        view.count = nodes;
        view.slot = slot_;
        view.S = stencil_.S;
        for (int a = 0; a < D; ++a) view.G[a] = stencil_.G[a];
        return view;
    }
    /// Shape functions only; the gradients of the view are not set.
    StencilView<D> values_of(std::int32_t p) {
        expand_values<D, Shape::axis_nodes>(factors_of<Shape>(grid_, domain_of(particles_, p)), tile_.window, table_,
                                            slot_, stencil_.S);
        StencilView<D> view{};
        view.count = nodes;
        view.slot = slot_;
        view.S = stencil_.S;
        return view;
    }

private:
    static constexpr int nodes = Shape::template max_nodes<D>;
    const Grid<D>& grid_;
    const Particles<D>& particles_;
    const Tile<D>& tile_;
    const std::int32_t* table_;
    Stencil<D, nodes> stencil_;
    std::int32_t slot_[nodes];
};

} // namespace abut
