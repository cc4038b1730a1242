#pragma once
#include "io/study/results.h"
#include "io/study/study.h"

#include <vector>

namespace abut {

/// Fills in the metrics of type convergence: the distance of another metric's values from what they are extrapolated
/// to, along an axis, the others fixed.
void measure_convergence(const Study& study, StudyResults& results);

/// The series of all metrics along all axes with sizes, with their orders; those of at least two variants with a value.
std::vector<ConvergenceSeries> find_series(const Study& study, const StudyResults& results);

} // namespace abut
