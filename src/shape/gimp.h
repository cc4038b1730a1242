#pragma once
#include "shape/box_shape.h"

namespace abut {

/// Finite GIMP: linear grid functions averaged over the *current* particle domain (FMPM paper §2.1), taken as the box
/// along the axes with the domain's extents (see CurrentBox).
struct GimpShape : BoxShape<LinearFunction, CurrentBox> {
    static constexpr bool stored = true;
};

} // namespace abut
