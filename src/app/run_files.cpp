#include "app/run_files.h"

#include "io/results/write_text.h"
#include "results/interpenetration.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <sys/resource.h>

#include <algorithm>
#include <fstream>

namespace abut {

namespace {

std::vector<std::string> with_key_columns(std::vector<std::string> keys, const std::vector<std::string>& columns) {
    keys.insert(keys.end(), columns.begin(), columns.end());
    return keys;
}

/// Writes one file of a series and enters it.
template <class Frame>
void write_to_series(RunSeries& series, const Frame& frame, Reals reals,
                     void (*write)(const std::filesystem::path&, const Frame&, Reals)) {
    const std::string file = frame_file(series, static_cast<std::size_t>(series.frames));
    const std::filesystem::path path = series.pvd.path.parent_path() / file;
    std::filesystem::create_directories(path.parent_path());
    write(path, frame, reals);
    series.pvd.append(frame.time, file);
    series.last_time = frame.time;
    ++series.frames;
}

CsvTable open_table(const std::filesystem::path& path, const std::vector<std::string>& columns,
                    const OutputProgress* resumed, std::size_t number) {
    return resumed ? CsvTable(path, columns, static_cast<std::uintmax_t>(resumed->bytes[number]))
                   : CsvTable(path, columns);
}

std::vector<std::string> bodies_table_columns() {
    return with_key_columns({"step", "time", "body"}, body_columns());
}
std::vector<std::string> pairs_table_columns() {
    return with_key_columns({"step", "time", "body_a", "body_b"}, pair_columns());
}

std::filesystem::path apart(const std::filesystem::path& folder, const std::string& name) {
    return folder / "particles" / (name + ".vtu");
}

/// Most memory that this program has had at once [bytes]. What getrusage() tells begins with that of the program which
/// started this one.
long long peak_memory() {
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);)
        if (line.starts_with("VmHWM:")) return std::stoll(line.substr(6)) * 1024;
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<long long>(usage.ru_maxrss) * 1024;
}

template <int D>
void draw_live(LivePicture& live, State<D>& state) {
    std::optional<PointFrame> contact;
    if (state.effects.contact && live.wants_contact()) contact = contact_frame(state);
    live.draw(particle_frame(state), contact ? &*contact : nullptr);
}

} // namespace

template <int D>
RunFiles::RunFiles(const std::filesystem::path& folder, const std::string& resolved_scene, State<D>& state,
                   const OutputProgress* resumed)
    : folder_(folder), series_(series_of(folder, state)) {
    const OutputSpec& output = state.scene.output;
    const bool has_pairs = state.effects.contact && output.pairs;
    if (resumed) { // before anything is changed
        check_continued(folder / "history.csv", history_columns(state), resumed->bytes[0]);
        check_continued(folder / "bodies.csv", bodies_table_columns(), resumed->bytes[1]);
        if (has_pairs) check_continued(folder / "pairs.csv", pairs_table_columns(), resumed->bytes[2]);
        for (std::size_t i = 0; i < series_.size(); ++i) written_so_far(series_[i], resumed->series[i]);
        clouds_ = read_cloud_series(folder);
    }
    history_.emplace(open_table(folder / "history.csv", history_columns(state), resumed, 0));
    bodies_.emplace(open_table(folder / "bodies.csv", bodies_table_columns(), resumed, 1));
    if (has_pairs) pairs_.emplace(open_table(folder / "pairs.csv", pairs_table_columns(), resumed, 2));
    write_text_atomically(folder / "scene.json", resolved_scene);
    if (output.single_precision) reals_ = Reals::float32;
    if (output.live) {
        live_schedule_ = Schedule(output.particles.every.value_or(output.every));
        live_.emplace(folder / "live.png", Bounds{state.scene.grid.lower, state.scene.grid.upper}, state.scene.title,
                      output.live_preset, state.scene.time.end);
    }
    if (!resumed) return;
    for (std::size_t i = 0; i < series_.size(); ++i) resume(series_[i], resumed->series[i], state.time);
    cut_cloud_series(clouds_, contact().last_time);
    last_history_ = resumed->history_last;
    write_all_pvd();
    for (const char* name : {"failed", "last_good"}) std::filesystem::remove(apart(folder, name));
}

void RunFiles::write_all_pvd() const {
    std::vector<PvdPart> parts;
    for (const RunSeries& series : series_)
        if (series.wanted || !series.pvd.entries.empty()) parts.push_back({series.name, &series.pvd});
    write_parts(folder_ / "all.pvd", parts);
}

OutputProgress RunFiles::progress() const {
    OutputProgress progress;
    for (std::size_t i = 0; i < series_.size(); ++i)
        progress.series[i] = {series_[i].frames, series_[i].last_time, series_[i].schedule.every(),
                              series_[i].schedule.next()};
    progress.history_last = last_history_;
    progress.bytes = {static_cast<std::int64_t>(history_->bytes()), static_cast<std::int64_t>(bodies_->bytes()),
                      pairs_ ? static_cast<std::int64_t>(pairs_->bytes()) : 0};
    return progress;
}

template <int D>
Totals RunFiles::write_history(State<D>& state) {
    const std::vector<Totals> by_body = body_totals(state);
    const Totals all = deformable_totals(state, by_body);
    const double interval = state.time - last_history_;
    history_->row(history_row(state, all, interval));
    last_history_ = state.time;
    for (std::size_t b = 0; b < by_body.size(); ++b) {
        std::vector<CsvTable::Value> row = {std::int64_t{state.step}, state.time,
                                            std::string_view(state.bodies[b].name)};
        for (const double value : body_row(by_body[b], state.bodies[b].rigid.has_value())) row.emplace_back(value);
        bodies_->row(row);
    }
    if (pairs_) {
        for (const PairRow& pair : pair_rows(state, interval)) {
            std::vector<CsvTable::Value> row = {std::int64_t{state.step}, state.time,
                                                std::string_view(state.bodies[pair.body_a].name),
                                                std::string_view(state.bodies[pair.body_b].name)};
            for (const double value : pair.values) row.emplace_back(value);
            pairs_->row(row);
        }
        pairs_->flush();
    }
    history_->flush();
    bodies_->flush();
    return all;
}

bool RunFiles::is_due(double time) const {
    return live_schedule_.is_due(time) || std::any_of(series_.begin(), series_.end(), [&](const RunSeries& series) {
               return series.schedule.is_due(time);
           });
}

template <int D>
bool RunFiles::write_frames(State<D>& state, Frames which) {
    const bool of_particles = gets_frame(particles(), state.time, which);
    const bool of_grid = gets_frame(grid(), state.time, which);
    const bool of_contact = gets_frame(contact(), state.time, which);
    const bool live_due = live_schedule_.due(state.time);
    const bool of_live = live_ && (live_due || (which == Frames::last && live_time_ != state.time));
    if (!of_particles && !of_grid && !of_contact && !of_live) return false;
    look(state);
    interpenetration_.reset();
    if (of_particles) {
        PointFrame frame = particle_frame(state, particles().choice);
        if constexpr (D == 2)
            if (state.effects.contact) {
                interpenetration_ = abut::interpenetration(state.particles).fraction();
                frame.globals.push_back({"interpenetration", 1, std::vector<double>{*interpenetration_}});
            }
        write_to_series(particles(), frame, reals_, write_particles);
    }
    if (of_live) {
        draw_live(*live_, state);
        live_time_ = state.time;
    }
    if (of_grid) write_to_series(grid(), grid_frame(state, grid().choice), reals_, write_grid);
    if (of_contact) write_to_series(contact(), contact_frame(state, contact().choice), reals_, write_contact);
    if (of_contact && state.scene.output.contact_clouds)
        write_contact_clouds(state, folder_, contact().frames - 1, clouds_); // numbered as the pairs' frame
    write_all_pvd();
    return true;
}

template <int D>
std::filesystem::path RunFiles::write_apart(const State<D>& state, const std::string& name) {
    std::filesystem::path file = apart(folder_, name);
    std::filesystem::create_directories(file.parent_path());
    write_particles(file, particle_frame(state));
    return file;
}

void RunFiles::sync_tables() {
    history_->sync();
    bodies_->sync();
    if (pairs_) pairs_->sync();
}

std::string RunFiles::last_frame() const {
    const std::vector<PvdEntry>& entries = series_[0].pvd.entries;
    if (entries.empty()) return "";
    return fmt::format("{} ({:g} s)", (folder_ / entries.back().file).string(), entries.back().time);
}

template <int D>
void write_timing(const std::filesystem::path& file, const State<D>& state, const std::vector<Task<D>>& tasks,
                  const RunTiming& timing) {
    const auto particle_steps =
        static_cast<long long>(state.particles.size()) * (state.step - timing.resumed_at_step + timing.abandoned_steps);
    nlohmann::ordered_json json = {
        {"wall_seconds", timing.wall_seconds},
        {"cpu_seconds", timing.cpu_seconds},
        {"solver_seconds", timing.solver_seconds},
        {"solver_cpu_seconds", timing.solver_cpu_seconds},
        {"output_seconds", timing.output_seconds},
        {"tasks", nlohmann::ordered_json::object()},
        {"steps", state.step},
        {"resumed_at_step", timing.resumed_at_step},
        {"step_reductions", state.step_reductions},
        {"abandoned_steps", timing.abandoned_steps},
        {"particles", state.particles.size()},
        {"nodes", state.fields.size()},
        {"threads", timing.threads},
        {"peak_memory_bytes", peak_memory()},
        {"particle_updates", particle_steps},
        {"particle_sweeps", timing.particle_sweeps},
        {"node_updates", timing.node_updates},
        {"ns_per_particle_step",
         particle_steps > 0 ? timing.solver_seconds * 1e9 / static_cast<double>(particle_steps) : 0.0}};
    if (timing.instructions) json["instructions"] = *timing.instructions;
    if (!timing.trouble.empty()) json["trouble"] = timing.trouble;
    for (const Task<D>& task : tasks) {
        auto& seconds = json["tasks"][task.name];
        seconds = (seconds.is_null() ? 0.0 : double(seconds)) + task.seconds;
    }
    write_text_atomically(file, json.dump(2) + "\n");
}

template RunFiles::RunFiles(const std::filesystem::path&, const std::string&, State<2>&, const OutputProgress*);
template Totals RunFiles::write_history<2>(State<2>&);
template bool RunFiles::write_frames<2>(State<2>&, Frames);
template std::filesystem::path RunFiles::write_apart<2>(const State<2>&, const std::string&);
template void write_timing<2>(const std::filesystem::path&, const State<2>&, const std::vector<Task<2>>&,
                              const RunTiming&);
template RunFiles::RunFiles(const std::filesystem::path&, const std::string&, State<3>&, const OutputProgress*);
template Totals RunFiles::write_history<3>(State<3>&);
template bool RunFiles::write_frames<3>(State<3>&, Frames);
template std::filesystem::path RunFiles::write_apart<3>(const State<3>&, const std::string&);
template void write_timing<3>(const std::filesystem::path&, const State<3>&, const std::vector<Task<3>>&,
                              const RunTiming&);

} // namespace abut
