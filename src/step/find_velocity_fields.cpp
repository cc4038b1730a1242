#include "grid/parallel.h"
#include "particles/sort.h"
#include "shape/dispatch.h"
#include "step/run_error.h"
#include "step/tasks.h"

namespace abut {

namespace {

template <class Shape, int D>
ShapedFace<D> face_of(const State<D>& state, const TractionFace& face) {
    ShapedFace<D> result;
    const bool ring = state.effects.ring;
    result.deformed =
        deformed_face(state.particles, face.particle, face.axis, face.outward, ring, state.scene.thickness);
    if constexpr (Shape::face_rule == FaceRule::simpson)
        fit_to_box<D>(result.deformed, state.particles.position[face.particle],
                      Shape::box(domain_of(state.particles, face.particle)));
    result.count = face_points(result.deformed, Shape::face_rule, ring, result.points);
    return result;
}

/// Finds the faces with tractions, which may see nodes that their particles don't.
template <int D>
void include_traction_faces(State<D>& state) {
    if (state.traction_faces.empty()) return;
    state.shaped_faces.clear();
    with_shape(state.scene.method.shape, [&](auto shape) {
        using Shape = decltype(shape);
        for (const TractionFace& face : state.traction_faces) {
            const ShapedFace<D> shaped = face_of<Shape>(state, face);
            for (int q = 0; q < shaped.count; ++q)
                state.tiling.tiles[face.tile].window.include(
                    point_window<typename Shape::GridFunction>(state.grid, shaped.points[q].position));
            state.shaped_faces.push_back(shaped);
        }
    });
}

/// Finds the window of every tile. \return whether any has changed
template <int D>
bool find_windows(State<D>& state) {
    std::vector<Window<D>> previous(state.tiling.tiles.size());
    for (std::size_t t = 0; t < previous.size(); ++t) previous[t] = state.tiling.tiles[t].window;
    const bool stored = state.effects.stored_stencils;
    if (stored) state.stencil_store.window.resize(state.particles.size());
    with_shape(state.scene.method.shape, [&](auto shape) {
        for_each_tile(state.tiling, [&](Tile<D>& tile) {
            tile.window = Window<D>::empty();
            for (std::int32_t p = tile.first; p < tile.last; ++p) {
                const Window<D> window = shape.window(state.grid, domain_of(state.particles, p));
                tile.window.include(window);
                if (stored) state.stencil_store.window[p] = window;
            }
        });
    });
    include_traction_faces(state);
    for (std::size_t t = 0; t < previous.size(); ++t)
        if (!(previous[t] == state.tiling.tiles[t].window)) return true;
    return false;
}

/// The particle of a tile that sees the most nodes along an axis among those that see beyond the grid's blocks, or
/// among all.
template <int D>
std::int32_t widest_particle(const State<D>& state, const Tile<D>& tile, int axis, bool beyond) {
    std::int32_t widest = tile.first;
    int most = 0;
    with_shape(state.scene.method.shape, [&](auto shape) {
        for (std::int32_t p = tile.first; p < tile.last; ++p) {
            const Window<D> window = shape.window(state.grid, domain_of(state.particles, p));
            const bool inside = window.lower[axis] >= 0 && window.upper[axis] < state.grid.blocks[axis] * block_edge;
            if ((beyond && inside) || window.extent(axis) <= most) continue;
            widest = p;
            most = window.extent(axis);
        }
    });
    return widest;
}

template <int D>
void check_windows(const State<D>& state) {
    for (const Tile<D>& tile : state.tiling.tiles)
        for (int a = 0; a < D; ++a)
            if (tile.window.lower[a] < 0 || tile.window.upper[a] >= state.grid.blocks[a] * block_edge)
                throw run_error(Trouble::domain_left_grid, state, widest_particle(state, tile, a, true),
                                "the particle's domain reaches out of the grid");
    for (const Tile<D>& tile : state.tiling.tiles)
        for (int a = 0; a < D; ++a)
            if (tile.window.extent(a) > most_axis_nodes)
                throw run_error(Trouble::stretched, state, widest_particle(state, tile, a, false),
                                "the particle is stretched over dozens of cells");
}

} // namespace

template <int D>
void find_traction_particles(State<D>& state) {
    if (state.traction_faces.empty()) return;
    std::vector<std::int32_t> index(state.particles.size());
    std::vector<std::int32_t> tile_of(state.particles.size());
    for (std::size_t t = 0; t < state.tiling.tiles.size(); ++t)
        for (std::int32_t p = state.tiling.tiles[t].first; p < state.tiling.tiles[t].last; ++p) {
            index[state.particles.id[p]] = p;
            tile_of[p] = static_cast<std::int32_t>(t);
        }
    for (TractionFace& face : state.traction_faces) {
        face.particle = index[face.id];
        face.tile = tile_of[face.particle];
    }
}

template <int D>
void find_velocity_fields(State<D>& state) {
    Tiling<D>& tiling = state.tiling;
    bool changed = !tiling.tiles.empty() && find_windows(state);
    if (tiling.tiles.empty() || tiling.needed_stride(state.grid) > tiling.stride) {
        // Particles have drifted so far that blocks of one colour would share nodes.
        tiling = sort_particles(state.particles, state.grid, state.effects.contact);
        find_traction_particles(state);
        find_windows(state);
        check_windows(state);
        tiling.make_colours(state.grid, tiling.needed_stride(state.grid));
        changed = true;
    }
    if (!changed) return;
    check_windows(state);
    number_slots(state.grid, tiling, state.fields);
}

namespace {

template <int D, bool Ring>
void store_all_stencils(State<D>& state) {
    StencilStore<D>& store = state.stencil_store;
    with_shape(state.scene.method.shape, [&](auto shape) {
        using Shape = decltype(shape);
        store.first.assign(state.particles.size() + 1, 0);
        for_each_tile(state.tiling, [&](const Tile<D>& tile) {
            for (std::int32_t p = tile.first; p < tile.last; ++p) store.first[p + 1] = Shape::count(store.window[p]);
        });
        for (std::size_t p = 0; p < state.particles.size(); ++p) store.first[p + 1] += store.first[p];
        const std::size_t entries = store.first.back();
        store.slot.resize(entries);
        store.S.resize(entries);
        for (auto& component : store.G) component.resize(entries);
        if constexpr (Ring) store.T.resize(entries);
        for_each_tile(state.tiling, [&](const Tile<D>& tile) {
            const std::int32_t* const table = state.fields.table.data() + tile.slots;
            for (std::int32_t p = tile.first; p < tile.last; ++p) {
                const std::size_t first = store.first[p];
                StencilEntries<D> s{store.slot.data() + first, store.S.data() + first, {}, nullptr};
                for (int a = 0; a < D; ++a) s.G[a] = store.G[a].data() + first;
                const Domain<D> domain = domain_of(state.particles, p);
                if constexpr (Ring) s.T = store.T.data() + first;
                Shape::template fill<Ring>(state.grid, domain, store.window[p], tile.window, s);
                for (std::size_t entry = first; entry < store.first[p + 1]; ++entry)
                    store.slot[entry] = table[store.slot[entry]];
            }
        });
    });
}

} // namespace

template <int D>
void store_stencils(State<D>& state) {
    if constexpr (D == 2)
        if (state.effects.ring) return store_all_stencils<D, true>(state);
    store_all_stencils<D, false>(state);
}

template void find_traction_particles<2>(State<2>&);
template void find_traction_particles<3>(State<3>&);
template void find_velocity_fields<2>(State<2>&);
template void find_velocity_fields<3>(State<3>&);
template void store_stencils<2>(State<2>&);
template void store_stencils<3>(State<3>&);

} // namespace abut
