#pragma once
/// \file validate_parts.h
/// What the parts of validate() share.

#include "scene/problem.h"
#include "scene/scene.h"

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace abut {

inline constexpr std::array axis_names{"x", "y", "z"};

/// Part of a length by which rounding may put something over an edge it lies on.
inline constexpr double place_rounding = 1e-9;

/// "0.001 m"
std::string with_unit(double value, const char* unit);
inline std::string metres(double value) {
    return with_unit(value, "m");
}

/// Adds a problem unless `good`; comparisons with NaN are false and so never good.
void demand(bool good, const std::string& pointer, const std::string& message, std::vector<Problem>& problems);

/// Number of space dimensions.
inline std::size_t axes(const Scene& scene) {
    return std::size_t(dimension(scene.analysis));
}

/// Bodies and images: sizes and places.
void validate_matter(const Scene& scene, std::vector<Problem>& problems);

/// Contact laws: their constants; rigid bodies: what they need.
void validate_contact(const Scene& scene, std::vector<Problem>& problems);

/// Boundary conditions: axes, places and movements.
void validate_boundaries(const Scene& scene, std::vector<Problem>& problems);

} // namespace abut
