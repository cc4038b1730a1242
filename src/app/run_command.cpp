#include "app/commands.h"
#include "app/run_files.h"
#include "app/schedule.h"
#include "geometry/build_model.h"
#include "io/results/progress.h"
#include "io/results/result_folder.h"
#include "io/results/si_prefix.h"
#include "io/scene/read_scene.h"
#include "io/scene/units.h"
#include "scene/input_files.h"
#include "step/run_error.h"

#include <fmt/format.h>
#include <omp.h>

#include <charconv>
#include <chrono>
#include <csignal>
#include <ctime>

namespace abut {

namespace {

volatile std::sig_atomic_t interrupted = 0; // NOLINT: all that a signal handler may set

void on_signal(int signal) {
    interrupted = 1;
    std::signal(signal, SIG_DFL); // a second one ends the program at once
}

double seconds_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

double history_interval(const Scene& scene) {
    if (scene.output.history_every) return *scene.output.history_every;
    return (scene.output.every > 0 ? scene.output.every : scene.time.end) / 100;
}

double end_time(const RunOptions& options, const Scene& scene) {
    if (!options.until) return scene.time.end;
    double until = 0;
    const char* const text_end = options.until->data() + options.until->size();
    try {
        if (std::from_chars(options.until->data(), text_end, until).ptr != text_end) // else a plain number, in s
            until = parse_quantity(*options.until, dimensions::time);
    } catch (const std::exception& error) {
        throw UsageError(fmt::format("--until: {}", error.what()));
    }
    if (!(until > 0)) throw UsageError(fmt::format("--until: {} is not a time after the start", *options.until));
    return std::min(until, scene.time.end);
}

/// An unusable result folder is a mistake on the command line, unlike a disk that fills up during the run.
void make_ready(const std::filesystem::path& folder, const RunOptions& options, const Scene& scene) {
    std::vector<std::filesystem::path> inputs = input_files(scene);
    inputs.push_back(options.scene.scene);
    try {
        prepare_result_folder(folder, options.overwrite, inputs);
    } catch (const std::runtime_error& error) {
        throw UsageError(error.what());
    }
}

/// Runs a scene in its number of dimensions.
template <int D>
int run(const RunOptions& options, const LoadedScene& loaded, std::chrono::steady_clock::time_point start) {
    const std::clock_t cpu_start = std::clock();
    const double end = end_time(options, loaded.scene);
    const Model model = build_model(loaded.scene, options.scene.scene.string());
    if (options.threads > 0) omp_set_num_threads(options.threads);

    std::filesystem::path folder = options.output;
    if (folder.empty()) folder = options.scene.scene.stem().string() + "-results";
    State<D> state = make_state<D>(loaded.scene, model);
    check_start(state, options.scene.scene);
    make_ready(folder, options, loaded.scene);

    std::signal(SIGINT, on_signal);
    std::signal(SIGTERM, on_signal);
    std::vector<Task<D>> tasks = step_tasks<D>(loaded.scene);
    RunFiles files(folder, loaded.resolved, state);
    Progress progress(options.quiet ? ProgressMode::quiet : ProgressMode::automatic, end);
    RunTiming timing;
    timing.threads = options.threads > 0 ? options.threads : omp_get_max_threads();

    Schedule history(history_interval(loaded.scene));
    history.due(0);
    const auto write_frames = [&](Frames which) {
        const auto writing = std::chrono::steady_clock::now();
        if (!files.write_frames(state, which)) return;
        timing.output_seconds += seconds_since(writing);
        const std::optional<double> overlap = files.interpenetration();
        progress.note(overlap ? fmt::format("interpenetration {:.2e} of the area", *overlap) : "");
    };
    const auto write_history = [&] {
        const auto writing = std::chrono::steady_clock::now();
        files.write_history(state);
        timing.output_seconds += seconds_since(writing);
    };
    const auto finish = [&] {
        timing.wall_seconds = seconds_since(start);
        timing.cpu_seconds = static_cast<double>(std::clock() - cpu_start) / CLOCKS_PER_SEC;
        write_timing(folder / "timing.json", state, tasks, timing);
    };

    write_frames(Frames::last);
    write_history();
    bool history_written = true;
    try {
        while (state.time < end && !interrupted) {
            const auto step_start = std::chrono::steady_clock::now();
            state.dt = next_step(state, end);
            if (state.time + state.dt == state.time) {
                if (end - state.time <= 1e-12 * end) break; // what is left of the run is round-off
                throw RunError(fmt::format("step {}, time {:g} s: the time step has shrunk to {:g} s, which no longer "
                                           "advances the time; the run has diverged",
                                           state.step, state.time, state.dt));
            }
            const double after = state.time + state.dt;
            state.wants_areas = state.effects.pairs && (history.is_due(after) || after >= end);
            advance(state, tasks);
            timing.solver_seconds += seconds_since(step_start);
            progress.update(state.step, state.time);
            history_written = history.due(state.time);
            if (history_written) write_history();
            write_frames(Frames::due);
        }
    } catch (const RunError&) {
        files.write_failed(state);
        finish();
        throw;
    }
    if (!history_written) write_history();
    write_frames(Frames::last);
    progress.finish();
    finish();
    if (interrupted && state.time < end) {
        fmt::print(stderr, "interrupted at {}; the state is written in {}\n", format_time(state.time), folder.string());
        return 130;
    }
    return 0;
}

} // namespace

int run_command(const RunOptions& options) {
    const auto start = std::chrono::steady_clock::now();
    const LoadedScene loaded = load_scene(options.scene.scene, options.scene.set);
    print_advice(loaded.scene, options.scene.scene);
    return dimension(loaded.scene.analysis) == 3 ? run<3>(options, loaded, start) : run<2>(options, loaded, start);
}

} // namespace abut
