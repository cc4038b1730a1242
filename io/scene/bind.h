#pragma once
#include "io/scene/json.h"
#include "scene/problem.h"
#include "scene/scene.h"

#include <vector>

namespace abut {

/// Copies a checked scene (check_scene) to its plain values. What checking left out keeps the value of scene.h. Elastic
/// constants become K and G here; those that make no solid are added to `problems` as /materials/NAME.
Scene bind_scene(const Json& checked, std::vector<Problem>& problems);

} // namespace abut
