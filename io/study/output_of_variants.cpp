#include "io/study/output_of_variants.h"

#include <algorithm>
#include <regex>

namespace abut {

namespace {

/// Whether a metric looks at frames between the first and the last.
bool wants_all_frames(const Metric& metric) {
    switch (metric.type) {
    case MetricType::particles:
        return metric.at.has_value() || metric.frames != Reduction::end;
    case MetricType::interpenetration:
    case MetricType::symmetry_error:
        return metric.at.has_value() || metric.reduce != Reduction::end;
    default:
        return false;
    }
}

/// Whether an expression has a name with two dots: ball.block.force_x.
bool wants_pairs(const Metric& metric) {
    static const std::regex pair(R"([A-Za-z_]\w*\.\w+\.\w+)");
    const auto has_pair = [](const std::string& text) { return std::regex_search(text, pair); };
    return metric.type == MetricType::history &&
           (has_pair(metric.scale) || std::any_of(metric.value.begin(), metric.value.end(), has_pair));
}

} // namespace

Json output_of_variants(const Study& study, const Scene& scene, const Json& output) {
    const auto any = [&](auto property) { return std::any_of(study.metrics.begin(), study.metrics.end(), property); };
    const double every = scene.output.particles.every.value_or(scene.output.every);
    const double rows = (scene.output.every > 0 ? scene.output.every : scene.time.end) / 100; // as a run has them
    Json result = Json::object();
    result["every"] = any(wants_all_frames) ? every : 0;
    result["history_every"] = output.contains("history_every") ? output["history_every"] : Json(rows);
    result["grid"] = false;
    result["contact"] = false;
    result["pairs"] = any(wants_pairs);
    result["checkpoint"] = false;
    return result;
}

} // namespace abut
