#include "io/study/read_study.h"

#include "expression/expression.h"
#include "io/results/checksum.h"
#include "io/scene/bind_parts.h"
#include "io/scene/check.h"
#include "io/scene/overrides.h"
#include "io/scene/parse_json.h"
#include "io/study/read_study_parts.h"
#include "io/study/specification_study.h"
#include "scene/suggest.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>

namespace abut {

namespace {

std::string below(const std::string& pointer, const std::string& name) {
    return pointer + "/" + pointer_token(name);
}

/// The content of a file; a message instead if it can't be read.
std::optional<std::string> read_file(const std::filesystem::path& file, std::string& message) {
    std::error_code ignored;
    if (std::filesystem::is_directory(file, ignored)) {
        message = "it is a folder";
        return {};
    }
    errno = 0;
    std::ifstream stream(file, std::ios::binary);
    std::string text{std::istreambuf_iterator<char>(stream), {}};
    if (stream && !stream.bad()) return text;
    message = std::strerror(errno);
    return {};
}

/// The scene that varies, as text; nothing if there is none.
void read_base(const Json& document, Study& study, std::vector<Problem>& problems) {
    const Json* base = find(document, "base");
    if (!base) return;
    if (base->is_object()) {
        study.base = base->dump();
        return;
    }
    if (!base->is_string() || base->get_ref<const std::string&>().empty()) {
        problems.push_back({"/base", "a path of a scene, or a scene itself, is needed, not " + in_words(*base)});
        return;
    }
    const std::filesystem::path written = base->get<std::string>();
    study.base_file = (study.file.parent_path() / written).lexically_normal();
    std::string message;
    if (std::optional<std::string> text = read_file(study.base_file, message))
        study.base = std::move(*text);
    else
        problems.push_back({"/base", fmt::format("cannot read the scene {}: {}", study.base_file.string(), message)});
}

void read_settings(const Json& document, Study& study) {
    for (const auto& [pointer, value] : part(document, "set").items())
        study.settings.push_back({pointer, value.dump(), below("/set", pointer)});
    if (const Json* end = find(document, "end")) study.settings.push_back({"/time/end", end->dump(), "/end"});
}

void read_parameters(const Json& document, Study& study, std::vector<Problem>& problems) {
    for (const auto& [name, value] : part(document, "parameters").items()) {
        const std::string where = below("/parameters", name);
        if (expression_name(name) != name)
            problems.push_back(
                {where, fmt::format("\"{}\" can't be a name in expressions; write {}", name, expression_name(name))});
        else if (!value.is_number() && !value.is_string())
            problems.push_back({where, "a number or a text is needed, not " + in_words(value)});
        else
            study.parameters.push_back({name, value.dump(), where});
    }
}

/// Tries all settings on the base scene with the other axes at their centers: pointers must name something.
void check_pointers(const Study& study, std::vector<Problem>& problems) {
    const ParsedJson base = parse_json(study.base);
    if (!base.value || !base.value->is_object()) return; // make_variants() tells of it
    const auto apply = [&](Json& scene, const std::vector<Setting>& settings, bool tell) {
        for (const Setting& setting : settings) {
            const auto message = apply_setting(scene, setting.pointer, Json::parse(setting.value));
            const auto same = [&](const Problem& p) { return p.pointer == setting.where && p.message == *message; };
            if (message && tell && std::none_of(problems.begin(), problems.end(), same))
                problems.push_back({setting.where, *message});
        }
    };
    Json common = *base.value;
    apply(common, study.settings, true);
    for (const Axis& varied : study.axes)
        for (const Level& level : varied.levels) {
            Json scene = common;
            for (const Axis& axis : study.axes)
                if (&axis != &varied && axis.center < axis.levels.size())
                    apply(scene, axis.levels[axis.center].settings, false);
            apply(scene, level.settings, true);
        }
}

/// Axes and metrics become columns of study.csv, which must differ.
void check_names(const Study& study, std::vector<Problem>& problems) {
    const auto complain = [&](const std::string& where, const std::string& name, const char* what) {
        problems.push_back({where, fmt::format("\"{}\" is {}; study.csv needs another name", name, what)});
    };
    for (const Axis& axis : study.axes)
        if (is_study_column(axis.name)) complain(below("/axes", axis.name), axis.name, "a column of every study.csv");
    for (const Metric& metric : study.metrics) {
        if (is_study_column(metric.name)) complain(metric.where, metric.name, "a column of every study.csv");
        for (const Axis& axis : study.axes)
            if (axis.name == metric.name) complain(metric.where, metric.name, "an axis, too");
    }
}

} // namespace

Study read_study(const std::filesystem::path& file) {
    std::string message;
    const std::optional<std::string> text = read_file(file, message);
    if (!text) throw SceneError(file.string(), {{"", "cannot read the study file: " + message}});
    ParsedJson parsed = parse_json(*text);
    std::vector<Problem> problems = std::move(parsed.problems);
    if (!parsed.value) throw SceneError(file.string(), problems);
    expand_short_metrics(*parsed.value);

    const CheckedScene checked = check_document(*parsed.value, study_specification());
    problems.insert(problems.end(), checked.problems.begin(), checked.problems.end());
    Study study;
    study.file = file;
    study.checksum = checksum_of(*text);
    copy(checked.scene, "title", study.title);
    copy(checked.scene, "repeats", study.repeats);
    copy(checked.scene, "threads", study.threads);
    copy(checked.scene, "time_limit", study.time_limit);
    read_base(checked.scene, study, problems);
    read_settings(checked.scene, study);
    read_parameters(checked.scene, study, problems);
    read_axes(checked.scene, study, problems);
    read_metrics(checked.scene, study, problems);
    if (!problems.empty()) throw SceneError(file.string(), problems);
    check_names(study, problems);
    check_pointers(study, problems);
    if (!problems.empty()) throw SceneError(file.string(), problems);
    return study;
}

} // namespace abut
