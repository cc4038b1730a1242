#pragma once
#include "boundary/rigid_motion.h"
#include "step/state.h"

namespace abut {

/// Whether a body moves as prescribed.
template <int D>
bool is_rigid(const State<D>& state, std::int32_t body) {
    return state.effects.rigid && state.bodies[body].rigid.has_value();
}

/// Poses at a time, by body; those of bodies that aren't rigid are not used.
template <int D>
std::vector<RigidPose> rigid_poses(const State<D>& state, double time);

/// Sets the velocities of the slots of rigid bodies to those of the bodies at the nodes: exactly, and not as the
/// particles' extrapolate. Masses stay what the particles give.
template <int D>
void set_rigid_velocities(const State<D>& state, const std::vector<RigidPose>& poses, std::vector<Pack>& velocity);

/// Moves the particles of rigid bodies to where they are at the end of the step.
template <int D>
void move_rigid_bodies(State<D>& state);

} // namespace abut
