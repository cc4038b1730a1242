#pragma once
/// \file commands.h
/// The subcommands of the program. Each returns the exit code, and throws for what it cannot do: SceneError and
/// UsageError mean exit code 2, everything else 1.

#include "io/render/plot_results.h"
#include "io/render/render_series.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace abut {

struct Scene;

template <int D>
struct State;

/// The command line is wrong in a way that CLI11 can't see.
class UsageError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

struct SceneOptions {
    std::filesystem::path scene;
    std::vector<std::string> set; ///< "PTR=VALUE"
};

struct ParticlesOptions {
    std::filesystem::path output; ///< empty: NAME-particles.vtu, NAME that of the scene file
    RenderOptions render;         ///< of the picture beside it
    bool no_picture = false;
    std::filesystem::path boundaries; ///< .vtp to write them to; empty: not written
    std::filesystem::path grid;       ///< .vti, likewise
};

struct RunOptions {
    SceneOptions scene;
    std::filesystem::path output;     ///< empty: NAME-results, NAME that of the scene file
    int threads = 0;                  ///< 0: all cores
    std::optional<std::string> until; ///< a time, as in a scene file
    std::optional<long> steps;        ///< of the whole run, at most
    bool overwrite = false;
    bool resume = false; ///< goes on from the checkpoint in `output`
    bool quiet = false;
    bool count_instructions = false; ///< of stepping, into timing.json
};

struct StudyOptions {
    std::filesystem::path study;
    std::filesystem::path output;             ///< empty: NAME-results, NAME that of the study file
    int jobs = 1;                             ///< runs at the same time
    std::string shard;                        ///< "I/N": every Nth variant, from the Ith; empty: all
    std::vector<std::filesystem::path> merge; ///< study folders whose runs are taken over; nothing is run then
    bool list = false;                        ///< only tells what would be run
    bool overwrite = false;                   ///< runs all anew
    bool quiet = false;
};

struct RenderRequest {
    std::filesystem::path results;
    RenderOptions options; ///< its jobs 0: one for each core
    std::string region;    ///< lengths, with units or in m, separated by commas; empty: everything
    bool quiet = false;
};

struct ContactOptions {
    std::filesystem::path results;   ///< result folder
    std::optional<int> step;         ///< number of the frame, as in the names of its files; the last if not given
    std::optional<std::string> node; ///< "I,J" or "I,J,K"
    std::optional<std::string> near; ///< "X,Y" or "X,Y,Z", lengths as in a scene file
    std::filesystem::path output;    ///< empty: RESULTS/clouds
};

/// What isn't given is chosen by the kind of grains.
struct PackOptions {
    std::filesystem::path file; ///< its extension says what is written
    std::string grains = "ellipses";
    std::optional<int> width, height, depth; ///< [pixels]
    int bodies = 20;
    std::optional<double> area_fraction;
    std::optional<std::string> sizes;
    std::optional<double> min_aspect, max_aspect;
    double gap = 0; ///< [pixels]
    std::uint64_t seed = 1;
    std::optional<int> shades;
    std::optional<double> neighbour_distance; ///< [pixels]
    std::optional<double> pixel;              ///< [m]
    std::string material = "aluminium";
    std::optional<double> blur, noise;
};

/// Refuses a scene that only shows to be wrong once its particles are there: SceneError with the problems of
/// check_state() (see step/check_state.h).
template <int D>
void check_start(State<D>& state, const std::filesystem::path& scene);

/// Tells on stderr what the scene's author may want to know; see advice().
void print_advice(const Scene& scene, const std::filesystem::path& file);

int run_command(const RunOptions& options);
/// \param png where to draw the bodies; empty: nowhere
int check_command(const SceneOptions& options, const std::filesystem::path& png);
int particles_command(const SceneOptions& options, ParticlesOptions preview);
int study_command(const StudyOptions& options);
int render_command(const RenderRequest& request);
int plot_command(const std::filesystem::path& results, const PlotOptions& options);
int contact_command(const ContactOptions& options);
int pack_command(const PackOptions& options);
int schema_command();
/// \param study of study files, not of scenes
int reference_command(bool study);

} // namespace abut
