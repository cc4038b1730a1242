#pragma once
/// \file bind_parts.h
/// What the parts of bind_scene() share. Each copies the value at a key of a checked object, if there is one, to a
/// member.

#include "io/scene/json.h"
#include "io/scene/words.h"
#include "scene/scene.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <vector>

namespace abut {

template <class T>
void copy(const Json& object, const char* key, T& member) {
    if (const Json* value = find(object, key)) member = value->get<T>();
}

template <class T>
void copy(const Json& object, const char* key, std::optional<T>& member) {
    if (const Json* value = find(object, key)) member = value->get<T>();
}

/// A list of components; those that the list does not have keep their values (z in plane analyses).
template <std::size_t Size>
void copy_components(const Json& object, const char* key, std::array<double, Size>& member) {
    const Json* value = find(object, key);
    if (!value) return;
    for (std::size_t i = 0; i < std::min(Size, value->size()); ++i) member[i] = (*value)[i].template get<double>();
}

/// A list of components, or one value for the first `axes` of them.
template <std::size_t Size>
void copy_per_axis(const Json& object, const char* key, std::array<double, Size>& member, std::size_t axes) {
    const Json* value = find(object, key);
    if (value && value->is_array()) return copy_components(object, key, member);
    if (value) std::fill_n(member.begin(), std::min(Size, axes), value->get<double>());
}

template <class Words, class T>
void copy_word(const Json& object, const char* key, const Words& words, T& member) {
    if (const Json* value = find(object, key))
        if (const auto known = value_of(words, value->get_ref<const std::string&>())) member = *known;
}

/// The object or list at a key; an empty one if it is not there.
inline const Json& part(const Json& object, const char* key) {
    static const Json empty = Json::object();
    const Json* value = find(object, key);
    return value ? *value : empty;
}

template <class T, class Bind>
void copy_list(const Json& object, const char* key, std::vector<T>& member, Bind bind) {
    for (const Json& entry : part(object, key)) member.push_back(bind(entry));
}

/// The shape of an object that has one of shape_kinds().
ShapeSpec bind_shape(const Json& json);

/// An entry of /images.
ImageSpec bind_image(const Json& json);

/// Angular velocity, temperature and so on of a body or an entry of a legend.
InitialState bind_initial_state(const Json& json);

/// A prescribed motion.
RigidSpec bind_rigid(const Json& json);

/// What stands at /output.
OutputSpec bind_output(const Json& json);

/// An entry of /boundaries.
BoundarySpec bind_boundary(const Json& json);

} // namespace abut
