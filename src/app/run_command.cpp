#include "app/checkpoints.h"
#include "app/commands.h"
#include "app/good_states.h"
#include "app/meter.h"
#include "app/run_files.h"
#include "app/schedule.h"
#include "app/trouble.h"
#include "geometry/build_model.h"
#include "io/results/progress.h"
#include "io/results/result_folder.h"
#include "io/results/si_prefix.h"
#include "io/scene/read_scene.h"
#include "io/scene/units.h"
#include "results/history.h"
#include "scene/input_files.h"
#include "step/setback.h"
#include "step/sweeps.h"
#include "step/watch.h"

#include <fmt/format.h>
#include <omp.h>

#include <charconv>
#include <chrono>
#include <csignal>
#include <limits>

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
FolderLock make_ready(const std::filesystem::path& folder, const RunOptions& options, const Scene& scene) {
    std::vector<std::filesystem::path> inputs = input_files(scene);
    inputs.push_back(options.scene.scene);
    try {
        return prepare_result_folder(folder, options.overwrite, inputs);
    } catch (const std::runtime_error& error) {
        throw UsageError(error.what());
    }
}

FolderLock lock_results(const std::filesystem::path& folder) {
    try {
        return FolderLock(folder);
    } catch (const std::runtime_error& error) {
        throw UsageError(error.what());
    }
}

/// Files of a new run, or those of the run that is resumed: if they don't fit, that is a mistake on the command line.
template <int D>
void open_files(std::optional<RunFiles>& files, const std::filesystem::path& folder, const std::string& resolved_scene,
                State<D>& state, const std::optional<OutputProgress>& resumed) {
    if (!resumed) {
        files.emplace(folder, resolved_scene, state);
        return;
    }
    try {
        files.emplace(folder, resolved_scene, state, &*resumed);
    } catch (const std::runtime_error& error) {
        throw UsageError(error.what());
    }
}

/// Runs a scene in its number of dimensions.
template <int D>
int run(const RunOptions& options, const LoadedScene& loaded, std::chrono::steady_clock::time_point start) {
    const double cpu_start = cpu_seconds();
    Meter meter(options.count_instructions);
    const double end = end_time(options, loaded.scene);
    const Model model = build_model(loaded.scene, options.scene.scene.string());
    if (options.threads > 0) omp_set_num_threads(options.threads);

    std::filesystem::path folder = options.output;
    if (folder.empty()) folder = options.scene.scene.stem().string() + "-results";
    State<D> state = make_state<D>(loaded.scene, model);
    check_start(state, options.scene.scene);
    const bool keeps_state = options.resume || loaded.scene.output.checkpoint;
    const std::uint64_t checksum = keeps_state ? model_checksum(model) : 0;
    Checkpoints checkpoints(folder, loaded.resolved, checksum, loaded.scene.output);
    std::optional<OutputProgress> resumed;
    const FolderLock lock = options.resume ? lock_results(folder) : make_ready(folder, options, loaded.scene);
    if (options.resume) {
        const Resumption from = resume_state(folder, loaded.resolved, checksum, state);
        if (!from.problem.empty())
            fmt::print(stderr, "abut: {}; going on from {}, step {}\n", from.problem, from.file.string(),
                       from.head.step);
        resumed = from.output;
        checkpoints.found(from);
    }

    std::signal(SIGINT, on_signal);
    std::signal(SIGTERM, on_signal);
    if (std::signal(SIGHUP, on_signal) == SIG_IGN) std::signal(SIGHUP, SIG_IGN); // under nohup
    std::vector<Task<D>> tasks = step_tasks<D>(loaded.scene);
    std::optional<RunFiles> files;
    open_files(files, folder, loaded.resolved, state, resumed);
    GoodStates<D> good(loaded.scene.time.on_trouble == OnTrouble::shrink_step);
    Progress progress(options.quiet ? ProgressMode::quiet : ProgressMode::automatic, end);
    if (resumed) progress.update(state.step, state.time);
    RunTiming timing;
    timing.resumed_at_step = state.step;
    timing.threads = options.threads > 0 ? options.threads : omp_get_max_threads();

    Schedule history(history_interval(loaded.scene));
    history.due(0);
    if (resumed) history.resume(state.time, resumed->history_every, resumed->history_next);
    /// Output is not part of what stepping costs.
    const auto timed = [&](const auto& write) {
        const auto writing = std::chrono::steady_clock::now();
        const bool stepping = meter.pause(timing);
        write();
        timing.output_seconds += seconds_since(writing);
        if (stepping) meter.go_on();
    };
    const auto write_frames = [&](Frames which) {
        bool written = false;
        timed([&] { written = files->write_frames(state, which); });
        if (!written) return;
        const std::optional<double> overlap = files->interpenetration();
        progress.note(overlap ? fmt::format("interpenetration {:.2e} of the area", *overlap) : "");
    };
    const auto write_history = [&] {
        Totals all;
        timed([&] { all = files->write_history(state); });
        return all;
    };
    const auto watch = [&](const Totals& all) {
        watch_energy(state, all.kinetic_energy + all.strain_energy, all.mass);
    };
    const auto totals = [&] { return deformable_totals(state, body_totals(state)); };
    const auto output_progress = [&] {
        OutputProgress output = files->progress();
        output.history_every = history.every();
        output.history_next = history.next();
        return output;
    };
    const auto write_checkpoint = [&] {
        timed([&] {
            const State<D>& saved = good.empty() ? state : good.oldest().state;
            if (!checkpoints.lacks(saved)) return;
            files->sync_tables(); // the checkpoint counts on their rows
            checkpoints.write(saved, good.empty() ? output_progress() : good.oldest().output);
        });
    };
    const auto finish = [&] {
        timing.wall_seconds = seconds_since(start);
        timing.cpu_seconds = cpu_seconds() - cpu_start;
        meter.pause(timing);
        write_timing(folder / "timing.json", state, tasks, timing);
    };

    if (!resumed) {
        write_frames(Frames::last);
        watch(write_history());
    }
    bool history_written = true;
    bool cut_short = false;
    const auto run_to_end = [&] {
        const long most_steps = options.steps.value_or(std::numeric_limits<long>::max());
        bool is_last = false;
        while (state.time < end && state.step < most_steps && !is_last) {
            // An interrupt is obeyed after one more step, which then is known to be followed by a row.
            is_last = interrupted != 0 || state.step + 1 == most_steps;
            if (good.due(state)) good.keep(state, output_progress());
            const double full_step = next_step(state, std::numeric_limits<double>::infinity());
            state.dt = std::min(full_step, end - state.time);
            // A run that is resumed to a later end goes on from before a last step that was cut short for this end, as
            // if it had never been made.
            cut_short = state.dt < full_step;
            if (cut_short || checkpoints.due(state)) write_checkpoint();
            const auto step_start = std::chrono::steady_clock::now();
            if (state.time + state.dt == state.time) {
                if (end - state.time <= 1e-12 * end) break; // what is left of the run is round-off
                throw run_error(Trouble::step_vanished, state, stiffest_particle(state),
                                fmt::format("the time step has shrunk to {:g} s, which no longer "
                                            "advances the time; waves are fastest here, {:g} m/s",
                                            state.dt, state.largest_wave_speed));
            }
            const double after = state.time + state.dt;
            state.wants_areas = state.effects.pairs && (is_last || history.is_due(after) || after >= end);
            advance(state, tasks);
            timing.node_updates += static_cast<long long>(state.fields.size());
            timing.particle_sweeps += sweeps_of_step(state) * static_cast<long long>(state.particles.size());
            timing.solver_seconds += seconds_since(step_start);
            progress.update(state.step, state.time);
            history_written = history.due(state.time);
            if (history_written)
                watch(write_history());
            else if (state.step % energy_watch_steps == 0)
                watch(totals());
            if (files->is_due(state.time)) write_frames(Frames::due); // else not even the clocks are read
        }
        // The state that the run ends with too; without a trace, so that a run that is resumed goes on as if there had
        // been no end. One that is interrupted only saves its state.
        if (!history_written && !interrupted) {
            const EnergyWatch before = state.energy_watch;
            watch(totals());
            state.energy_watch = before;
        }
    };
    const auto can_go_back = [&](const RunError& error) {
        return !good.empty() && depends_on_step(error.trouble()) && state.step_reductions < most_step_reductions &&
               setback_of(state, error).returns < most_returns;
    };
    const auto go_back_and_halve_step = [&](const RunError& error) {
        const auto& [from, output] = good.oldest();
        progress.warn(fmt::format("abut: {}\n  going back to step {}, time {:g} s, and on with half the time step "
                                  "(reduction {} of at most {})",
                                  error.what(), from.step, from.time, from.step_reductions + 1, most_step_reductions));
        timing.abandoned_steps += state.step - from.step;
        good.drop_newer();
        ++good.oldest().state.step_reductions;
        good.oldest().state.setback = setback_of(state, error);
        go_back(from, state);
        files.emplace(folder, loaded.resolved, state, &output);
        history.resume(state.time, output.history_every, output.history_next);
        history_written = true;
        checkpoints.go_back(from);
        write_checkpoint();
    };
    meter.go_on();
    for (;;) {
        try {
            run_to_end();
            break;
        } catch (const RunError& error) {
            if (can_go_back(error)) {
                go_back_and_halve_step(error);
                continue;
            }
            timing.trouble = word_of(error.trouble());
            std::string unwritten; // a disk that is full as well must not hide the diagnosis
            try {
                if (!good.empty()) write_checkpoint();
                finish();
            } catch (const std::exception& cause) {
                unwritten = cause.what();
            }
            report_trouble(error, state, *files, good, checkpoints.last(), unwritten);
        }
    }
    meter.pause(timing);
    if (resumed && state.step == timing.resumed_at_step && !options.quiet && !interrupted)
        fmt::print(stderr, "nothing to do: the run that is resumed has reached {} (step {}) already\n",
                   format_time(state.time), state.step);
    // Before the rows and frames that only this end of the run calls for.
    if (!cut_short || !good.empty()) write_checkpoint();
    if (!history_written) write_history();
    write_frames(Frames::last);
    progress.finish();
    finish();
    if (interrupted && state.time < end) {
        fmt::print(stderr, "interrupted at {}; the state is written in {}{}\n", format_time(state.time),
                   folder.string(), loaded.scene.output.checkpoint ? "; go on with --resume" : "");
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
