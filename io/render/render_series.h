#pragma once
/// \file render_series.h
/// Result series as pictures, without a display.

#include "io/render/view.h"
#include "results/frame.h"

#include <filesystem>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace abut {

/// How particles are drawn: as their deformed domains (solids in space), as the ellipses inscribed in these (in the
/// plane only) or as dots.
enum class ParticleStyle { domains, ellipses, dots };

struct RenderOptions {
    std::string preset;         ///< one of render_presets(): sets `array`, `normals` and `separations`
    std::string array = "body"; ///< particle array that colours the particles
    int component = -1;         ///< of `array`; -1: its magnitude
    bool normals = false;       ///< arrows at the contact pairs in contact, from body_a to body_b
    bool separations = false;   ///< arrows at all contact pairs, coloured by separation
    ParticleStyle particles = ParticleStyle::domains;
    bool legend = true; ///< names of bodies, or the colour bar
    int width = 1000;   ///< [pixels]
    int height = 0;     ///< [pixels]; 0: from the proportions of the scene
    std::optional<std::pair<double, double>>
        range; ///< of the colours, in the SI unit of the array or of separations; default: all values drawn
    /// [%] In each frame, values beyond this percentile, and below the same from the other end if there are negative
    /// ones, don't widen the range of the colours. Default: 100, but 99 for the presets of stress and energy.
    std::optional<double> percentile;
    std::vector<double> region;      ///< part of the scene to show, lower corner then upper [m]; 4 numbers, in space 6
    std::vector<std::string> bodies; ///< to draw; default all. Contact pairs of which a body is drawn are, too
    std::optional<std::vector<int>> frames; ///< which frames of the series, from 0; default all
    bool last_only = false;                 ///< only the last frame
    std::filesystem::path output;    ///< folder of the pictures; default RESULTS/frames/NAME, NAME being the preset or
                                     ///< what it would be called: bodies, normals, or the array
    std::filesystem::path animation; ///< also all pictures as one file: .ogv, or .apng or .png; default none
    int fps = 10;                    ///< pictures a second of the animation
    int jobs = 1;                    ///< processes that draw; pictures don't depend on it
    std::function<void(int done, int total)> progress; ///< called after each picture
    std::function<void(const std::string&)> note;      ///< called, before the first picture, with what is left out
};

/// What is asked for does not exist or cannot be: a folder without results, an unknown array, preset or frame, a size.
class RenderRequestError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// Draws the frames of `result_dir`/particles.pvd as `frame_00000.png`, …, numbered as in the series; view and colours
/// are the same in all. Plane scenes are seen from above in the box of their grid, others obliquely in the box that the
/// particles of these frames need. Where contact pairs are drawn, frames without any at their time are left out, or
/// refused if they were asked for by number. Returns the files written, the animation last. Throws RenderRequestError
/// if the folder, the series, the array, the preset, a body or a frame is not there, naming it and what there is, and
/// std::runtime_error for files that are missing or broken. Nothing has been written if a request was wrong or a file
/// is missing or cut off; one that is broken within may only be found after pictures of others. With several jobs it
/// forks: no other thread may hold locks then. Where this process has drawn already it draws by itself.
std::vector<std::filesystem::path> render_series(const std::filesystem::path& result_dir, const RenderOptions& given);

/// Draws one frame that is in no file yet, as `file` (PNG), which appears whole or not at all. Plane scenes are seen in
/// the box of their grid. Throws RenderRequestError for an unknown array or preset or a size, std::runtime_error if the
/// file can't be written. \param given its normals, separations, frames and output are not used
void render_frame(const PointFrame& frame, const Bounds& grid, const std::string& title, const RenderOptions& given,
                  const std::filesystem::path& file);

/// The names that RenderOptions::preset takes.
const std::vector<std::string>& render_presets();

} // namespace abut
