#pragma once
#include "shape/point_shape.h"

namespace abut {

/// Linear shape functions of a particle without extent ("classic" MPM).
struct LinearShape : PointShape<LinearFunction> {};

} // namespace abut
