#include "io/scene/json.h"
#include "io/scene/read_scene.h"
#include "io/scene/specification.h"
#include "scene/scene.h"

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
    static constexpr const char* number_and_unit =
        R"(^\s*[-+]?([0-9]+\.?[0-9]*|\.[0-9]+)([eE][-+]?[0-9]+)?\s*([^\s0-9.]|1\s*/).*$)";
    return {{"anyOf",
             Json::array({number_schema("number", key.range), {{"type", "string"}, {"pattern", number_and_unit}}})}};
}

Json vector_schema(const Key& key) {
    constexpr int components = dimension(Analysis::plane_strain);
    return {{"type", "array"}, {"items", quantity_schema(key)}, {"minItems", components}, {"maxItems", components}};
}

Json value_schema(const Key& key) {
    switch (key.kind) {
    case Kind::quantity:
        return quantity_schema(key);
    case Kind::vector:
        return vector_schema(key);
    case Kind::per_axis: {
        Json schema = quantity_schema(key);
        schema["anyOf"].push_back(vector_schema(key));
        return schema;
    }
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

/// if the neighbour has its value, then the key may (or must) be there, else it must not.
Json only_with_schema(const SpecificationNode& object, const SpecificationNode& child) {
    const OnlyWith& only = *child.key->only_with;
    const std::optional<std::string>& otherwise = object.find(only.key)->key->otherwise;
    Json condition{{"properties", {{only.key, {{"const", Json::parse(only.value)}}}}}};
    if (otherwise != only.value) condition["required"] = Json::array({only.key});
    Json schema{{"if", condition}};
    if (child.key->required) schema["then"] = require({child.name});
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
        if (key.required && !key.only_with) required.push_back(child.name);
        if (key.only_with) rules.push_back(only_with_schema(node, child));
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

} // namespace

std::string scene_schema() {
    Json schema{{"$schema", "https://json-schema.org/draft/2020-12/schema"}, {"title", "abut scene"}};
    schema.update(node_schema(scene_specification()));
    return schema.dump(2) + '\n';
}

} // namespace abut
