#pragma once
/// \file specification.h
/// The one table of everything a scene file may hold. Checking, defaults, the JSON Schema and the scene reference are
/// all made from it.

#include "io/scene/units.h"

#include <optional>
#include <string>
#include <vector>

namespace abut {

/// What may stand at a key.
enum class Kind {
    object,    ///< the keys below it and no others
    list,      ///< of what stands at its path with "/#"; `range` counts the entries
    map,       ///< from names to what stands at its path with "/*"
    quantity,  ///< number (SI) or text with a unit
    vector,    ///< list of quantities, one per axis
    per_axis,  ///< one quantity, or a list of one per axis
    spin,      ///< one quantity in plane scenes, a list of three in 3D
    points,    ///< list of 3 or more vectors
    outlines,  ///< list of lists of points
    matrix,    ///< list of one row per axis, each a list of one quantity per axis
    function,  ///< of time: one quantity, {"times", "values"} or {"pulse"} (check_function.cpp); or one of `words`
    functions, ///< list of functions of time, one per axis
    number,    ///< without dimension
    integer,
    boolean,
    text,
    name,   ///< text that is not empty
    file,   ///< a path; relative ones start from the scene file's folder
    word,   ///< one of `words`
    colour, ///< "#rrggbb"
    any,    ///< whatever: it is checked elsewhere
    later,  ///< planned; every use is a problem that says so
};

/// Limits of a number; each is part of the range unless excluded.
struct Range {
    std::optional<double> minimum;
    std::optional<double> maximum;
    bool minimum_excluded = false;
    bool maximum_excluded = false;
};
constexpr Range above(double limit) {
    return {limit, {}, true, false};
}
constexpr Range at_least(double limit) {
    return {limit, {}, false, false};
}
constexpr Range from_to(double minimum, double maximum) {
    return {minimum, maximum, false, false};
}

/// The key may be used only where its neighbour `key` (or that one's default) has one of the `values` (JSON texts), or
/// is given at all if there are none. A key that begins with "/" is one of the scene itself: "/analysis".
struct OnlyWith {
    std::string key;
    std::vector<std::string> values;
    std::string why{}; ///< added to the message about a wrong place

    /// Whether `key` is one of the scene itself.
    bool of_scene() const { return key.starts_with('/'); }
    /// Name of the neighbour.
    std::string name() const { return of_scene() ? key.substr(1) : key; }
};

/// One key of the scene file.
struct Key {
    std::string path; ///< JSON pointer pattern: "/bodies/#/disk/center"; "#" is any list entry, "*" any name
    Kind kind = Kind::object;
    Dimension dimension{};
    std::vector<std::string> words{};       ///< allowed words (of a function: instead of one)
    std::vector<std::string> later_words{}; ///< planned words
    bool required = false;                  ///< (where `only_with` holds)
    std::optional<std::string> otherwise{}; ///< default, JSON text; vectors get as many zeros more as they need
    Range range{};
    std::optional<OnlyWith> only_with{};
    std::string unless{};  ///< a neighbour that takes its place: where that is given, this must not be
    std::string hint{};    ///< added to the message about a value out of range or an unknown word
    std::string meaning{}; ///< one sentence
};

enum class Count { exactly_one, exactly_two, at_most_one };

/// Keys of one object of which only so many go together.
struct Group {
    std::string path; ///< of the object
    std::vector<std::string> keys;
    Count count = Count::exactly_one;
};

/// A key with the keys below it, in the order of the table.
struct SpecificationNode {
    std::string name; ///< last token of the path
    const Key* key = nullptr;
    std::vector<SpecificationNode> children;
    std::vector<const Group*> groups;

    /// The child of that name; null if there is none.
    const SpecificationNode* find(std::string_view child) const;
};

/// All keys, parents before children.
const std::vector<Key>& scene_keys();
/// All groups.
const std::vector<Group>& scene_groups();
/// Keys and groups, which must outlive it, as a tree; the root's path is "".
SpecificationNode make_specification(const std::vector<Key>& keys, const std::vector<Group>& groups);

/// The same keys as a tree; its root is the scene itself.
const SpecificationNode& scene_specification();

/// Names of the keys that an object may have in this version.
std::vector<std::string> key_names(const SpecificationNode& object);

} // namespace abut
