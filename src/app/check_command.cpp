#include "app/commands.h"
#include "geometry/build_model.h"
#include "io/render/render_series.h"
#include "io/results/si_prefix.h"
#include "io/results/write_frame.h"
#include "io/scene/read_scene.h"
#include "plan/fields.h"
#include "plan/time_step.h"
#include "results/boundary_frame.h"
#include "results/frames.h"
#include "scene/input_files.h"
#include "scene/problem.h"
#include "scene/validate.h"
#include "step/check_state.h"
#include "step/step.h"

#include <fmt/format.h>

#include <cmath>

namespace abut {

void print_advice(const Scene& scene, const std::filesystem::path& file) {
    for (const Problem& problem : advice(scene))
        fmt::print(stderr, "{}: {}: advice: {}\n", file.string(), problem.pointer, problem.message);
}

template <int D>
void check_start(State<D>& state, const std::filesystem::path& scene) {
    std::vector<Problem> problems = check_state(state);
    if (!problems.empty()) throw SceneError(scene.string(), std::move(problems));
}

template void check_start<2>(State<2>&, const std::filesystem::path&);
template void check_start<3>(State<3>&, const std::filesystem::path&);

namespace {

template <int D>
std::size_t count_of(const State<D>& state, const std::string& place) {
    if (place == "particle") return state.particles.size();
    if (place == "stencil entry") return state.stencil_store.S.size();
    return place == "slot" ? state.fields.size() : state.contact.groups.size();
}

/// "40 x 20 cells of 1 x 1 m".
template <int D>
std::string describe(const Grid<D>& grid) {
    std::string cells = fmt::format("{}", grid.cells[0]);
    std::string sizes = fmt::format("{:.6g}", grid.cell[0]);
    for (int a = 1; a < D; ++a) {
        cells += fmt::format(" x {}", grid.cells[a]);
        sizes += fmt::format(" x {:.6g}", grid.cell[a]);
    }
    return fmt::format("{} cells of {} m", cells, sizes);
}

/// Where the time step comes from.
std::string describe_choice(const Scene& scene) {
    if (scene.time.step) return " (fixed)";
    const double limit = cfl_limit(scene);
    if (scene.time.cfl <= limit) return fmt::format(" (cfl {:g}, follows the wave speed)", scene.time.cfl);
    return fmt::format(" (cfl {:.3g}, not {:g}: more is unstable with fmpm of order {} and this shape)", limit,
                       scene.time.cfl, scene.method.transfer.order);
}

/// How far the time step is from the largest one that carries the springs of the contact laws.
void print_interfaces(const Scene& scene, double dt) {
    const auto print = [&](const std::string& pointer, const LawSpec& law) {
        const double stiffness = largest_stiffness(law);
        if (stiffness == 0) return;
        const double limit = interface_step_limit(scene, stiffness);
        fmt::print(
            "{}: springs of up to {:.4g} Pa/m; steps below {} carry them at full nodes (κΔt < π/2; here {:.3g})\n\n",
            pointer, stiffness, format_time(limit), 0.5 * M_PI * dt / limit);
    };
    print("/contact/law", scene.contact->law);
    for (std::size_t i = 0; i < scene.contact->laws.size(); ++i)
        print(fmt::format("/contact/laws/{}/law", i), scene.contact->laws[i].law);
}

template <int D>
void print_plan(State<D>& state, const SceneOptions& options) {
    check_start(state, options.scene);
    look(state);
    const double dt = next_step(state, state.scene.time.end);

    fmt::print("{}\n\n", state.scene.title.empty() ? options.scene.string() : state.scene.title);
    fmt::print("{} bodies, {} particles; {}\n", state.bodies.size(), state.particles.size(), describe(state.grid));
    fmt::print("{} slots (a body at a node), {} nodes see several bodies\n", state.fields.size(),
               state.fields.contact_nodes.size());
    fmt::print("wave speed {:.4g} m/s, stable step {}, time step {}{}, about {:.0f} steps to {}\n\n",
               state.largest_wave_speed, format_time(stable_step(state)), format_time(dt), describe_choice(state.scene),
               std::ceil(state.scene.time.end / dt), format_time(state.scene.time.end));

    if (state.scene.contact) print_interfaces(state.scene, dt);
    fmt::print("A step:\n");
    for (const Task<D>& task : step_tasks<D>(state.scene)) fmt::print("  {:<36} {}\n", task.name, task.reason);

    fmt::print("\nFields:\n");
    double total = 0;
    for (const Field& field : fields_of<D>(state.effects)) {
        const auto bytes = static_cast<double>(field.bytes_each * count_of(state, field.place));
        total += bytes;
        fmt::print("  {:>9.2f} MB {:>5} bytes a {:<13} {} ({})\n", bytes / 1e6, field.bytes_each, field.place,
                   field.name, field.reason);
    }
    fmt::print("  {:>9.2f} MB together\n", total / 1e6);
}

/// The box of the scene's grid.
Bounds grid_box(const Scene& scene) {
    return {scene.grid.lower, scene.grid.upper};
}

/// Refuses to write where the scene or what it names lies.
void check_output(const std::filesystem::path& output, const SceneOptions& options, const Scene& scene) {
    std::vector<std::filesystem::path> inputs = input_files(scene);
    inputs.push_back(options.scene);
    for (const std::filesystem::path& input : inputs) {
        std::error_code ignored;
        if (std::filesystem::equivalent(output, input, ignored))
            throw UsageError(
                fmt::format("\"{}\" is a file that the scene uses; it would be overwritten", output.string()));
    }
}

/// Refuses a further file whose name has not the extension that ParaView would need.
void check_extra(const std::filesystem::path& file, const char* option, const char* extension,
                 const SceneOptions& options, const Scene& scene) {
    if (file.empty()) return;
    if (file.extension() != extension)
        throw UsageError(fmt::format("{} {}: the name must end in {}", option, file.string(), extension));
    check_output(file, options, scene);
}

template <int D>
void draw(const State<D>& state, const RenderOptions& options, const std::filesystem::path& file) {
    try {
        render_frame(particle_frame(state), grid_box(state.scene), state.scene.title, options, file);
    } catch (const RenderRequestError& error) {
        throw UsageError(error.what());
    }
}

/// Builds the state of a scene in its number of dimensions and hands it on.
template <class Use>
int with_state(const SceneOptions& options, ModelReport* report, Use&& use) {
    const LoadedScene loaded = load_scene(options.scene, options.set);
    print_advice(loaded.scene, options.scene);
    const Model model = build_model(loaded.scene, options.scene.string(), report);
    if (const std::string advice = size_advice(model, loaded.scene.grid); !advice.empty())
        fmt::print(stderr, "{}: advice: {}\n", options.scene.string(), advice);
    if (report)
        for (const std::string& warning : warnings_of(*report))
            fmt::print(stderr, "{}: advice: {}\n", options.scene.string(), warning);
    if (dimension(loaded.scene.analysis) == 3) {
        State<3> state = make_state<3>(loaded.scene, model);
        use(state);
    } else {
        State<2> state = make_state<2>(loaded.scene, model);
        use(state);
    }
    return 0;
}

} // namespace

int check_command(const SceneOptions& options, const std::filesystem::path& png) {
    return with_state(options, nullptr, [&](auto& state) {
        if (!png.empty()) check_output(png, options, state.scene);
        print_plan(state, options);
        if (png.empty()) return;
        draw(state, {}, png);
        fmt::print("\nwritten: {}\n", png.string());
    });
}

int particles_command(const SceneOptions& options, ParticlesOptions preview) {
    if (preview.output.empty()) preview.output = options.scene.stem().string() + "-particles.vtu";
    ModelReport report;
    return with_state(options, &report, [&](auto& state) {
        if (preview.output.extension() != ".vtu")
            throw UsageError(
                fmt::format("-o {}: the name must end in .vtu; the picture is put beside it", preview.output.string()));
        check_extra(preview.boundaries, "--boundaries", ".vtp", options, state.scene);
        check_extra(preview.grid, "--grid", ".vti", options, state.scene);
        const std::filesystem::path picture = std::filesystem::path(preview.output).replace_extension(".png");
        check_output(preview.output, options, state.scene);
        if (!preview.no_picture) check_output(picture, options, state.scene);
        fmt::print("{}", table_of(report, static_cast<std::size_t>(dimension(state.scene.analysis))));
        for (const std::string& note : report.notes) fmt::print("{}\n", note);
        write_particles(preview.output, particle_frame(state));
        if (!preview.boundaries.empty()) write_cells(preview.boundaries, boundary_frame(state));
        if (!preview.grid.empty()) write_grid(preview.grid, empty_grid_frame(state));
        if (!preview.no_picture) draw(state, preview.render, picture);
        fmt::print("written: {}", preview.output.string());
        for (const std::filesystem::path& file : {preview.boundaries, preview.grid})
            if (!file.empty()) fmt::print(", {}", file.string());
        fmt::print("{}\n", preview.no_picture ? "" : " and " + picture.string());
    });
}

} // namespace abut
