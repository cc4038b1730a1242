#pragma once
/// \file progress.h
/// What the user sees while a run goes on.

#include <chrono>
#include <cstdint>
#include <cstdio>
#include <string>
#include <string_view>

namespace abut {

enum class ProgressMode {
    automatic, ///< `bar` on a terminal, else `lines`
    bar,       ///< one line, redrawn in place
    lines,     ///< a line for each note
    quiet      ///< nothing
};

/// Reports how far a run is: percent, simulated time, steps a second, time to go.
/// If it is destroyed unfinished (an error is on its way up), the bar's line is ended so that messages start on a new
/// one.
class Progress {
public:
    /// `end_time` in seconds of the simulation. The first update is where speed is measured from.
    Progress(ProgressMode mode, double end_time, std::FILE* out = stderr);
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;
    ~Progress();

    void update(std::int64_t step, double time); ///< call at each step: redraws ten times a second, else costs a clock
    void note(std::string_view text);            ///< a line of its own, with the percentage, time and step before it
    void warn(std::string_view text);            ///< a line of its own, also if quiet
    void finish();                               ///< the bar as it ends, and steps, wall time and speed in one line

private:
    using Clock = std::chrono::steady_clock;

    void draw();

    ProgressMode mode_;
    double end_time_;
    std::FILE* out_;
    bool started_ = false, finished_ = false, line_open_ = false;
    std::int64_t first_step_ = 0, step_ = 0, drawn_step_ = 0;
    double time_ = 0, drawn_time_ = 0;
    double step_rate_ = 0, time_rate_ = 0; ///< per second of wall time, smoothed
    Clock::time_point start_, drawn_;
};

} // namespace abut
