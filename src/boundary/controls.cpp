#include "boundary/boundary.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace abut {

namespace {

/// Calls visit(node, slot) for all slots of the blocks that are `wanted`.
template <int D, class Wanted, class Visit>
void for_each_slot(const VelocityFields<D>& fields, Wanted&& wanted, Visit&& visit) {
    for (const auto& block : fields.blocks) {
        if (!wanted(block)) continue;
        for (std::size_t local = 0; local < nodes_per_block<D>; ++local) {
            if (block.first_slot[local] == block.first_slot[local + 1]) continue;
            const Index<D> node = block.node(static_cast<int>(local));
            for (std::int32_t slot = block.first_slot[local]; slot < block.first_slot[local + 1]; ++slot)
                visit(node, slot);
        }
    }
}

/// The same for all blocks with nodes from layer `first` to layer `last` along an axis.
template <int D, class Visit>
void for_each_slot_between(const VelocityFields<D>& fields, int axis, int first, int last, Visit&& visit) {
    const auto wanted = [&](const auto& block) {
        return block.first_node[axis] <= last && block.first_node[axis] + block_edge > first;
    };
    for_each_slot(fields, wanted, visit);
}

/// A wall at one moment.
template <int D>
struct Place {
    int axis;
    double position;
    double inward; ///< 1 or -1: direction into the material
    double reach;  ///< [m]
    const Grid<D>& grid;

    /// Distance of a layer of nodes from the wall into the material [m].
    double depth_of(int layer) const { return (grid.origin[axis] + layer * grid.cell[axis] - position) * inward; }
    bool controls(int layer) const { return depth_of(layer) <= reach; }
    /// The innermost layer that the wall controls.
    int last_controlled() const {
        const double inner = (position + inward * reach - grid.origin[axis]) * grid.inverse_cell[axis];
        int layer = static_cast<int>(inward > 0 ? std::floor(inner) : std::ceil(inner));
        if (controls(layer + static_cast<int>(inward))) layer += static_cast<int>(inward); // round-off
        return layer;
    }
};

/// Place of a node along the wall, and its velocity field, as one number.
template <int D>
std::uint64_t line_of(const Index<D>& node, int axis, std::int32_t field) {
    auto key = static_cast<std::uint64_t>(field);
    for (int a = 0; a < D; ++a)
        if (a != axis) key = key * 1'000'003U + static_cast<std::uint64_t>(node[a]);
    return key;
}

/// Gradients of FMPM paper Eq. (4), for each line of nodes across the wall: a least-squares line through the wall's
/// velocity at the wall and the extrapolated velocities of the last uncontrolled and the first controlled node inside
/// the material. Lines without such nodes have none.
template <int D>
std::unordered_map<std::uint64_t, double> estimate_gradients(const Place<D>& wall, const VelocityFields<D>& fields,
                                                             const std::vector<Pack>& velocity, double wall_velocity) {
    struct Sums {
        double products = 0;
        double squares = 0;
        bool inside = false; ///< the uncontrolled node has mass
    };
    std::unordered_map<std::uint64_t, Sums> sums;
    const int controlled = wall.last_controlled();
    const int uncontrolled = controlled + static_cast<int>(wall.inward);
    const auto [first, last] = std::minmax(controlled, uncontrolled);
    for_each_slot_between(fields, wall.axis, first, last, [&](const Index<D>& node, std::int32_t slot) {
        const int layer = node[wall.axis];
        if (layer != uncontrolled && !(layer == controlled && wall.depth_of(layer) > 0)) return;
        if (!(velocity[slot][0] > 0)) return;
        const double dx = wall.depth_of(layer) * wall.inward;
        const double dv = velocity[slot][wall.axis + 1] - wall_velocity;
        Sums& line = sums[line_of<D>(node, wall.axis, fields.field[slot])];
        line.products += dv * dx;
        line.squares += dx * dx;
        line.inside |= layer == uncontrolled;
    });
    std::unordered_map<std::uint64_t, double> gradients;
    const double shortest = 0.25 * wall.grid.cell[wall.axis]; // nearer to the wall, velocities tell no slope
    for (const auto& [line, s] : sums)
        if (s.inside && s.squares > shortest * shortest)
            gradients[line] = s.products / s.squares; // one node close to the wall would tell nothing
    return gradients;
}

} // namespace

template <int D>
void control_wall(const WallSpec& wall, std::int32_t boundary, const Grid<D>& grid, const VelocityFields<D>& fields,
                  const std::vector<Pack>& velocity, double time, double dt, std::vector<Control>& controls) {
    const int axis = wall.axis;
    // A node exactly `depth` cells inside the wall is controlled: round-off must not decide.
    const Place<D> place{axis, wall_position(wall, time), wall.side == Side::lower ? 1.0 : -1.0,
                         (wall.depth + 1e-9) * grid.cell[axis], grid};
    const double wall_velocity = wall.velocity.at(time + dt);
    const double gradient = wall.gradient.at(time);
    std::unordered_map<std::uint64_t, double> estimates;
    if (wall.estimated_gradient) estimates = estimate_gradients(place, fields, velocity, wall.velocity.at(time));
    const auto gradient_at = [&](const Index<D>& node, std::int32_t slot) {
        if (!wall.estimated_gradient) return gradient;
        const auto found = estimates.find(line_of<D>(node, axis, fields.field[slot]));
        return found == estimates.end() ? 0.0 : found->second;
    };
    Pack direction{};
    direction[axis + 1] = 1;
    const auto near = [&](const auto& block) {
        const int first = block.first_node[axis];
        return place.controls(first) || place.controls(first + block_edge - 1);
    };
    for_each_slot(fields, near, [&](const Index<D>& node, std::int32_t slot) {
        if (!place.controls(node[axis])) return;
        const double distance = place.depth_of(node[axis]) * place.inward;
        controls.push_back({slot, boundary, direction, wall_velocity + gradient_at(node, slot) * distance,
                            wall.grip ? 0.0 : place.inward, false, -1, 0});
    });
}

template <int D>
Window<D> nodes_in(const VelocitySpec& condition, const Grid<D>& grid) {
    constexpr double slack = 1e-9; // [cells]: a node on the box's edge is in it
    Window<D> box;
    for (int a = 0; a < D; ++a) {
        box.lower[a] =
            static_cast<int>(std::ceil((condition.lower[a] - grid.origin[a]) * grid.inverse_cell[a] - slack));
        box.upper[a] =
            static_cast<int>(std::floor((condition.upper[a] - grid.origin[a]) * grid.inverse_cell[a] + slack));
    }
    return box;
}

template <int D>
void control_box(const VelocitySpec& condition, std::int32_t boundary, const Grid<D>& grid,
                 const VelocityFields<D>& fields, double time, double dt, std::vector<Control>& controls) {
    const Window<D> box = nodes_in(condition, grid);
    const Pack direction = pack<D>(0, to_vec<D>(condition.direction).normalized());
    const double velocity = condition.velocity.at(time + dt);
    for_each_slot_between(fields, 0, box.lower[0], box.upper[0], [&](const Index<D>& node, std::int32_t slot) {
        for (int a = 0; a < D; ++a)
            if (node[a] < box.lower[a] || node[a] > box.upper[a]) return;
        controls.push_back({slot, boundary, direction, velocity, 0, true, -1, 0});
    });
}

void control_axis(const Grid<2>& grid, const VelocityFields<2>& fields, std::vector<Control>& controls) {
    const double axis = -grid.origin[0] * grid.inverse_cell[0];
    const int middle = static_cast<int>(std::lround(axis));
    if (std::abs(grid.lower()[0]) > 1e-9 * grid.cell[0]) return; // the grid begins beyond the reach of the axis
    std::unordered_map<std::uint64_t, std::int32_t> inside;
    constexpr int most_beyond = 2; // layers that a particle at the axis sees across it
    for_each_slot_between(fields, 0, middle + 1, middle + most_beyond, [&](const Index<2>& node, std::int32_t slot) {
        if (node[0] > middle && node[0] <= middle + most_beyond)
            inside[line_of<2>(node, 0, fields.field[slot]) * 8 + static_cast<std::uint64_t>(node[0] - middle)] = slot;
    });
    const Pack direction{0, 1, 0, 0};
    for_each_slot_between(fields, 0, 0, middle, [&](const Index<2>& node, std::int32_t slot) {
        if (node[0] > middle) return;
        Control control{slot, -1, direction, 0, 0, false, -1, 0};
        if (node[0] < middle) {
            const auto found =
                inside.find(line_of<2>(node, 0, fields.field[slot]) * 8 + static_cast<std::uint64_t>(middle - node[0]));
            if (found != inside.end()) control.mirror = found->second;
        }
        controls.push_back(control);
    });
}

template void control_wall<2>(const WallSpec&, std::int32_t, const Grid<2>&, const VelocityFields<2>&,
                              const std::vector<Pack>&, double, double, std::vector<Control>&);
template void control_wall<3>(const WallSpec&, std::int32_t, const Grid<3>&, const VelocityFields<3>&,
                              const std::vector<Pack>&, double, double, std::vector<Control>&);
template Window<2> nodes_in<2>(const VelocitySpec&, const Grid<2>&);
template Window<3> nodes_in<3>(const VelocitySpec&, const Grid<3>&);
template void control_box<2>(const VelocitySpec&, std::int32_t, const Grid<2>&, const VelocityFields<2>&, double,
                             double, std::vector<Control>&);
template void control_box<3>(const VelocitySpec&, std::int32_t, const Grid<3>&, const VelocityFields<3>&, double,
                             double, std::vector<Control>&);

} // namespace abut
