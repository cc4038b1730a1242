#pragma once
#include "io/scene/json.h"
#include "scene/problem.h"

#include <optional>
#include <string>
#include <vector>

namespace abut {

/// Sets a value of a scene that is not checked yet; null removes the key. Objects missing on the way are made. Returns
/// what is wrong, and changes nothing, if the pointer names no key of the scene format or no existing entry of a list
/// or map.
std::optional<std::string> apply_setting(Json& scene, const std::string& pointer, const Json& value);

/// Applies one override "PTR=VALUE" ("/method/transfer/order=4") to a scene that is not checked yet. VALUE is JSON,
/// else a text; null removes the key. Objects missing on the way are made. A problem is added, and nothing changed, if
/// the pointer names no key of the scene format or no existing entry of a list or map.
void apply_override(Json& scene, const std::string& override, std::vector<Problem>& problems);

} // namespace abut
