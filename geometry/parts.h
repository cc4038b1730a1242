#pragma once
/// \file parts.h
/// The particles of a scene while the model is being built, and the checks that need all of them.

#include "scene/problem.h"
#include "scene/scene.h"

#include <string>
#include <vector>

namespace abut {

/// Particles that one place of the scene made for one body: a shape, or a body's colours in a picture.
struct Part {
    std::string pointer; ///< of that place, for messages
    std::string body_name;
    int body = 0;                 ///< index into Model::bodies
    Vector half_size{};           ///< of each particle [m]; z is 0 in two dimensions
    std::vector<Vector> position; ///< centres [m]
    double angle = 0;             ///< by which each particle is turned counter-clockwise about its centre [rad]
};

/// Reports every part with particles whose centres lie outside the grid's box.
void check_inside(const std::vector<Part>& parts, const GridSpec& grid, std::vector<Problem>& problems);

/// Reports every two parts that claim the same place: a particle's centre lies within the domain of a particle of the
/// other part. Parts that only touch are fine. Also parts of one body: its mass would count twice.
void check_overlap(const std::vector<Part>& parts, std::vector<Problem>& problems);

/// "14.3 um": a length in the unit that suits it, 4 digits.
std::string length_text(double metres);

/// "500 mm × 500 mm": the edges of a particle, three in three dimensions.
std::string edges_text(const Vector& half_size);

/// "1 particle", "14 particles".
std::string count_text(std::size_t count, const std::string& noun);

} // namespace abut
