#pragma once
#include "app/run_series.h"
#include "io/checkpoint/checkpoint.h"
#include "io/render/live_picture.h"
#include "io/results/csv.h"
#include "io/results/write_contact_clouds.h"
#include "io/results/write_frame.h"
#include "results/frames.h"
#include "results/history.h"
#include "step/state.h"
#include "step/step.h"

#include <array>
#include <filesystem>
#include <optional>
#include <string>

namespace abut {

/// The result files of a run under way (contract §3).
class RunFiles {
public:
    /// Writes scene.json and opens the tables; the folder is ready (prepare_result_folder).
    /// \param resumed where the output of the run that this one continues was: rows and frames after it are removed.
    /// Throws std::runtime_error, before anything is changed, if the files are not those of this run.
    template <int D>
    RunFiles(const std::filesystem::path& folder, const std::string& resolved_scene, State<D>& state,
             const OutputProgress* resumed = nullptr);
    /// Where the output is; without the schedule of the tables, which is not kept here.
    OutputProgress progress() const;

    /// A row of history.csv and the rows of bodies.csv and pairs.csv. \return totals of the bodies that deform
    template <int D>
    Totals write_history(State<D>& state);
    /// A frame of each series that gets one, and all.pvd. \return false if none got one
    template <int D>
    bool write_frames(State<D>& state, Frames which);
    /// Whether write_frames() of what is due has anything to do.
    bool is_due(double time) const;
    /// The interpenetration of bodies in the frame of particles just written, if one was, as a fraction of their area;
    /// nothing without contact and in 3D, where it isn't measured.
    std::optional<double> interpenetration() const { return interpenetration_; }
    /// The particles of a state beside the series: particles/NAME.vtu, failed or last_good. \return the file
    template <int D>
    std::filesystem::path write_apart(const State<D>& state, const std::string& name);
    /// "results/particles/particles_00012.vtu (2.1e-06 s)", the last frame of particles; empty if there is none.
    std::string last_frame() const;
    /// Waits until the rows of the tables are on the disk, as frames are.
    void sync_tables();

private:
    RunSeries& particles() { return series_[0]; }
    RunSeries& grid() { return series_[1]; }
    RunSeries& contact() { return series_[2]; }

    void write_all_pvd() const;

    std::filesystem::path folder_;
    Reals reals_ = Reals::float64;
    std::array<RunSeries, 3> series_;
    std::optional<CsvTable> history_; ///< opened once it is clear that all files fit; from then on they are there
    std::optional<CsvTable> bodies_;
    std::optional<CsvTable> pairs_; ///< scenes with contact
    CloudSeries clouds_;            ///< scenes that take contact nodes apart
    std::optional<double> interpenetration_;
    std::optional<LivePicture> live_; ///< scenes that want one
    Schedule live_schedule_;          ///< when it is drawn: as the particles would be written
    double live_time_ = -1;           ///< of the last one [s]
    double last_history_ = 0;         ///< time of the last row
};

/// What timing.json tells beside the tasks.
struct RunTiming {
    double wall_seconds = 0;
    double cpu_seconds = 0;
    double solver_seconds = 0;             ///< stepping
    double output_seconds = 0;             ///< making and writing frames and rows
    double solver_cpu_seconds = 0;         ///< CPU time of all threads while stepping
    long resumed_at_step = 0;              ///< the steps before are not in these times
    long abandoned_steps = 0;              ///< given up after trouble
    long long node_updates = 0;            ///< slots of all steps
    long long particle_sweeps = 0;         ///< sweeps_of_step() of all particles and steps
    std::optional<long long> instructions; ///< of stepping
    std::string trouble;                   ///< what ended the run; empty: nothing
    int threads = 1;
};

template <int D>
void write_timing(const std::filesystem::path& file, const State<D>& state, const std::vector<Task<D>>& tasks,
                  const RunTiming& timing);

} // namespace abut
