#include "app/run_series.h"

#include <fmt/format.h>

#include <stdexcept>

namespace abut {

namespace {

RunSeries make_series(const std::filesystem::path& folder, const std::string& name, const char* extension,
                      const SeriesSpec& spec, const OutputSpec& output, const std::vector<bool>& bodies) {
    return {name,
            extension,
            {folder / (name + ".pvd"), {}},
            Schedule(spec.every.value_or(output.every)),
            spec.write,
            {spec.arrays, bodies}};
}

} // namespace

std::string frame_file(const RunSeries& series, std::size_t number) {
    return fmt::format("{0}/{0}_{1:05}.{2}", series.name, number, series.extension);
}

template <int D>
std::array<RunSeries, 3> series_of(const std::filesystem::path& folder, const State<D>& state) {
    const OutputSpec& output = state.scene.output;
    const std::vector<bool> bodies = chosen_bodies(state);
    std::array<RunSeries, 3> series{make_series(folder, "particles", "vtu", output.particles, output, bodies),
                                    make_series(folder, "grid", "vti", output.grid, output, bodies),
                                    make_series(folder, "contact", "vtp", output.contact, output, bodies)};
    series[2].wanted &= state.effects.contact;
    return series;
}

PvdSeries written_so_far(const RunSeries& series, const SeriesProgress& progress) {
    const std::filesystem::path& path = series.pvd.path;
    const auto kept = static_cast<std::size_t>(progress.frames);
    if (!std::filesystem::exists(path) && (!series.wanted || kept == 0)) return series.pvd;
    const auto advice = [&] {
        return fmt::format("put back the file, which listed {} frames; or remove it and leave the series out: --set "
                           "/output/{}=false",
                           kept, series.name);
    };
    PvdSeries found;
    try {
        found = read_pvd(path);
    } catch (const std::runtime_error& error) {
        throw std::runtime_error(fmt::format("{}; {}", error.what(), advice()));
    }
    const std::vector<PvdEntry>& entries = found.entries;
    if (entries.size() < kept)
        throw std::runtime_error(fmt::format("{}: has {} frames instead of at least {}: it has been changed; {}",
                                             path.string(), entries.size(), kept, advice()));
    for (std::size_t i = 0; i < entries.size(); ++i)
        if (entries[i].file != frame_file(series, i))
            throw std::runtime_error(fmt::format("{}: entry {} is \"{}\" instead of \"{}\": it has been changed; {}",
                                                 path.string(), i, entries[i].file, frame_file(series, i), advice()));
    const std::filesystem::path frames = path.parent_path() / series.name;
    if (std::filesystem::is_symlink(frames))
        throw std::runtime_error(fmt::format("{}: is a link; a resumed run removes and writes frames only in its own "
                                             "folder: move them there, or link the whole folder of results",
                                             frames.string()));
    return found;
}

void resume(RunSeries& series, const SeriesProgress& progress, double time) {
    series.schedule.resume(time, progress.every, progress.next);
    series.pvd = written_so_far(series, progress);
    if (series.pvd.entries.empty()) return;
    const auto kept = static_cast<std::size_t>(progress.frames);
    const std::filesystem::path folder = series.pvd.path.parent_path();
    for (std::size_t i = kept; i < series.pvd.entries.size() || std::filesystem::exists(folder / frame_file(series, i));
         ++i)
        std::filesystem::remove(folder / frame_file(series, i));
    series.pvd.entries.resize(kept);
    if (kept > 0)
        series.pvd.write();
    else
        std::filesystem::remove(series.pvd.path);
    series.frames = static_cast<int>(progress.frames);
    series.last_time = progress.last_time;
}

bool gets_frame(RunSeries& series, double time, Frames which) {
    const bool due = series.schedule.due(time);
    return series.wanted && (which == Frames::last ? series.last_time != time : due);
}

template std::array<RunSeries, 3> series_of<2>(const std::filesystem::path&, const State<2>&);
template std::array<RunSeries, 3> series_of<3>(const std::filesystem::path&, const State<3>&);

} // namespace abut
