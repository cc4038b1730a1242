// The command line (contract §1). CLI11 is slow to compile: it stays in this file.
#include "app/commands.h"
#include "scene/problem.h"
#include "scene/suggest.h"

#include <CLI/CLI.hpp>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <functional>
#include <map>
#include <stdexcept>
#include <string>

namespace abut {

namespace {

void add_scene(CLI::App& command, SceneOptions& options) {
    command.add_option("SCENE", options.scene, "scene file (JSON)")->required();
    command.add_option("--set", options.set, "PTR=VALUE: sets a value of the scene by JSON pointer; may be repeated")
        ->type_name("PTR=VALUE")
        ->allow_extra_args(false);
}

void add_render(CLI::App& program, RenderRequest& request, std::vector<double>& range, std::vector<int>& frames,
                std::function<int()>& action) {
    CLI::App* render = program.add_subcommand("render", "Draws a result series as PNG pictures, without a display");
    RenderOptions& options = request.options;
    options.jobs = 0;
    render->add_option("DIR", request.results, "result folder")->required();

    const std::string what = "What is drawn";
    std::string presets;
    for (const std::string& name : render_presets()) presets += (presets.empty() ? "" : ", ") + name;
    render->add_option("--preset", options.preset, "one of " + presets)->group(what);
    render->add_option("--array", options.array, "particle array that colours the particles")->group(what);
    render->add_option("--component", options.component, "of the array, from 0; default its magnitude")->group(what);
    render->add_flag("--normals", options.normals, "arrows at the contact pairs in contact")->group(what);
    const std::map<std::string, ParticleStyle> styles{
        {"domains", ParticleStyle::domains}, {"ellipses", ParticleStyle::ellipses}, {"dots", ParticleStyle::dots}};
    render
        ->add_option("--particles", options.particles,
                     "domains (deformed parallelograms, solids in 3D; default), ellipses (2D) or dots")
        ->transform(CLI::Transformer(styles).description(""))
        ->type_name("STYLE")
        ->group(what);
    render
        ->add_option("--bodies", options.bodies,
                     "NAME,NAME...: only these, and their contacts; also all bodies of one legend entry")
        ->delimiter(',')
        ->type_name("NAMES")
        ->group(what);
    render
        ->add_option("--region", request.region,
                     "X0,Y0,X1,Y1: only this part, e.g. 0.2mm,0,0.6mm,0.4mm; in 3D X0,Y0,Z0,X1,Y1,Z1")
        ->type_name("LENGTHS")
        ->group(what);
    render->add_option("--frames", frames, "numbers of the frames to draw; default all")->group(what);
    render->add_flag("--last", options.last_only, "only the last frame")->group(what);

    const std::string how = "How it looks";
    render->add_option("--range", range, "LOW HIGH of the colours, SI units; default: all values of all frames drawn")
        ->expected(2)
        ->group(how);
    render
        ->add_option("--percentile", options.percentile,
                     "e.g. 99: the largest 1 % of each frame's values don't widen the range of the colours; default 99 "
                     "for presets of stress and energy, else 100")
        ->group(how);
    render->add_option("--width", options.width, "pixels; default 1000")->check(CLI::Range(100, 8192))->group(how);
    render->add_option("--height", options.height, "pixels; default: as the scene needs")
        ->check(CLI::Range(100, 8192))
        ->group(how);
    render
        ->add_flag_callback(
            "--no-legend", [&] { options.legend = false; }, "no names of bodies, no colour bar")
        ->group(how);

    const std::string where = "Where it goes";
    render->add_option("-o,--output", options.output, "folder of the pictures; default DIR/frames/<preset>")
        ->group(where);
    render->add_option("--animation", options.animation, "also all pictures in one file: .ogv, or .apng or .png")
        ->type_name("FILE")
        ->group(where);
    render->add_option("--fps", options.fps, "pictures a second of the animation; default 10")
        ->check(CLI::Range(1, 100))
        ->group(where);
    render->add_option("--jobs", options.jobs, "processes that draw; default: one for each core")
        ->check(CLI::Range(1, 1024))
        ->group(where);
    render->add_flag("--quiet", request.quiet, "no progress, no closing line")->group(where);
    render->callback([&] {
        if (!range.empty()) options.range = {range[0], range[1]};
        if (!frames.empty()) options.frames = frames;
        action = [&] { return render_command(request); };
    });
}

void add_plot(CLI::App& command, std::filesystem::path& results, PlotOptions& options) {
    command.add_option("DIR", results, "result folder")->required();
    command.add_option("-o,--output", options.output, "folder of the pictures; default DIR/plots");
    command.add_option("--columns", options.columns, "of the table, by commas; default the usual ones")
        ->delimiter(',')
        ->allow_extra_args(false);
    command.add_option("--bodies", options.bodies, "names by commas, or all: curves of bodies.csv")
        ->delimiter(',')
        ->allow_extra_args(false);
    command.add_flag("--pairs", options.pairs, "curves of pairs.csv; with --bodies only the pairs that they are in");
    command.add_option("--against", options.against, "column of the axis across; default time");
    command.add_option("--width", options.width, "pixels; default 1200")->check(CLI::Range(200, 8192));
    command.add_option("--height", options.height, "pixels; default 800")->check(CLI::Range(200, 8192));
    command.add_flag("--log-x", options.log_x, "logarithmic axis across");
    command.add_flag("--log-y", options.log_y, "logarithmic axis upwards");
    command.add_option("--title", options.title, "default: the scene's");
}

void add_study(CLI::App& program, StudyOptions& options, std::function<int()>& action) {
    CLI::App* study = program.add_subcommand("study", "Runs a family of scenes and tabulates accuracy against cost");
    study->add_option("STUDY", options.study, "study file (JSON)")->required();
    study->add_option("-o,--output", options.output, "folder of the study; default NAME-results. What is done is kept");
    CLI::Option* list = study->add_flag("--list", options.list, "tell what would be run; run nothing");
    study->add_option("--jobs", options.jobs, "runs at the same time; times are not reliable then")
        ->check(CLI::Range(1, 1024));
    study->add_option("--shard", options.shard, "I/N: only every Nth variant, from the Ith, e.g. 1/2 and 2/2")
        ->type_name("I/N")
        ->excludes(list);
    study->add_option("--merge", options.merge, "take over the runs of these study folders (shards); run nothing")
        ->type_name("DIR...")
        ->excludes(list);
    study->add_flag("--overwrite", options.overwrite, "run everything anew");
    study->add_flag("--quiet", options.quiet, "no progress");
    study->callback([&] { action = [&] { return study_command(options); }; });
}

/// CLI11 would only say that a subcommand is missing.
void check_command_name(const CLI::App& program, int argc, char** argv) {
    if (argc < 2 || argv[1][0] == '-') return;
    std::vector<std::string> names;
    for (const CLI::App* command : program.get_subcommands({})) names.push_back(command->get_name());
    if (std::find(names.begin(), names.end(), argv[1]) != names.end()) return;
    throw UsageError("no command \"" + std::string(argv[1]) + "\"" + did_you_mean(argv[1], names) +
                     " (there are: " + quoted_list(names, "and") + ")");
}

int run_program(int argc, char** argv) {
    CLI::App program("abut: material point contact mechanics that opens in ParaView");
    program.set_version_flag("--version", "abut " ABUT_VERSION);
    program.require_subcommand(1);
    std::function<int()> action;

    RunOptions run_options;
    CLI::App* run = program.add_subcommand("run", "Runs a scene");
    add_scene(*run, run_options.scene);
    run->add_option("-o,--output", run_options.output, "result folder; default NAME-results");
    run->add_option("--threads", run_options.threads, "threads; default all cores")->check(CLI::Range(1, 1024));
    run->add_option("--until", run_options.until, "stop at this time, e.g. 3us (a plain number: seconds)");
    CLI::Option* overwrite =
        run->add_flag("--overwrite", run_options.overwrite, "replace the results of an earlier run");
    run->add_flag("--resume", run_options.resume, "go on from the checkpoint of an earlier run")->excludes(overwrite);
    run->add_option("--steps", run_options.steps, "stop after so many steps, those before --resume included")
        ->check(CLI::PositiveNumber);
    run->add_flag("--quiet", run_options.quiet, "no progress");
    run->add_flag("--count-instructions", run_options.count_instructions,
                  "count the instructions of stepping for timing.json, where the system allows it");
    run->callback([&] { action = [&] { return run_command(run_options); }; });

    SceneOptions check_options;
    std::filesystem::path check_png;
    CLI::App* check = program.add_subcommand("check", "Checks a scene and prints what would run; runs nothing");
    add_scene(*check, check_options);
    check->add_option("--png", check_png, "also draws the bodies to this PNG file");
    check->callback([&] { action = [&] { return check_command(check_options, check_png); }; });

    StudyOptions study_options;
    add_study(program, study_options, action);

    SceneOptions particles_options;
    ParticlesOptions preview;
    CLI::App* particles = program.add_subcommand("particles", "Builds the model only, for a look before a run");
    add_scene(*particles, particles_options);
    particles->add_option("-o,--output", preview.output,
                          "VTU file; default NAME-particles.vtu. The picture is beside it, with .png");
    particles->add_option("--array", preview.render.array, "particle array that colours the picture; default body");
    particles->add_option("--width", preview.render.width, "of the picture [pixels]")->check(CLI::Range(100, 8192));
    particles->add_option("--boundaries", preview.boundaries,
                          "VTP file, written too: walls, velocity conditions and tractions at time 0");
    particles->add_option("--grid", preview.grid, "VTI file, written too: the grid without arrays");
    particles->add_flag("--no-png", preview.no_picture, "no picture");
    particles->callback([&] { action = [&] { return particles_command(particles_options, preview); }; });

    RenderRequest picture;
    std::vector<double> range;
    std::vector<int> frames;
    add_render(program, picture, range, frames, action);

    std::filesystem::path results;
    PlotOptions plot_options;
    CLI::App* plot = program.add_subcommand("plot", "Draws the tables of a run as curves, without a display");
    add_plot(*plot, results, plot_options);
    plot->callback([&] { action = [&] { return plot_command(results, plot_options); }; });

    ContactOptions contact_options;
    CLI::App* contact = program.add_subcommand("contact", "Takes a contact node of a result apart, method by method");
    contact->add_option("DIR", contact_options.results, "result folder")->required();
    contact->add_option("--step,--frame", contact_options.step,
                        "number of the frame (no time step), N of particles_0000N.vtu; default the last");
    CLI::Option* node = contact->add_option("--node", contact_options.node,
                                            "I,J[,K]: the node, by its numbers along the axes from grid/lower");
    contact->add_option("--near", contact_options.near, "X,Y[,Z]: the nearest contact node, e.g. 0.5mm,1mm")
        ->excludes(node);
    contact->add_option("-o,--output", contact_options.output, "folder of the files; default DIR/clouds");
    contact->callback([&] { action = [&] { return contact_command(contact_options); }; });

    PackOptions packing;
    CLI::App* pack = program.add_subcommand("pack", "Packs random grains densely, as a bitmap or as shapes of a scene");
    pack->add_option("FILE", packing.file, "by its name: .png, .bmp or .tif a bitmap, .json a scene of shapes")
        ->required();
    pack->add_option("--grains", packing.grains, "disks, ellipses, polygons or balls");
    pack->add_option("--width", packing.width, "pixels");
    pack->add_option("--height", packing.height, "pixels");
    pack->add_option("--depth", packing.depth, "pixels, of balls");
    pack->add_option("--bodies", packing.bodies, "number of grains");
    pack->add_option("--area-fraction", packing.area_fraction, "of the box that grains fill (balls: of its volume)");
    pack->add_option("--sizes", packing.sizes, "equal, uniform:MIN,MAX or lognormal:SIGMA, relative to each other");
    pack->add_option("--min-aspect", packing.min_aspect, "of ellipses: longer over shorter axis, smallest");
    pack->add_option("--max-aspect", packing.max_aspect, "of ellipses: longer over shorter axis, largest");
    pack->add_option("--gap", packing.gap, "least distance between grains [pixels]");
    pack->add_option("--seed", packing.seed, "of the random numbers")->check(CLI::NonNegativeNumber);
    pack->add_option("--shades", packing.shades, "number of greys; 4: grains that touch still differ");
    pack->add_option(
        "--neighbour-distance", packing.neighbour_distance,
        "grains nearer than this have different greys [pixels]; default: 8, or less if the shades are few");
    pack->add_option("--pixel", packing.pixel, "length of a pixel [m]");
    pack->add_option("--material", packing.material, "name in the legend or the scene");
    pack->add_option("--blur", packing.blur, "micrograph: deviation of the blur [pixels]; all grains have one grey");
    pack->add_option("--noise", packing.noise, "micrograph: deviation of the noise [greys]; all grains have one grey");
    pack->callback([&] { action = [&] { return pack_command(packing); }; });

    program.add_subcommand("schema", "Prints the JSON Schema of scene files")->callback([&] {
        action = schema_command;
    });
    bool of_study = false;
    CLI::App* reference = program.add_subcommand("reference", "Prints the reference of scene files as Markdown");
    reference->add_flag("--study", of_study, "the keys of study files instead");
    reference->callback([&] { action = [&] { return reference_command(of_study); }; });

    check_command_name(program, argc, argv);
    try {
        program.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return program.exit(error) == 0 ? 0 : 2;
    }
    const int exit_code = action();
    if (std::fflush(stdout) != 0)
        throw std::runtime_error(std::string("cannot write the output: ") + std::strerror(errno));
    return exit_code;
}

/// Makes OpenMP's threads sleep while they wait for one another, unless the user's environment chooses otherwise. GNU's
/// default, to spin, is a little faster when no other program runs, but many times slower when cores are shared. The
/// library reads its settings before main, so the program starts itself again.
void wait_asleep(char** argv) {
    for (const char* chosen : {"OMP_WAIT_POLICY", "GOMP_SPINCOUNT"})
        if (std::getenv(chosen) != nullptr) return; // NOLINT(concurrency-mt-unsafe): no threads yet
    if (setenv("OMP_WAIT_POLICY", "passive", 1) == 0) execv("/proc/self/exe", argv); // comes back only if it can't
}

} // namespace

} // namespace abut

int main(int argc, char** argv) {
    abut::wait_asleep(argv);
    std::signal(SIGXFSZ, SIG_IGN); // a file over the limit (ulimit -f) is then reported as a write that failed
    try {
        return abut::run_program(argc, argv);
    } catch (const abut::SceneError& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 2;
    } catch (const abut::UsageError& error) {
        std::fprintf(stderr, "abut: %s\n", error.what());
        return 2;
    } catch (const std::filesystem::filesystem_error& error) { // its own words are for programmers
        const std::filesystem::path& file = error.path2().empty() ? error.path1() : error.path2();
        std::fprintf(stderr, "abut: %s: %s\n", file.c_str(), error.code().message().c_str());
        return 1;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "abut: %s\n", error.what());
        return 1;
    }
}
