#pragma once
#include "io/checkpoint/checkpoint.h"

#include <chrono>
#include <filesystem>
#include <string>

namespace abut {

/// What a run is resumed from.
struct Resumption {
    std::filesystem::path file;
    CheckpointHead head;
    OutputProgress output; ///< where the output was
    /// Why it is not the newest checkpoint, which cannot be read; empty: it is.
    std::string problem;
};

/// The checkpoints of a run under way.
class Checkpoints {
public:
    /// \param resolved_scene, checksum as write_checkpoint() takes them
    Checkpoints(const std::filesystem::path& folder, std::string resolved_scene, std::uint64_t checksum,
                const OutputSpec& output);

    /// Whether one is due at the present state.
    template <int D>
    bool due(const State<D>& state);
    /// Whether one can be written: the scene wants them, and the last is of another step.
    template <int D>
    bool lacks(const State<D>& state) const {
        return wanted_ && state.step != last_step_;
    }
    /// Writes one, if lacks().
    template <int D>
    void write(const State<D>& state, const OutputProgress& output);
    /// Where the run stands again after it has gone back in time: at a state of which another one may be written.
    template <int D>
    void go_back(const State<D>& state);
    /// A run that is resumed has one.
    void found(const Resumption& from);
    /// "results/checkpoint.h5 (step 200, 2.1e-06 s)", the last one written; empty if there is none.
    const std::string& last() const { return last_; }

private:
    using Clock = std::chrono::steady_clock;

    std::filesystem::path file_;
    std::string resolved_scene_;
    std::uint64_t checksum_;
    bool wanted_;
    double every_;      ///< of the simulation [s]; 0: not by it
    long every_steps_;  ///< 0: not by steps
    double every_wall_; ///< [s]
    double last_time_ = 0;
    long last_step_ = -1;
    std::string last_; ///< described
    Clock::time_point last_wall_ = Clock::now();
};

/// Brings a new state to where the newest checkpoint of a result folder was, or to the one before if the newest cannot
/// be read, for a scene and a model that are the same as then. \throws UsageError that says what is missing or has
/// changed
template <int D>
Resumption resume_state(const std::filesystem::path& folder, const std::string& resolved_scene, std::uint64_t checksum,
                        State<D>& state);

} // namespace abut
