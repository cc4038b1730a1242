#include "app/commands.h"
#include "app/study_report.h"
#include "app/study_runs.h"
#include "io/study/read_study.h"
#include "scene/problem.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <set>
#include <utility>

namespace abut {

namespace {

/// Which variants are run here.
struct Shard {
    std::size_t number = 0, count = 1;
    bool has(std::size_t variant) const { return variant % count == number; }
};

Shard parse_shard(const std::string& text) {
    if (text.empty()) return {};
    std::size_t number = 0, count = 0;
    const char* const end = text.data() + text.size();
    const auto [slash, error] = std::from_chars(text.data(), end, number);
    const bool good = error == std::errc() && slash != end && *slash == '/' &&
                      std::from_chars(slash + 1, end, count).ptr == end && number >= 1 && number <= count;
    if (!good) throw UsageError(fmt::format("--shard {}: write I/N with I from 1 to N, for example 1/2", text));
    return {number - 1, count};
}

/// Refuses a folder that holds anything but a study.
void make_ready(const std::filesystem::path& folder) {
    std::error_code error;
    if (std::filesystem::exists(folder) && !std::filesystem::is_directory(folder))
        throw UsageError(fmt::format("-o {}: it is a file", folder.string()));
    const bool foreign = std::filesystem::exists(folder) && !std::filesystem::is_empty(folder, error) &&
                         !std::filesystem::exists(folder / "records");
    if (foreign || error)
        throw UsageError(
            fmt::format("-o {}: the folder is not empty and not that of a study; choose another one", folder.string()));
    std::filesystem::create_directories(folder / "records", error);
    if (error) throw UsageError(fmt::format("-o {}: {}", folder.string(), error.message()));
}

/// Problems of variants, each told once.
class VariantProblems {
public:
    void add(const std::vector<Problem>& problems, const std::string& label) {
        for (const Problem& problem : problems) {
            const std::string pointer = label.empty() || problem.pointer.empty() ? "" : problem.pointer + ": ";
            const std::string message = label.empty() ? problem.message : label + ": " + pointer + problem.message;
            if (known_.emplace(problem.pointer, problem.message).second)
                problems_.push_back({label.empty() ? problem.pointer : "", message});
        }
    }
    void complain(const std::filesystem::path& file) const {
        if (!problems_.empty()) throw SceneError(file.string(), problems_);
    }

private:
    std::set<std::pair<std::string, std::string>> known_;
    std::vector<Problem> problems_;
};

/// Looks at the models of all variants before the first runs.
std::vector<VariantModel> examine_all(const Study& study, const std::vector<Variant>& variants,
                                      const StudyFolder& folder, const std::vector<RunRecord>& records) {
    std::vector<VariantModel> models;
    VariantProblems problems;
    for (std::size_t v = 0; v < variants.size(); ++v) {
        const Variant& variant = variants[v];
        try {
            models.push_back(records[v].status == Status::done ? examine_results(variant, folder.results(variant))
                                                               : examine(variant));
            problems.add(check_metrics(study, variant, models.back().columns), "");
        } catch (const SceneError& error) {
            problems.add(error.problems(), fmt::format("variant \"{}\"", variant.name));
        }
    }
    problems.complain(study.file);
    return models;
}

void print_list(const std::vector<Variant>& variants, const std::vector<VariantModel>& models,
                const std::vector<RunRecord>& records, int repeats) {
    std::size_t width = 0;
    for (const Variant& variant : variants) width = std::max(width, variant.name.size());
    for (std::size_t v = 0; v < variants.size(); ++v) {
        const std::string size = models[v].particles == 0 ? ""
                                                          : fmt::format("  {} particles, about {:.0f} steps",
                                                                        models[v].particles, models[v].steps);
        const std::string done = records[v].complete(repeats) ? "  " + status_word(records[v].status) : "";
        fmt::print("{:<{}}{}{}\n", variants[v].name, width, size, done);
    }
    fmt::print("{} variants, {} repeats each\n", variants.size(), repeats);
}

/// Refuses folders that have nothing to take over.
void check_merge(const std::vector<std::filesystem::path>& others, const std::vector<Variant>& variants) {
    for (const std::filesystem::path& path : others) {
        if (!std::filesystem::exists(path / "records"))
            throw UsageError(fmt::format("--merge {}: not the folder of a study", path.string()));
        const auto has = [&](const Variant& variant) {
            return StudyFolder{path}.known(variant).status != Status::missing;
        };
        if (std::none_of(variants.begin(), variants.end(), has))
            throw UsageError(
                fmt::format("--merge {}: none of its runs is one of this study as it is now", path.string()));
    }
}

/// Takes over one run of another folder of the study.
void take_over(const Variant& variant, const StudyFolder& from, const StudyFolder& to) {
    using Copy = std::filesystem::copy_options;
    std::filesystem::remove_all(to.results(variant));
    for (const auto& [source, target] :
         {std::pair{from.results(variant), to.results(variant)}, std::pair{from.log(variant), to.log(variant)},
          std::pair{from.scene(variant), to.scene(variant)}}) {
        std::filesystem::create_directories(target.parent_path());
        if (std::filesystem::exists(source))
            std::filesystem::copy(source, target, Copy::recursive | Copy::overwrite_existing);
    }
}

/// Takes over what other folders of the study have and this one has not, or with more repeats.
void merge(const std::vector<std::filesystem::path>& others, const std::vector<Variant>& variants,
           const StudyFolder& folder, std::vector<RunRecord>& records) {
    for (const std::filesystem::path& path : others)
        for (std::size_t v = 0; v < variants.size(); ++v) {
            const RunRecord known = StudyFolder{path}.known(variants[v]);
            const bool better = known.costs.size() > records[v].costs.size() || records[v].status == Status::missing;
            if (known.status == Status::missing || !better) continue;
            take_over(variants[v], {path}, folder);
            write_record(folder.record(variants[v]), known);
            records[v] = known;
        }
}

} // namespace

int study_command(const StudyOptions& options) {
    const Shard shard = parse_shard(options.shard);
    const Study study = read_study(options.study);
    const std::vector<Variant> variants = make_variants(study);
    StudyFolder folder{options.output};
    if (folder.path.empty()) folder.path = options.study.stem().string() + "-results";
    std::vector<RunRecord> records;
    for (const Variant& variant : variants) {
        records.push_back(folder.known(variant));
        if (options.overwrite) records.back() = RunRecord{variant.key, Status::missing, {}, {}, {}, true};
    }
    if (!options.merge.empty()) {
        check_merge(options.merge, variants);
        make_ready(folder.path);
        merge(options.merge, variants, folder, records);
    }
    std::vector<VariantModel> models = examine_all(study, variants, folder, records);
    if (options.list) {
        print_list(variants, models, records, study.repeats);
        return 0;
    }
    make_ready(folder.path);
    bool uninterrupted = true;
    if (options.merge.empty()) {
        const std::vector<StudyTask> tasks =
            tasks_left(records, study.repeats, [&](std::size_t v) { return shard.has(v); });
        StudyProgress progress(variants, models, tasks, options.quiet);
        uninterrupted =
            do_tasks(study, variants, folder, tasks, options.jobs, records,
                     [&](std::size_t done, const StudyTask& task) { progress.update(done, task, records); });
    }
    const StudyResults results = tabulate(study, variants, models, records, folder);
    print_summary(results, folder);
    if (!uninterrupted) {
        fmt::print(stderr, "interrupted; the same command goes on\n");
        return 130;
    }
    const auto is_done = [](const VariantResult& variant) { return variant.status == Status::done; };
    return std::any_of(results.variants.begin(), results.variants.end(), is_done) ? 0 : 1;
}

} // namespace abut
