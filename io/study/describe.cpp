#include "io/study/describe.h"

#include "io/study/scene_values.h"
#include "io/study/specification_study.h"

#include <fmt/format.h>

namespace abut {

namespace {

std::string joined(const std::vector<std::string>& texts) {
    std::string result;
    for (const std::string& text : texts) result += (result.empty() ? "" : ", ") + text;
    return texts.size() > 1 ? "(" + result + ")" : result;
}

std::string describe_reference(const Study& study, const Metric& metric) {
    std::string text;
    for (std::size_t a = 0; a < study.axes.size(); ++a) {
        const ReferenceLevel& level = metric.reference[a];
        if (level.kind == ReferenceLevel::Kind::own) continue;
        const bool finest = level.kind == ReferenceLevel::Kind::finest;
        text += fmt::format("{}{} {}", text.empty() ? "" : ", ", study.axes[a].name,
                            finest ? "finest" : study.axes[a].levels[level.level].name);
    }
    return text;
}

std::string describe_when(const Metric& metric) {
    if (metric.at) return fmt::format(" at {:g} s", *metric.at);
    std::string text;
    if (metric.from) text += fmt::format(" from {:g} s", *metric.from);
    if (metric.to) text += fmt::format(" to {:g} s", *metric.to);
    return text;
}

std::string describe_divisor(const Metric& metric) {
    if (metric.relative) return ", relative";
    return metric.scale.empty() ? "" : ", over " + metric.scale;
}

bool is_error(const Metric& metric) {
    const bool plain = metric.type == MetricType::history || metric.type == MetricType::particles;
    return !plain || !metric.exact.empty() || !metric.reference.empty() || !metric.results.empty();
}

} // namespace

std::string describe(const Study& study, const Metric& metric) {
    const auto reduction = std::string(text_of(reduction_words, metric.reduce));
    switch (metric.type) {
    case MetricType::history:
    case MetricType::particles: {
        const bool particles = metric.type == MetricType::particles;
        std::string text = reduction + " of " + joined(metric.value) + (particles ? " over particles" : "");
        if (!metric.exact.empty()) text += " against " + joined(metric.exact);
        if (!metric.reference.empty()) text += " against the run with " + describe_reference(study, metric);
        if (!metric.results.empty()) text += " against " + metric.results.string();
        if (metric.frames != Reduction::end)
            text += fmt::format(", {} over the frames", text_of(reduction_words, metric.frames));
        return text + describe_when(metric) + describe_divisor(metric);
    }
    case MetricType::convergence:
        return fmt::format("distance of {} from its limit along {}{}", metric.of, study.axes[metric.axis].name,
                           metric.relative ? ", relative" : "");
    case MetricType::energy_loss:
        return "energy missing from the balance, over the largest total energy" + describe_when(metric);
    case MetricType::balance_error:
        return reduction + " of the energy missing from the balance, over the largest total energy";
    case MetricType::interpenetration:
        return reduction + " of the area that bodies share, over the area of all" + describe_when(metric);
    case MetricType::momentum_error:
        return reduction + " of the momentum that no force brought, over the largest of all bodies" +
               describe_divisor(metric);
    case MetricType::symmetry_error:
        return fmt::format("{} of displacements less their mirror image in {} = {:g} m, over displacements{}{}",
                           reduction, text_of(axis_words, metric.mirror), metric.plane, describe_when(metric),
                           describe_divisor(metric));
    }
    return "";
}

StudyResults describe(const Study& study) {
    StudyResults results;
    results.version = ABUT_VERSION;
    results.title = study.title;
    results.file = study.file.string();
    results.checksum = study.checksum;
    results.repeats = study.repeats;
    for (const Axis& axis : study.axes) {
        AxisResult& result = results.axes.emplace_back();
        result.name = axis.name;
        for (const Level& level : axis.levels) result.levels.push_back(level.name);
        result.center = axis.center;
        if (axis.threads) result.size = "threads";
        if (!axis.size) continue;
        result.size = axis.size->pointer;
        result.unit = unit_at(axis.size->pointer);
    }
    for (const Metric& metric : study.metrics)
        results.metrics.push_back({metric.name, std::string(text_of(metric_words, metric.type)),
                                   describe(study, metric), is_error(metric), metric.tolerance});
    return results;
}

} // namespace abut
