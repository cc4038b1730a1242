#include "app/checkpoints.h"

#include "app/commands.h"
#include "io/checkpoint/compare_scenes.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace abut {

namespace {

const char* const file_name = "checkpoint.h5";

std::string described(const std::filesystem::path& file, std::int64_t step, double time) {
    return fmt::format("{} (step {}, {:g} s)", file.string(), step, time);
}

/// \throws UsageError that says what has changed
void check_same_scene(const std::filesystem::path& file, const CheckpointHead& head, const std::string& resolved_scene,
                      std::uint64_t checksum) {
    constexpr std::size_t most = 10;
    std::vector<std::string> changes = forbidden_changes(head.resolved_scene, resolved_scene);
    if (!changes.empty()) {
        const bool of_step = std::any_of(changes.begin(), changes.end(), [](const std::string& change) {
            return change.starts_with("/time/cfl:") || change.starts_with("/time/step:");
        });
        if (changes.size() > most) {
            const std::size_t more = changes.size() - most;
            changes.resize(most);
            changes.push_back(fmt::format("and {} more", more));
        }
        throw UsageError(fmt::format("{}: the scene has changed since, and only `time/end`, `time/on_trouble`, "
                                     "`time/limits`, `output` and where files lie may:\n  {}{}",
                                     file.string(), fmt::join(changes, "\n  "),
                                     of_step
                                         ? "\n  (--set /time/on_trouble=shrink-step halves the step of a resumed run "
                                           "where it must; another step needs a run of its own)"
                                         : ""));
    }
    if (head.checksum != checksum)
        throw UsageError(fmt::format("{}: the scene gives other particles than then; has an image or another file that "
                                     "it names been changed?",
                                     file.string()));
}

} // namespace

Checkpoints::Checkpoints(const std::filesystem::path& folder, std::string resolved_scene, std::uint64_t checksum,
                         const OutputSpec& output)
    : file_(folder / file_name), resolved_scene_(std::move(resolved_scene)), checksum_(checksum),
      wanted_(output.checkpoint), every_(output.checkpoint_every.value_or(0)),
      every_steps_(output.checkpoint_every_steps.value_or(0)), every_wall_(output.checkpoint_every_wall) {}

template <int D>
bool Checkpoints::due(const State<D>& state) {
    if (!wanted_) return false;
    if (every_steps_ > 0 && state.step % every_steps_ == 0) return true;
    if (every_ > 0 && std::floor(state.time / every_) > std::floor(last_time_ / every_)) return true;
    return std::chrono::duration<double>(Clock::now() - last_wall_).count() >= every_wall_;
}

template <int D>
void Checkpoints::write(const State<D>& state, const OutputProgress& output) {
    if (!lacks(state)) return;
    write_checkpoint(file_, state, output, resolved_scene_, checksum_);
    last_step_ = state.step;
    last_time_ = state.time;
    last_wall_ = Clock::now();
    last_ = described(file_, state.step, state.time);
}

template <int D>
void Checkpoints::go_back(const State<D>& state) {
    last_step_ = -1;
    last_time_ = state.time;
}

void Checkpoints::found(const Resumption& from) {
    last_ = described(from.file, from.head.step, from.head.time);
}

template <int D>
Resumption resume_state(const std::filesystem::path& folder, const std::string& resolved_scene, std::uint64_t checksum,
                        State<D>& state) {
    std::string problems;
    for (const std::filesystem::path& file : {folder / file_name, previous_checkpoint(folder / file_name)}) {
        if (!std::filesystem::exists(file)) continue;
        try {
            const CheckpointHead head = read_checkpoint_head(file);
            check_same_scene(file, head, resolved_scene, checksum);
            return {file, head, read_checkpoint(file, state), problems};
        } catch (const UsageError&) {
            throw;
        } catch (const std::runtime_error& error) {
            problems += (problems.empty() ? "" : "; ") + std::string(error.what());
        }
    }
    if (problems.empty())
        throw UsageError(
            fmt::format("{}: no {} to resume from; without --resume the run starts anew", folder.string(), file_name));
    throw UsageError(problems);
}

template bool Checkpoints::due<2>(const State<2>&);
template bool Checkpoints::due<3>(const State<3>&);
template void Checkpoints::go_back<2>(const State<2>&);
template void Checkpoints::go_back<3>(const State<3>&);
template void Checkpoints::write<2>(const State<2>&, const OutputProgress&);
template void Checkpoints::write<3>(const State<3>&, const OutputProgress&);
template Resumption resume_state<2>(const std::filesystem::path&, const std::string&, std::uint64_t, State<2>&);
template Resumption resume_state<3>(const std::filesystem::path&, const std::string&, std::uint64_t, State<3>&);

} // namespace abut
