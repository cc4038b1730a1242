// The command line (contract §1). CLI11 is slow to compile: it stays in this file.
#include "app/commands.h"
#include "scene/problem.h"
#include "scene/suggest.h"

#include <CLI/CLI.hpp>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <functional>
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
    run->add_flag("--overwrite", run_options.overwrite, "replace the results of an earlier run");
    run->add_flag("--quiet", run_options.quiet, "no progress");
    run->callback([&] { action = [&] { return run_command(run_options); }; });

    SceneOptions check_options;
    std::filesystem::path check_png;
    CLI::App* check = program.add_subcommand("check", "Checks a scene and prints what would run; runs nothing");
    add_scene(*check, check_options);
    check->add_option("--png", check_png, "also draws the bodies to this PNG file");
    check->callback([&] { action = [&] { return check_command(check_options, check_png); }; });

    SceneOptions particles_options;
    ParticlesOptions preview;
    CLI::App* particles = program.add_subcommand("particles", "Builds the model only, for a look before a run");
    add_scene(*particles, particles_options);
    particles->add_option("-o,--output", preview.output,
                          "VTU file; default NAME-particles.vtu. The picture is beside it, with .png");
    particles->add_option("--array", preview.render.array, "particle array that colours the picture; default body");
    particles->add_option("--width", preview.render.width, "of the picture [pixels]")->check(CLI::Range(100, 8192));
    particles->add_flag("--no-png", preview.no_picture, "no picture");
    particles->callback([&] { action = [&] { return particles_command(particles_options, preview); }; });

    std::filesystem::path results;
    RenderOptions render_options;
    std::vector<double> range;
    std::vector<int> frames;
    CLI::App* render = program.add_subcommand("render", "Draws a result series as PNG pictures, without a display");
    render->add_option("DIR", results, "result folder")->required();
    std::string presets;
    for (const std::string& name : render_presets()) presets += (presets.empty() ? "" : ", ") + name;
    render->add_option("--preset", render_options.preset, "one of " + presets);
    render->add_option("--array", render_options.array, "particle array that colours the particles");
    render->add_option("--component", render_options.component, "of the array; default its magnitude");
    render->add_flag("--normals", render_options.normals, "arrows at the contact pairs in contact");
    render->add_option("--width", render_options.width, "pixels")->check(CLI::Range(100, 8192));
    render->add_option("--range", range, "LOW HIGH of the colours, SI units")->expected(2);
    render->add_option("--frames", frames, "numbers of the frames to draw; default all");
    render->add_flag("--last", render_options.last_only, "only the last frame");
    render->add_option("-o,--output", render_options.output, "folder of the pictures; default DIR/frames/<preset>");
    render->callback([&] {
        if (!range.empty()) render_options.range = {range[0], range[1]};
        if (!frames.empty()) render_options.frames = frames;
        action = [&] { return render_command(results, render_options); };
    });

    ContactOptions contact_options;
    CLI::App* contact = program.add_subcommand("contact", "Takes a contact node of a result apart, method by method");
    contact->add_option("DIR", contact_options.results, "result folder")->required();
    contact->add_option("--step", contact_options.step,
                        "number of the frame, as in particles_0000N.vtu; default the last");
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
    program.add_subcommand("reference", "Prints the reference of scene files as Markdown")->callback([&] {
        action = reference_command;
    });

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
    try {
        return abut::run_program(argc, argv);
    } catch (const abut::SceneError& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 2;
    } catch (const abut::UsageError& error) {
        std::fprintf(stderr, "abut: %s\n", error.what());
        return 2;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "abut: %s\n", error.what());
        return 1;
    }
}
