#pragma once
/// \file json.h
/// The JSON type of this room; not for other rooms' headers, it is slow to compile.

#include <nlohmann/json.hpp>

namespace abut {

/// Objects keep the order in which their keys were written.
using Json = nlohmann::ordered_json;

/// The value at a key of an object; null if there is none.
inline const Json* find(const Json& object, const std::string& key) {
    const auto place = object.find(key);
    return place == object.end() ? nullptr : &*place;
}

} // namespace abut
