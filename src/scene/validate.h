#pragma once
#include "scene/problem.h"
#include "scene/scene.h"

#include <vector>

namespace abut {

/// Everything that is wrong with the meaning of a scene, as far as the scene alone can tell (images are not opened):
/// names that fit nothing, bodies and walls outside the grid, quantities out of range. Empty for a good scene.
std::vector<Problem> validate(const Scene& scene);

/// The part of validate() about names: of materials, bodies and boundaries. Empty names are passed over.
std::vector<Problem> validate_names(const Scene& scene);

/// The part of validate() about numbers: ranges, sizes and places.
std::vector<Problem> validate_numbers(const Scene& scene);

/// What is allowed but seldom wise, with the better choice.
std::vector<Problem> advice(const Scene& scene);

} // namespace abut
