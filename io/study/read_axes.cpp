#include "io/scene/bind_parts.h"
#include "io/scene/check.h"
#include "io/study/read_study_parts.h"
#include "scene/suggest.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

namespace abut {

namespace {

std::vector<std::string> level_names(const Axis& axis) {
    std::vector<std::string> names;
    for (const Level& level : axis.levels) names.push_back(level.name);
    return names;
}

/// What a level is called that is only a value.
std::string name_of_value(const Json& value) {
    return value.is_string() ? value.get<std::string>() : value.dump();
}

/// Whether a value of a scene looks like a number or a quantity.
bool is_number(const Json& value) {
    if (!value.is_string()) return value.is_number();
    const auto& text = value.get_ref<const std::string&>();
    return !text.empty() && std::string("0123456789.+-").find(text[0]) != std::string::npos;
}

void read_values(const Json& json, const std::string& where, Axis& axis, std::vector<Problem>& problems) {
    const Json* pointer = find(json, "pointer");
    if (!pointer) {
        problems.push_back({where, "\"values\" are of a \"pointer\", which is missing"});
        return;
    }
    const Json& values = json["values"];
    for (const Json& value : values)
        axis.levels.push_back(
            {name_of_value(value), {{pointer->get<std::string>(), value.dump(), where + "/pointer"}}, {}});
    if (std::all_of(values.begin(), values.end(), is_number))
        axis.size = Setting{pointer->get<std::string>(), "", where + "/pointer"};
}

void read_variants(const Json& json, const std::string& where, Axis& axis) {
    for (const auto& [name, settings] : json["variants"].items()) {
        Level& level = axis.levels.emplace_back(Level{name, {}, {}});
        const std::string place = where + "/variants/" + pointer_token(name);
        for (const auto& [pointer, value] : settings.items())
            level.settings.push_back({pointer, value.dump(), place + "/" + pointer_token(pointer)});
    }
}

Axis read_axis(const std::string& name, const Json& json, std::vector<Problem>& problems) {
    Axis axis;
    axis.name = name;
    const std::string where = "/axes/" + pointer_token(name);
    if (name.empty()) problems.push_back({where, "the name of an axis must not be empty"});
    if (json.contains("values")) read_values(json, where, axis, problems);
    if (json.contains("variants")) read_variants(json, where, axis);
    if (json.contains("threads")) {
        axis.threads = true;
        for (const Json& count : json["threads"])
            if (count.is_number()) // else the check has told
                axis.levels.push_back({count.dump(), {}, count.get<int>()});
    }
    if (const Json* size = find(json, "size")) {
        if (axis.threads) problems.push_back({where + "/size", "threads are their own size; leave this out"});
        axis.size = Setting{size->get<std::string>(), "", where + "/size"};
    }
    const bool listed = json.contains("variants") || json.contains("values") || axis.threads;
    if (axis.levels.empty() && listed) problems.push_back({where, "at least one level is needed"});
    std::vector<std::string> names = level_names(axis);
    std::sort(names.begin(), names.end());
    const auto twice = std::adjacent_find(names.begin(), names.end());
    if (twice != names.end()) problems.push_back({where, fmt::format("the level \"{}\" is there twice", *twice)});
    if (const Json* center = find(json, "center"); center && !axis.levels.empty())
        axis.center = find_level(axis, *center, where + "/center", problems).value_or(0);
    return axis;
}

/// The levels that a selection has of one axis.
std::vector<std::size_t> read_levels(const Axis& axis, const Json& json, const std::string& where,
                                     std::vector<Problem>& problems) {
    std::vector<std::size_t> levels(axis.levels.size());
    std::iota(levels.begin(), levels.end(), 0);
    if (json == "*") return levels;
    levels.clear();
    const Json list = json.is_array() ? json : Json::array({json});
    for (std::size_t i = 0; i < list.size(); ++i) {
        const std::string place = json.is_array() ? fmt::format("{}/{}", where, i) : where;
        if (const auto level = find_level(axis, list[i], place, problems)) levels.push_back(*level);
    }
    if (list.empty()) problems.push_back({where, "a level, or a list of some, is needed"});
    return levels;
}

/// \param others whether axes that are not named may have any level; else they are at their centers
LevelChoice read_choice(const Study& study, const Json& json, const std::string& where, bool others,
                        std::vector<Problem>& problems) {
    LevelChoice choice;
    for (const Axis& axis : study.axes) {
        std::vector<std::size_t>& levels = choice.emplace_back(others ? axis.levels.size() : 1, axis.center);
        if (others) std::iota(levels.begin(), levels.end(), 0);
    }
    if (!json.is_object()) {
        problems.push_back({where, "an object { }, from axes to levels, is needed, not " + in_words(json)});
        return choice;
    }
    for (const auto& [name, levels] : json.items()) {
        const std::string place = where + "/" + pointer_token(name);
        if (const auto axis = find_axis(study, name, place, problems))
            choice[*axis] = read_levels(study.axes[*axis], levels, place, problems);
    }
    return choice;
}

void read_combine(const Json& document, Study& study, std::vector<Problem>& problems) {
    const Json* combine = find(document, "combine");
    if (!combine || *combine == "product") return;
    if (*combine == "one-at-a-time") {
        study.combine = Combine::one_at_a_time;
    } else if (combine->is_array()) {
        study.combine = Combine::chosen;
        for (std::size_t i = 0; i < combine->size(); ++i)
            study.chosen.push_back(read_choice(study, (*combine)[i], fmt::format("/combine/{}", i), false, problems));
    } else {
        const std::string text = combine->is_string() ? combine->get<std::string>() : "";
        problems.push_back(
            {"/combine", fmt::format("\"product\", \"one-at-a-time\" or a list of selections is needed, "
                                     "not {}{}",
                                     in_words(*combine), did_you_mean(text, {"product", "one-at-a-time"}))});
    }
}

} // namespace

std::optional<std::size_t> find_level(const Axis& axis, const Json& level, const std::string& where,
                                      std::vector<Problem>& problems) {
    const std::string name = name_of_value(level);
    for (std::size_t i = 0; i < axis.levels.size(); ++i)
        if (axis.levels[i].name == name) return i;
    const std::vector<std::string> names = level_names(axis);
    const std::string guess = did_you_mean(name, names);
    problems.push_back({where, fmt::format("axis \"{}\" has no level \"{}\"{}", axis.name, name,
                                           guess.empty() ? "; there are: " + quoted_list(names, "and") : guess)});
    return {};
}

std::optional<std::size_t> find_axis(const Study& study, const std::string& name, const std::string& where,
                                     std::vector<Problem>& problems) {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < study.axes.size(); ++i) {
        if (study.axes[i].name == name) return i;
        names.push_back(study.axes[i].name);
    }
    const std::string guess = did_you_mean(name, names);
    problems.push_back({where, fmt::format("no axis \"{}\"{}", name,
                                           guess.empty() ? "; there are: " + quoted_list(names, "and") : guess)});
    return {};
}

void read_axes(const Json& document, Study& study, std::vector<Problem>& problems) {
    const Json& axes = part(document, "axes");
    if (document.contains("axes") && axes.empty())
        problems.push_back({"/axes", "nothing varies: at least one axis is needed"});
    for (const auto& [name, json] : axes.items()) study.axes.push_back(read_axis(name, json, problems));
    read_combine(document, study, problems);
    const Json& except = part(document, "except");
    for (std::size_t i = 0; i < except.size(); ++i)
        study.except.push_back(read_choice(study, except[i], fmt::format("/except/{}", i), true, problems));
}

} // namespace abut
