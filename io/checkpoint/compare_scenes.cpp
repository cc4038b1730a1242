#include "io/checkpoint/compare_scenes.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <string_view>

namespace abut {

namespace {

bool may_change(std::string_view pointer) {
    constexpr std::array<std::string_view, 5> free{"/time/end", "/time/on_trouble", "/title", "/abut_version",
                                                   "/$schema"};
    if (pointer == "/output/pairs") return false;
    if (pointer.ends_with("/file")) return true; // what is in files is compared by the checksum of the model
    return pointer.starts_with("/output/") || pointer.starts_with("/time/limits") ||
           std::find(free.begin(), free.end(), pointer) != free.end();
}

std::string shortened(const nlohmann::json& value) {
    std::string text = value.dump();
    if (text.size() > 60) text = text.substr(0, 57) + "...";
    return text;
}

} // namespace

std::vector<std::string> forbidden_changes(const std::string& before, const std::string& now) {
    using Json = nlohmann::json;
    const Json old_scene = Json::parse(before);
    const Json new_scene = Json::parse(now);
    std::vector<std::string> changes;
    for (const Json& change : Json::diff(old_scene, new_scene)) {
        const std::string pointer = change["path"];
        if (may_change(pointer)) continue;
        const std::string operation = change["op"];
        if (operation == "add")
            changes.push_back(fmt::format("{}: {} was not there", pointer, shortened(change["value"])));
        else if (operation == "remove")
            changes.push_back(
                fmt::format("{}: {} is gone", pointer, shortened(old_scene.at(Json::json_pointer(pointer)))));
        else
            changes.push_back(fmt::format("{}: was {}, is {}", pointer,
                                          shortened(old_scene.at(Json::json_pointer(pointer))),
                                          shortened(change["value"])));
    }
    return changes;
}

} // namespace abut
