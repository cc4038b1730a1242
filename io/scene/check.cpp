#include "io/scene/check.h"

#include "io/scene/words.h"
#include "scene/suggest.h"

#include <algorithm>
#include <iterator>

#include <fmt/format.h>

namespace abut {

namespace {

using Problems = std::vector<Problem>;
using Node = SpecificationNode;

std::optional<Json> check_node(const Json& value, const Node& node, const std::string& pointer, Checking& checking);

/// How a key stands to its neighbour: OnlyWith holds, does not hold, or cannot be known as the neighbour is wrong.
enum class Place { right, wrong, unknown };

struct PlaceOf {
    Place place = Place::right;
    Json neighbour{}; ///< the neighbour's value; null: it is not there
};

PlaceOf place_of(const Key& key, const Json& object, const Node& node, const Checking& checking) {
    if (!key.only_with) return {};
    const OnlyWith& only = *key.only_with;
    const Key& neighbour = *(only.of_scene() ? checking.specification : node).find(only.name())->key;
    const Json* given = find(only.of_scene() ? checking.scene : object, only.name());
    if (only.values.empty()) return {given ? Place::right : Place::wrong};
    if (!given && !neighbour.otherwise) return {Place::unknown};
    const Json value = given ? *given : Json::parse(*neighbour.otherwise);
    Problems ignored;
    Checking silent{checking.scene, checking.analysis, ignored, checking.specification};
    if (!check_value(value, neighbour, "", silent)) return {Place::unknown};
    const bool right = std::any_of(only.values.begin(), only.values.end(),
                                   [&](const std::string& allowed) { return value == Json::parse(allowed); });
    return {right ? Place::right : Place::wrong, value};
}

std::string wrong_place(const OnlyWith& only, const Json& neighbour) {
    if (only.values.empty()) return fmt::format("only goes with \"{}\", which is not given", only.name());
    std::string values;
    for (std::size_t i = 0; i < only.values.size(); ++i)
        values += (i == 0 ? "" : i + 1 == only.values.size() ? " or " : ", ") + only.values[i];
    return fmt::format("only goes with \"{}\": {}; here it is {}{}", only.name(), values, neighbour.dump(),
                       only.why.empty() ? "" : "; " + only.why);
}

void report_unknown_key(const std::string& name, const Node& node, const std::string& pointer, Problems& problems) {
    const std::vector<std::string> known = key_names(node);
    const std::string guess = did_you_mean(name, known);
    const std::string help = guess.empty() ? "; known here: " + quoted_list(known, "and") : guess;
    problems.push_back({pointer + "/" + pointer_token(name), fmt::format("unknown key \"{}\"{}", name, help)});
}

std::vector<std::string> given_keys(const Group& group, const Json& object) {
    std::vector<std::string> given;
    std::copy_if(group.keys.begin(), group.keys.end(), std::back_inserter(given),
                 [&](const std::string& key) { return object.contains(key); });
    return given;
}

void check_group(const Group& group, const Json& object, const std::string& pointer, Problems& problems) {
    const std::vector<std::string> given = given_keys(group, object);
    const std::size_t allowed = group.count == Count::exactly_two ? 2 : 1;
    if (given.size() == allowed || (given.empty() && group.count == Count::at_most_one)) return;
    const std::string_view how_many = group.count == Count::exactly_two   ? "exactly two"
                                      : group.count == Count::exactly_one ? "exactly one"
                                                                          : "at most one";
    const bool missing = given.size() < allowed;
    const std::string found = given.empty() ? "is none" : (missing ? "is only " : "are ") + quoted_list(given, "and");
    problems.push_back({pointer, fmt::format("{} of {} {} {}; here {}", how_many, quoted_list(group.keys, "and"),
                                             allowed == 2 ? "are" : "is", missing ? "needed" : "allowed", found)});
}

/// Whether a default has to stay away because another key of its group is there.
bool replaced(const std::string& key, const Json& object, const Node& node) {
    return std::any_of(node.groups.begin(), node.groups.end(), [&](const Group* group) {
        const bool member = std::find(group->keys.begin(), group->keys.end(), key) != group->keys.end();
        return member && !given_keys(*group, object).empty();
    });
}

/// A key of an object: its checked value or default, if it has any.
std::optional<Json> check_child(const Json& object, const Node& node, const Node& child, const std::string& pointer,
                                Checking& checking) {
    const Json* given = find(object, child.name);
    const Key& key = *child.key;
    const PlaceOf place = place_of(key, object, node, checking);
    if (given && place.place == Place::wrong) {
        checking.problems.push_back({pointer, wrong_place(*key.only_with, place.neighbour)});
        return {};
    }
    const bool has_substitute = !key.unless.empty() && find(object, key.unless);
    if (given && has_substitute) {
        checking.problems.push_back({pointer, fmt::format("does not go with \"{}\"", key.unless)});
        return {};
    }
    if (given) return check_node(*given, child, pointer, checking);
    if (has_substitute) return {};
    if (place.place != Place::right) return {};
    if (key.required) {
        checking.problems.push_back({pointer, "this key is required and missing. " + key.meaning});
        return {};
    }
    if (key.otherwise && !replaced(child.name, object, node))
        return check_node(default_of(key, checking.analysis), child, pointer, checking);
    return {};
}

Json check_object(const Json& object, const Node& node, const std::string& pointer, Checking& checking) {
    Json checked = Json::object();
    for (const Node& child : node.children) {
        std::optional<Json> value = check_child(object, node, child, pointer + "/" + child.name, checking);
        if (value) checked[child.name] = std::move(*value);
    }
    for (const auto& [name, value] : object.items())
        if (!node.find(name)) report_unknown_key(name, node, pointer, checking.problems);
    for (const Group* group : node.groups) check_group(*group, object, pointer, checking.problems);
    return checked;
}

Json check_list(const Json& list, const Node& node, const std::string& pointer, Checking& checking) {
    if (!contains(node.key->range, static_cast<double>(list.size()))) {
        const Range& range = node.key->range;
        const std::string needed =
            range.minimum == range.maximum ? fmt::format("exactly {}", *range.minimum) : in_words(range, "");
        checking.problems.push_back({pointer, fmt::format("{} entries are needed, not {}", needed, list.size())});
    }
    Json checked = Json::array();
    const Node& entry = node.children.front();
    for (std::size_t i = 0; i < list.size(); ++i) {
        std::optional<Json> value = check_node(list[i], entry, fmt::format("{}/{}", pointer, i), checking);
        // Something must hold the place of a wrong entry, or later pointers would name the wrong one.
        checked.push_back(value ? std::move(*value) : entry.key->kind == Kind::object ? Json::object() : Json(""));
    }
    return checked;
}

Json check_map(const Json& map, const Node& node, const std::string& pointer, Checking& checking) {
    Json checked = Json::object();
    for (const auto& [name, value] : map.items()) {
        std::optional<Json> entry =
            check_node(value, node.children.front(), pointer + "/" + pointer_token(name), checking);
        checked[name] = entry ? std::move(*entry) : Json::object();
    }
    return checked;
}

std::optional<Json> check_node(const Json& value, const Node& node, const std::string& pointer, Checking& checking) {
    const Kind kind = node.key->kind;
    const bool list = kind == Kind::list;
    if (!list && kind != Kind::object && kind != Kind::map) return check_value(value, *node.key, pointer, checking);
    if (list ? !value.is_array() : !value.is_object()) {
        checking.problems.push_back(
            {pointer, fmt::format("{} is needed, not {}", list ? "a list [ ]" : "an object { }", in_words(value))});
        return {};
    }
    if (list) return check_list(value, node, pointer, checking);
    if (kind == Kind::map) return check_map(value, node, pointer, checking);
    return check_object(value, node, pointer, checking);
}

} // namespace

std::optional<Analysis> analysis_of(const Json& scene) {
    const Json* given = find(scene, "analysis");
    const Json word = given ? *given : Json::parse(*scene_specification().find("analysis")->key->otherwise);
    if (!word.is_string()) return {};
    return value_of(analysis_words, word.get_ref<const std::string&>());
}

Json default_of(const Key& key, std::optional<Analysis> analysis) {
    Json value = Json::parse(*key.otherwise);
    const bool vector = key.kind == Kind::vector || (key.kind == Kind::per_axis && value.is_array());
    const std::size_t components = vector && analysis ? std::size_t(dimension(*analysis)) : 0;
    while (value.size() < components) value.push_back(0);
    return value;
}

CheckedScene check_scene(const Json& scene) {
    CheckedScene result{Json::object(), {}};
    Checking checking{scene, analysis_of(scene), result.problems};
    std::optional<Json> checked = check_node(scene, scene_specification(), "", checking);
    if (checked) result.scene = std::move(*checked);
    return result;
}

CheckedScene check_document(const Json& document, const SpecificationNode& specification) {
    CheckedScene result{Json::object(), {}};
    Checking checking{document, {}, result.problems, specification};
    std::optional<Json> checked = check_node(document, specification, "", checking);
    if (checked) result.scene = std::move(*checked);
    return result;
}

} // namespace abut
