#pragma once
#include "shape/convected_shape.h"

namespace abut {

/// CPDI with linear grid functions.
struct CpdiShape : ConvectedShape<LinearFunction> {};

} // namespace abut
