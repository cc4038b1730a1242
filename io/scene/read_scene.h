#pragma once
/// \file read_scene.h
/// Scene files to scenes. The format itself is in specification.h; documents made from it are declared here too.

#include "scene/scene.h"

#include <filesystem>
#include <string>
#include <vector>

namespace abut {

/// A scene that is good to run.
struct LoadedScene {
    Scene scene;          ///< image files as absolute paths
    std::string resolved; ///< the same as JSON text: overrides applied, defaults filled in, numbers in SI units, image
                          ///< files absolute, "abut_version" added; load_scene reads it back to the same scene
};

/// Reads a scene file and checks it: syntax, keys, units, ranges (specification.h) and meaning (validate.h).
/// `overrides` are "PTR=VALUE" (overrides.h), applied in their order before checking; a relative image file among them
/// starts from the scene file's folder like one in the file.
/// Throws SceneError with all the problems of the scene; problems of the file as a whole have an empty pointer.
LoadedScene load_scene(const std::filesystem::path& file, const std::vector<std::string>& overrides = {});

/// The same for the text of a scene.
/// \param shown what messages call it \param folder where relative files start from
LoadedScene load_scene_text(const std::string& text, const std::string& shown, const std::filesystem::path& folder,
                            const std::vector<std::string>& overrides = {});

/// JSON Schema (draft 2020-12) of scene files, as JSON text. What it cannot say (units, meaning) only load_scene
/// checks.
std::string scene_schema();

/// The reference of the scene file, as Markdown: a section for each object with a table of its keys.
std::string scene_reference();

} // namespace abut
