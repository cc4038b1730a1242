#include "io/scene/read_scene.h"

#include "io/scene/bind.h"
#include "io/scene/check.h"
#include "io/scene/overrides.h"
#include "io/scene/parse_json.h"
#include "io/scene/specification.h"
#include "scene/problem.h"
#include "scene/validate.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <system_error>
#include <utility>

#include <fmt/format.h>

namespace abut {

namespace {

std::string read_text(const std::filesystem::path& file) {
    const auto fail = [&](const std::string& reason) {
        throw SceneError(file.string(), {{"", "cannot read the scene file: " + reason}});
    };
    std::error_code ignored;
    if (std::filesystem::is_directory(file, ignored)) fail("it is a folder");
    errno = 0;
    std::ifstream stream(file, std::ios::binary);
    if (!stream) fail(std::strerror(errno));
    std::string text{std::istreambuf_iterator<char>(stream), {}};
    if (stream.bad()) fail("reading failed");
    return text;
}

/// Whether one of the pointers leads to, above or below the other.
bool on_one_path(const std::string& a, const std::string& b) {
    const auto leads_to = [](const std::string& from, const std::string& to) {
        return to.starts_with(from) && (to.size() == from.size() || to[from.size()] == '/');
    };
    return leads_to(a, b) || leads_to(b, a);
}

/// Whether a name can fit nothing just because what it could fit was not readable.
bool follows_from(const std::string& name, const std::string& unreadable) {
    if (unreadable == "/materials") return name.ends_with("/material");
    if (unreadable.starts_with("/images/") && unreadable.ends_with("/bodies"))
        return name.starts_with("/contact/laws/");
    if (unreadable == "/shapes") return name.starts_with("/bodies/");
    const bool of_body = name.starts_with("/contact/laws/") || name.ends_with("/traction/body");
    return (unreadable == "/bodies" || unreadable == "/images") && of_body;
}

/// Adds problems that are not a consequence of one that is known already.
void add_new(std::vector<Problem>& problems, const std::vector<Problem>& more) {
    const std::vector<Problem> known = problems;
    for (const Problem& problem : more) {
        const auto explains = [&](const Problem& earlier) {
            return on_one_path(earlier.pointer, problem.pointer) || follows_from(problem.pointer, earlier.pointer);
        };
        if (std::none_of(known.begin(), known.end(), explains)) problems.push_back(problem);
    }
}

/// All values at keys of Kind::file below `json`.
void make_paths_absolute(Json& json, const SpecificationNode& node, const std::filesystem::path& folder) {
    if (json.is_array() || (json.is_object() && node.key->kind == Kind::map)) {
        if (!node.children.empty())
            for (Json& entry : json) make_paths_absolute(entry, node.children.front(), folder);
    } else if (json.is_object()) {
        for (auto& [name, value] : json.items())
            if (const SpecificationNode* child = node.find(name)) make_paths_absolute(value, *child, folder);
    } else if (node.key->kind == Kind::file && json.is_string()) {
        json = (folder / json.get<std::string>()).lexically_normal().string();
    }
}

/// JSON text of the checked scene, led by the version of abut.
std::string resolved_text(const Json& scene) {
    Json resolved = Json::object();
    resolved["abut_version"] = ABUT_VERSION;
    for (const auto& [key, value] : scene.items())
        if (key != "abut_version" && key != "$schema") resolved[key] = value;
    return resolved.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

} // namespace

LoadedScene load_scene(const std::filesystem::path& file, const std::vector<std::string>& overrides) {
    return load_scene_text(read_text(file), file.string(), std::filesystem::absolute(file).parent_path(), overrides);
}

LoadedScene load_scene_text(const std::string& text, const std::string& shown, const std::filesystem::path& folder,
                            const std::vector<std::string>& overrides) {
    ParsedJson parsed = parse_json(text);
    std::vector<Problem> problems = std::move(parsed.problems);
    if (!parsed.value) throw SceneError(shown, problems);
    if (parsed.value->is_object())
        for (const std::string& override : overrides) apply_override(*parsed.value, override, problems);

    CheckedScene checked = check_scene(*parsed.value);
    problems.insert(problems.end(), checked.problems.begin(), checked.problems.end());
    make_paths_absolute(checked.scene, scene_specification(), folder);

    // After a problem of structure, numbers may be missing, but names can still be checked.
    const bool complete = problems.empty();
    std::vector<Problem> elastic;
    Scene scene = bind_scene(checked.scene, elastic);
    if (complete) problems = elastic;
    add_new(problems, complete ? validate(scene) : validate_names(scene));
    if (!problems.empty()) throw SceneError(shown, problems);
    return {std::move(scene), resolved_text(checked.scene)};
}

} // namespace abut
