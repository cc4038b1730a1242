#include "io/scene/overrides.h"

#include "io/scene/check.h"
#include "io/scene/parse_json.h"
#include "io/scene/specification.h"
#include "scene/suggest.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <string_view>

#include <fmt/format.h>

namespace abut {

namespace {

/// The tokens of a JSON pointer, unescaped.
std::vector<std::string> tokens_of(std::string_view pointer) {
    std::vector<std::string> tokens;
    for (std::size_t i = 0; i < pointer.size(); ++i) {
        if (pointer[i] == '/') {
            tokens.emplace_back();
        } else if (pointer[i] == '~' && i + 1 < pointer.size() && (pointer[i + 1] == '0' || pointer[i + 1] == '1')) {
            tokens.back() += pointer[++i] == '0' ? '~' : '/';
        } else {
            tokens.back() += pointer[i];
        }
    }
    return tokens;
}

/// Walks down a scene and its specification together.
struct Walk {
    Json* value; ///< null: not in the scene yet
    const SpecificationNode* node;
    std::string pointer{};
    bool made = false; ///< something on the way was not in the scene
};

/// One list entry or vector component; a message if there is none of that number.
std::optional<std::string> enter_entry(Walk& walk, const std::string& token) {
    const std::size_t size = walk.value && walk.value->is_array() ? walk.value->size() : 0;
    std::size_t index = 0;
    const char* end = token.data() + token.size();
    const auto [stop, error] = std::from_chars(token.data(), end, index);
    if (error != std::errc{} || stop != end || index >= size) {
        const std::string entries = size == 0   ? "no entries"
                                    : size == 1 ? "one entry, 0"
                                                : fmt::format("entries 0 to {}", size - 1);
        return fmt::format("\"{}\" has no entry {}; it has {}", walk.pointer, token, entries);
    }
    walk.value = &(*walk.value)[index];
    if (walk.node->key->kind == Kind::list) walk.node = &walk.node->children.front();
    return {};
}

/// One named entry of a map; only the last token may name a new one.
std::optional<std::string> enter_name(Walk& walk, const std::string& token, bool last) {
    Json& map = *walk.value;
    if (!map.contains(token) && !last) {
        std::vector<std::string> names;
        for (const auto& [name, entry] : map.items()) names.push_back(name);
        const std::string guess = did_you_mean(token, names);
        const std::string help = guess.empty() ? "; there are: " + quoted_list(names, "and") : guess;
        return fmt::format("\"{}\" has no entry \"{}\"{}", walk.pointer, token, names.empty() ? "" : help);
    }
    walk.value = &map[token];
    walk.node = &walk.node->children.front();
    return {};
}

std::optional<std::string> enter_key(Walk& walk, const std::string& token) {
    const SpecificationNode* child = walk.node->find(token);
    if (!child) {
        const std::vector<std::string> known = key_names(*walk.node);
        const std::optional<std::string> guess = nearest(token, known);
        const std::string help = guess ? fmt::format("; did you mean \"{}/{}\"?", walk.pointer, *guess)
                                       : "; known here: " + quoted_list(known, "and");
        return fmt::format("the scene format has no key \"{}/{}\"{}", walk.pointer, pointer_token(token), help);
    }
    Json& object = *walk.value;
    if (!object.contains(token)) {
        object[token] = nullptr;
        walk.made = true;
    }
    walk.value = &object[token];
    walk.node = child;
    return {};
}

/// One part of a function of time that is an object; what fits together, checking finds out later.
std::optional<std::string> enter_function(Walk& walk, const std::string& token) {
    static const std::vector<std::string> known{"times", "values", "pulse", "start", "width", "peak"};
    if (std::find(known.begin(), known.end(), token) == known.end())
        return fmt::format("a function of time has no \"{}\"{}", token, did_you_mean(token, known));
    walk.made = walk.made || !walk.value->contains(token);
    walk.value = &(*walk.value)[token];
    return {};
}

/// Puts what a key would hold by default where there is nothing yet, so that a part of it can be set.
void fill(Json& value, const Key& key, const Json& scene) {
    if (!value.is_null()) return;
    if (key.otherwise) {
        value = default_of(key, analysis_of(scene));
    } else if (key.kind == Kind::object || key.kind == Kind::map) {
        value = Json::object();
    }
}

/// Whether a value without keys of the table below it has parts as it stands in the scene.
bool has_parts(const Key& key, const Json& value) {
    if (key.kind == Kind::vector || key.kind == Kind::per_axis || key.kind == Kind::matrix) return true;
    return key.kind == Kind::functions || (key.kind == Kind::function && value.is_array());
}

std::optional<std::string> enter(Walk& walk, const std::string& token, bool last, const Json& scene) {
    const Key& key = *walk.node->key;
    const bool of_function = key.kind == Kind::function || key.kind == Kind::functions;
    if (of_function && walk.value->is_object()) {
        std::optional<std::string> message = enter_function(walk, token);
        walk.pointer += "/" + pointer_token(token);
        return message;
    }
    fill(*walk.value, key, scene);
    const bool named = key.kind == Kind::object || key.kind == Kind::map;
    const bool numbered = key.kind == Kind::list || has_parts(key, *walk.value);
    if (!named && !numbered) return fmt::format("\"{}\" is a single value, nothing is below it", walk.pointer);
    if (named && !walk.value->is_object()) return fmt::format("\"{}\" is not an object in the scene", walk.pointer);
    std::optional<std::string> message = numbered                ? enter_entry(walk, token)
                                         : key.kind == Kind::map ? enter_name(walk, token, last)
                                                                 : enter_key(walk, token);
    walk.pointer += "/" + pointer_token(token);
    return message;
}

} // namespace

std::optional<std::string> apply_setting(Json& scene, const std::string& pointer, const Json& value) {
    if (!pointer.starts_with('/'))
        return fmt::format("\"{}\" is no JSON pointer; write for example /method/transfer/order", pointer);
    const std::vector<std::string> tokens = tokens_of(pointer);
    Json changed = scene;
    Walk walk{&changed, &scene_specification()};
    Walk parent = walk;
    for (std::size_t i = 0; i < tokens.size(); ++i) {
        parent = walk;
        if (std::optional<std::string> message = enter(walk, tokens[i], i + 1 == tokens.size(), scene)) return message;
    }
    if (!value.is_null() || !parent.value->is_object()) {
        *walk.value = value;
    } else {
        if (walk.made) return {}; // it was not there anyway
        parent.value->erase(tokens.back());
    }
    scene = std::move(changed);
    return {};
}

void apply_override(Json& scene, const std::string& override, std::vector<Problem>& problems) {
    const std::size_t equals = override.find('=');
    if (equals == std::string::npos || equals == 0 || override.front() != '/') {
        problems.push_back({"", fmt::format("--set \"{}\": write a JSON pointer, =, and a value, for example "
                                            "/method/transfer/order=4",
                                            override)});
        return;
    }
    const std::string pointer = override.substr(0, equals);
    const std::string text = override.substr(equals + 1);
    Json value = text;
    ParsedJson parsed = parse_json(text);
    if (!parsed.value) {
        // No key wants a text like this: it is a list or an object with a slip of the pen.
        if (!text.empty() && (text.front() == '[' || text.front() == '{')) {
            const std::string why = parsed.problems.empty() ? "" : ": " + parsed.problems.front().message;
            problems.push_back({pointer, fmt::format("--set: {} is not valid JSON{}", text, why)});
            return;
        }
    } else {
        for (const Problem& problem : parsed.problems) problems.push_back({pointer + problem.pointer, problem.message});
        value = std::move(*parsed.value);
    }
    if (const std::optional<std::string> message = apply_setting(scene, pointer, value))
        problems.push_back({pointer, "--set: " + *message});
}

} // namespace abut
