#pragma once
#include "io/render/live_picture.h"
#include "io/results/csv.h"
#include "io/results/pvd.h"
#include "step/state.h"
#include "step/step.h"

#include <filesystem>
#include <optional>
#include <string>

namespace abut {

/// The result files of a run under way (contract §3).
class RunFiles {
public:
    /// Writes scene.json and opens the tables; the folder is ready (prepare_result_folder).
    template <int D>
    RunFiles(const std::filesystem::path& folder, const std::string& resolved_scene, State<D>& state);

    /// A row of history.csv and the rows of bodies.csv and pairs.csv.
    template <int D>
    void write_history(State<D>& state);
    /// A frame of each series that the scene asks for. \return the interpenetration of bodies, as a fraction of their
    /// area; nothing without contact and in 3D, where it isn't measured
    template <int D>
    std::optional<double> write_frames(State<D>& state);
    /// The particles of a state that has gone wrong, as particles/failed.vtu.
    template <int D>
    void write_failed(const State<D>& state);

private:
    std::filesystem::path folder_;
    CsvTable history_;
    CsvTable bodies_;
    std::optional<CsvTable> pairs_; ///< scenes with contact
    PvdSeries particles_;
    PvdSeries grid_;
    PvdSeries contact_;
    std::optional<LivePicture> live_; ///< scenes that want one
    int frame_ = 0;
    double last_history_ = 0; ///< time of the last row
};

/// What timing.json tells beside the tasks.
struct RunTiming {
    double wall_seconds = 0;
    double cpu_seconds = 0;
    double solver_seconds = 0;
    int threads = 1;
};

template <int D>
void write_timing(const std::filesystem::path& file, const State<D>& state, const std::vector<Task<D>>& tasks,
                  const RunTiming& timing);

} // namespace abut
