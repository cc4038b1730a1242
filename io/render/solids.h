#pragma once
/// \file solids.h
/// Three-dimensional scenes: solid particle domains, the box around them and the directions of the axes.

#include "io/render/domains.h"
#include "io/render/picture.h"

#include <vector>

namespace abut {

/// Adds the faces of deformed particle domains that look towards the eye, lit from above the observer;
/// those of particles within bodies are left out. Horizontal faces on top have the colours themselves, others darker
/// ones. Edges are a third of a pixel longer at both ends. Returns false, adding nothing, if there is no `half_size`.
bool add_solids(Faces& faces, const PointFrame& frame, const View& view, const std::vector<Rgb>& colours);

/// The edges of a box but the three that meet in its corner next to the eye; solids cover them.
void add_box(Faces& faces, const Bounds& bounds, const View& view, double width, Rgb colour);

/// Arrows along x, y and z with their names, at `origin` [pixels].
void add_axes(Picture& picture, const View& view, const Pixel& origin, double unit, Rgb colour);

} // namespace abut
