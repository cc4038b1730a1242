#include "step/tasks.h"

namespace abut {

namespace {

/// The mean force on a face over a step [N].
template <int D>
Vec<D> face_force(const TractionSpec& traction, const DeformedFace<D>& face, double time, double dt) {
    const auto mean = [&](const TimeFunction& f) {
        return f.is_constant() ? f.value[0] : (f.integral(time + dt) - f.integral(time)) / dt;
    };
    Vec<D> stress = -mean(traction.pressure) * face.outward;
    for (int a = 0; a < D; ++a) stress[a] += mean(traction.traction[a]);
    return face.area * stress;
}

/// Adds the force on a face to the nodes that its points see. What would go to nodes without mass is shared among the
/// others, so that all of the force arrives (notes 2.5).
template <class Shape, int D>
void spread(State<D>& state, const TractionFace& face, const ShapedFace<D>& shaped, const Vec<D>& force) {
    struct Entry {
        std::int32_t slot;
        double weight;
    };
    using Function = typename Shape::GridFunction;
    std::vector<Entry> entries;
    const Tile<D>& tile = state.tiling.tiles[face.tile];
    const std::int32_t* const table = state.fields.table.data() + tile.slots;
    double total = 0;
    const auto add = [&](const Vec<D>& point, double share) {
        const Vec<D> x = state.grid.lattice_position(point);
        for_each_node(point_window<Function>(state.grid, point), [&](const Index<D>& node) {
            const std::int32_t slot = table[tile.window.local(node)];
            double weight = share;
            for (int a = 0; a < D; ++a) weight *= Function::value(x[a] - node[a]);
            if (!(state.nodes.momentum[slot][0] > 0) || weight == 0) return;
            entries.push_back({slot, weight});
            total += weight;
        });
    };
    for (int q = 0; q < shaped.count; ++q) add(shaped.points[q].position, shaped.points[q].share);
    // Shapes that don't deform may leave all nodes of a far stretched face without mass.
    if (entries.empty()) add(state.particles.position[face.particle], 1);
    for (const Entry& entry : entries) {
        const Pack f = pack<D>(0, force * (entry.weight / total));
        state.nodes.traction[entry.slot] += f;
        state.nodes.force[entry.slot] += f;
    }
}

} // namespace

template <int D>
void apply_tractions(State<D>& state) {
    state.nodes.traction.assign(state.fields.size(), Pack{});
    with_shape(state.scene.method.shape, [&](auto shape) {
        for (std::size_t f = 0; f < state.traction_faces.size(); ++f) {
            const TractionFace& face = state.traction_faces[f];
            const ShapedFace<D>& shaped = state.shaped_faces[f];
            Boundary& boundary = state.boundaries[face.boundary];
            const Vec<D> force =
                face_force(std::get<TractionSpec>(boundary.condition), shaped.deformed, state.time, state.dt);
            if (force.isZero(0)) continue;
            spread<decltype(shape)>(state, face, shaped, force);
            for (int a = 0; a < D; ++a) boundary.impulse[a] += force[a] * state.dt;
        }
    });
}

template void apply_tractions<2>(State<2>&);
template void apply_tractions<3>(State<3>&);

} // namespace abut
