#pragma once
/// \file scene_schema_rules.h
/// As much of JSON Schema as the scene's schema uses.

#include "io/scene/json.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <regex>
#include <stdexcept>
#include <string>
#include <vector>

namespace abut::scene_test {

/// Whether a text has the pattern; compiling one takes far longer than using it, so each is compiled once.
inline bool has_pattern(const std::string& text, const std::string& pattern) {
    static std::map<std::string, std::regex> compiled;
    return std::regex_search(text, compiled.try_emplace(pattern, pattern).first->second);
}

inline bool has_type(const Json& value, const std::string& type) {
    if (type == "object") return value.is_object();
    if (type == "array") return value.is_array();
    if (type == "string") return value.is_string();
    if (type == "boolean") return value.is_boolean();
    if (type == "number") return value.is_number();
    if (type == "integer") return value.is_number() && std::floor(value.get<double>()) == value.get<double>();
    throw std::logic_error("type " + type);
}

inline bool conforms(const Json& value, const Json& schema);

inline std::size_t matches(const Json& value, const Json& schemas) {
    std::size_t count = 0;
    for (const Json& schema : schemas) count += conforms(value, schema) ? 1 : 0;
    return count;
}

/// One keyword of a schema, of those that ours uses; as in JSON Schema, keywords about another type say nothing.
inline bool keyword_holds(const Json& value, const std::string& keyword, const Json& rule, const Json& schema) {
    if (keyword == "type") return has_type(value, rule);
    if (keyword == "enum") return std::find(rule.begin(), rule.end(), value) != rule.end();
    if (keyword == "const") return value == rule;
    if (keyword == "anyOf") return matches(value, rule) > 0;
    if (keyword == "oneOf") return matches(value, rule) == 1;
    if (keyword == "allOf") return matches(value, rule) == rule.size();
    if (keyword == "not") return !conforms(value, rule);
    if (keyword == "if") {
        const std::string branch = conforms(value, rule) ? "then" : "else";
        return !schema.contains(branch) || conforms(value, schema[branch]);
    }
    if (value.is_number()) {
        if (keyword == "minimum") return value >= rule;
        if (keyword == "maximum") return value <= rule;
        if (keyword == "exclusiveMinimum") return value > rule;
        if (keyword == "exclusiveMaximum") return value < rule;
    }
    if (value.is_string()) {
        if (keyword == "minLength") return value.get<std::string>().size() >= rule.get<std::size_t>();
        if (keyword == "pattern") return has_pattern(value, rule);
    }
    if (value.is_array()) {
        if (keyword == "minItems") return value.size() >= rule.get<std::size_t>();
        if (keyword == "maxItems") return value.size() <= rule.get<std::size_t>();
        if (keyword == "items")
            return std::all_of(value.begin(), value.end(), [&](const Json& item) { return conforms(item, rule); });
    }
    if (value.is_object()) {
        if (keyword == "required")
            return std::all_of(rule.begin(), rule.end(), [&](const Json& key) { return value.contains(key); });
        for (const auto& [key, member] : value.items()) {
            const bool named = schema.contains("properties") && schema["properties"].contains(key);
            if (keyword == "properties" && named && !conforms(member, rule[key])) return false;
            if (keyword == "additionalProperties" && !named && !conforms(member, rule)) return false;
        }
    }
    static const std::vector<std::string> known{"then",
                                                "else",
                                                "$schema",
                                                "title",
                                                "description",
                                                "default",
                                                "minimum",
                                                "maximum",
                                                "exclusiveMinimum",
                                                "exclusiveMaximum",
                                                "minLength",
                                                "pattern",
                                                "minItems",
                                                "maxItems",
                                                "items",
                                                "required",
                                                "properties",
                                                "additionalProperties"};
    if (std::find(known.begin(), known.end(), keyword) == known.end()) throw std::logic_error("keyword " + keyword);
    return true;
}

inline bool conforms(const Json& value, const Json& schema) {
    if (schema.is_boolean()) return schema.get<bool>();
    for (const auto& [keyword, rule] : schema.items())
        if (!keyword_holds(value, keyword, rule, schema)) return false;
    return true;
}

} // namespace abut::scene_test
