#include "io/scene/check.h"

#include "scene/suggest.h"

#include <algorithm>
#include <iterator>

#include <fmt/format.h>

namespace abut {

namespace {

using Problems = std::vector<Problem>;
using Node = SpecificationNode;

std::optional<Json> check_node(const Json& value, const Node& node, const std::string& pointer, Problems& problems);

/// How a key stands to its neighbour: OnlyWith holds, does not hold, or cannot be known as the neighbour is wrong.
enum class Place { right, wrong, unknown };

struct PlaceOf {
    Place place = Place::right;
    Json neighbour{}; ///< the neighbour's value
};

PlaceOf place_of(const Key& key, const Json& object, const Node& node) {
    if (!key.only_with) return {};
    const Key& neighbour = *node.find(key.only_with->key)->key;
    const Json* given = find(object, key.only_with->key);
    if (!given && !neighbour.otherwise) return {Place::unknown};
    const Json value = given ? *given : Json::parse(*neighbour.otherwise);
    Problems ignored;
    if (!check_value(value, neighbour, "", ignored)) return {Place::unknown};
    return {value == Json::parse(key.only_with->value) ? Place::right : Place::wrong, value};
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
                                Problems& problems) {
    const Json* given = find(object, child.name);
    const Key& key = *child.key;
    const PlaceOf place = place_of(key, object, node);
    if (given && place.place == Place::wrong) {
        problems.push_back({pointer, fmt::format("only goes with \"{}\": {}; here it is {}", key.only_with->key,
                                                 key.only_with->value, place.neighbour.dump())});
        return {};
    }
    if (given) return check_node(*given, child, pointer, problems);
    if (place.place != Place::right) return {};
    if (key.required) {
        problems.push_back({pointer, "this key is required and missing. " + key.meaning});
        return {};
    }
    if (key.otherwise && !replaced(child.name, object, node))
        return check_node(Json::parse(*key.otherwise), child, pointer, problems);
    return {};
}

Json check_object(const Json& object, const Node& node, const std::string& pointer, Problems& problems) {
    Json checked = Json::object();
    for (const Node& child : node.children) {
        std::optional<Json> value = check_child(object, node, child, pointer + "/" + child.name, problems);
        if (value) checked[child.name] = std::move(*value);
    }
    for (const auto& [name, value] : object.items())
        if (!node.find(name)) report_unknown_key(name, node, pointer, problems);
    for (const Group* group : node.groups) check_group(*group, object, pointer, problems);
    return checked;
}

Json check_list(const Json& list, const Node& node, const std::string& pointer, Problems& problems) {
    if (!contains(node.key->range, static_cast<double>(list.size()))) {
        const Range& range = node.key->range;
        const std::string needed =
            range.minimum == range.maximum ? fmt::format("exactly {}", *range.minimum) : in_words(range, "");
        problems.push_back({pointer, fmt::format("{} entries are needed, not {}", needed, list.size())});
    }
    Json checked = Json::array();
    const Node& entry = node.children.front();
    for (std::size_t i = 0; i < list.size(); ++i) {
        std::optional<Json> value = check_node(list[i], entry, fmt::format("{}/{}", pointer, i), problems);
        // Something must hold the place of a wrong entry, or later pointers would name the wrong one.
        checked.push_back(value ? std::move(*value) : entry.key->kind == Kind::object ? Json::object() : Json(""));
    }
    return checked;
}

Json check_map(const Json& map, const Node& node, const std::string& pointer, Problems& problems) {
    Json checked = Json::object();
    for (const auto& [name, value] : map.items()) {
        std::optional<Json> entry =
            check_node(value, node.children.front(), pointer + "/" + pointer_token(name), problems);
        checked[name] = entry ? std::move(*entry) : Json::object();
    }
    return checked;
}

std::optional<Json> check_node(const Json& value, const Node& node, const std::string& pointer, Problems& problems) {
    const Kind kind = node.key->kind;
    const bool list = kind == Kind::list;
    if (!list && kind != Kind::object && kind != Kind::map) return check_value(value, *node.key, pointer, problems);
    if (list ? !value.is_array() : !value.is_object()) {
        problems.push_back(
            {pointer, fmt::format("{} is needed, not {}", list ? "a list [ ]" : "an object { }", in_words(value))});
        return {};
    }
    if (list) return check_list(value, node, pointer, problems);
    if (kind == Kind::map) return check_map(value, node, pointer, problems);
    return check_object(value, node, pointer, problems);
}

} // namespace

CheckedScene check_scene(const Json& scene) {
    CheckedScene result{Json::object(), {}};
    std::optional<Json> checked = check_node(scene, scene_specification(), "", result.problems);
    if (checked) result.scene = std::move(*checked);
    return result;
}

} // namespace abut
