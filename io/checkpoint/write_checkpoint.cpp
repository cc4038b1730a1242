#include "io/checkpoint/checkpoint.h"
#include "io/checkpoint/checkpoint_parts.h"
#include "io/checkpoint/hdf5_file.h"
#include "io/results/output_file.h"
#include "step/visit_state.h"

#include <concepts>

namespace abut {

namespace {

using namespace checkpoint;

template <class Element>
std::span<const double> numbers(const Element* first, std::size_t count) {
    static_assert(sizeof(Element) % sizeof(double) == 0);
    return {reinterpret_cast<const double*>(first), count * width<Element>};
}

/// A row for each element.
template <class Element>
void save_rows(Hdf5Writer& file, const std::string& name, const std::vector<Element>& values) {
    if constexpr (width<Element> == 1)
        file.reals(name, numbers(values.data(), values.size()), {values.size()});
    else
        file.reals(name, numbers(values.data(), values.size()), {values.size(), width<Element>});
}

// === save(file, name, member): one for each kind of member that visit_state() knows

template <std::integral Number>
void save(Hdf5Writer& file, const std::string& name, Number number) {
    file.integers(name, std::vector{static_cast<std::int64_t>(number)}, {1});
}

template <class... Numbers>
void save(Hdf5Writer& file, const std::string& name, const std::tuple<Numbers&...>& numbers) {
    const auto values = std::apply([](const auto&... number) { return std::vector<double>{number...}; }, numbers);
    file.reals(name, values, {values.size()});
}

void save(Hdf5Writer& file, const std::string& name, const Ledger& ledger) {
    file.reals(name, numbers(&ledger, 1), {width<Ledger>});
}

void save(Hdf5Writer& file, const std::string& name, const EnergyWatch& watch) {
    file.reals(name, numbers(&watch, 1), {width<EnergyWatch>});
}

/// Nothing if there was none.
void save(Hdf5Writer& file, const std::string& name, const std::optional<Setback>& setback) {
    if (!setback) return;
    const auto& [trouble, time, place, returns] = *setback;
    file.reals(name + "/at", std::vector{time, place[0], place[1], place[2]}, {4});
    save(file, name + "/trouble", static_cast<int>(trouble));
    save(file, name + "/returns", returns);
}

/// Without what a particle keeps for good: that is made anew from the scene and put in the order of `id`.
template <int D>
void save(Hdf5Writer& file, const std::string& name, const Particles<D>& particles) {
    visit_changing(
        [&](const std::string& array, const auto& values) {
            if (!values.empty()) save_rows(file, name + "/" + array, values);
        },
        particles);
    file.integers(name + "/id", std::vector<std::int64_t>(particles.id.begin(), particles.id.end()),
                  {particles.size()});
}

/// Rows of block, body, first, last.
template <int D>
void save(Hdf5Writer& file, const std::string& name, const Tiling<D>& tiling) {
    std::vector<std::int64_t> rows;
    for (const Tile<D>& tile : tiling.tiles) rows.insert(rows.end(), {tile.block, tile.body, tile.first, tile.last});
    file.integers(name, rows, {tiling.tiles.size(), 4});
    save(file, "stride", tiling.stride);
}

void save(Hdf5Writer& file, const std::string& name, const std::vector<Boundary>& boundaries) {
    std::vector<Vector> impulses;
    for (const Boundary& boundary : boundaries) impulses.push_back(boundary.impulse);
    save_rows(file, name, impulses);
}

void save(Hdf5Writer& file, const std::string& name,
          const std::map<std::pair<std::int32_t, std::int32_t>, PairTotals>& pairs) {
    std::vector<std::int64_t> bodies;
    std::vector<PairTotals> totals;
    for (const auto& [pair, sums] : pairs) {
        bodies.insert(bodies.end(), {pair.first, pair.second});
        totals.push_back(sums);
    }
    file.integers(name + "/bodies", bodies, {totals.size(), 2});
    save_rows(file, name + "/totals", totals);
}

void save(Hdf5Writer& file, const std::string& name, const std::map<std::int32_t, RigidTotals>& rigid) {
    std::vector<std::int64_t> bodies;
    std::vector<RigidTotals> totals;
    for (const auto& [body, sums] : rigid) {
        bodies.push_back(body);
        totals.push_back(sums);
    }
    file.integers(name + "/bodies", bodies, {totals.size()});
    save_rows(file, name + "/totals", totals);
}

void save_output(Hdf5Writer& file, const OutputProgress& output) {
    std::vector<double> times;
    std::vector<std::int64_t> counts;
    for (const SeriesProgress& series : output.series) {
        times.insert(times.end(), {series.last_time, series.every, series.next});
        counts.push_back(series.frames);
    }
    times.insert(times.end(), {output.history_every, output.history_next, output.history_last});
    counts.insert(counts.end(), output.bytes.begin(), output.bytes.end());
    file.reals("output/times", times, {times.size()});
    file.integers("output/counts", counts, {counts.size()});
}

} // namespace

std::filesystem::path previous_checkpoint(const std::filesystem::path& path) {
    return path.parent_path() / (path.stem().string() + "-previous" + path.extension().string());
}

template <int D>
void write_checkpoint(const std::filesystem::path& path, const State<D>& state, const OutputProgress& output,
                      const std::string& resolved_scene, std::uint64_t checksum) {
    const std::filesystem::path fresh =
        path.parent_path() / (path.stem().string() + "-new" + path.extension().string());
    replace_file(fresh, [&](const std::filesystem::path& temporary) {
        Hdf5Writer file(temporary, path);
        file.text("format", "abut checkpoint");
        save(file, "version", version);
        file.text("scene", resolved_scene);
        save(file, "model_checksum", checksum);
        visit_state([&](const char* name, const auto& member) { save(file, name, member); }, state);
        save_output(file, output);
        file.close();
    });
    // Whenever the program ends, a complete file is there under one of the two names.
    std::error_code none_yet;
    std::filesystem::rename(path, previous_checkpoint(path), none_yet);
    std::filesystem::rename(fresh, path);
}

template void write_checkpoint<2>(const std::filesystem::path&, const State<2>&, const OutputProgress&,
                                  const std::string&, std::uint64_t);
template void write_checkpoint<3>(const std::filesystem::path&, const State<3>&, const OutputProgress&,
                                  const std::string&, std::uint64_t);

} // namespace abut
