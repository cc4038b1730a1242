/// Checks of values with parts: vectors, matrices and functions of time.
#include "io/scene/check_parts.h"

#include "io/scene/words.h"
#include "scene/suggest.h"

#include <algorithm>

#include <fmt/format.h>

namespace abut {

namespace {

using Value = CheckedValue;

std::string scene_of(Analysis analysis) {
    if (analysis == Analysis::three_d) return "a 3d scene";
    return analysis == Analysis::axisymmetric ? "an axisymmetric scene" : "a plane scene";
}

/// "a velocity, m/s"; "numbers" for what has no unit.
std::string unit_in_words(const Dimension& dimension) {
    if (dimension == dimensions::none) return "numbers";
    return fmt::format("{}, {} each", name_of(dimension), unit_of(dimension));
}

/// A list of one entry per axis, each checked by `check`; `parts`: what to call them.
std::optional<Json> list_per_axis(const Value& value, const std::string& parts,
                                  std::optional<Json> (*check)(const Value&)) {
    const std::optional<Analysis> analysis = value.checking.analysis;
    const std::string needed = analysis ? std::to_string(dimension(*analysis)) : "2 or 3";
    if (!value.json.is_array())
        return value.wrong_type(fmt::format("a list of {} {} ({})", needed, parts, unit_in_words(value.key.dimension)));
    const std::size_t size = value.json.size();
    if (analysis ? size != std::size_t(dimension(*analysis)) : size != 2 && size != 3)
        return value.wrong(fmt::format("{} {} are needed in {}, not {}", needed, parts,
                                       analysis ? scene_of(*analysis) : "a scene", size));
    Json list = Json::array();
    for (std::size_t i = 0; i < size; ++i) {
        const std::string pointer = fmt::format("{}/{}", value.pointer, i);
        if (std::optional<Json> part = check({value.json[i], value.key, pointer, value.checking}))
            list.push_back(std::move(*part));
    }
    if (list.size() != size) return {};
    return list;
}

/// "angular velocity" of "an angular velocity".
std::string name_without_article(const Dimension& dimension) {
    const std::string name = name_of(dimension);
    return name.substr(name.find(' ') + 1);
}

/// A list of at least so many entries, each checked by `check`; `parts`: what to call them.
std::optional<Json> list_of(const Value& value, std::size_t least, const std::string& parts,
                            std::optional<Json> (*check)(const Value&)) {
    if (!value.json.is_array()) return value.wrong_type("a list of " + parts);
    if (value.json.size() < least)
        return value.wrong(fmt::format("at least {} {} are needed, not {}", least, parts, value.json.size()));
    Json list = Json::array();
    for (std::size_t i = 0; i < value.json.size(); ++i) {
        const std::string pointer = fmt::format("{}/{}", value.pointer, i);
        if (std::optional<Json> part = check({value.json[i], value.key, pointer, value.checking}))
            list.push_back(std::move(*part));
    }
    if (list.size() != value.json.size()) return {};
    return list;
}

const Key time_key{.path = "", .kind = Kind::quantity, .dimension = dimensions::time};
const Key width_key{.path = "", .kind = Kind::quantity, .dimension = dimensions::time, .range = above(0)};

/// Adds a problem for each key that is not in `known`.
bool has_only(const Json& object, const std::vector<std::string>& known, const std::string& pointer,
              Checking& checking) {
    bool good = true;
    for (const auto& [name, value] : object.items()) {
        if (std::find(known.begin(), known.end(), name) != known.end()) continue;
        const std::string guess = did_you_mean(name, known);
        checking.problems.push_back(
            {pointer + "/" + pointer_token(name),
             fmt::format("unknown key \"{}\"{}", name,
                         guess.empty() ? "; known here: " + quoted_list(known, "and") : guess)});
        good = false;
    }
    return good;
}

/// A quantity at a key of an object that must have it.
std::optional<Json> quantity_at(const Json& object, const char* name, const Key& key, const std::string& parent,
                                Checking& checking) {
    const std::string pointer = parent + "/" + name;
    const Json* given = find(object, name);
    if (given) return check_quantity({*given, key, pointer, checking});
    checking.problems.push_back({pointer, "this key is required and missing"});
    return {};
}

/// A list of two or more quantities at a key of a function.
std::optional<Json> quantities_at(const Value& function, const char* name, const Key& key) {
    const std::string pointer = function.pointer + "/" + name;
    const Json* given = find(function.json, name);
    if (!given) {
        function.checking.problems.push_back({pointer, "this key is required and missing"});
        return {};
    }
    const Value list{*given, key, pointer, function.checking};
    if (!given->is_array()) return list.wrong_type("a list [ ]");
    if (given->size() < 2) return list.wrong(fmt::format("at least 2 entries are needed, not {}", given->size()));
    Json checked = Json::array();
    for (std::size_t i = 0; i < given->size(); ++i) {
        const std::string at = fmt::format("{}/{}", pointer, i);
        if (std::optional<Json> entry = check_quantity({(*given)[i], key, at, function.checking}))
            checked.push_back(std::move(*entry));
    }
    if (checked.size() != given->size()) return {};
    return checked;
}

/// {"times": [...], "values": [...]}
std::optional<Json> points(const Value& value) {
    bool good = has_only(value.json, {"times", "values"}, value.pointer, value.checking);
    std::optional<Json> times = quantities_at(value, "times", time_key);
    std::optional<Json> values = quantities_at(value, "values", value.key);
    if (!times || !values) return {};
    if (times->size() != values->size())
        return value.wrong(fmt::format("as many values as times are needed; here are {} times and {} values",
                                       times->size(), values->size()));
    for (std::size_t i = 1; i < times->size(); ++i) {
        const double before = (*times)[i - 1].get<double>();
        if ((*times)[i].get<double>() > before) continue;
        value.checking.problems.push_back({fmt::format("{}/times/{}", value.pointer, i),
                                           fmt::format("must be later than the time before, {} s", before)});
        good = false;
    }
    if (!good) return {};
    return Json{{"times", std::move(*times)}, {"values", std::move(*values)}};
}

/// {"pulse": {"start": 0, "width": ..., "peak": ...}}
std::optional<Json> pulse(const Value& value) {
    bool good = has_only(value.json, {"pulse"}, value.pointer, value.checking);
    const Json& object = value.json["pulse"];
    const std::string pointer = value.pointer + "/pulse";
    const Value whole{object, value.key, pointer, value.checking};
    if (!object.is_object()) return whole.wrong_type("an object { }");
    good = has_only(object, {"start", "width", "peak"}, pointer, value.checking) && good;
    std::optional<Json> start =
        object.contains("start") ? quantity_at(object, "start", time_key, pointer, value.checking) : Json(0.0);
    std::optional<Json> width = quantity_at(object, "width", width_key, pointer, value.checking);
    std::optional<Json> peak = quantity_at(object, "peak", value.key, pointer, value.checking);
    if (!good || !start || !width || !peak) return {};
    const double begin = start->get<double>();
    const double half = width->get<double>() / 2;
    if (!(begin + half > begin && begin + 2 * half > begin + half))
        return whole.wrong("the width is too small beside the start to make a difference");
    return Json{{"pulse", {{"start", *start}, {"width", *width}, {"peak", *peak}}}};
}

} // namespace

std::optional<Json> check_vector(const CheckedValue& value) {
    return list_per_axis(value, "components", check_quantity);
}

std::optional<Json> check_matrix(const CheckedValue& value) {
    return list_per_axis(value, "rows", check_vector);
}

std::optional<Json> check_spin(const CheckedValue& value) {
    if (!value.checking.analysis) return {};
    if (*value.checking.analysis == Analysis::three_d) return check_vector(value);
    if (value.json.is_array())
        return value.wrong(fmt::format("one {} is needed in {}, not a list", name_without_article(value.key.dimension),
                                       scene_of(*value.checking.analysis)));
    return check_quantity(value);
}

std::optional<Json> check_points(const CheckedValue& value) {
    return list_of(value, 3, "points", check_vector);
}

std::optional<Json> check_outlines(const CheckedValue& value) {
    return list_of(value, 0, "lists of points", check_points);
}

std::optional<Json> check_functions(const CheckedValue& value) {
    return list_per_axis(value, "components", check_function);
}

std::optional<Json> check_function(const CheckedValue& value) {
    const Key& key = value.key;
    if (value.json.is_number()) return check_quantity(value);
    if (value.json.is_string()) {
        const auto text = value.json.get<std::string>();
        if (std::find(key.words.begin(), key.words.end(), text) != key.words.end()) return value.json;
        const std::string guess = did_you_mean(text, key.words);
        if (!guess.empty()) return value.wrong(fmt::format("unknown word \"{}\"{}", text, guess));
        return check_quantity(value);
    }
    if (!value.json.is_object())
        return value.wrong_type(fmt::format("{} (a number in {} or a text with a unit) or a function of time {{ }}",
                                            name_of(key.dimension), unit_of(key.dimension)));
    if (value.json.contains("pulse")) return pulse(value);
    if (value.json.contains("times") || value.json.contains("values")) return points(value);
    return value.wrong(R"(a function of time has "times" and "values", or a "pulse"; here is neither)");
}

} // namespace abut
