#include "app/commands.h"
#include "io/results/pvd.h"
#include "io/results/read_frame.h"
#include "io/results/read_state.h"
#include "io/results/si_prefix.h"
#include "io/results/write_contact_clouds.h"
#include "io/scene/read_scene.h"
#include "io/scene/units.h"
#include "io/scene/words.h"
#include "results/frames.h"
#include "step/run_error.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>
#include <numbers>

namespace abut {

namespace {

constexpr std::size_t most_listed = 20;

/// Number of a frame from the name of its file, particles_00012.vtu; -1 for another name.
int frame_number(const std::string& file) {
    const std::string stem = std::filesystem::path(file).stem().string();
    const std::string digits = stem.substr(stem.find_last_of('_') + 1);
    int number = -1;
    const char* const end = digits.data() + digits.size();
    return std::from_chars(digits.data(), end, number).ptr == end ? number : -1;
}

struct ChosenFrame {
    int number = 0;
    std::filesystem::path file;
};

ChosenFrame choose_frame(const ContactOptions& options) {
    const std::filesystem::path series = options.results / "particles.pvd";
    if (!std::filesystem::is_directory(options.results))
        throw UsageError(fmt::format("{}: no such folder", options.results.string()));
    if (!std::filesystem::is_regular_file(options.results / "scene.json"))
        throw UsageError(fmt::format("{}: no scene.json; is it the result folder of a run?", options.results.string()));
    if (!std::filesystem::is_regular_file(series))
        throw UsageError(
            fmt::format("{}: no particles.pvd, which tells where the particles were", options.results.string()));
    std::vector<ChosenFrame> frames;
    for (const PvdEntry& entry : read_pvd(series).entries)
        if (const int number = frame_number(entry.file); number >= 0)
            frames.push_back({number, options.results / entry.file});
    if (frames.empty()) throw UsageError(fmt::format("{} lists no frames", series.string()));
    if (!options.step) return frames.back();
    const auto found = std::find_if(frames.begin(), frames.end(),
                                    [&](const ChosenFrame& frame) { return frame.number == *options.step; });
    if (found != frames.end()) return *found;
    std::vector<int> numbers;
    std::ranges::transform(frames, std::back_inserter(numbers), &ChosenFrame::number);
    const bool gapless = numbers.back() - numbers.front() + 1 == static_cast<int>(numbers.size());
    throw UsageError(fmt::format("no frame {}; there are {}", *options.step,
                                 gapless ? fmt::format("{} to {}", numbers.front(), numbers.back())
                                         : fmt::format("{}", fmt::join(numbers, ", "))));
}

std::vector<std::string> parts_of(const std::string& text, const char* option, std::size_t count) {
    std::vector<std::string> parts(1);
    for (const char c : text) c == ',' ? void(parts.emplace_back()) : parts.back().push_back(c);
    if (parts.size() != count)
        throw UsageError(fmt::format("{} {}: {} values are needed, with commas between", option, text, count));
    return parts;
}

template <int D>
Index<D> parse_node(const std::string& text) {
    Index<D> node;
    const std::vector<std::string> parts = parts_of(text, "--node", D);
    for (std::size_t a = 0; a < node.size(); ++a) {
        const char* const end = parts[a].data() + parts[a].size();
        const auto [read, error] = std::from_chars(parts[a].data(), end, node[a]);
        if (error != std::errc{} || read != end)
            throw UsageError(fmt::format("--node {}: \"{}\" is no whole number", text, parts[a]));
    }
    return node;
}

template <int D>
Vec<D> parse_place(const std::string& text) {
    Vec<D> place;
    const std::vector<std::string> parts = parts_of(text, "--near", D);
    for (int a = 0; a < D; ++a) {
        const std::string& part = parts[static_cast<std::size_t>(a)];
        const char* const end = part.data() + part.size();
        const auto [read, error] = std::from_chars(part.data(), end, place[a]);
        try { // a plain number is in m
            if (error != std::errc{} || read != end) place[a] = parse_quantity(part, dimensions::length);
        } catch (const UnitError& wrong) {
            throw UsageError(fmt::format("--near {}: {}", text, wrong.what()));
        }
        if (!std::isfinite(place[a])) throw UsageError(fmt::format("--near {}: {} is no place", text, part));
    }
    return place;
}

/// Lengths of one size in a common readable unit.
struct LengthUnit {
    SiPrefix prefix;
    std::string name() const { return fmt::format("{}m", prefix.symbol); }
    std::string operator()(double length, int decimals = 3) const {
        if (!std::isfinite(length)) return "-";
        return fmt::format("{:.{}f}", length / prefix.factor, decimals);
    }
};

/// All places of a grid are in one unit.
template <int D>
std::string place_text(const Grid<D>& grid, const Vec<D>& x) {
    const LengthUnit unit{si_prefix((grid.upper() - grid.lower()).maxCoeff())};
    std::string text = unit(x[0], 4);
    for (int a = 1; a < D; ++a) text += ", " + unit(x[a], 4);
    return fmt::format("{} {}", text, unit.name());
}

template <int D>
std::string node_text(const Index<D>& node) {
    return fmt::format("{}", fmt::join(node, ","));
}

double degrees(double angle) {
    return angle * 180 / std::numbers::pi;
}

template <int D>
void print_disagreements(State<D>& state) {
    const std::vector<Disagreement<D>> all = nodes_in_disagreement(state, 0);
    const LengthUnit unit{si_prefix(0.1 * state.grid.length())};
    if (state.scene.contact->separation == SeparationMethod::none)
        fmt::print("{} contact nodes, all taken as in contact (separation \"none\")", state.contact.groups.size());
    else
        fmt::print("{} contact nodes, {} of them with bodies nearer than a tenth of a cell",
                   state.contact.groups.size(), all.size());
    if (all.empty()) return fmt::print("\n");
    fmt::print("; where the normals of two methods differ most:\n\n  {:<12} {:<28} {:<28} {:>11} {:>16} {:>10}\n",
               "node", "place", "bodies", "differ by", fmt::format("separation [{}]", unit.name()), "particles");
    for (std::size_t i = 0; i < std::min(all.size(), most_listed); ++i) {
        const Disagreement<D>& one = all[i];
        fmt::print("  {:<12} {:<28} {:<28} {:>11} {:>16} {:>10}\n", node_text<D>(one.node),
                   place_text<D>(state.grid, one.position),
                   state.bodies[one.body_a].name + " / " + state.bodies[one.body_b].name,
                   fmt::format("{:.2f} deg", degrees(one.angle)), unit(one.separation), one.cloud_size);
    }
    fmt::print("\nTake one apart with --node {}\n", node_text<D>(all.front().node));
}

template <int D>
void print_point(const State<D>& state, const PointSeen<D>& point) {
    const LengthUnit unit{si_prefix(0.1 * state.grid.length())};
    const auto of_a = std::count_if(point.cloud.begin(), point.cloud.end(),
                                    [&](const ParticleSeen<D>& particle) { return particle.body == point.body_a; });
    fmt::print("\n{} / {}{}: {} + {} particles; lengths in {}\n", state.bodies[point.body_a].name,
               point.lumped ? "all others, as " : "", state.bodies[point.body_b].name, of_a,
               static_cast<std::ptrdiff_t>(point.cloud.size()) - of_a, unit.name());
    fmt::print("  {:<20} {:<{}} {:>10} {:>10} {:>9} {:>9} | {:>14} {:>17} {:>15} {:>12}\n", "", "normal", D * 9,
               "angle", "iterations", "a ends at", "b ends at", "particle-edges", "critical-position",
               "fitted-position", "displacement");
    for (const PlaneSeen<D>& plane : point.planes) {
        std::string normal = "none";
        if (!plane.normal.isZero(0)) {
            normal.clear();
            for (int a = 0; a < D; ++a) // + 0.0: no "-0.00000"
                normal += fmt::format("{:>8.5f} ", std::round(plane.normal[a] * 1e5) / 1e5 + 0.0);
        }
        fmt::print("{} {:<20} {:<{}} {:>10} {:>10} {:>9} {:>9} | {:>14} {:>17} {:>15} {:>12}\n",
                   plane.chosen ? '*' : ' ', text_of(normal_words, plane.method), normal, D * 9,
                   std::isnan(plane.angle) ? "-" : fmt::format("{:.3f} deg", degrees(plane.angle)), plane.iterations,
                   unit(plane.end_a), unit(plane.end_b), unit(plane.separation[0]), unit(plane.separation[1]),
                   unit(plane.separation[2]), unit(plane.separation[3]));
    }
}

/// The node that is asked for, which must be a contact node.
template <int D>
Index<D> chosen_node(const State<D>& state, const ContactOptions& options, int frame) {
    const auto nearest_to = [&](const Vec<D>& place) {
        const std::optional<Index<D>> node = nearest_contact_node<D>(state, place);
        if (!node) throw UsageError(fmt::format("no node of frame {} sees two bodies", frame));
        return *node;
    };
    if (options.near) return nearest_to(parse_place<D>(*options.near));
    const Index<D> node = parse_node<D>(*options.node);
    const auto place_of = [&](Index<D> number) {
        for (std::size_t a = 0; a < number.size(); ++a)
            number[a] = std::clamp(number[a], -grid_margin, state.grid.cells[a] + grid_margin) + grid_margin;
        return state.grid.node_position(number);
    };
    bool inside = true;
    for (std::size_t a = 0; a < node.size(); ++a) inside &= node[a] >= 0 && node[a] <= state.grid.cells[a];
    const Index<D> nearest = nearest_to(place_of(node));
    if (nearest == node) return node;
    std::string limits;
    for (const int cells : state.grid.cells) limits += fmt::format("{}0..{}", limits.empty() ? "" : ", ", cells);
    throw UsageError(
        fmt::format("--node {}: {} in frame {}; the nearest contact node is {}, at {}", *options.node,
                    inside ? "not a contact node"
                           : fmt::format("outside the grid, whose nodes are {}, and not a contact node", limits),
                    frame, node_text<D>(nearest), place_text<D>(state.grid, place_of(nearest))));
}

/// The state of a run at a frame, `look`ed at.
template <int D>
State<D> state_at(const Scene& scene, const std::filesystem::path& file) {
    try {
        State<D> state = read_state<D>(scene, read_points(file, arrays_of_state()));
        look(state);
        return state;
    } catch (const FrameError& error) {
        throw UsageError(fmt::format("{}: {}", file.string(), error.what()));
    } catch (const RunError& error) {
        throw std::runtime_error(
            fmt::format("{}: damaged, or of a run that had diverged: {}", file.string(), error.what()));
    }
}

template <int D>
void take_apart(const ContactOptions& options, const Scene& scene, const ChosenFrame& chosen,
                const std::filesystem::path& folder) {
    State<D> state = state_at<D>(scene, chosen.file);
    const auto print_frame = [&] { fmt::print("frame {}, {}\n", chosen.number, format_time(state.time)); };
    if (!options.node && !options.near) {
        print_frame();
        return print_disagreements(state);
    }
    const Index<D> node = chosen_node(state, options, chosen.number);
    make_node_folder(folder);
    const std::vector<NodeSeen<D>> seen = inspect_contact<D>(state, {node});
    print_frame();
    fmt::print("node {} at {}; normals point from the first body to the second, * is the scene's own\n",
               node_text<D>(node), place_text<D>(state.grid, seen[0].position));
    for (const PointSeen<D>& point : seen[0].points) print_point(state, point);
    const auto files = write_node_files<D>(state, seen, folder, node_file_suffix<D>(chosen.number, node));
    fmt::print("\nwritten: {}, {} and {}\n", files[0].string(), files[1].string(), files[2].string());
}

} // namespace

int contact_command(const ContactOptions& options) {
    const ChosenFrame chosen = choose_frame(options);
    const Scene scene = load_scene(options.results / "scene.json").scene;
    const bool asks = options.node || options.near;
    if (!asks && !options.output.empty()) throw UsageError("-o needs a node to write: --node or --near");
    if (!scene.contact) throw UsageError("the scene has no \"contact\": bodies share one velocity field");
    if (!effects_of(scene).planes)
        throw UsageError("all interfaces of the scene are perfect: no normals and separations are found");
    const bool among_recorded = asks && options.output.empty() && scene.output.contact_clouds;
    if (among_recorded && scene.output.contact.every.value_or(scene.output.every) !=
                              scene.output.particles.every.value_or(scene.output.every))
        throw UsageError(
            "the run recorded clouds for frames of contact, which are not those of particles; name another "
            "folder with -o");
    if (among_recorded && scene.output.single_precision)
        throw UsageError("the run recorded clouds of its particles in double precision, and wrote the particles in "
                         "single precision; name another folder with -o, so that no recorded file is replaced by a "
                         "less precise one");
    const std::filesystem::path folder = options.output.empty() ? options.results / "clouds" : options.output;
    if (asks && std::filesystem::exists(folder) && !std::filesystem::is_directory(folder))
        throw UsageError(fmt::format("{}: is a file; a folder is needed (-o)", folder.string()));
    if (scene.output.single_precision)
        fmt::print(stderr, "abut: the particles were written in single precision: what is found from them differs from "
                           "the run's in about the 7th digit of places\n");
    dimension(scene.analysis) == 3 ? take_apart<3>(options, scene, chosen, folder)
                                   : take_apart<2>(options, scene, chosen, folder);
    return 0;
}

} // namespace abut
