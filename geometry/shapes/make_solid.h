#pragma once
/// \file make_solid.h
/// Shapes of a scene to solids.

#include "geometry/shapes/solid.h"

#include <filesystem>
#include <string>

namespace abut {

/// What shapes need besides themselves.
struct ShapeContext {
    const std::vector<NamedShapeSpec>& shapes; ///< of the scene
    int dimension = 2;
    std::filesystem::path folder; ///< where relative file names start
    double resolution = 0;        ///< edge of a particle: implicit surfaces are meshed to 1/500 of it [m]
};

/// Whether a shape exists in 2 or 3 dimensions: disks, ellipses, rings, polygons and paths are plane; balls,
/// ellipsoids, cylinders, cones, surfaces and implicit ones are not; boxes and combinations are either.
bool exists_in(const ShapeSpec& shape, int dimension);

/// \throws std::runtime_error when a file can't be read or its content is no closed outline or surface, an expression
/// is wrong or its surface leaves its box, a name is unknown, of the other dimension or used in its own definition, or
/// a combination is empty; what() says what and where, and can stand after "/bodies/3: " \param repairs gets what was
/// repaired in surfaces that ask for it
Solid make_solid(const ShapeSpec& shape, const ShapeContext& context, std::vector<std::string>* repairs = nullptr);

} // namespace abut
