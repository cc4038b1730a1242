#pragma once
/// \file round_solids.h
/// Boxes, and what circles bound, as solids: closed forms.

#include "geometry/shapes/solid.h"

namespace abut {

Solid plane_solid(const Box& box);
Solid plane_solid(const Disk& disk);
Solid plane_solid(const Ellipse& ellipse);
Solid plane_solid(const Ring& ring);

Solid space_solid(const Box& box);
Solid space_solid(const Ball& ball);
Solid space_solid(const Ellipsoid& ellipsoid);
Solid space_solid(const Cylinder& cylinder);
Solid space_solid(const Cone& cone);

} // namespace abut
