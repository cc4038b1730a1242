#include "io/checkpoint/checkpoint.h"

#include "io/checkpoint/hdf5_file.h"
#include "io/results/output_file.h"
#include "shape/product.h"
#include "step/good_state.h"
#include "step/tasks.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <cstring>
#include <stdexcept>

namespace abut {

namespace {

constexpr std::int64_t version = 1;
constexpr std::size_t longest_scene = 1 << 26; // bytes

// === Vectors and matrices as plain numbers; matrices column by column, as they lie in memory

template <class Element>
std::span<const double> numbers(const std::vector<Element>& values) {
    static_assert(sizeof(Element) % sizeof(double) == 0);
    return {reinterpret_cast<const double*>(values.data()), values.size() * (sizeof(Element) / sizeof(double))};
}

template <class Element>
constexpr std::size_t width = sizeof(Element) / sizeof(double);

template <class Element>
void save(Hdf5Writer& file, const std::string& name, const std::vector<Element>& values) {
    if constexpr (width<Element> == 1)
        file.reals(name, numbers(values), {values.size()});
    else
        file.reals(name, numbers(values), {values.size(), width<Element>});
}

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
std::vector<Element> load(const Hdf5Reader& file, const std::string& name, std::size_t size) {
    const std::vector<double> values =
        file.reals(name, width<Element> == 1 ? Shape{size} : Shape{size, width<Element>});
    for (std::size_t i = 0; i < values.size(); ++i)
        if (!std::isfinite(values[i])) fail(file, name, fmt::format("entry {} is {}", i / width<Element>, values[i]));
    std::vector<Element> result(size);
    if (size > 0) std::memcpy(static_cast<void*>(result.data()), values.data(), values.size() * sizeof(double));
    return result;
}

std::vector<std::int64_t> wide(const std::vector<std::int32_t>& values) {
    return {values.begin(), values.end()};
}

/// Whole numbers, each in [low, high).
std::vector<std::int64_t> load_numbers(const Hdf5Reader& file, const std::string& name, const Shape& shape,
                                       std::int64_t low, std::int64_t high) {
    std::vector<std::int64_t> values = file.integers(name, shape);
    for (const std::int64_t value : values)
        if (value < low || value >= high) fail(file, name, fmt::format("{} is out of its range", value));
    return values;
}

// === The parts of a state

template <int D>
void save_particles(Hdf5Writer& file, const Particles<D>& particles) {
    save(file, "particles/position", particles.position);
    save(file, "particles/velocity", particles.velocity);
    save(file, "particles/deformation_gradient", particles.deformation_gradient);
    save(file, "particles/stress", particles.stress);
    if (!particles.across.empty()) save(file, "particles/across", particles.across);
    file.integers("particles/id", wide(particles.id), {particles.size()});
}

/// Entry i becomes that of particle ids[i] of the model's order.
template <class T>
void reorder(std::vector<T>& values, const std::vector<std::size_t>& place_of, const std::vector<std::int64_t>& ids) {
    if (values.empty()) return;
    std::vector<T> ordered(ids.size());
    for (std::size_t i = 0; i < ids.size(); ++i) ordered[i] = values[place_of[static_cast<std::size_t>(ids[i])]];
    values.swap(ordered);
}

/// \param made as make_particles() makes them, perhaps sorted since
template <int D>
Particles<D> load_particles(const Hdf5Reader& file, const Particles<D>& made, const Grid<D>& grid) {
    const std::size_t n = made.size();
    Particles<D> particles = made;
    const auto ids = load_numbers(file, "particles/id", {n}, 0, static_cast<std::int64_t>(n));
    std::vector<bool> seen(n, false);
    for (const std::int64_t id : ids) {
        if (seen[static_cast<std::size_t>(id)]) fail(file, "particles/id", fmt::format("{} is there twice", id));
        seen[static_cast<std::size_t>(id)] = true;
    }
    std::vector<std::size_t> place_of(n);
    for (std::size_t p = 0; p < n; ++p) place_of[static_cast<std::size_t>(made.id[p])] = p;
    reorder(particles.mass, place_of, ids);
    reorder(particles.volume, place_of, ids);
    reorder(particles.half_size, place_of, ids);
    reorder(particles.prestress, place_of, ids);
    reorder(particles.body, place_of, ids);
    reorder(particles.id, place_of, ids);
    particles.position = load<Vec<D>>(file, "particles/position", n);
    particles.velocity = load<Vec<D>>(file, "particles/velocity", n);
    particles.deformation_gradient = load<Mat<D>>(file, "particles/deformation_gradient", n);
    particles.stress = load<Stress<D>>(file, "particles/stress", n);
    if (!made.across.empty()) particles.across = load<double>(file, "particles/across", n);
    for (std::size_t p = 0; p < n; ++p) {
        if (!grid.contains(particles.position[p]))
            fail(file, "particles/position", fmt::format("particle {} is outside the grid", ids[p]));
        if (!(particles.deformation_gradient[p].determinant() * particles.across_of(p) > 0))
            fail(file, "particles/deformation_gradient", fmt::format("particle {} is turned inside out", ids[p]));
    }
    return particles;
}

/// Tiles and blocks: rows of block, body, first, last.
template <int D>
void save_tiling(Hdf5Writer& file, const Tiling<D>& tiling) {
    std::vector<std::int64_t> rows;
    for (const Tile<D>& tile : tiling.tiles) rows.insert(rows.end(), {tile.block, tile.body, tile.first, tile.last});
    file.integers("tiles", rows, {tiling.tiles.size(), 4});
    file.integers("stride", std::vector<std::int64_t>{tiling.stride}, {1});
}

template <int D>
Tiling<D> load_tiling(const Hdf5Reader& file, const Particles<D>& particles, const Grid<D>& grid, bool contact) {
    const std::size_t count = file.rows("tiles", 4, particles.size());
    const auto rows = file.integers("tiles", {count, 4});
    std::int64_t blocks = 1;
    for (int a = 0; a < D; ++a) blocks *= grid.blocks[a];
    Tiling<D> tiling;
    for (std::size_t t = 0; t < count; ++t) {
        const std::int64_t* row = rows.data() + 4 * t;
        const std::int64_t begin = t == 0 ? 0 : tiling.tiles.back().last;
        const bool follows = row[2] == begin && row[3] > begin && row[3] <= std::int64_t(particles.size());
        if (!follows || row[0] < 0 || row[0] >= blocks) fail(file, "tiles", fmt::format("row {} cannot be", t));
        for (std::int64_t p = row[2]; p < row[3]; ++p)
            if (particles.body[static_cast<std::size_t>(p)] != row[1])
                fail(file, "tiles", fmt::format("row {} holds a particle of another body", t));
        Tile<D> tile{};
        tile.window = Window<D>::empty(); // not to be taken for the one that the present slots are for
        tile.block = static_cast<int>(row[0]);
        tile.body = static_cast<std::int32_t>(row[1]);
        tile.field = contact ? tile.body : 0;
        tile.first = static_cast<std::int32_t>(row[2]);
        tile.last = static_cast<std::int32_t>(row[3]);
        if (t > 0) {
            const Tile<D>& before = tiling.tiles.back();
            if (std::pair(tile.block, tile.body) <= std::pair(before.block, before.body))
                fail(file, "tiles", "blocks and bodies are not in their order");
        }
        if (t == 0 || tile.block != tiling.tiles.back().block)
            tiling.blocks.push_back({tile.block, static_cast<std::int32_t>(t), 0});
        tiling.tiles.push_back(tile);
        tiling.blocks.back().last = static_cast<std::int32_t>(t) + 1;
    }
    if (!tiling.tiles.empty() && tiling.tiles.back().last != std::int64_t(particles.size()))
        fail(file, "tiles", "they do not hold all particles");
    // Windows of more nodes end a run; see Tiling::needed_stride().
    constexpr std::int64_t most_blocks = (most_axis_nodes + block_edge - 1) / block_edge + 1;
    const auto stride = load_numbers(file, "stride", {1}, 0, most_blocks + 1)[0];
    if (!tiling.tiles.empty()) tiling.make_colours(grid, static_cast<int>(std::max<std::int64_t>(2, stride)));
    return tiling;
}

/// Sums since the last row of the tables, and since the start.
template <int D>
void save_totals(Hdf5Writer& file, const State<D>& state) {
    const Ledger& ledger = state.ledger;
    file.reals("ledger",
               std::vector{ledger.external_work, ledger.contact_work, ledger.friction_work, ledger.interface_energy},
               {4});
    std::vector<Vector> impulses;
    for (const Boundary& boundary : state.boundaries) impulses.push_back(boundary.impulse);
    save(file, "boundary_impulses", impulses);
    std::vector<std::int64_t> bodies;
    std::vector<std::array<double, 7>> pairs;
    for (const auto& [pair, t] : state.pair_totals) {
        bodies.insert(bodies.end(), {pair.first, pair.second});
        pairs.push_back(
            {t.impulse[0], t.impulse[1], t.impulse[2], t.work, t.friction_work, t.interface_energy, t.area});
    }
    file.integers("pairs/bodies", bodies, {pairs.size(), 2});
    save(file, "pairs/totals", pairs);
    bodies.clear();
    std::vector<std::array<double, 6>> rigid;
    for (const auto& [body, t] : state.rigid_totals) {
        bodies.push_back(body);
        rigid.push_back({t.impulse[0], t.impulse[1], t.impulse[2], t.angular_impulse[0], t.angular_impulse[1],
                         t.angular_impulse[2]});
    }
    file.integers("rigid/bodies", bodies, {rigid.size()});
    save(file, "rigid/totals", rigid);
}

/// What save_totals() saves.
struct SavedTotals {
    Ledger ledger;
    std::vector<Vector> impulses;
    std::map<std::pair<std::int32_t, std::int32_t>, PairTotals> pairs;
    std::map<std::int32_t, RigidTotals> rigid;
};

template <int D>
SavedTotals load_totals(const Hdf5Reader& file, const State<D>& state) {
    const std::size_t bodies = state.bodies.size();
    const auto most = static_cast<std::int64_t>(bodies);
    SavedTotals totals;
    const auto ledger = load<double>(file, "ledger", 4);
    totals.ledger = {ledger[0], ledger[1], ledger[2], ledger[3]};
    totals.impulses = load<Vector>(file, "boundary_impulses", state.boundaries.size());
    const std::size_t pairs = file.rows("pairs/bodies", 2, bodies * bodies);
    const auto names = load_numbers(file, "pairs/bodies", {pairs, 2}, 0, most);
    const auto values = load<std::array<double, 7>>(file, "pairs/totals", pairs);
    for (std::size_t i = 0; i < pairs; ++i) {
        const auto& v = values[i];
        const std::pair pair(static_cast<std::int32_t>(names[2 * i]), static_cast<std::int32_t>(names[2 * i + 1]));
        if (pair.first >= pair.second || totals.pairs.contains(pair))
            fail(file, "pairs/bodies", fmt::format("{} and {} cannot be", pair.first, pair.second));
        totals.pairs[pair] = {{v[0], v[1], v[2]}, v[3], v[4], v[5], v[6]};
    }
    const std::size_t rigid = file.rows("rigid/bodies", 0, bodies);
    const auto rigid_names = load_numbers(file, "rigid/bodies", {rigid}, 0, most);
    const auto rigid_values = load<std::array<double, 6>>(file, "rigid/totals", rigid);
    for (std::size_t i = 0; i < rigid; ++i) {
        const auto& v = rigid_values[i];
        const auto body = static_cast<std::int32_t>(rigid_names[i]);
        if (!state.bodies[static_cast<std::size_t>(body)].rigid || totals.rigid.contains(body))
            fail(file, "rigid/bodies", fmt::format("{} cannot be", body));
        totals.rigid[body] = {{v[0], v[1], v[2]}, {v[3], v[4], v[5]}};
    }
    return totals;
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

OutputProgress load_output(const Hdf5Reader& file) {
    const auto times = load<double>(file, "output/times", 12);
    const auto counts = load_numbers(file, "output/counts", {6}, 0, std::int64_t{1} << 62);
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

std::uint64_t model_checksum(const Model& model) {
    std::uint64_t sum = 14695981039346656037U; // FNV-1a
    const auto add = [&](const void* data, std::size_t bytes) {
        for (std::size_t i = 0; i < bytes; ++i)
            sum = (sum ^ static_cast<const unsigned char*>(data)[i]) * 1099511628211U;
    };
    const auto add_all = [&](const auto& values) { add(values.data(), values.size() * sizeof(values[0])); };
    for (const ModelBody& body : model.bodies) add(body.name.c_str(), body.name.size() + 1);
    add_all(model.position);
    add_all(model.half_size);
    add_all(model.body);
    add_all(model.angle);
    add_all(model.temperature);
    add_all(model.orientation);
    return sum;
}

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
        file.integers("version", std::vector{version}, {1});
        file.text("scene", resolved_scene);
        file.integers("model_checksum", std::vector{static_cast<std::int64_t>(checksum)}, {1});
        file.integers("step", std::vector<std::int64_t>{state.step}, {1});
        file.reals("clock", std::vector{state.time, state.dt, state.largest_wave_speed, state.since_transfer}, {4});
        file.integers("transfers", std::vector<std::int64_t>{state.transfers}, {1});
        save_particles(file, state.particles);
        save_tiling(file, state.tiling);
        save_totals(file, state);
        const EnergyWatch& watch = state.energy_watch;
        file.reals("energy_watch",
                   std::vector{watch.initial, watch.given, watch.lowest, watch.external_work, watch.contact_work}, {5});
        file.integers("step_reductions", std::vector<std::int64_t>{state.step_reductions}, {1});
        save_output(file, output);
        file.close();
    });
    // Whenever the program ends, a complete file is there under one of the two names.
    std::error_code none_yet;
    std::filesystem::rename(path, previous_checkpoint(path), none_yet);
    std::filesystem::rename(fresh, path);
}

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
    head.step = load_numbers(file, "step", {1}, 0, std::int64_t{1} << 62)[0];
    head.time = load<double>(file, "clock", 4)[0];
    return head;
}

template <int D>
OutputProgress read_checkpoint(const std::filesystem::path& path, State<D>& state) {
    const Hdf5Reader file(path);
    const auto clock = load<double>(file, "clock", 4);
    if (!(clock[0] >= 0) || !(clock[1] >= 0) || !(clock[2] > 0) || !(clock[3] >= 0))
        fail(file, "clock", "a time, a step or a wave speed cannot be");
    const auto step = load_numbers(file, "step", {1}, 0, std::int64_t{1} << 62)[0];
    const bool transfers = load_numbers(file, "transfers", {1}, 0, 2)[0] != 0;
    Particles<D> particles = load_particles(file, state.particles, state.grid);
    Tiling<D> tiling = load_tiling(file, particles, state.grid, state.effects.contact);
    SavedTotals totals = load_totals(file, state);
    const auto watch = load<double>(file, "energy_watch", 5);
    if (!(watch[1] >= 0)) fail(file, "energy_watch", "a sum without signs is negative");
    const auto reductions = load_numbers(file, "step_reductions", {1}, 0, most_step_reductions + 1)[0];
    const OutputProgress output = load_output(file);

    state.particles = std::move(particles);
    state.tiling = std::move(tiling);
    state.ledger = totals.ledger;
    state.pair_totals = std::move(totals.pairs);
    state.rigid_totals = std::move(totals.rigid);
    for (std::size_t b = 0; b < state.boundaries.size(); ++b) state.boundaries[b].impulse = totals.impulses[b];
    state.time = clock[0];
    state.dt = clock[1];
    state.largest_wave_speed = clock[2];
    state.since_transfer = clock[3];
    state.transfers = transfers;
    state.step = static_cast<long>(step);
    state.step_reductions = static_cast<int>(reductions);
    state.energy_watch = {watch[0], watch[1], watch[2], watch[3], watch[4]};
    find_traction_particles(state);
    return output;
}

template void write_checkpoint<2>(const std::filesystem::path&, const State<2>&, const OutputProgress&,
                                  const std::string&, std::uint64_t);
template void write_checkpoint<3>(const std::filesystem::path&, const State<3>&, const OutputProgress&,
                                  const std::string&, std::uint64_t);
template OutputProgress read_checkpoint<2>(const std::filesystem::path&, State<2>&);
template OutputProgress read_checkpoint<3>(const std::filesystem::path&, State<3>&);

} // namespace abut
