#pragma once
#include "io/study/results.h"
#include "io/study/study.h"

#include <string>

namespace abut {

/// The results of a study without variants: what it varies and measures.
StudyResults describe(const Study& study);

/// A metric in one line, for captions: "rms of velocity_x against 3*t, relative".
std::string describe(const Study& study, const Metric& metric);

} // namespace abut
