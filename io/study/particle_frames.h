#pragma once
#include "io/results/pvd.h"
#include "io/study/study.h"
#include "results/frame.h"

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace abut {

/// The frames of particles of a run.
PvdSeries particle_series(const std::filesystem::path& folder);

/// The entry nearest to a time; the last if none is given. Throws NoValue if there is none.
const PvdEntry& frame_at(const PvdSeries& series, std::optional<double> time);

/// Reads a frame of a series.
PointFrame read_frame(const PvdSeries& series, const PvdEntry& entry, const std::vector<std::string>& wanted);

/// A measure of single frames, made of all of them as `reduction` says, or that of the last or the one nearest to `at`.
double over_frames(const std::filesystem::path& folder, Reduction reduction, std::optional<double> at,
                   const std::vector<std::string>& wanted, const std::function<double(const PointFrame&)>& measure);

/// The array of that name; throws std::runtime_error if the frame has none.
const Array& array_of(const PointFrame& frame, const std::string& name);

/// One component of an array as numbers.
std::vector<double> component_of(const Array& array, int component);

/// Numbers of the particles of these bodies; of all if no names are given.
std::vector<std::size_t> particles_of(const PointFrame& frame, const std::vector<std::string>& bodies);

/// A number that an expression on particles may use.
struct ParticleVariable {
    std::string name;  ///< in the expression
    std::string array; ///< "" for X, Y, Z, x, y, z and t
    int component = 0; ///< of the array, or of the position
};

/// X, Y, Z (undeformed) and x, y, z (present) [m], t [s] and the components of all arrays (results/arrays.h):
/// "pressure", "velocity_x", "stress_xy", "deformation_gradient_yx".
std::vector<ParticleVariable> particle_variables(bool temperature, bool orientation);

} // namespace abut
