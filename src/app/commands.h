#pragma once
/// \file commands.h
/// The subcommands of the program. Each returns the exit code, and throws for what it cannot do: SceneError and
/// UsageError mean exit code 2, everything else 1.

#include "geometry/packing/draw_ellipses.h"
#include "io/render/render_series.h"

#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace abut {

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
};

struct RunOptions {
    SceneOptions scene;
    std::filesystem::path output;     ///< empty: NAME-results, NAME that of the scene file
    int threads = 0;                  ///< 0: all cores
    std::optional<std::string> until; ///< a time, as in a scene file
    bool overwrite = false;
    bool quiet = false;
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
int render_command(const std::filesystem::path& results, const RenderOptions& options);
int draw_ellipses_command(const std::filesystem::path& output, const EllipseDrawing& drawing,
                          const std::string& material);
int schema_command();
int reference_command();

} // namespace abut
