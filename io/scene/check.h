#pragma once
#include "io/scene/json.h"
#include "io/scene/specification.h"
#include "scene/problem.h"
#include "scene/scene.h"

#include <optional>
#include <vector>

namespace abut {

/// A scene after checking against the table of keys: quantities are numbers in SI units, defaults are filled in, keys
/// are in the table's order. What is wrong is left out (entries of lists keep their place) and named in `problems`.
struct CheckedScene {
    Json scene;
    std::vector<Problem> problems;
};

/// Checks keys, types, units, ranges and words, and fills in defaults.
CheckedScene check_scene(const Json& scene);

/// The same for a document of another kind, whose keys have no vectors.
CheckedScene check_document(const Json& document, const SpecificationNode& specification);

/// What checking a value of a scene needs to know of the whole.
struct Checking {
    const Json& scene;                ///< as written
    std::optional<Analysis> analysis; ///< analysis_of(scene)
    std::vector<Problem>& problems;   ///< found so far
    const SpecificationNode& specification = scene_specification();
};

/// The analysis that an unchecked scene asks for, which decides how many components vectors have; nothing if what it
/// says is no analysis.
std::optional<Analysis> analysis_of(const Json& scene);

/// The default of a key that has one; a vector with as many components as the analysis needs.
Json default_of(const Key& key, std::optional<Analysis> analysis);

/// The checked value of a key that has no keys below it; nothing if it is unusable, with the problem added.
std::optional<Json> check_value(const Json& json, const Key& key, const std::string& pointer, Checking& checking);

/// A value in words for a message: `the text "abc"`, `a list`, `3`.
std::string in_words(const Json& value);

/// "at least 0 m", "between 0 and 1 (0 excluded)"; `unit` follows the numbers.
std::string in_words(const Range& range, const std::string& unit);

/// Whether a number lies in the range.
bool contains(const Range& range, double value);

} // namespace abut
