#pragma once
/// \file plot_results.h
/// The tables of a run as figures.

#include <filesystem>
#include <string>
#include <vector>

namespace abut {

struct PlotOptions {
    std::filesystem::path output;     ///< folder of the pictures; empty: RESULTS/plots
    std::vector<std::string> columns; ///< of the table; empty: the usual ones
    std::vector<std::string> bodies;  ///< names: bodies.csv instead of history.csv; "all": every body
    bool pairs = false;               ///< pairs.csv instead; with `bodies` the pairs that these are in
    std::string against = "time";     ///< column of the axis across
    int width = 1200, height = 800;   ///< [pixels]
    bool log_x = false, log_y = false;
    std::string title; ///< empty: the scene's
};

struct PlotOutcome {
    std::vector<std::filesystem::path> files;
    std::vector<std::string> notes; ///< what was left out, and why
};

/// Draws tables of a result folder. By default energies.png, stresses.png, forces.png and momentum.png of history.csv,
/// those that have anything to show; with columns one picture of them for each unit; with bodies or pairs one picture
/// for each column, with a curve for each body or pair. The run may still be writing: whole rows are drawn. Throws
/// RenderRequestError (render_series.h) if the folder, the table, a column or a body is not there, naming it and what
/// there is, and std::runtime_error for files that are broken or can't be written.
PlotOutcome plot_results(const std::filesystem::path& result_dir, const PlotOptions& options);

} // namespace abut
