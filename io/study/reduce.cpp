#include "io/study/reduce.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace abut {

bool same_time(double a, double b) {
    return std::abs(a - b) <= 1e-9 * std::max(std::abs(a), std::abs(b));
}

double interpolate(const std::vector<double>& times, const std::vector<double>& values, double t) {
    const auto after = std::lower_bound(times.begin(), times.end(), t) - times.begin();
    if (after == 0) return values.front();
    if (after == static_cast<std::ptrdiff_t>(times.size())) return values.back();
    const auto i = static_cast<std::size_t>(after);
    const double share = (t - times[i - 1]) / (times[i] - times[i - 1]);
    return values[i - 1] + share * (values[i] - values[i - 1]);
}

double reduce_weighted(Reduction reduction, std::span<const double> values, std::span<const double> weights) {
    double sum = 0, all = 0, largest = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        largest = std::max(largest, std::abs(values[i]));
        sum += weights[i] * (reduction == Reduction::rms ? values[i] * values[i] : values[i]);
        all += weights[i];
        if (std::isnan(values[i])) return values[i]; // which max passes over
    }
    if (reduction == Reduction::max) return largest;
    return reduction == Reduction::rms ? std::sqrt(sum / all) : sum / all;
}

double reduce_in_time(const Metric& metric, const std::vector<double>& times, const std::vector<double>& values) {
    if (metric.at) {
        const double t = *metric.at;
        if (t > times.back() && !same_time(t, times.back()))
            throw NoValue(fmt::format("its rows end at {:g} s, before {:g} s", times.back(), t));
        return interpolate(times, values, t);
    }
    std::vector<double> within, when;
    for (std::size_t i = 0; i < times.size(); ++i) {
        const bool late_enough = !metric.from || times[i] >= *metric.from || same_time(times[i], *metric.from);
        const bool early_enough = !metric.to || times[i] <= *metric.to || same_time(times[i], *metric.to);
        if (!late_enough || !early_enough) continue;
        within.push_back(values[i]);
        when.push_back(times[i]);
    }
    if (within.empty()) throw NoValue("no row lies between \"from\" and \"to\"");
    if (metric.reduce == Reduction::end) return within.back();
    std::vector<double> weights(within.size(), 1.0);
    if (when.back() > when.front())
        for (std::size_t i = 0; i < when.size(); ++i)
            weights[i] = 0.5 * (when[std::min(i + 1, when.size() - 1)] - when[i == 0 ? 0 : i - 1]);
    return reduce_weighted(metric.reduce, within, weights);
}

} // namespace abut
