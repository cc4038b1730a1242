#pragma once
/// \file render_series.h
/// Result series as pictures, without a display.

#include "io/render/view.h"
#include "results/frame.h"

#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace abut {

struct RenderOptions {
    std::string preset; ///< "bodies", "pressure", "von-mises", "velocity", "normals": sets `array` and `normals`
    std::string array = "body"; ///< particle array that colours the particles
    int component = -1;         ///< of `array`; -1: its magnitude
    bool normals = false;       ///< arrows at the contact pairs in contact, from body_a to body_b
    bool domains = true;        ///< particles as their deformed domains; false: as dots
    int width = 1000;           ///< [pixels]
    int height = 0;             ///< [pixels]; 0: from the proportions of the scene
    std::optional<std::pair<double, double>>
        range;                              ///< of the colours, in the array's SI unit; default: all values drawn
    std::optional<std::vector<int>> frames; ///< which frames of the series, from 0; default all
    bool last_only = false;                 ///< only the last frame
    std::filesystem::path output;           ///< folder of the pictures; default RESULTS/frames/<preset or array>
};

/// What is asked for does not exist or cannot be: a folder without results, an unknown array, preset or frame, a size.
class RenderRequestError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// Draws the frames of `result_dir`/particles.pvd as `frame_00000.png`, …, numbered as in the series; view and colours
/// are the same in all. Plane scenes are seen from above in the box of their grid, others obliquely in the box that the
/// particles of these frames need. Returns the files written. Throws RenderRequestError if the folder, the series, the
/// array, the preset or a frame is not there, naming it and what there is, and std::runtime_error for files that are
/// broken.
std::vector<std::filesystem::path> render_series(const std::filesystem::path& result_dir, const RenderOptions& given);

/// Draws one frame that is in no file yet, as `file` (PNG), which appears whole or not at all. Plane scenes are seen in
/// the box of their grid. Throws RenderRequestError for an unknown array or preset or a size, std::runtime_error if the
/// file can't be written. \param given its normals, frames and output are not used
void render_frame(const PointFrame& frame, const Bounds& grid, const std::string& title, const RenderOptions& given,
                  const std::filesystem::path& file);

/// The names that RenderOptions::preset takes.
const std::vector<std::string>& render_presets();

} // namespace abut
