#pragma once
/// \file scene_values.h
/// Numbers of a resolved scene by JSON pointer.

#include "expression/expression.h"
#include "io/scene/json.h"
#include "io/study/study.h"

#include <stdexcept>
#include <string>
#include <vector>

namespace abut {

/// A pointer that leads to no number; what() says where it ends, and offers the nearest key.
class NoNumber : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// The number at a JSON pointer, SI; of a list of numbers (cells along the axes) the largest. Throws NoNumber.
double number_at(const Json& resolved_scene, const std::string& pointer);

/// SI unit of the key at a pointer of a scene; "" for plain numbers and for pointers to no key.
std::string unit_at(const std::string& pointer);

/// The parameters of a study in one of its scenes. Throws std::runtime_error "NAME: CAUSE" for the first that has no
/// value; `where` is then set to its place in the study file.
std::vector<Constant> parameters_of(const Study& study, const Json& resolved_scene, std::string& where);

} // namespace abut
