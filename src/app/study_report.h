#pragma once
#include "app/study_runs.h"
#include "io/study/results.h"

#include <chrono>
#include <cstdio>
#include <vector>

namespace abut {

/// What the user sees while a study runs: a bar with the time to go on a terminal, else a line for each run. The time
/// to go counts the work of each variant, not their number.
class StudyProgress {
public:
    StudyProgress(const std::vector<Variant>& variants, const std::vector<VariantModel>& models,
                  const std::vector<StudyTask>& tasks, bool quiet);
    StudyProgress(const StudyProgress&) = delete;
    StudyProgress& operator=(const StudyProgress&) = delete;
    ~StudyProgress();

    void update(std::size_t done, const StudyTask& task, const std::vector<RunRecord>& records);

private:
    void draw();

    const std::vector<Variant>& variants_;
    const std::vector<VariantModel>& models_;
    std::size_t total_, done_ = 0;
    double all_work_ = 0, done_work_ = 0;
    bool quiet_, on_terminal_;
    std::chrono::steady_clock::time_point start_;
};

/// Measures what is done, and writes study.csv and study.json.
StudyResults tabulate(const Study& study, const std::vector<Variant>& variants, const std::vector<VariantModel>& models,
                      const std::vector<RunRecord>& records, const StudyFolder& folder);

/// How many variants are done, which are not and why, what has no value, what is written.
void print_summary(const StudyResults& results, const StudyFolder& folder);

} // namespace abut
