#include "io/scene/json.h"
#include "io/scene/read_scene.h"
#include "io/scene/specification.h"
#include "io/scene/words.h"
#include "scene/scene.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

namespace abut {

namespace {

void add_range(Json& schema, const Range& range) {
    if (range.minimum) schema[range.minimum_excluded ? "exclusiveMinimum" : "minimum"] = *range.minimum;
    if (range.maximum) schema[range.maximum_excluded ? "exclusiveMaximum" : "maximum"] = *range.maximum;
}

Json number_schema(const char* type, const Range& range) {
    Json schema{{"type", type}};
    add_range(schema, range);
    return schema;
}

/// A number in SI, or a text of a number and a unit (whether it is the right unit a schema cannot say).
Json quantity_schema(const Key& key) {
    if (key.dimension == dimensions::none) return number_schema("number", key.range);
    static constexpr const char* number_and_unit =
        R"(^\s*[-+]?([0-9]+\.?[0-9]*|\.[0-9]+)([eE][-+]?[0-9]+)?\s*([^\s0-9.]|1\s*/).*$)";
    return {{"anyOf",
             Json::array({number_schema("number", key.range), {{"type", "string"}, {"pattern", number_and_unit}}})}};
}

/// A list of one part per axis; how many that is analysis_schema() says.
Json per_axis_schema(Json part) {
    return {{"type", "array"}, {"items", std::move(part)}, {"minItems", 2}, {"maxItems", 3}};
}

Json points_schema(const Key& key) {
    return {{"type", "array"}, {"items", per_axis_schema(quantity_schema(key))}, {"minItems", 3}};
}

Json object_of(const Json& properties, const std::vector<std::string>& required) {
    return {{"type", "object"}, {"properties", properties}, {"additionalProperties", false}, {"required", required}};
}

/// One quantity, points, a pulse, or one of the words.
Json function_schema(const Key& key) {
    const auto time = [](Range range) {
        return quantity_schema({.path = "", .kind = Kind::quantity, .dimension = dimensions::time, .range = range});
    };
    const auto points = [](const Json& entry) { return Json{{"type", "array"}, {"items", entry}, {"minItems", 2}}; };
    Json schema = quantity_schema(key);
    const Json value = schema;
    schema["anyOf"].push_back(object_of({{"times", points(time({}))}, {"values", points(value)}}, {"times", "values"}));
    const Json pulse = object_of({{"start", time({})}, {"width", time(above(0))}, {"peak", value}}, {"width", "peak"});
    schema["anyOf"].push_back(object_of({{"pulse", pulse}}, {"pulse"}));
    if (!key.words.empty()) schema["anyOf"].push_back({{"enum", key.words}});
    return schema;
}

Json value_schema(const Key& key) {
    switch (key.kind) {
    case Kind::quantity:
        return quantity_schema(key);
    case Kind::vector:
        return per_axis_schema(quantity_schema(key));
    case Kind::spin:
    case Kind::per_axis: {
        Json schema = quantity_schema(key);
        schema["anyOf"].push_back(per_axis_schema(quantity_schema(key)));
        return schema;
    }
    case Kind::points:
        return points_schema(key);
    case Kind::outlines:
        return {{"type", "array"}, {"items", points_schema(key)}};
    case Kind::matrix:
        return per_axis_schema(per_axis_schema(quantity_schema(key)));
    case Kind::function:
        return function_schema(key);
    case Kind::functions:
        return per_axis_schema(function_schema(key));
    case Kind::number:
        return number_schema("number", key.range);
    case Kind::integer:
        return number_schema("integer", key.range);
    case Kind::boolean:
        return {{"type", "boolean"}};
    case Kind::text:
        return {{"type", "string"}};
    case Kind::name:
    case Kind::file:
        return {{"type", "string"}, {"minLength", 1}};
    case Kind::word:
        return {{"enum", key.words}};
    case Kind::colour:
        return {{"type", "string"}, {"pattern", "^#[0-9a-fA-F]{6}$"}};
    case Kind::object:
    case Kind::list:
    case Kind::map:
    case Kind::any:
    case Kind::later:
        break; // made in node_schema, or never
    }
    return {};
}

Json require(const std::vector<std::string>& keys) {
    return {{"required", keys}};
}

Json group_schema(const Group& group) {
    Json choices = Json::array();
    for (std::size_t i = 0; i < group.keys.size(); ++i) {
        if (group.count == Count::exactly_one) choices.push_back(require({group.keys[i]}));
        for (std::size_t j = i + 1; j < group.keys.size() && group.count != Count::exactly_one; ++j)
            choices.push_back(require({group.keys[i], group.keys[j]}));
    }
    // Of n given keys n(n-1)/2 pairs are complete: just one pair for two keys, none for at most one.
    if (group.count == Count::at_most_one) return {{"not", {{"anyOf", choices}}}};
    return {{"oneOf", choices}};
}

/// Says of an object whether `key` has one of the values (JSON texts).
Json has_value(const std::string& name, const Key& key, const std::vector<std::string>& values) {
    Json allowed = Json::array();
    for (const std::string& value : values) allowed.push_back(Json::parse(value));
    const bool by_default = key.otherwise && std::find(values.begin(), values.end(), *key.otherwise) != values.end();
    Json schema{{"properties", {{name, {{"enum", allowed}}}}}};
    if (!by_default) schema["required"] = Json::array({name});
    return schema;
}

/// That a required key is there, or its substitute.
Json require(const Key& key, const std::string& name) {
    if (key.unless.empty()) return require({name});
    return {{"oneOf", Json::array({require({name}), require({key.unless})})}};
}

/// if the neighbour has its value, then the key may (or must) be there, else it must not.
Json only_with_schema(const SpecificationNode& object, const SpecificationNode& child) {
    const OnlyWith& only = *child.key->only_with;
    const Key& neighbour = *object.find(only.key)->key;
    Json schema{{"if", only.values.empty() ? require({only.key}) : has_value(only.key, neighbour, only.values)}};
    if (child.key->required) schema["then"] = require(*child.key, child.name);
    schema["else"] = {{"properties", {{child.name, false}}}};
    return schema;
}

Json node_schema(const SpecificationNode& node);

Json object_schema(const SpecificationNode& node) {
    Json properties = Json::object();
    Json required = Json::array();
    Json rules = Json::array();
    for (const SpecificationNode& child : node.children) {
        const Key& key = *child.key;
        if (key.kind == Kind::later) continue;
        properties[child.name] = node_schema(child);
        if (key.required && !key.only_with && key.unless.empty()) required.push_back(child.name);
        if (key.required && !key.only_with && !key.unless.empty()) rules.push_back(require(key, child.name));
        if (!key.required && !key.unless.empty()) rules.push_back({{"not", require({child.name, key.unless})}});
        if (key.only_with && !key.only_with->of_scene()) rules.push_back(only_with_schema(node, child));
    }
    for (const Group* group : node.groups) rules.push_back(group_schema(*group));
    Json schema{{"type", "object"}, {"properties", properties}, {"additionalProperties", false}};
    if (!required.empty()) schema["required"] = required;
    if (!rules.empty()) schema["allOf"] = rules;
    return schema;
}

Json list_schema(const SpecificationNode& node) {
    Json schema{{"type", "array"}, {"items", node_schema(node.children.front())}};
    const Range& range = node.key->range;
    if (range.minimum) schema["minItems"] = static_cast<int>(*range.minimum);
    if (range.maximum) schema["maxItems"] = static_cast<int>(*range.maximum);
    return schema;
}

Json node_schema(const SpecificationNode& node) {
    const Key& key = *node.key;
    Json schema;
    if (key.kind == Kind::object) {
        schema = object_schema(node);
    } else if (key.kind == Kind::map) {
        schema = {{"type", "object"}, {"additionalProperties", node_schema(node.children.front())}};
    } else if (key.kind == Kind::list) {
        schema = list_schema(node);
    } else {
        schema = value_schema(key);
    }
    const bool has_unit = key.dimension != dimensions::none;
    schema["description"] = has_unit ? fmt::format("{} [{}]", key.meaning, unit_of(key.dimension)) : key.meaning;
    if (key.otherwise) schema["default"] = Json::parse(*key.otherwise);
    return schema;
}

/// What an analysis asks of a part of the scene beyond its own schema: how many components vectors have, and which
/// keys must not be there. Null if it asks nothing.
Json analysis_schema(const SpecificationNode& node, const Word<Analysis>& analysis) {
    const Key& key = *node.key;
    const int components = dimension(analysis.value);
    Json count{{"minItems", components}, {"maxItems", components}};
    if (key.only_with && key.only_with->of_scene()) {
        const std::vector<std::string>& allowed = key.only_with->values;
        const std::string word = Json(analysis.text).dump();
        if (std::find(allowed.begin(), allowed.end(), word) == allowed.end()) return false;
    }
    if (key.kind == Kind::vector || key.kind == Kind::per_axis || key.kind == Kind::functions) return count;
    if (key.kind == Kind::spin) {
        if (analysis.value != Analysis::three_d) return {{"not", {{"type", "array"}}}};
        count["type"] = "array";
        return count;
    }
    if (key.kind == Kind::points) return {{"items", count}};
    if (key.kind == Kind::outlines) return {{"items", {{"items", count}}}};
    if (key.kind == Kind::matrix) {
        const Json row = count;
        count["items"] = row;
        return count;
    }
    Json parts = Json::object();
    for (const SpecificationNode& child : node.children)
        if (const Json part = analysis_schema(child, analysis); !part.is_null()) parts[child.name] = part;
    if (parts.empty()) return nullptr;
    if (key.kind == Kind::list) return {{"items", parts.front()}};
    if (key.kind == Kind::map) return {{"additionalProperties", parts.front()}};
    return {{"properties", parts}};
}

/// For each set of analyses that ask the same: if the scene is one of them, then it must be as they ask.
Json analysis_rules() {
    const SpecificationNode& scene = scene_specification();
    std::vector<std::pair<std::vector<std::string>, Json>> rules;
    for (const Word<Analysis>& analysis : analysis_words) {
        const Json schema = analysis_schema(scene, analysis);
        const auto same = std::find_if(rules.begin(), rules.end(), [&](const auto& r) { return r.second == schema; });
        auto& rule = same == rules.end() ? rules.emplace_back(std::vector<std::string>{}, schema) : *same;
        rule.first.push_back(Json(analysis.text).dump());
    }
    Json all = Json::array();
    for (const auto& [words, schema] : rules)
        all.push_back({{"if", has_value("analysis", *scene.find("analysis")->key, words)}, {"then", schema}});
    return all;
}

} // namespace

std::string scene_schema() {
    Json schema{{"$schema", "https://json-schema.org/draft/2020-12/schema"}, {"title", "abut scene"}};
    schema.update(node_schema(scene_specification()));
    for (const Json& rule : analysis_rules()) schema["allOf"].push_back(rule);
    return schema.dump(2) + '\n';
}

} // namespace abut
