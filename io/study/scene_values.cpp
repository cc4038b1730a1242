#include "io/study/scene_values.h"

#include "io/scene/specification.h"
#include "io/scene/units.h"
#include "scene/suggest.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace abut {

namespace {

std::vector<std::string> tokens_of(const std::string& pointer) {
    try {
        std::vector<std::string> tokens;
        for (Json::json_pointer place(pointer); !place.empty(); place.pop_back()) tokens.push_back(place.back());
        std::reverse(tokens.begin(), tokens.end());
        return tokens;
    } catch (const Json::exception&) {
        throw NoNumber(fmt::format("\"{}\" is no JSON pointer; write for example /grid/cell", pointer));
    }
}

std::vector<std::string> keys_of(const Json& object) {
    std::vector<std::string> keys;
    for (const auto& [key, value] : object.items()) keys.push_back(key);
    return keys;
}

/// What stands at a token of an object or list; null if nothing does.
const Json* step_into(const Json& json, const std::string& token) {
    if (json.is_object()) return find(json, token);
    if (!json.is_array()) return nullptr;
    std::size_t index = 0;
    const char* const end = token.data() + token.size();
    const auto [stop, error] = std::from_chars(token.data(), end, index);
    return error == std::errc() && stop == end && index < json.size() ? &json[index] : nullptr;
}

double parameter(const Setting& setting, const Json& scene, const std::vector<Constant>& before) {
    const Json value = Json::parse(setting.value);
    if (value.is_number()) return value.get<double>();
    const auto& text = value.get_ref<const std::string&>();
    if (text.starts_with('/')) return number_at(scene, text);
    try {
        return parse_quantity(text).value;
    } catch (const UnitError&) { // no quantity, so an expression
        return Expression(text, {}, before)({});
    }
}

} // namespace

double number_at(const Json& resolved_scene, const std::string& pointer) {
    const Json* place = &resolved_scene;
    std::string reached;
    for (const std::string& token : tokens_of(pointer)) {
        const Json* next = step_into(*place, token);
        if (!next) {
            const std::string guess = place->is_object() ? did_you_mean(token, keys_of(*place)) : "";
            throw NoNumber(
                fmt::format("the scene has no \"{}\": \"{}\" has no \"{}\"{}", pointer, reached, token, guess));
        }
        place = next;
        reached += "/" + pointer_token(token);
    }
    if (place->is_number()) return place->get<double>();
    const auto is_number = [](const Json& entry) { return entry.is_number(); };
    if (!place->is_array() || place->empty() || !std::all_of(place->begin(), place->end(), is_number))
        throw NoNumber(fmt::format("there is no number at \"{}\" of the scene", pointer));
    double largest = (*place)[0].get<double>();
    for (const Json& entry : *place) largest = std::max(largest, entry.get<double>());
    return largest;
}

std::string unit_at(const std::string& pointer) {
    const SpecificationNode* node = &scene_specification();
    for (const std::string& token : tokens_of(pointer)) {
        const SpecificationNode* next = node->find(token);
        for (const char* any : {"#", "*"})
            if (!next) next = node->find(any);
        if (!next) break; // a component
        node = next;
    }
    const std::string unit = unit_of(node->key->dimension);
    return unit == "1" ? "" : unit;
}

std::vector<Constant> parameters_of(const Study& study, const Json& resolved_scene, std::string& where) {
    std::vector<Constant> constants;
    for (const Setting& setting : study.parameters) {
        where = setting.where;
        const double value = parameter(setting, resolved_scene, constants);
        if (!std::isfinite(value)) throw std::runtime_error(fmt::format("{} is not a number here", setting.pointer));
        constants.push_back({setting.pointer, value});
    }
    return constants;
}

} // namespace abut
