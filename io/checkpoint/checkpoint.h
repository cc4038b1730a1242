#pragma once
/// \file checkpoint.h
/// All that a run needs to go on as if it had not been interrupted, bit for bit, as an HDF5 file.
///
/// What follows from the scene alone is not saved: it is made anew, and a checksum of the model tells whether it is the
/// same. Particles are saved in the order of the store, with its tiles, since sums are made in that order.

#include "step/state.h"

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace abut {

/// Where one series of result files is.
struct SeriesProgress {
    std::int64_t frames = 0; ///< written so far
    double last_time = -1;   ///< of the last of them [s]
    double every = 0;        ///< between two [s]
    double next = 0;         ///< time of the next [s]
};

/// Where the output of a run is.
struct OutputProgress {
    std::array<SeriesProgress, 3> series; ///< particles, grid, contact
    double history_every = 0;             ///< between two rows of the tables [s]
    double history_next = 0;              ///< time of the next row [s]
    double history_last = 0;              ///< time of the last row [s]
    std::array<std::int64_t, 3> bytes{};  ///< of history.csv, bodies.csv, pairs.csv
};

/// A checksum of the particles as the scene makes them, with their bodies' names.
std::uint64_t model_checksum(const Model& model);

/// Writes `path`, which appears complete or not at all; the file that was there becomes `previous_checkpoint(path)`.
/// \param resolved_scene as in scene.json
/// Throws std::runtime_error naming file and cause.
template <int D>
void write_checkpoint(const std::filesystem::path& path, const State<D>& state, const OutputProgress& output,
                      const std::string& resolved_scene, std::uint64_t checksum);

/// DIR/checkpoint-previous.h5 of DIR/checkpoint.h5.
std::filesystem::path previous_checkpoint(const std::filesystem::path& path);

/// What stands in a checkpoint beside the state; read before anything else.
struct CheckpointHead {
    std::string resolved_scene;
    std::uint64_t checksum = 0;
    std::int64_t step = 0;
    double time = 0; ///< [s]
};
/// Throws std::runtime_error naming the file if it is missing, broken or of another version.
CheckpointHead read_checkpoint_head(const std::filesystem::path& path);

/// Brings a state that make_state() made from the same scene to where the checkpoint was. All values are checked
/// before the state is touched. Throws std::runtime_error naming file, array and cause.
template <int D>
OutputProgress read_checkpoint(const std::filesystem::path& path, State<D>& state);

} // namespace abut
