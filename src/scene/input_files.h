#pragma once
#include "scene/scene.h"

#include <filesystem>
#include <vector>

namespace abut {

/// All files that a scene names: images, paths, surfaces. A "*" in a name stays as it is.
std::vector<std::filesystem::path> input_files(const Scene& scene);

} // namespace abut
