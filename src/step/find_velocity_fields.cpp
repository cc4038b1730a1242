#include "grid/parallel.h"
#include "particles/sort.h"
#include "shape/dispatch.h"
#include "step/run_error.h"
#include "step/tasks.h"

namespace abut {

namespace {

/// Finds the window of every tile. \return whether any has changed
template <int D>
bool find_windows(State<D>& state) {
    std::vector<Window<D>> previous(state.tiling.tiles.size());
    for (std::size_t t = 0; t < previous.size(); ++t) previous[t] = state.tiling.tiles[t].window;
    with_shape(state.scene.method.shape, [&](auto shape) {
        for_each_tile(state.tiling, [&](Tile<D>& tile) {
            tile.window = Window<D>::empty();
            for (std::int32_t p = tile.first; p < tile.last; ++p)
                tile.window.include(shape.window(state.grid, domain_of(state.particles, p)));
        });
    });
    for (std::size_t t = 0; t < previous.size(); ++t)
        if (!(previous[t] == state.tiling.tiles[t].window)) return true;
    return false;
}

template <int D>
void check_windows(const State<D>& state) {
    for (const Tile<D>& tile : state.tiling.tiles)
        for (int a = 0; a < D; ++a)
            if (tile.window.lower[a] < 0 || tile.window.upper[a] >= state.grid.blocks[a] * block_edge)
                throw RunError(describe_failure(state, tile.first,
                                                "the domain of a particle near this one reaches out of the grid"));
}

} // namespace

template <int D>
void find_velocity_fields(State<D>& state) {
    Tiling<D>& tiling = state.tiling;
    bool changed = !tiling.tiles.empty() && find_windows(state);
    if (tiling.tiles.empty() || tiling.needed_stride(state.grid) > tiling.stride) {
        // Particles have drifted so far that blocks of one colour would share nodes.
        tiling = sort_particles(state.particles, state.grid, state.effects.contact);
        find_windows(state);
        check_windows(state);
        tiling.make_colours(state.grid, tiling.needed_stride(state.grid));
        changed = true;
    }
    if (!changed) return;
    check_windows(state);
    number_slots(state.grid, tiling, state.fields);
}

template <int D>
void store_stencils(State<D>& state) {
    StencilStore<D>& store = state.stencil_store;
    with_shape(state.scene.method.shape, [&](auto shape) {
        using Shape = decltype(shape);
        constexpr int most = Shape::template max_nodes<D>;
        store.first.assign(state.particles.size() + 1, 0);
        for_each_tile(state.tiling, [&](const Tile<D>& tile) {
            for (std::int32_t p = tile.first; p < tile.last; ++p)
                store.first[p + 1] = std::min(most, Shape::window(state.grid, domain_of(state.particles, p)).size());
        });
        for (std::size_t p = 0; p < state.particles.size(); ++p) store.first[p + 1] += store.first[p];
        const std::size_t entries = store.first.back();
        store.slot.resize(entries);
        store.S.resize(entries);
        for (auto& component : store.G) component.resize(entries);
        for_each_tile(state.tiling, [&](const Tile<D>& tile) {
            const std::int32_t* const table = state.fields.table.data() + tile.slots;
            Stencil<D, most> s;
            for (std::int32_t p = tile.first; p < tile.last; ++p) {
                Shape::expand(state.grid, domain_of(state.particles, p), tile.window, s);
                std::size_t entry = store.first[p];
                for (int k = 0; k < s.count; ++k, ++entry) {
                    store.slot[entry] = table[s.node[k]];
                    store.S[entry] = s.S[k];
                    for (int a = 0; a < D; ++a) store.G[a][entry] = s.G[a][k];
                }
            }
        });
    });
}

template void find_velocity_fields<2>(State<2>&);
template void store_stencils<2>(State<2>&);

} // namespace abut
