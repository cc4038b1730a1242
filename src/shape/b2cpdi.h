#pragma once
#include "shape/convected_shape.h"

namespace abut {

/// CPDI with quadratic splines on the grid (B2CPDI of the FMPM paper).
struct B2cpdiShape : ConvectedShape<SplineFunction> {};

} // namespace abut
