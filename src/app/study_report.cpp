#include "app/study_report.h"

#include "io/results/bar.h"
#include "io/scene/words.h"
#include "io/study/describe.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace abut {

StudyProgress::StudyProgress(const std::vector<Variant>& variants, const std::vector<VariantModel>& models,
                             const std::vector<StudyTask>& tasks, bool quiet)
    : variants_(variants), models_(models), total_(tasks.size()), quiet_(quiet),
      on_terminal_(isatty(fileno(stderr)) != 0), start_(std::chrono::steady_clock::now()) {
    for (const StudyTask& task : tasks) all_work_ += models[task.variant].work;
    draw();
}

StudyProgress::~StudyProgress() {
    if (!on_terminal_ || quiet_ || total_ == 0) return;
    std::fputs("\r\x1b[K", stderr);
    std::fflush(stderr);
}

void StudyProgress::draw() {
    if (quiet_ || !on_terminal_ || total_ == 0) return;
    // Where results are there the work is not known; their repeats are counted like the rest.
    const double share = all_work_ > 0 ? done_work_ / all_work_ : double(done_) / double(total_);
    const double passed = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    const double left = share > 0 ? passed * (1 - share) / share : INFINITY;
    const std::string text = fmt::format(" {} of {} runs  {} left", done_, total_, format_duration(left));
    fmt::print(stderr, "\r{}\x1b[K", bar_line(share, text, columns(stderr)));
    std::fflush(stderr);
}

void StudyProgress::update(std::size_t done, const StudyTask& task, const std::vector<RunRecord>& records) {
    done_ = done;
    done_work_ += models_[task.variant].work;
    if (quiet_) return;
    const RunRecord& record = records[task.variant];
    const bool good = record.status == Status::done;
    if (on_terminal_ && good) return draw();
    const std::string outcome = good ? fmt::format("{:.3g} s", record.costs.back().solver_seconds)
                                     : fmt::format("{}: {}", status_word(record.status), record.cause);
    fmt::print(stderr, "{}[{}/{}] {}: {}\n", on_terminal_ ? "\r\x1b[K" : "", done, total_, variants_[task.variant].name,
               outcome);
    draw();
}

namespace {

/// Why times must not be compared.
std::vector<std::string> timing_warnings(const std::vector<VariantResult>& variants) {
    // Of one thread, wall time beyond CPU time is time that other programs took; short runs may lose a little.
    constexpr double usual = 1.1, unnoticed = 0.02;
    std::size_t shared = 0, waited = 0;
    std::set<std::string> machines;
    for (const VariantResult& variant : variants)
        for (const Cost& cost : variant.costs) {
            shared += cost.alone ? 0 : 1;
            waited += cost.threads == 1 && cost.solver_seconds > usual * cost.solver_cpu_seconds + unnoticed ? 1 : 0;
            machines.insert(cost.machine);
        }
    std::vector<std::string> warnings;
    if (shared > 0)
        warnings.push_back(fmt::format("{} runs shared the machine with others of the study (--jobs)", shared));
    if (waited > 0)
        warnings.push_back(fmt::format("{} runs had to wait for a processor that other programs used; compare "
                                       "solver_cpu_seconds",
                                       waited));
    if (machines.size() > 1) {
        std::string list;
        for (const std::string& machine : machines) list += (list.empty() ? "" : "; ") + machine;
        warnings.push_back("runs come from several machines: " + list);
    }
    return warnings;
}

} // namespace

StudyResults tabulate(const Study& study, const std::vector<Variant>& variants, const std::vector<VariantModel>& models,
                      const std::vector<RunRecord>& records, const StudyFolder& folder) {
    StudyResults results = describe(study);
    for (std::size_t v = 0; v < variants.size(); ++v) {
        const Variant& variant = variants[v];
        VariantResult& result = results.variants.emplace_back();
        result.name = variant.name;
        result.folder = run_folder(variant);
        result.levels = variant.levels;
        result.sizes = variant.sizes;
        result.key = variant.key;
        result.status = records[v].status;
        result.cause = records[v].status == Status::missing ? "not run yet" : records[v].cause;
        result.costs = records[v].costs;
        result.repeats_agree = records[v].repeats_agree;
    }
    results.timing_warnings = timing_warnings(results.variants);
    std::vector<VariantColumns> columns;
    for (const VariantModel& model : models) columns.push_back(model.columns);
    measure(study, variants, columns, folder.path, results);
    write_study_csv(folder.path / "study.csv", results);
    write_results(folder.path / "study.json", results);
    return results;
}

void print_summary(const StudyResults& results, const StudyFolder& folder) {
    std::map<Status, std::size_t> counts;
    for (const VariantResult& variant : results.variants) ++counts[variant.status];
    std::string text = fmt::format("{} of {} variants done", counts[Status::done], results.variants.size());
    for (const Status status : {Status::unstable, Status::failed, Status::missing})
        if (counts[status] > 0) text += fmt::format(", {} {}", counts[status], status_word(status));
    fmt::print("{}\n", text);
    for (const VariantResult& variant : results.variants) {
        if (variant.status == Status::unstable || variant.status == Status::failed)
            fmt::print("  {}: {}: {}\n", variant.name, status_word(variant.status), variant.cause);
        if (!variant.repeats_agree) fmt::print("  {}: its repeats differ in history.csv\n", variant.name);
    }
    for (std::size_t m = 0; m < results.metrics.size(); ++m) {
        std::map<std::string, std::size_t> causes; // of variants that are done
        for (const VariantResult& variant : results.variants)
            if (variant.status == Status::done && !variant.metrics[m]) ++causes[variant.absent[m]];
        for (const auto& [cause, count] : causes)
            fmt::print("  {}: no value of {} variants: {}\n", results.metrics[m].name, count, cause);
    }
    for (const std::string& warning : results.timing_warnings) fmt::print("  times are not reliable: {}\n", warning);
    fmt::print("written: {} and study.json\n", (folder.path / "study.csv").string());
}

} // namespace abut
