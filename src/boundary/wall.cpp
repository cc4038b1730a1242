#include "boundary/wall.h"

namespace abut {

template <int D>
void find_controlled(Wall<D>& wall, const Grid<D>& grid, const VelocityFields<D>& fields, double time) {
    wall.controlled.clear();
    const int axis = wall.spec.axis;
    const double position = wall.position(time);
    const double direction = wall.spec.side == Side::lower ? 1.0 : -1.0; // into the material
    // A node exactly `depth` cells inside the wall is controlled: round-off must not decide.
    const double reach = (wall.spec.depth + 1e-9) * grid.cell[axis];
    const auto controls = [&](int node) {
        return (grid.origin[axis] + node * grid.cell[axis] - position) * direction <= reach;
    };
    int stride = 1;
    for (int a = 0; a < axis; ++a) stride *= block_edge;
    for (const auto& block : fields.blocks) {
        const int first = block.first_node[axis];
        if (!controls(first) && !controls(first + block_edge - 1)) continue;
        for (std::size_t local = 0; local < nodes_per_block<D>; ++local) {
            const int node = first + static_cast<int>(local) / stride % block_edge;
            if (!controls(node)) continue;
            const double distance = grid.origin[axis] + node * grid.cell[axis] - position;
            for (std::int32_t slot = block.first_slot[local]; slot < block.first_slot[local + 1]; ++slot)
                wall.controlled.push_back({slot, wall.spec.velocity + wall.spec.gradient * distance, 0});
        }
    }
}

template <int D>
void impose(Wall<D>& wall, std::vector<Pack>& velocity) {
    const int lane = wall.spec.axis + 1;
    const double direction = wall.spec.side == Side::lower ? 1.0 : -1.0;
    for (auto& node : wall.controlled) {
        Pack& v = velocity[node.slot];
        const double change = node.velocity - v[lane];
        if (!wall.spec.grip && change * direction < 0) continue; // leaves the wall
        node.impulse += v[0] * change;
        v[lane] = node.velocity;
    }
}

template <int D>
double settle(Wall<D>& wall) {
    double work = 0;
    for (auto& node : wall.controlled) {
        wall.impulse += node.impulse;
        work += node.impulse * node.velocity;
        node.impulse = 0;
    }
    return work;
}

template void find_controlled<2>(Wall<2>&, const Grid<2>&, const VelocityFields<2>&, double);
template void impose<2>(Wall<2>&, std::vector<Pack>&);
template double settle<2>(Wall<2>&);

} // namespace abut
