#pragma once
/// \file read_study_parts.h
/// The parts of read_study(). Each copies its part of a checked study file to the study and adds what is wrong.

#include "io/scene/json.h"
#include "io/study/study.h"
#include "scene/problem.h"

#include <optional>
#include <string>
#include <vector>

namespace abut {

/// Axes with their levels, and which variants there are: /axes, /combine, /except.
void read_axes(const Json& document, Study& study, std::vector<Problem>& problems);

/// /metrics and /tolerances; the axes are read.
void read_metrics(const Json& document, Study& study, std::vector<Problem>& problems);

/// Metrics that are a text become a `history` with that value.
void expand_short_metrics(Json& document);

/// The level of an axis that has the name, or was written as the value; a problem if there is none.
std::optional<std::size_t> find_level(const Axis& axis, const Json& level, const std::string& where,
                                      std::vector<Problem>& problems);

/// The number of the axis of that name; a problem if there is none.
std::optional<std::size_t> find_axis(const Study& study, const std::string& name, const std::string& where,
                                     std::vector<Problem>& problems);

/// Whether every study.csv has a column of this name.
bool is_study_column(const std::string& name);

} // namespace abut
