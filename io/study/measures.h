#pragma once
/// \file measures.h
/// The measures of one run, a file for each kind. All throw NoValue (reduce.h), or std::runtime_error naming a broken
/// file, if there is none.

#include "io/study/metrics.h"
#include "io/study/run_tables.h"

#include <filesystem>
#include <string>
#include <vector>

namespace abut {

/// One run and what is known of it.
struct MeasuredRun {
    const Variant& variant;
    VariantColumns columns;
    std::filesystem::path folder;
    RunTables tables;
};

/// Expressions in the columns of the tables, at all rows, against `exact` or another run (null: none).
double measure_history(const Metric& metric, MeasuredRun& run, MeasuredRun* reference);

/// Expressions in the arrays of particles, against a field.
double measure_particles(const Metric& metric, MeasuredRun& run);

/// Energy less its first value and all work, over the largest energy: its end with the other sign, or all rows.
double measure_energy(const Metric& metric, MeasuredRun& run);

/// Change of momentum less the impulses of boundaries, rigid bodies and gravity, over what bodies have at most.
double measure_momentum(const Metric& metric, MeasuredRun& run);

/// Area that bodies share, over the area of all; of the frames of particles.
double measure_interpenetration(const Metric& metric, MeasuredRun& run);

/// Displacements less those of the mirror images of the particles (rms over particles), over all displacements (rms).
double measure_symmetry(const Metric& metric, MeasuredRun& run);

/// Checks the expressions of a metric. Returns what is wrong, as pointers into the study file.
std::vector<Problem> check_history(const Metric& metric, const std::vector<Constant>& parameters,
                                   const VariantColumns& columns);
std::vector<Problem> check_particles(const Metric& metric, const std::vector<Constant>& parameters,
                                     const VariantColumns& columns);

/// What a metric is divided by: `scale` at the first row; 1 without one.
double scale_of(const Metric& metric, MeasuredRun& run);

} // namespace abut
