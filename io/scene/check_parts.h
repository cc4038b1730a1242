#pragma once
/// \file check_parts.h
/// What the checks of single values (check_value.cpp) and of those with parts (check_function.cpp) share.

#include "io/scene/check.h"

namespace abut {

/// A value on its way through the checks, and where to complain about it.
struct CheckedValue {
    const Json& json;
    const Key& key;
    const std::string& pointer;
    Checking& checking;

    /// Adds a problem.
    std::nullopt_t wrong(const std::string& message) const;
    /// Adds the problem that something else is needed: "a text", "a list of 2 components".
    std::nullopt_t wrong_type(const std::string& needed) const;
};

/// A number in SI units or a text with a unit, as a number in the key's range.
std::optional<Json> check_quantity(const CheckedValue& value);

/// A list of quantities, one per axis.
std::optional<Json> check_vector(const CheckedValue& value);

/// A list of rows, one per axis, each a vector.
std::optional<Json> check_matrix(const CheckedValue& value);

/// A function of time: a quantity; {"times": [...], "values": [...]}; {"pulse": {"start", "width", "peak"}}; or one of
/// the key's words.
std::optional<Json> check_function(const CheckedValue& value);

/// One quantity in plane scenes, a vector in 3D.
std::optional<Json> check_spin(const CheckedValue& value);

/// A list of 3 or more vectors.
std::optional<Json> check_points(const CheckedValue& value);

/// A list of lists of points.
std::optional<Json> check_outlines(const CheckedValue& value);

/// A list of functions of time, one per axis.
std::optional<Json> check_functions(const CheckedValue& value);

} // namespace abut
