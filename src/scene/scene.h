#pragma once
/// \file scene.h
/// A scene as plain values, in SI units, after reading and before checking its meaning (see validate.h).
/// Two-dimensional analyses use the first two components of every vector and leave the third at zero; axisymmetric
/// ones have r for x and z for y.

#include "scene/bodies.h"
#include "scene/boundaries.h"
#include "scene/contact.h"
#include "scene/images.h"
#include "scene/method.h"
#include "scene/output.h"
#include "scene/shapes.h"
#include "scene/space.h"
#include "scene/time_spec.h"

#include <optional>
#include <string>
#include <vector>

namespace abut {

/// All of a scene file.
struct Scene {
    std::string title;
    Analysis analysis = Analysis::plane_strain;
    double thickness = 1; ///< plane strain and plane stress [m]
    GridSpec grid;
    TimeSpec time;
    MethodSpec method;
    std::vector<MaterialSpec> materials;
    std::vector<NamedShapeSpec> shapes;
    std::vector<BodySpec> bodies;
    std::vector<ImageSpec> images;
    Overlap overlap = Overlap::refuse;
    std::optional<ContactSpec> contact;
    std::vector<BoundarySpec> boundaries;
    Vector gravity{};
    OutputSpec output;
};

} // namespace abut
