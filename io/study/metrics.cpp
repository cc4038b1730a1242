#include "io/study/metrics.h"

#include "io/study/convergence.h"
#include "io/study/measures.h"
#include "io/study/reduce.h"
#include "io/study/series.h"
#include "scene/suggest.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <set>

namespace abut {

namespace {

/// The variant that a metric compares with; nothing if the study has none.
std::optional<std::size_t> reference_of(const Study& study, const Metric& metric, const std::vector<Variant>& variants,
                                        std::size_t variant) {
    std::optional<std::size_t> found;
    for (std::size_t v = 0; v < variants.size(); ++v) {
        bool fits = true;
        for (std::size_t a = 0; a < study.axes.size() && fits; ++a) {
            const ReferenceLevel& level = metric.reference[a];
            if (level.kind == ReferenceLevel::Kind::own) fits = variants[v].levels[a] == variants[variant].levels[a];
            if (level.kind == ReferenceLevel::Kind::level) fits = variants[v].levels[a] == level.level;
        }
        if (!fits) continue;
        // Of those that are left, the finest; only axes with Kind::finest differ.
        const auto sizes = [&](std::size_t i) {
            std::vector<double> list;
            for (std::size_t a = 0; a < study.axes.size(); ++a)
                if (metric.reference[a].kind == ReferenceLevel::Kind::finest)
                    list.push_back(variants[i].sizes[a].value_or(std::numeric_limits<double>::infinity()));
            return list;
        };
        if (!found || sizes(v) < sizes(*found)) found = v;
    }
    return found;
}

/// Runs of the study, and others that metrics compare with, with their tables.
class Runs {
public:
    Runs(const std::vector<Variant>& variants, const std::vector<VariantColumns>& columns,
         const std::filesystem::path& folder)
        : variants_(variants), columns_(columns), folder_(folder) {}

    MeasuredRun& of(std::size_t v, const std::filesystem::path& results) {
        std::unique_ptr<MeasuredRun>& run = runs_[results.string()];
        if (!run) run.reset(new MeasuredRun{variants_[v], columns_[v], results, RunTables(results)});
        return *run;
    }
    MeasuredRun& of(std::size_t v) { return of(v, folder_ / run_folder(variants_[v])); }

private:
    const std::vector<Variant>& variants_;
    const std::vector<VariantColumns>& columns_;
    std::filesystem::path folder_;
    std::map<std::string, std::unique_ptr<MeasuredRun>> runs_;
};

double measure_one(const Metric& metric, MeasuredRun& run, MeasuredRun* reference) {
    switch (metric.type) {
    case MetricType::particles:
        return measure_particles(metric, run);
    case MetricType::energy_loss:
    case MetricType::balance_error:
        return measure_energy(metric, run);
    case MetricType::interpenetration:
        return measure_interpenetration(metric, run);
    case MetricType::momentum_error:
        return measure_momentum(metric, run);
    case MetricType::symmetry_error:
        return measure_symmetry(metric, run);
    case MetricType::history:
    case MetricType::convergence: // not here
        break;
    }
    return measure_history(metric, run, reference);
}

/// One metric of one variant. Throws NoValue, or std::runtime_error naming a broken file.
double measure_variant(const Study& study, const Metric& metric, const std::vector<Variant>& variants, std::size_t v,
                       Runs& runs, const StudyResults& results) {
    MeasuredRun* reference = nullptr;
    if (!metric.results.empty()) reference = &runs.of(v, metric.results);
    if (!metric.reference.empty()) {
        const auto number = reference_of(study, metric, variants, v);
        if (!number) throw NoValue("the study has no such reference");
        if (*number == v) throw NoValue("it is the reference itself");
        const VariantResult& result = results.variants[*number];
        if (result.status != Status::done)
            throw NoValue(fmt::format("its reference \"{}\" is {}", result.name, status_word(result.status)));
        reference = &runs.of(*number);
    }
    const double value = measure_one(metric, runs.of(v), reference);
    if (!std::isfinite(value)) throw NoValue("it is no finite number");
    return value;
}

void check_bodies(const Metric& metric, const VariantColumns& columns, std::vector<Problem>& problems) {
    for (std::size_t i = 0; i < metric.bodies.size(); ++i) {
        const std::string& name = metric.bodies[i];
        if (std::find(columns.bodies.begin(), columns.bodies.end(), name) != columns.bodies.end()) continue;
        problems.push_back({fmt::format("{}/bodies/{}", metric.where, i),
                            fmt::format("no body \"{}\"{}", name, did_you_mean(name, columns.bodies))});
    }
}

} // namespace

std::string run_folder(const Variant& variant) {
    return "runs/" + variant.folder;
}

std::vector<Problem> check_metrics(const Study& study, const Variant& variant, const VariantColumns& columns) {
    std::vector<Problem> problems;
    for (const Metric& metric : study.metrics) {
        const auto add = [&](const std::vector<Problem>& more) {
            problems.insert(problems.end(), more.begin(), more.end());
        };
        if (metric.type == MetricType::particles) {
            Metric scale = metric; // in columns, unlike the rest
            scale.value.clear();
            scale.exact.clear();
            add(check_particles(metric, variant.parameters, columns));
            add(check_history(scale, variant.parameters, columns));
        } else {
            add(check_history(metric, variant.parameters, columns));
        }
        check_bodies(metric, columns, problems);
        if (metric.type == MetricType::interpenetration && (columns.dimension == 3 || !columns.contact))
            problems.push_back({metric.where, "is measured in plane scenes with contact only"});
    }
    return problems;
}

void measure(const Study& study, const std::vector<Variant>& variants, const std::vector<VariantColumns>& columns,
             const std::filesystem::path& folder, StudyResults& results) {
    Runs runs(variants, columns, folder);
    for (std::size_t v = 0; v < variants.size(); ++v) {
        VariantResult& result = results.variants[v];
        result.metrics.assign(study.metrics.size(), std::nullopt);
        result.absent.assign(study.metrics.size(), "");
        for (std::size_t m = 0; m < study.metrics.size(); ++m) {
            if (study.metrics[m].type == MetricType::convergence) continue;
            if (result.status != Status::done) {
                result.absent[m] = "the run is " + status_word(result.status);
                continue;
            }
            try {
                result.metrics[m] = measure_variant(study, study.metrics[m], variants, v, runs, results);
            } catch (const std::exception& error) {
                result.absent[m] = error.what();
            }
        }
    }
    measure_convergence(study, results);
    results.series = find_series(study, results);
}

} // namespace abut
