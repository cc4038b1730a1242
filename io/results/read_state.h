#pragma once
/// \file read_state.h
/// The state of a run at one of its frames, from the files it left.

#include "results/frame.h"
#include "step/state.h"

#include <stdexcept>
#include <string>
#include <vector>

namespace abut {

/// A frame lacks what a state needs; what() says what and why.
class FrameError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// Arrays of the particles that read_state() needs.
const std::vector<std::string>& arrays_of_state();

/// The state that a frame of particles shows, for looking at its grid and its contacts (`look`): places, shapes,
/// masses, bodies and laws are those of the run, particles in the order of their ids. The bodies' shapes and images are
/// not read. Velocities and stresses are not restored, nor are tractions and impulses: the state is not for stepping.
/// \param scene of the result folder  \param frame of all particles, with arrays_of_state()
/// Throws FrameError.
template <int D>
State<D> read_state(Scene scene, const PointFrame& frame);

} // namespace abut
