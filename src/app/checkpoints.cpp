#include "app/checkpoints.h"

#include "app/commands.h"
#include "io/checkpoint/compare_scenes.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <utility>

namespace abut {

namespace {

const char* const file_name = "checkpoint.h5";

std::string described(const std::filesystem::path& file, std::int64_t step, double time) {
    return fmt::format("{} (step {}, {:g} s)", file.string(), step, time);
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
    if (!wanted_ || state.step == last_step_) return;
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

Resumption find_checkpoint(const std::filesystem::path& folder, const std::string& resolved_scene,
                           std::uint64_t checksum) {
    Resumption found;
    std::string problem;
    for (const std::filesystem::path& file : {folder / file_name, previous_checkpoint(folder / file_name)}) {
        if (!std::filesystem::exists(file)) continue;
        try {
            found = {file, read_checkpoint_head(file)};
            break;
        } catch (const std::runtime_error& error) {
            problem += (problem.empty() ? "" : "; ") + std::string(error.what());
        }
    }
    if (found.file.empty())
        throw UsageError(problem.empty() ? fmt::format("{}: no {} to resume from; without --resume the run starts anew",
                                                       folder.string(), file_name)
                                         : problem);
    const std::vector<std::string> changes = forbidden_changes(found.head.resolved_scene, resolved_scene);
    if (!changes.empty())
        throw UsageError(fmt::format("{}: the scene has changed since, and only `time/end`, `time/on_trouble`, "
                                     "`time/limits` and `output` may:\n  {}",
                                     found.file.string(), fmt::join(changes, "\n  ")));
    if (found.head.checksum != checksum)
        throw UsageError(fmt::format("{}: the scene gives other particles than then; has an image or another file that "
                                     "it names been changed?",
                                     found.file.string()));
    return found;
}

template bool Checkpoints::due<2>(const State<2>&);
template bool Checkpoints::due<3>(const State<3>&);
template void Checkpoints::go_back<2>(const State<2>&);
template void Checkpoints::go_back<3>(const State<3>&);
template void Checkpoints::write<2>(const State<2>&, const OutputProgress&);
template void Checkpoints::write<3>(const State<3>&, const OutputProgress&);

} // namespace abut
