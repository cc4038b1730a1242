#include "io/checkpoint/checkpoint.h"
#include "io/checkpoint/checkpoint_parts.h"
#include "io/checkpoint/hdf5_file.h"
#include "shape/product.h"
#include "step/good_state.h"
#include "step/setback.h"
#include "step/visit_state.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <concepts>
#include <cstring>
#include <limits>
#include <stdexcept>

namespace abut {

namespace {

using namespace checkpoint;

constexpr std::size_t longest_scene = 1 << 26; // bytes
constexpr std::int64_t most = std::int64_t{1} << 62;
constexpr std::int64_t troubles = static_cast<std::int64_t>(Trouble::rigid_left_grid) + 1; // the last kind

// === Values of a file, checked for themselves

/// Whether a text is a JSON object, and none so deep that handling it would exhaust the stack.
bool is_scene(const std::string& text) {
    constexpr int deepest = 100;
    bool too_deep = false;
    const auto shallow = [&](int depth, nlohmann::json::parse_event_t, nlohmann::json&) {
        too_deep |= depth > deepest;
        return depth <= deepest;
    };
    return nlohmann::json::parse(text, shallow, false).is_object() && !too_deep;
}

[[noreturn]] void fail(const Hdf5Reader& file, const std::string& name, const std::string& cause) {
    throw std::runtime_error(fmt::format("{}: {}: {}", file.path().string(), name, cause));
}

/// An array of `size` elements, all finite.
template <class Element>
std::vector<Element> load_rows(const Hdf5Reader& file, const std::string& name, std::size_t size) {
    const std::vector<double> values =
        file.reals(name, width<Element> == 1 ? Shape{size} : Shape{size, width<Element>});
    for (std::size_t i = 0; i < values.size(); ++i)
        if (!std::isfinite(values[i])) fail(file, name, fmt::format("entry {} is {}", i / width<Element>, values[i]));
    std::vector<Element> result(size);
    if (size > 0) std::memcpy(static_cast<void*>(result.data()), values.data(), values.size() * sizeof(double));
    return result;
}

/// Numbers that belong together, as many as a struct of reals has.
template <class Sums>
Sums load_sums(const Hdf5Reader& file, const std::string& name) {
    const std::vector<double> values = load_rows<double>(file, name, width<Sums>);
    Sums sums;
    std::memcpy(static_cast<void*>(&sums), values.data(), sizeof sums);
    return sums;
}

/// Whole numbers, each in [low, high).
std::vector<std::int64_t> load_numbers(const Hdf5Reader& file, const std::string& name, const Shape& shape,
                                       std::int64_t low, std::int64_t high) {
    std::vector<std::int64_t> values = file.integers(name, shape);
    for (const std::int64_t value : values)
        if (value < low || value >= high) fail(file, name, fmt::format("{} is out of its range", value));
    return values;
}

/// Where the members of a state come from.
template <int D>
struct Source {
    const Hdf5Reader& file;
    const State<D>& made;          ///< by make_state() from the same scene, perhaps advanced since
    const Particles<D>& particles; ///< loaded: they come first
};

// === load(from, name, member): one for each kind of member that visit_state() knows

template <int D, std::integral Number>
void load(const Source<D>& from, const std::string& name, Number& number) {
    constexpr bool truth = std::is_same_v<Number, bool>;
    const std::int64_t end = truth ? 2 : std::min(most, std::int64_t{std::numeric_limits<Number>::max()});
    number = static_cast<Number>(load_numbers(from.file, name, {1}, 0, end)[0]);
}

template <int D, class... Numbers>
void load(const Source<D>& from, const std::string& name, const std::tuple<Numbers&...>& numbers) {
    const auto values = load_rows<double>(from.file, name, sizeof...(Numbers));
    std::size_t next = 0;
    std::apply([&](auto&... number) { ((number = values[next++]), ...); }, numbers);
}

template <int D>
void load(const Source<D>& from, const std::string& name, Ledger& ledger) {
    ledger = load_sums<Ledger>(from.file, name);
}

template <int D>
void load(const Source<D>& from, const std::string& name, EnergyWatch& watch) {
    watch = load_sums<EnergyWatch>(from.file, name);
}

template <int D>
void load(const Source<D>& from, const std::string& name, std::optional<Setback>& setback) {
    setback.reset();
    if (!from.file.has(name)) return;
    const auto at = load_rows<double>(from.file, name + "/at", 4);
    const auto kind = load_numbers(from.file, name + "/trouble", {1}, 0, troubles)[0];
    const auto returns = load_numbers(from.file, name + "/returns", {1}, 0, most_returns + 1)[0];
    setback = {static_cast<Trouble>(kind), at[0], {at[1], at[2], at[3]}, static_cast<int>(returns)};
}

/// Entry i becomes that of particle ids[i] of the model's order.
template <class T>
void reorder(std::vector<T>& values, const std::vector<std::size_t>& place_of, const std::vector<std::int64_t>& ids) {
    if (values.empty()) return;
    std::vector<T> ordered(ids.size());
    for (std::size_t i = 0; i < ids.size(); ++i) ordered[i] = values[place_of[static_cast<std::size_t>(ids[i])]];
    values.swap(ordered);
}

/// \param particles as make_particles() makes them, perhaps sorted since
template <int D>
void load(const Source<D>& from, const std::string& name, Particles<D>& particles) {
    const std::size_t n = particles.size();
    const auto ids = load_numbers(from.file, name + "/id", {n}, 0, static_cast<std::int64_t>(n));
    std::vector<bool> seen(n, false);
    for (const std::int64_t id : ids) {
        if (seen[static_cast<std::size_t>(id)]) fail(from.file, name + "/id", fmt::format("{} is there twice", id));
        seen[static_cast<std::size_t>(id)] = true;
    }
    std::vector<std::size_t> place_of(n);
    for (std::size_t p = 0; p < n; ++p) place_of[static_cast<std::size_t>(particles.id[p])] = p;
    visit_lasting([&](const char*, auto& values) { reorder(values, place_of, ids); }, particles);
    visit_changing(
        [&]<class Element>(const std::string& array, std::vector<Element>& values) {
            if (!values.empty()) values = load_rows<Element>(from.file, name + "/" + array, n);
        },
        particles);
    for (std::size_t p = 0; p < n; ++p) {
        if (!from.made.grid.contains(particles.position[p]))
            fail(from.file, name + "/position", fmt::format("particle {} is outside the grid", ids[p]));
        if (!(particles.deformation_gradient[p].determinant() * particles.across_of(p) > 0))
            fail(from.file, name + "/deformation_gradient", fmt::format("particle {} is turned inside out", ids[p]));
    }
}

template <int D>
void load(const Source<D>& from, const std::string& name, Tiling<D>& tiling) {
    const auto& [file, made, particles] = from;
    const Grid<D>& grid = made.grid;
    const std::size_t count = file.rows(name, 4, particles.size());
    const auto rows = file.integers(name, {count, 4});
    std::int64_t blocks = 1;
    for (int a = 0; a < D; ++a) blocks *= grid.blocks[a];
    tiling = {};
    for (std::size_t t = 0; t < count; ++t) {
        const std::int64_t* row = rows.data() + 4 * t;
        const std::int64_t begin = t == 0 ? 0 : tiling.tiles.back().last;
        const bool follows = row[2] == begin && row[3] > begin && row[3] <= std::int64_t(particles.size());
        if (!follows || row[0] < 0 || row[0] >= blocks) fail(file, name, fmt::format("row {} cannot be", t));
        for (std::int64_t p = row[2]; p < row[3]; ++p)
            if (particles.body[static_cast<std::size_t>(p)] != row[1])
                fail(file, name, fmt::format("row {} holds a particle of another body", t));
        Tile<D> tile{};
        tile.window = Window<D>::empty(); // not to be taken for the one that the present slots are for
        tile.block = static_cast<int>(row[0]);
        tile.body = static_cast<std::int32_t>(row[1]);
        tile.field = made.effects.contact ? tile.body : 0;
        tile.first = static_cast<std::int32_t>(row[2]);
        tile.last = static_cast<std::int32_t>(row[3]);
        if (t > 0) {
            const Tile<D>& before = tiling.tiles.back();
            if (std::pair(tile.block, tile.body) <= std::pair(before.block, before.body))
                fail(file, name, "blocks and bodies are not in their order");
        }
        if (t == 0 || tile.block != tiling.tiles.back().block)
            tiling.blocks.push_back({tile.block, static_cast<std::int32_t>(t), 0});
        tiling.tiles.push_back(tile);
        tiling.blocks.back().last = static_cast<std::int32_t>(t) + 1;
    }
    if (!tiling.tiles.empty() && tiling.tiles.back().last != std::int64_t(particles.size()))
        fail(file, name, "they do not hold all particles");
    // Windows of more nodes end a run; see Tiling::needed_stride().
    constexpr std::int64_t most_blocks = (most_axis_nodes + block_edge - 1) / block_edge + 1;
    const auto stride = load_numbers(file, "stride", {1}, 0, most_blocks + 1)[0];
    if (!tiling.tiles.empty()) tiling.make_colours(grid, static_cast<int>(std::max<std::int64_t>(2, stride)));
}

template <int D>
void load(const Source<D>& from, const std::string& name, std::vector<Boundary>& boundaries) {
    const auto impulses = load_rows<Vector>(from.file, name, boundaries.size());
    for (std::size_t b = 0; b < boundaries.size(); ++b) boundaries[b].impulse = impulses[b];
}

template <int D>
void load(const Source<D>& from, const std::string& name,
          std::map<std::pair<std::int32_t, std::int32_t>, PairTotals>& pairs) {
    const std::size_t bodies = from.made.bodies.size();
    const std::size_t count = from.file.rows(name + "/bodies", 2, bodies * bodies);
    const auto names = load_numbers(from.file, name + "/bodies", {count, 2}, 0, static_cast<std::int64_t>(bodies));
    const auto totals = load_rows<PairTotals>(from.file, name + "/totals", count);
    pairs.clear();
    for (std::size_t i = 0; i < count; ++i) {
        const std::pair pair(static_cast<std::int32_t>(names[2 * i]), static_cast<std::int32_t>(names[2 * i + 1]));
        if (pair.first >= pair.second || pairs.contains(pair))
            fail(from.file, name + "/bodies", fmt::format("{} and {} cannot be", pair.first, pair.second));
        pairs[pair] = totals[i];
    }
}

template <int D>
void load(const Source<D>& from, const std::string& name, std::map<std::int32_t, RigidTotals>& rigid) {
    const std::vector<ModelBody>& bodies = from.made.bodies;
    const std::size_t count = from.file.rows(name + "/bodies", 0, bodies.size());
    const auto names = load_numbers(from.file, name + "/bodies", {count}, 0, static_cast<std::int64_t>(bodies.size()));
    const auto totals = load_rows<RigidTotals>(from.file, name + "/totals", count);
    rigid.clear();
    for (std::size_t i = 0; i < count; ++i) {
        const auto body = static_cast<std::int32_t>(names[i]);
        if (!bodies[static_cast<std::size_t>(body)].rigid || rigid.contains(body))
            fail(from.file, name + "/bodies", fmt::format("{} cannot be", body));
        rigid[body] = totals[i];
    }
}

OutputProgress load_output(const Hdf5Reader& file) {
    const auto times = load_rows<double>(file, "output/times", 12);
    const auto counts = load_numbers(file, "output/counts", {6}, 0, most);
    OutputProgress output;
    for (std::size_t s = 0; s < 3; ++s)
        output.series[s] = {counts[s], times[3 * s], times[3 * s + 1], times[3 * s + 2]};
    output.history_every = times[9];
    output.history_next = times[10];
    output.history_last = times[11];
    std::copy_n(counts.begin() + 3, 3, output.bytes.begin());
    return output;
}

} // namespace

CheckpointHead read_checkpoint_head(const std::filesystem::path& path) {
    const Hdf5Reader file(path);
    if (!file.has("format") || file.text("format", 100) != "abut checkpoint")
        throw std::runtime_error(path.string() + ": is no checkpoint of abut");
    if (const auto found = file.integers("version", {1})[0]; found != version)
        throw std::runtime_error(fmt::format("{}: has version {}, and this program reads version {}; run it with the "
                                             "program that wrote it",
                                             path.string(), found, version));
    CheckpointHead head;
    head.resolved_scene = file.text("scene", longest_scene);
    if (!is_scene(head.resolved_scene)) fail(file, "scene", "is no scene");
    head.checksum = static_cast<std::uint64_t>(file.integers("model_checksum", {1})[0]);
    head.step = load_numbers(file, "step", {1}, 0, most)[0];
    head.time = load_rows<double>(file, "clock", 4)[0];
    return head;
}

template <int D>
OutputProgress read_checkpoint(const std::filesystem::path& path, State<D>& state) {
    const Hdf5Reader file(path);
    State<D> loaded = kept_copy(state);
    const Source<D> from{file, state, loaded.particles};
    visit_state([&](const char* name, auto&& member) { load(from, name, member); }, loaded);
    if (!(loaded.time >= 0) || !(loaded.dt >= 0) || !(loaded.largest_wave_speed > 0) || !(loaded.since_transfer >= 0))
        fail(file, "clock", "a time, a step or a wave speed cannot be");
    if (!(loaded.energy_watch.given >= 0)) fail(file, "energy_watch", "a sum without signs is negative");
    if (loaded.step_reductions > most_step_reductions)
        fail(file, "step_reductions", fmt::format("{} is out of its range", loaded.step_reductions));
    const OutputProgress output = load_output(file);
    go_back(loaded, state);
    return output;
}

template OutputProgress read_checkpoint<2>(const std::filesystem::path&, State<2>&);
template OutputProgress read_checkpoint<3>(const std::filesystem::path&, State<3>&);

} // namespace abut
