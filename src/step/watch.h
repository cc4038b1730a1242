#pragma once
/// \file watch.h
/// The watch-dog: what no sound run does. Particles are checked in the loops that update them (update_particles.cpp),
/// the energy at every row of history.csv, at least every so many steps and at a run's end; what is looked for here
/// beyond that is looked for when a run has failed.

#include "step/run_error.h"

namespace abut {

/// Speed that no particle of a sound run reaches [m/s]: the scene's limit, or ten times the largest of the wave speed,
/// the particles' speeds at the start, the speeds of walls and velocity conditions, and what gravity gives a body that
/// falls through the whole grid. For a state at its start.
template <int D>
double speed_limit(const State<D>& state);

/// Steps between two looks at the energy at most: a sum over the particles, about a quarter of a step.
constexpr int energy_watch_steps = 50;

/// Looks at the energy balance. What a step does wrong shows as energy − initial energy − external work − contact work;
/// it falls where a method dissipates, and a sound run raises it by little: its rise from the lowest so far must stay
/// below LimitsSpec::energy_growth times all that the scene was given (EnergyWatch::given); with fmpm times its order
/// as well, since a load that sets in suddenly does more work at the edge of a body than the ledger's lumped nodes
/// tell. Motion at less than a millionth of the wave speed is round-off and counts as given. \param energy kinetic and
/// strain energy of the bodies that deform [J] \param mass theirs [kg] \throws RunError that names the fastest particle
template <int D>
void watch_energy(State<D>& state, double energy, double mass);

/// Throws RunError for a particle that the sweep over the particles has found to be wrong.
template <int D>
[[noreturn]] void throw_trouble_of(const State<D>& state, std::int32_t particle);

/// The particle with the fastest waves.
template <int D>
std::int32_t stiffest_particle(const State<D>& state);

} // namespace abut
