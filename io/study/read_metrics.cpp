#include "io/scene/bind_parts.h"
#include "io/scene/check.h"
#include "io/study/read_study_parts.h"
#include "io/study/specification_study.h"
#include "scene/suggest.h"

#include <fmt/format.h>

#include <algorithm>

namespace abut {

namespace {

/// An expression or a list of them.
std::vector<std::string> read_expressions(const Json& json, const char* key, const std::string& where,
                                          std::vector<Problem>& problems) {
    const Json* value = find(json, key);
    if (!value) return {};
    std::vector<std::string> expressions;
    for (const Json& entry : value->is_array() ? *value : Json::array({*value})) {
        if (entry.is_string())
            expressions.push_back(entry.get<std::string>());
        else if (entry.is_number())
            expressions.push_back(entry.dump());
        else
            problems.push_back({fmt::format("{}/{}", where, key),
                                "an expression as a text, or a list of them, is needed, not " + in_words(entry)});
    }
    if (value->empty()) problems.push_back({fmt::format("{}/{}", where, key), "an expression is needed"});
    return expressions;
}

Reduction usual_reduction(MetricType type) {
    if (type == MetricType::history) return Reduction::end;
    return type == MetricType::particles ? Reduction::rms : Reduction::max;
}

std::vector<ReferenceLevel> read_reference(const Study& study, const Json& json, const std::string& where,
                                           std::vector<Problem>& problems) {
    std::vector<ReferenceLevel> reference(study.axes.size());
    for (const auto& [name, level] : json.items()) {
        const std::string place = where + "/" + pointer_token(name);
        const auto number = find_axis(study, name, place, problems);
        if (!number) continue;
        const Axis& axis = study.axes[*number];
        const bool named =
            std::any_of(axis.levels.begin(), axis.levels.end(), [](const Level& l) { return l.name == "finest"; });
        if (level == "finest" && !named) {
            reference[*number].kind = ReferenceLevel::Kind::finest;
            if (!axis.size)
                problems.push_back({place, fmt::format("axis \"{}\" has no sizes, so none of its levels is the finest; "
                                                       "give it a \"size\"",
                                                       name)});
        } else if (const auto found = find_level(axis, level, place, problems)) {
            reference[*number] = {ReferenceLevel::Kind::level, *found};
        }
    }
    if (json.empty()) problems.push_back({where, "which variant? At least one axis is needed"});
    return reference;
}

void check_meaning(const Metric& metric, std::vector<Problem>& problems) {
    const bool particles = metric.type == MetricType::particles;
    if (particles && metric.reduce == Reduction::end)
        problems.push_back({metric.where + "/reduce", "\"rms\", \"max\" or \"mean\" over the particles is needed"});
    const bool rows = !particles && metric.type != MetricType::energy_loss;
    if (metric.at && rows && metric.reduce != Reduction::end)
        problems.push_back({metric.where + "/at", "is one time; \"reduce\" asks for all of them"});
    if (metric.at && metric.frames != Reduction::end)
        problems.push_back({metric.where + "/at", "is one time; \"frames\" asks for all of them"});
    if (!metric.exact.empty() && metric.exact.size() != metric.value.size())
        problems.push_back({metric.where + "/exact", fmt::format("{} expressions for {} of \"value\"",
                                                                 metric.exact.size(), metric.value.size())});
    const bool compares = !metric.exact.empty() || !metric.reference.empty() || !metric.results.empty();
    if (metric.relative && !compares && metric.type != MetricType::convergence)
        problems.push_back({metric.where + "/relative",
                            "to what? \"exact\", \"reference\" or \"results\" is needed, or \"scale\" instead"});
    if (metric.from && metric.to && *metric.from >= *metric.to)
        problems.push_back({metric.where + "/to", "must be later than \"from\""});
}

Metric read_metric(const std::string& name, const Json& json, const Study& study, std::vector<Problem>& problems) {
    Metric metric;
    metric.name = name;
    metric.where = "/metrics/" + pointer_token(name);
    if (name.empty()) problems.push_back({metric.where, "the name of a metric must not be empty"});
    copy_word(json, "type", metric_words, metric.type);
    metric.reduce = usual_reduction(metric.type);
    copy_word(json, "reduce", reduction_words, metric.reduce);
    copy_word(json, "frames", reduction_words, metric.frames);
    copy_word(json, "weight", weight_words, metric.weight);
    copy_word(json, "mirror", axis_words, metric.mirror);
    copy(json, "at", metric.at);
    if (metric.at && !json.contains("reduce") && metric.type != MetricType::particles) metric.reduce = Reduction::end;
    copy(json, "from", metric.from);
    copy(json, "to", metric.to);
    copy(json, "relative", metric.relative);
    copy(json, "scale", metric.scale);
    copy(json, "plane", metric.plane);
    copy(json, "of", metric.of);
    copy(json, "bodies", metric.bodies);
    metric.value = read_expressions(json, "value", metric.where, problems);
    metric.exact = read_expressions(json, "exact", metric.where, problems);
    if (const Json* reference = find(json, "reference"))
        metric.reference = read_reference(study, *reference, metric.where + "/reference", problems);
    if (const Json* results = find(json, "results")) {
        metric.results = (study.file.parent_path() / results->get<std::string>()).lexically_normal();
        if (!std::filesystem::exists(metric.results / "history.csv"))
            problems.push_back({metric.where + "/results", fmt::format("no results of a run: there is no {}",
                                                                       (metric.results / "history.csv").string())});
    }
    if (const Json* axis = find(json, "axis")) {
        const std::string place = metric.where + "/axis";
        if (const auto number = find_axis(study, axis->get<std::string>(), place, problems)) {
            metric.axis = *number;
            const Axis& along = study.axes[*number];
            if (!along.size && !along.threads)
                problems.push_back(
                    {place, fmt::format("axis \"{}\" has no sizes to converge with; give it a \"size\"", along.name)});
            else if (along.levels.size() < 3)
                problems.push_back({place, fmt::format("axis \"{}\" has {} levels; extrapolation takes 3", along.name,
                                                       along.levels.size())});
        }
    }
    check_meaning(metric, problems);
    return metric;
}

std::vector<std::string> metric_names(const Study& study) {
    std::vector<std::string> names;
    for (const Metric& metric : study.metrics) names.push_back(metric.name);
    return names;
}

Metric* find_metric(Study& study, const std::string& name, const std::string& where, std::vector<Problem>& problems) {
    const auto found = std::find_if(study.metrics.begin(), study.metrics.end(),
                                    [&](const Metric& metric) { return metric.name == name; });
    if (found != study.metrics.end()) return &*found;
    const std::vector<std::string> names = metric_names(study);
    const std::string guess = did_you_mean(name, names);
    problems.push_back({where, fmt::format("no metric \"{}\"{}", name,
                                           guess.empty() ? "; there are: " + quoted_list(names, "and") : guess)});
    return nullptr;
}

} // namespace

void expand_short_metrics(Json& document) {
    if (!document.is_object() || !document.contains("metrics") || !document["metrics"].is_object()) return;
    for (Json& metric : document["metrics"])
        if (metric.is_string()) metric = Json{{"value", metric}};
}

void read_metrics(const Json& document, Study& study, std::vector<Problem>& problems) {
    const Json& metrics = part(document, "metrics");
    if (document.contains("metrics") && metrics.empty())
        problems.push_back({"/metrics", "nothing is measured: at least one metric is needed"});
    for (const auto& [name, json] : metrics.items()) study.metrics.push_back(read_metric(name, json, study, problems));
    for (const Metric& metric : study.metrics) {
        if (metric.type != MetricType::convergence || metric.of.empty()) continue;
        const Metric* of = find_metric(study, metric.of, metric.where + "/of", problems);
        if (of && of->type == MetricType::convergence)
            problems.push_back({metric.where + "/of", fmt::format("\"{}\" is of this type itself", metric.of)});
    }
    for (const auto& [name, tolerance] : part(document, "tolerances").items())
        if (Metric* metric = find_metric(study, name, "/tolerances/" + pointer_token(name), problems);
            metric && tolerance.is_number()) // else the check has told
            metric->tolerance = tolerance.get<double>();
}

} // namespace abut
