#include "boundary/rigid_body.h"

#include "grid/parallel.h"
#include "step/run_error.h"

namespace abut {

template <int D>
std::vector<RigidPose> rigid_poses(const State<D>& state, double time) {
    std::vector<RigidPose> poses(state.bodies.size());
    for (std::size_t b = 0; b < poses.size(); ++b)
        if (state.bodies[b].rigid) poses[b] = rigid_pose(*state.bodies[b].rigid, time);
    return poses;
}

template <int D>
void set_rigid_velocities(const State<D>& state, const std::vector<RigidPose>& poses, std::vector<Pack>& velocity) {
    const auto n = static_cast<std::ptrdiff_t>(state.fields.blocks.size());
#pragma omp parallel for schedule(dynamic, 16)
    for (std::ptrdiff_t b = 0; b < n; ++b) {
        const auto& block = state.fields.blocks[b];
        for (std::size_t local = 0; local < nodes_per_block<D>; ++local)
            for (std::int32_t slot = block.first_slot[local]; slot < block.first_slot[local + 1]; ++slot) {
                const std::int32_t body = state.fields.field[slot];
                if (!is_rigid(state, body)) continue;
                const Vec<D> x = state.grid.node_position(block.node(static_cast<int>(local)));
                velocity[slot] = pack<D>(velocity[slot][0], to_vec<D>(poses[body].velocity_at(to_array<D>(x))));
            }
    }
}

template <int D>
void move_rigid_bodies(State<D>& state) {
    Particles<D>& particles = state.particles;
    const std::vector<RigidPose>& before = state.poses;
    const std::vector<RigidPose> after = rigid_poses(state, state.time + state.dt);
    std::vector<std::int32_t> outside(state.tiling.tiles.size(), -1);
    for_each_tile(state.tiling, [&](const Tile<D>& tile) {
        if (!is_rigid(state, tile.body)) return;
        const RigidPose& pose = after[tile.body];
        const Mat<3> turn = pose.rotation * before[tile.body].rotation.transpose();
        const Mat<D> turn_here = turn.template topLeftCorner<D, D>();
        const bool turns = !state.bodies[tile.body].rigid->angular_velocity.is_zero();
        std::int32_t& first = outside[&tile - state.tiling.tiles.data()];
        for (std::int32_t p = tile.first; p < tile.last; ++p) {
            const Vector x = pose.position_of(to_array<D>(state.initial_position[particles.id[p]]));
            particles.position[p] = to_vec<D>(x);
            particles.velocity[p] = to_vec<D>(pose.velocity_at(x));
            if (turns) particles.deformation_gradient[p] = turn_here * particles.deformation_gradient[p];
            if (first < 0 && !state.grid.contains(particles.position[p])) first = p;
        }
    });
    for (const std::int32_t p : outside)
        if (p >= 0) throw run_error(Trouble::rigid_left_grid, state, p, "the rigid body left the grid");
}

template std::vector<RigidPose> rigid_poses<2>(const State<2>&, double);
template std::vector<RigidPose> rigid_poses<3>(const State<3>&, double);
template void set_rigid_velocities<2>(const State<2>&, const std::vector<RigidPose>&, std::vector<Pack>&);
template void set_rigid_velocities<3>(const State<3>&, const std::vector<RigidPose>&, std::vector<Pack>&);
template void move_rigid_bodies<2>(State<2>&);
template void move_rigid_bodies<3>(State<3>&);

} // namespace abut
