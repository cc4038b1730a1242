#include "io/study/results.h"

#include "io/results/write_text.h"
#include "io/scene/json.h"
#include "io/scene/words.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace abut {

namespace {

constexpr std::array status_words{Word{"done", Status::done}, Word{"unstable", Status::unstable},
                                  Word{"failed", Status::failed}, Word{"missing", Status::missing}};

/// Of ascending values, at a share of their number.
double quantile(const std::vector<double>& sorted, double share) {
    const double place = share * static_cast<double>(sorted.size() - 1);
    const auto below = static_cast<std::size_t>(place);
    const std::size_t above = std::min(below + 1, sorted.size() - 1);
    return sorted[below] + (place - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

template <class T>
Json to_json(const std::optional<T>& value) {
    return value ? Json(*value) : Json(nullptr);
}

template <class T>
Json to_json(const std::vector<std::optional<T>>& values) {
    Json list = Json::array();
    for (const auto& value : values) list.push_back(to_json(value));
    return list;
}

template <class T>
std::optional<T> optional_of(const Json& json) {
    return json.is_null() ? std::optional<T>() : json.get<T>();
}

template <class T>
std::vector<std::optional<T>> optionals_of(const Json& json) {
    std::vector<std::optional<T>> values;
    for (const Json& value : json) values.push_back(optional_of<T>(value));
    return values;
}

Json series_json(const ConvergenceSeries& series) {
    return {{"metric", series.metric},
            {"axis", series.axis},
            {"variants", series.variants},
            {"fitted_order", to_json(series.fitted_order)},
            {"observed_order", to_json(series.observed_order)},
            {"extrapolated", to_json(series.extrapolated)},
            {"note", series.note}};
}

ConvergenceSeries series_of(const Json& json) {
    return {json.at("metric"),
            json.at("axis"),
            json.at("variants"),
            optional_of<double>(json.at("fitted_order")),
            optional_of<double>(json.at("observed_order")),
            optional_of<double>(json.at("extrapolated")),
            json.at("note")};
}

Json variant_json(const VariantResult& variant) {
    Json costs = Json::array();
    for (const Cost& cost : variant.costs) costs.push_back(Json::parse(cost_text(cost)));
    return {{"name", variant.name},
            {"folder", variant.folder},
            {"levels", variant.levels},
            {"sizes", to_json(variant.sizes)},
            {"key", variant.key},
            {"status", status_word(variant.status)},
            {"cause", variant.cause},
            {"metrics", to_json(variant.metrics)},
            {"absent", variant.absent},
            {"repeats_agree", variant.repeats_agree},
            {"costs", costs}};
}

VariantResult variant_of(const Json& json) {
    VariantResult variant;
    variant.name = json.at("name");
    variant.folder = json.at("folder");
    variant.levels = json.at("levels").get<std::vector<std::size_t>>();
    variant.sizes = optionals_of<double>(json.at("sizes"));
    variant.key = json.at("key");
    const auto status = value_of(status_words, json.at("status").get<std::string>());
    if (!status) throw std::runtime_error("unknown status of a variant");
    variant.status = *status;
    variant.cause = json.at("cause");
    variant.metrics = optionals_of<double>(json.at("metrics"));
    variant.absent = json.at("absent").get<std::vector<std::string>>();
    variant.repeats_agree = json.at("repeats_agree");
    for (const Json& cost : json.at("costs")) variant.costs.push_back(cost_of(cost.dump()));
    return variant;
}

Json axis_json(const AxisResult& axis) {
    return {{"name", axis.name},
            {"levels", axis.levels},
            {"center", axis.center},
            {"size", axis.size},
            {"unit", axis.unit}};
}

Json metric_json(const MetricResult& metric) {
    return {{"name", metric.name},
            {"type", metric.type},
            {"meaning", metric.meaning},
            {"is_error", metric.is_error},
            {"tolerance", to_json(metric.tolerance)}};
}

StudyResults results_of(const Json& json) {
    StudyResults results;
    results.version = json.at("abut_version");
    results.title = json.at("title");
    results.file = json.at("study");
    results.checksum = json.at("checksum");
    results.repeats = json.at("repeats");
    results.timing_warnings = json.at("timing_warnings").get<std::vector<std::string>>();
    for (const Json& axis : json.at("axes"))
        results.axes.push_back(
            {axis.at("name"), axis.at("levels"), axis.at("center"), axis.at("size"), axis.at("unit")});
    for (const Json& metric : json.at("metrics"))
        results.metrics.push_back({metric.at("name"), metric.at("type"), metric.at("meaning"), metric.at("is_error"),
                                   optional_of<double>(metric.at("tolerance"))});
    for (const Json& variant : json.at("variants")) results.variants.push_back(variant_of(variant));
    for (const Json& series : json.at("series")) results.series.push_back(series_of(series));
    return results;
}

} // namespace

Spread spread_of(std::vector<double> values) {
    Spread spread;
    spread.values = std::move(values);
    if (spread.values.empty()) return spread;
    std::vector<double> sorted = spread.values;
    std::sort(sorted.begin(), sorted.end());
    spread.median = quantile(sorted, 0.5);
    spread.low = quantile(sorted, 0.25);
    spread.high = quantile(sorted, 0.75);
    for (double& value : sorted) value = std::abs(value - spread.median);
    std::sort(sorted.begin(), sorted.end());
    spread.deviation = quantile(sorted, 0.5);
    return spread;
}

Spread VariantResult::spread(double Cost::*time) const {
    std::vector<double> values;
    for (const Cost& cost : costs) values.push_back(cost.*time);
    return spread_of(std::move(values));
}

Spread VariantResult::task_spread(const std::string& task) const {
    std::vector<double> values;
    for (const Cost& cost : costs)
        if (const auto found = cost.tasks.find(task); found != cost.tasks.end()) values.push_back(found->second);
    return spread_of(std::move(values));
}

std::string status_word(Status status) {
    return std::string(text_of(status_words, status));
}

std::string cost_text(const Cost& cost) {
    const Json json = {{"wall_seconds", cost.wall_seconds},
                       {"solver_seconds", cost.solver_seconds},
                       {"solver_cpu_seconds", cost.solver_cpu_seconds},
                       {"tasks", cost.tasks},
                       {"steps", cost.steps},
                       {"particles", cost.particles},
                       {"particle_updates", cost.particle_updates},
                       {"particle_sweeps", cost.particle_sweeps},
                       {"node_updates", cost.node_updates},
                       {"instructions", to_json(cost.instructions)},
                       {"peak_memory_bytes", cost.peak_memory_bytes},
                       {"threads", cost.threads},
                       {"alone", cost.alone},
                       {"machine", cost.machine}};
    return json.dump();
}

Cost cost_of(const std::string& text) {
    const Json json = Json::parse(text);
    Cost cost;
    cost.wall_seconds = json.at("wall_seconds");
    cost.solver_seconds = json.at("solver_seconds");
    cost.solver_cpu_seconds = json.at("solver_cpu_seconds");
    cost.tasks = json.at("tasks").get<std::map<std::string, double>>();
    cost.steps = json.at("steps");
    cost.particles = json.at("particles");
    cost.particle_updates = json.at("particle_updates");
    cost.particle_sweeps = json.at("particle_sweeps");
    cost.node_updates = json.at("node_updates");
    if (const Json* count = find(json, "instructions")) cost.instructions = optional_of<long long>(*count);
    cost.peak_memory_bytes = json.at("peak_memory_bytes");
    cost.threads = json.at("threads");
    if (const Json* alone = find(json, "alone")) cost.alone = *alone;
    if (const Json* machine = find(json, "machine")) cost.machine = *machine;
    return cost;
}

void write_results(const std::filesystem::path& file, const StudyResults& results) {
    Json json = {{"abut_version", results.version}, {"title", results.title},
                 {"study", results.file},           {"checksum", results.checksum},
                 {"repeats", results.repeats},      {"timing_warnings", results.timing_warnings},
                 {"axes", Json::array()},           {"metrics", Json::array()},
                 {"variants", Json::array()},       {"series", Json::array()}};
    for (const AxisResult& axis : results.axes) json["axes"].push_back(axis_json(axis));
    for (const MetricResult& metric : results.metrics) json["metrics"].push_back(metric_json(metric));
    for (const VariantResult& variant : results.variants) json["variants"].push_back(variant_json(variant));
    for (const ConvergenceSeries& series : results.series) json["series"].push_back(series_json(series));
    write_text_atomically(file, json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n");
}

StudyResults read_results(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    if (!stream) throw std::runtime_error(file.string() + ": cannot read the results of a study");
    const std::string text{std::istreambuf_iterator<char>(stream), {}};
    try {
        return results_of(Json::parse(text));
    } catch (const std::exception& error) {
        throw std::runtime_error(fmt::format("{}: not the results of a study: {}", file.string(), error.what()));
    }
}

} // namespace abut
