#pragma once
/// \file results.h
/// What a study found: study.json holds all of it, study.csv a row for each variant. Reports, pictures and advice are
/// made from these values alone; read_results() brings them back without a run.

#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace abut {

/// How a variant ended.
enum class Status {
    done,
    unstable, ///< the run stopped itself: energy out of nothing, a particle gone, a step too large ...
    failed,   ///< anything else: a wrong scene, a crash, a full disk, over its time limit
    missing,  ///< not run yet, or on another machine
};

/// Repeated measurements of one time [s].
struct Spread {
    double median = 0;
    double low = 0, high = 0;   ///< quartiles (linear interpolation)
    double deviation = 0;       ///< median distance from the median (MAD)
    std::vector<double> values; ///< in the order of the repeats
};
/// Of no values: all zero.
Spread spread_of(std::vector<double> values);

/// One run of a variant, as its timing.json and the system tell.
struct Cost {
    double wall_seconds = 0;             ///< of the whole program
    double solver_seconds = 0;           ///< wall time of stepping, without output
    double solver_cpu_seconds = 0;       ///< CPU time of all threads in it
    std::map<std::string, double> tasks; ///< wall time of each task of the step [s]
    long steps = 0;
    long particles = 0;
    long long particle_updates = 0;        ///< particles advanced by a step, over all steps
    long long particle_sweeps = 0;         ///< visits of particles by sweeps to the grid or back, over all steps
    long long node_updates = 0;            ///< slots (a body at a node) that steps had, over all steps
    std::optional<long long> instructions; ///< of stepping, where the system lets them be counted
    long long peak_memory_bytes = 0;
    int threads = 1;
    bool alone = true;   ///< no other run of the study at the same time
    std::string machine; ///< host name and processor
};

/// As JSON text and back; a run's timing.json can be read as well. Throws std::exception for a text that is none.
std::string cost_text(const Cost& cost);
Cost cost_of(const std::string& text);

/// A run of the family and what came of it.
struct VariantResult {
    std::string name;                         ///< levels in words: "1 mm, FMPM(2), cpdi"
    std::string folder;                       ///< of its results, relative to the study's
    std::vector<std::size_t> levels;          ///< one an axis
    std::vector<std::optional<double>> sizes; ///< number of each axis, SI
    std::string key;                          ///< checksum of the resolved scene, its files, threads and version
    Status status = Status::missing;
    std::string cause;                          ///< why it is unstable, failed or missing
    std::vector<std::optional<double>> metrics; ///< one a metric
    std::vector<std::string> absent;            ///< of each metric that has no value: why; else empty
    std::vector<Cost> costs;                    ///< one a repeat
    bool repeats_agree = true;                  ///< history.csv was the same, bit for bit, in all repeats

    /// Spread of a time over the repeats.
    Spread spread(double Cost::*time) const;
    Spread task_spread(const std::string& task) const;
};

/// Variants that differ in one axis with a size only, finest last.
struct ConvergenceSeries {
    std::size_t metric = 0;
    std::size_t axis = 0;
    std::vector<std::size_t> variants;    ///< those with a value, largest size first
    std::optional<double> fitted_order;   ///< slope of log |metric| over log size (least squares); at least 2 values
    std::optional<double> observed_order; ///< metrics of type convergence: of the values behind it, by Richardson
    std::optional<double> extrapolated;   ///< likewise: the value at size 0
    std::string note;                     ///< why there is no order
};

struct AxisResult {
    std::string name;
    std::vector<std::string> levels;
    std::size_t center = 0;
    std::string size; ///< pointer to the number that `sizes` have; empty: none
    std::string unit; ///< SI unit of `sizes`
};

struct MetricResult {
    std::string name;
    std::string type;                ///< as in the study file
    std::string meaning;             ///< one line for captions: "rms of velocity_x against 3*t, relative"
    bool is_error = true;            ///< 0 would be perfect (a loss of energy may have a sign); else just a value
    std::optional<double> tolerance; ///< magnitude that is good enough
};

struct StudyResults {
    std::string version; ///< of abut
    std::string title;
    std::string file;     ///< the study's, as given
    std::string checksum; ///< of its content
    std::vector<AxisResult> axes;
    std::vector<MetricResult> metrics;
    std::vector<VariantResult> variants; ///< in the study's order
    std::vector<ConvergenceSeries> series;
    int repeats = 1; ///< wanted
    /// Why times of this study must not be compared, one a line: runs at the same time, several machines; none: they
    /// may be.
    std::vector<std::string> timing_warnings;
};

/// A row for each variant: name, status, axes (levels, sizes), metrics, times (median, quartiles), counts, cause.
void write_study_csv(const std::filesystem::path& file, const StudyResults& results);
void write_results(const std::filesystem::path& file, const StudyResults& results);
/// Throws std::runtime_error naming the file if it is missing or broken.
StudyResults read_results(const std::filesystem::path& file);

/// "done", "unstable", "failed", "missing".
std::string status_word(Status status);

} // namespace abut
