#pragma once
/// \file study_runs.h
/// The runs of a study, each a child process.

#include "app/study_variants.h"
#include "io/study/run_record.h"
#include "io/study/study.h"

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace abut {

/// A study's folder: scenes/NAME.json as the runs get them, runs/NAME their results, logs/NAME.txt what they said,
/// records/NAME.json what is kept of them; study.csv and study.json.
struct StudyFolder {
    std::filesystem::path path;

    std::filesystem::path scene(const Variant& variant) const { return path / "scenes" / (variant.folder + ".json"); }
    std::filesystem::path results(const Variant& variant) const { return path / run_folder(variant); }
    std::filesystem::path record(const Variant& variant) const { return path / "records" / (variant.folder + ".json"); }
    std::filesystem::path log(const Variant& variant) const { return path / "logs" / (variant.folder + ".txt"); }
    std::filesystem::path repeat(const Variant& variant, int repeat) const;

    /// What is known of a variant in its present form; an empty record if it has not been run so.
    RunRecord known(const Variant& variant) const;
};

/// One run to do.
struct StudyTask {
    std::size_t variant = 0;
    int repeat = 0; ///< from 0
};

/// What is left to do: all variants once, then all again ..., those of this shard.
/// \param mine whether a variant belongs to this shard
std::vector<StudyTask> tasks_left(const std::vector<RunRecord>& records, int repeats,
                                  const std::function<bool(std::size_t)>& mine);

/// Told after each run: how many are done, which one it was.
using RunDone = std::function<void(std::size_t done, const StudyTask& task)>;

/// Does the tasks, `jobs` at a time, and keeps the records up to date, in memory and in the folder. A variant that
/// turns out to be unstable or to fail is not repeated. \return false if SIGINT or SIGTERM came between
bool do_tasks(const Study& study, const std::vector<Variant>& variants, const StudyFolder& folder,
              const std::vector<StudyTask>& tasks, int jobs, std::vector<RunRecord>& records, const RunDone& done);

} // namespace abut
