#pragma once
#include "shape/point_shape.h"

namespace abut {

/// Quadratic splines of a particle without extent (B2SPLINE of the FMPM paper).
struct B2splineShape : PointShape<SplineFunction> {};

} // namespace abut
