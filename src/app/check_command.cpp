#include "app/commands.h"
#include "geometry/build_model.h"
#include "io/results/si_prefix.h"
#include "io/results/write_frame.h"
#include "io/scene/read_scene.h"
#include "plan/fields.h"
#include "results/frames.h"
#include "scene/problem.h"
#include "scene/validate.h"
#include "step/step.h"

#include <fmt/format.h>

#include <cmath>

namespace abut {

void print_advice(const Scene& scene, const std::filesystem::path& file) {
    for (const Problem& problem : advice(scene))
        fmt::print(stderr, "{}: {}: advice: {}\n", file.string(), problem.pointer, problem.message);
}

namespace {

State<2> load_state(const SceneOptions& options) {
    const LoadedScene loaded = load_scene(options.scene, options.set);
    print_advice(loaded.scene, options.scene);
    return make_state<2>(loaded.scene, build_model(loaded.scene, options.scene.string()));
}

std::size_t count_of(const State<2>& state, const std::string& place) {
    if (place == "particle") return state.particles.size();
    if (place == "stencil entry") return state.stencil_store.S.size();
    return place == "slot" ? state.fields.size() : state.contact.groups.size();
}

} // namespace

void check_first_step(const State<2>& state, const std::filesystem::path& scene) {
    const std::optional<double>& step = state.scene.time.step;
    const double stable = stable_step(state);
    if (!step || *step <= stable) return;
    throw SceneError(scene.string(), {{"/time/step", fmt::format("{} is above the stable step, {} (cell / wave speed)",
                                                                 format_time(*step), format_time(stable))}});
}

int check_command(const SceneOptions& options) {
    State<2> state = load_state(options);
    check_first_step(state, options.scene);
    look(state);
    const double dt = next_step(state, state.scene.time.end);

    fmt::print("{}\n\n", state.scene.title.empty() ? options.scene.string() : state.scene.title);
    fmt::print("{} bodies, {} particles; {} x {} cells of {:.6g} x {:.6g} m\n", state.bodies.size(),
               state.particles.size(), state.grid.cells[0], state.grid.cells[1], state.grid.cell[0],
               state.grid.cell[1]);
    fmt::print("{} slots (a body at a node), {} nodes see several bodies\n", state.fields.size(),
               state.fields.contact_nodes.size());
    fmt::print("wave speed {:.4g} m/s, stable step {}, time step {}{}, about {:.0f} steps to {}\n\n",
               state.largest_wave_speed, format_time(stable_step(state)), format_time(dt),
               state.scene.time.step ? " (fixed)" : " (follows the wave speed)", std::ceil(state.scene.time.end / dt),
               format_time(state.scene.time.end));

    fmt::print("A step:\n");
    for (const Task<2>& task : step_tasks<2>(state.scene)) fmt::print("  {:<36} {}\n", task.name, task.reason);

    fmt::print("\nFields:\n");
    double total = 0;
    for (const Field& field : fields_of<2>(state.effects)) {
        const auto bytes = static_cast<double>(field.bytes_each * count_of(state, field.place));
        total += bytes;
        fmt::print("  {:>9.2f} MB {:>5} bytes a {:<13} {} ({})\n", bytes / 1e6, field.bytes_each, field.place,
                   field.name, field.reason);
    }
    fmt::print("  {:>9.2f} MB together\n", total / 1e6);
    return 0;
}

int particles_command(const SceneOptions& options, std::filesystem::path output) {
    const State<2> state = load_state(options);
    if (output.empty()) output = options.scene.stem().string() + "-particles.vtu";
    write_particles(output, particle_frame(state));
    std::vector<double> area(state.bodies.size(), 0);
    std::vector<std::size_t> count(state.bodies.size(), 0);
    for (std::size_t p = 0; p < state.particles.size(); ++p) {
        area[state.particles.body[p]] += 4 * state.particles.half_size[p].prod();
        ++count[state.particles.body[p]];
    }
    fmt::print("{:<24} {:>10} {:>14}\n", "body", "particles", "area [m^2]");
    for (std::size_t b = 0; b < area.size(); ++b)
        fmt::print("{:<24} {:>10} {:>14.6g}\n", state.bodies[b].name, count[b], area[b]);
    fmt::print("written: {}\n", output.string());
    return 0;
}

} // namespace abut
