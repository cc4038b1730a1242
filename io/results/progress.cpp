#include "io/results/progress.h"

#include "io/results/bar.h"
#include "io/results/si_prefix.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <unistd.h>

namespace abut {
namespace {

constexpr double redraw_every = 0.1; // [s]
constexpr double smoothing_time = 3; // of the speed shown [s]

double seconds(std::chrono::steady_clock::duration duration) {
    return std::chrono::duration<double>(duration).count();
}

std::string format_rate(double rate) {
    const SiPrefix prefix = rate >= 1e4 ? si_prefix(rate) : SiPrefix{};
    return fmt::format("{:.{}f}{} steps/s", rate / prefix.factor, rate < 10 ? 1 : 0, prefix.symbol);
}

ProgressMode resolved(ProgressMode mode, std::FILE* out) {
    if (mode != ProgressMode::automatic) return mode;
    return isatty(fileno(out)) ? ProgressMode::bar : ProgressMode::lines;
}

double fraction(double time, double end) {
    return end > 0 ? std::clamp(time / end, 0.0, 1.0) : 0.0;
}

/// Rounded down: 100 % means the end.
int percent(double time, double end) {
    return static_cast<int>(100 * fraction(time, end) * (1 + 1e-12));
}

} // namespace

Progress::Progress(ProgressMode mode, double end_time, std::FILE* out)
    : mode_(resolved(mode, out)), end_time_(end_time), out_(out), start_(Clock::now()), drawn_(start_) {}

Progress::~Progress() {
    if (line_open_) std::fputc('\n', out_);
}

void Progress::update(std::int64_t step, double time) {
    step_ = step;
    time_ = time;
    const Clock::time_point now = Clock::now();
    if (!started_) {
        started_ = true;
        first_step_ = drawn_step_ = step;
        drawn_time_ = time;
        start_ = drawn_ = now;
        return;
    }
    const double passed = seconds(now - drawn_);
    if (passed < redraw_every) return;
    // Exponential mean over the last seconds; from the start on it is the plain mean.
    const double weight = std::max(1 - std::exp(-passed / smoothing_time), passed / seconds(now - start_));
    step_rate_ += weight * (static_cast<double>(step - drawn_step_) / passed - step_rate_);
    time_rate_ += weight * ((time - drawn_time_) / passed - time_rate_);
    drawn_ = now;
    drawn_step_ = step;
    drawn_time_ = time;
    if (mode_ == ProgressMode::bar) draw();
}

void Progress::draw() {
    const double left = time_rate_ > 0 ? (end_time_ - time_) / time_rate_ : INFINITY;
    const std::string text =
        fmt::format(" {:3} %  {}  {}  ETA {}", percent(time_, end_time_), format_time_of(time_, end_time_),
                    format_rate(step_rate_), format_duration(left));
    fmt::print(out_, "\r{}\x1b[K", bar_line(fraction(time_, end_time_), text, columns(out_)));
    std::fflush(out_);
    line_open_ = true;
}

void Progress::note(std::string_view text) {
    if (mode_ == ProgressMode::quiet) return;
    if (line_open_) std::fputs("\r\x1b[K", out_);
    fmt::print(out_, "{:3} %  {}  step {}  {}\n", percent(time_, end_time_), format_time_of(time_, end_time_), step_,
               text);
    line_open_ = false;
    if (mode_ == ProgressMode::bar && !finished_)
        draw();
    else
        std::fflush(out_);
}

void Progress::warn(std::string_view text) {
    if (line_open_) std::fputs("\r\x1b[K", out_);
    fmt::print(out_, "{}\n", text);
    std::fflush(out_);
    line_open_ = false;
}

void Progress::finish() {
    if (finished_) return;
    finished_ = true;
    if (mode_ == ProgressMode::quiet) return;
    const double wall = seconds(Clock::now() - start_);
    const auto steps = step_ - first_step_;
    step_rate_ = wall > 0 ? static_cast<double>(steps) / wall : 0;
    time_rate_ = INFINITY; // nothing to wait for any more
    if (mode_ == ProgressMode::bar) {
        draw();
        std::fputc('\n', out_);
        line_open_ = false;
    }
    fmt::print(out_, "{} steps in {}, {}\n", steps, wall < 60 ? fmt::format("{:.3g} s", wall) : format_duration(wall),
               format_rate(step_rate_));
    std::fflush(out_);
}

} // namespace abut
