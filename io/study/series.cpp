#include "io/study/series.h"

#include "io/study/convergence.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace abut {

namespace {

using Group = std::vector<std::size_t>;

/// Variants that differ in one axis only, coarsest first; those without a size are left out.
std::vector<Group> groups_along(std::size_t axis, const StudyResults& results) {
    std::map<std::vector<std::size_t>, std::size_t> index;
    std::vector<Group> groups;
    for (std::size_t v = 0; v < results.variants.size(); ++v) {
        const VariantResult& variant = results.variants[v];
        if (!variant.sizes[axis] || !(*variant.sizes[axis] > 0)) continue;
        std::vector<std::size_t> others = variant.levels;
        others[axis] = 0;
        const auto [place, added] = index.try_emplace(others, groups.size());
        if (added) groups.emplace_back();
        groups[place->second].push_back(v);
    }
    for (Group& group : groups)
        std::stable_sort(group.begin(), group.end(), [&](std::size_t a, std::size_t b) {
            return *results.variants[a].sizes[axis] > *results.variants[b].sizes[axis];
        });
    return groups;
}

/// The variants of a group that have a value of a metric, with sizes and values. Of equal sizes the first counts.
struct Curve {
    Group variants;
    std::vector<double> sizes, values;
};

Curve curve_of(const Group& group, std::size_t axis, std::size_t metric, const StudyResults& results) {
    Curve curve;
    for (const std::size_t v : group) {
        const VariantResult& variant = results.variants[v];
        const double size = *variant.sizes[axis];
        if (!variant.metrics[metric] || (!curve.sizes.empty() && curve.sizes.back() == size)) continue;
        curve.variants.push_back(v);
        curve.sizes.push_back(size);
        curve.values.push_back(*variant.metrics[metric]);
    }
    return curve;
}

std::size_t number_of(const Study& study, const std::string& metric) {
    for (std::size_t m = 0; m < study.metrics.size(); ++m)
        if (study.metrics[m].name == metric) return m;
    return 0; // read_metrics() has checked it
}

} // namespace

void measure_convergence(const Study& study, StudyResults& results) {
    for (std::size_t m = 0; m < study.metrics.size(); ++m) {
        const Metric& metric = study.metrics[m];
        if (metric.type != MetricType::convergence) continue;
        const std::size_t of = number_of(study, metric.of);
        for (VariantResult& variant : results.variants)
            variant.absent[m] = variant.metrics[of] ? "it has no size" : variant.absent[of];
        for (const Group& group : groups_along(metric.axis, results)) {
            const Curve curve = curve_of(group, metric.axis, of, results);
            const Extrapolation limit = extrapolate(curve.sizes, curve.values);
            for (std::size_t i = 0; i < curve.variants.size(); ++i) {
                VariantResult& variant = results.variants[curve.variants[i]];
                variant.absent[m] = limit.note;
                if (!limit.value) continue;
                const double whole = metric.relative ? std::abs(*limit.value) : 1;
                if (whole > 0) {
                    variant.metrics[m] = std::abs(curve.values[i] - *limit.value) / whole;
                    variant.absent[m].clear();
                } else {
                    variant.absent[m] = "it converges to 0: there is no relative error";
                }
            }
        }
    }
}

std::vector<ConvergenceSeries> find_series(const Study& study, const StudyResults& results) {
    std::vector<ConvergenceSeries> all;
    for (std::size_t m = 0; m < study.metrics.size(); ++m)
        for (std::size_t a = 0; a < study.axes.size(); ++a) {
            const Metric& metric = study.metrics[m];
            const bool converges = metric.type == MetricType::convergence && metric.axis == a;
            if (results.axes[a].size.empty()) continue;
            for (const Group& group : groups_along(a, results)) {
                const Curve curve = curve_of(group, a, m, results);
                ConvergenceSeries series{m, a, curve.variants, {}, {}, {}, ""};
                if (converges) {
                    const Curve behind = curve_of(group, a, number_of(study, metric.of), results);
                    const Extrapolation limit = extrapolate(behind.sizes, behind.values);
                    series.observed_order = limit.order;
                    series.extrapolated = limit.value;
                    series.note = limit.note;
                    if (series.variants.empty()) series.variants = behind.variants;
                }
                if (curve.variants.size() >= 2) series.fitted_order = fit_order(curve.sizes, curve.values);
                if (series.variants.size() >= 2) all.push_back(std::move(series));
            }
        }
    return all;
}

} // namespace abut
