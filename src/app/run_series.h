#pragma once
#include "app/schedule.h"
#include "io/checkpoint/checkpoint.h"
#include "io/results/pvd.h"
#include "results/frames.h"
#include "step/state.h"

#include <array>
#include <filesystem>
#include <string>

namespace abut {

/// Which series get a frame: those whose next one is due, or all that don't have the present state yet.
enum class Frames { due, last };

/// One series of a run under way.
struct RunSeries {
    std::string name;      ///< of its folder and of its .pvd file
    std::string extension; ///< of its files
    PvdSeries pvd;
    Schedule schedule;
    bool wanted = true;
    FrameChoice choice;
    int frames = 0;        ///< written so far
    double last_time = -1; ///< of the last of them [s]
};

/// Those of a run at its start: particles, grid, contact.
template <int D>
std::array<RunSeries, 3> series_of(const std::filesystem::path& folder, const State<D>& state);

/// File of a frame, relative to the result folder.
std::string frame_file(const RunSeries& series, std::size_t number);

/// Whether a series gets a frame at this time; if it does, its schedule moves on.
bool gets_frame(RunSeries& series, double time, Frames which);

/// What an earlier part of the run has written of a series, whether it is wanted further or not; nothing if it is not
/// and is gone. Changes nothing. Throws std::runtime_error if the files are not as that part left them.
PvdSeries written_so_far(const RunSeries& series, const SeriesProgress& progress);

/// The series goes on after its first frames; files of later ones are removed. One that is not wanted now may be later
/// again.
void resume(RunSeries& series, const SeriesProgress& progress, double time);

} // namespace abut
