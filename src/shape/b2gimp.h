#pragma once
#include "shape/box_shape.h"

namespace abut {

/// uGIMP with quadratic splines on the grid (B2GIMP of the FMPM paper): averaged over the undeformed domain.
struct B2gimpShape : BoxShape<SplineFunction, InitialBox> {
    static constexpr bool stored = true;
};

} // namespace abut
