#pragma once
/// \file study.h
/// A study: a family of runs of one scene, what varies among them and what is measured. Plain values, as a study file
/// says them (io/study/README.md); read_study.h reads it, variants.h makes the runs, metrics.h measures.

#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace abut {

/// A value that a study sets in its scene.
struct Setting {
    std::string pointer; ///< JSON pointer into the scene
    std::string value;   ///< JSON text
    std::string where;   ///< pointer into the study file, for messages
};

/// One of the choices of an axis.
struct Level {
    std::string name; ///< "1 mm", "FMPM(2)"
    std::vector<Setting> settings;
    std::optional<int> threads; ///< of an axis of threads
};

/// One thing that varies.
struct Axis {
    std::string name;
    std::vector<Level> levels;
    std::size_t center = 0;        ///< level of the variants in which this axis does not vary
    std::optional<Setting> size{}; ///< where a variant's scene holds the number of this axis (value is unused): what it
                                   ///< is plotted over and converges with; none: words
    bool threads = false;          ///< its levels are numbers of threads
};

/// Which variants: for each axis (in their order) numbers of levels.
using LevelChoice = std::vector<std::vector<std::size_t>>;

enum class Combine {
    product,       ///< all levels of all axes with one another
    one_at_a_time, ///< all axes at their centers, then each axis along its levels
    chosen,        ///< what `chosen` says
};

enum class MetricType {
    history,          ///< an expression in the columns of the tables, against a closed form or another run or as it is
    particles,        ///< an expression in the arrays of particles against a field
    convergence,      ///< another metric's distance from what it converges to along an axis
    energy_loss,      ///< energy that is missing in the end, over the largest
    balance_error,    ///< energy out of nothing or gone, over the largest
    interpenetration, ///< area that bodies share, over the area of all
    momentum_error,   ///< momentum that no force brought
    symmetry_error,   ///< displacements against their mirror image
};

/// What is made of the values at all rows, frames or particles.
enum class Reduction {
    end,  ///< the last row or frame, or the one at `at`
    max,  ///< largest magnitude
    rms,  ///< root of the mean square (over time for rows)
    mean, ///< mean (over time for rows)
};

/// How particles count in means.
enum class Weight { none, mass, volume };

/// Where another run is found: of each axis a level, the smallest size ("finest"), or the variant's own.
struct ReferenceLevel {
    enum class Kind { own, level, finest } kind = Kind::own;
    std::size_t level = 0;
};

/// One measure of a run: a number. Errors are magnitudes, all else has its sign.
struct Metric {
    std::string name;
    std::string where; ///< pointer into the study file, for messages
    MetricType type = MetricType::history;
    Reduction reduce = Reduction::end;
    Reduction frames = Reduction::end; ///< particles: over the frames, each reduced by `reduce`
    std::optional<double> at;          ///< time [s]; none: the end
    std::optional<double> from, to;    ///< rows or frames that count [s]

    std::vector<std::string> value;        ///< expressions; several are components of a vector
    std::vector<std::string> exact;        ///< as many; none: no closed form
    std::string scale;                     ///< expression; empty: 1
    bool relative = false;                 ///< over the same reduction of what the value should be
    std::vector<ReferenceLevel> reference; ///< one an axis; empty: no other run of this study
    std::filesystem::path results;         ///< folder of a run outside the study to compare with; empty: none
    std::vector<std::string> bodies;       ///< of the particles that count; empty: all
    Weight weight = Weight::none;
    std::string of;                  ///< convergence: name of another metric
    std::size_t axis = 0;            ///< convergence: along which
    int mirror = 0;                  ///< symmetry: axis that is mirrored, 0 = x
    double plane = 0;                ///< symmetry: its coordinate [m]
    std::optional<double> tolerance; ///< magnitude that is good enough
};

struct Study {
    std::filesystem::path file;
    std::string title;
    std::filesystem::path base_file; ///< empty: the scene is in the study file
    std::string base;                ///< the scene as JSON text
    std::vector<Setting> settings;   ///< of all variants, `end` among them
    std::vector<Axis> axes;
    Combine combine = Combine::product;
    std::vector<LevelChoice> chosen; ///< of Combine::chosen
    std::vector<LevelChoice> except; ///< variants that are left out
    std::vector<Setting> parameters; ///< name (pointer) and value (JSON text) of each, in their order
    std::vector<Metric> metrics;
    int repeats = 1;
    int threads = 1;
    std::optional<double> time_limit; ///< wall time of one run [s]
    std::string checksum;             ///< of the file's content
};

} // namespace abut
