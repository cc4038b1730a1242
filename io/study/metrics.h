#pragma once
/// \file metrics.h
/// Measures of runs, from their result files.

#include "io/study/results.h"
#include "io/study/study.h"
#include "io/study/variants.h"
#include "scene/problem.h"

#include <filesystem>
#include <string>
#include <vector>

namespace abut {

/// What the metrics of a variant can refer to.
struct VariantColumns {
    std::vector<std::string> history; ///< columns of history.csv
    std::vector<std::string> bodies;  ///< names of the bodies
    bool contact = false;             ///< there is a pairs.csv
    int dimension = 2;
    bool temperature = false, orientation = false; ///< particles have these arrays
};

/// Checks the expressions of all metrics against what a variant will have. Problems have pointers into the study file.
std::vector<Problem> check_metrics(const Study& study, const Variant& variant, const VariantColumns& columns);

/// Where the results of a variant are in the study's folder.
std::string run_folder(const Variant& variant);

/// Measures all variants that are done: fills in `metrics`, `absent` and the series.
/// \param columns one a variant \param folder of the study \param results with the same variants
void measure(const Study& study, const std::vector<Variant>& variants, const std::vector<VariantColumns>& columns,
             const std::filesystem::path& folder, StudyResults& results);

} // namespace abut
