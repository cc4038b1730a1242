#pragma once
/// \file image_particles.h
/// Pixels to particles.

#include "geometry/images/image.h"
#include "geometry/labels/legend.h"
#include "scene/scene.h"

#include <array>
#include <vector>

namespace abut {

/// Edges of a pixel [m]: as given, or the given size of the whole picture divided by its pixels.
std::array<double, 2> pixel_size(const ImageSpec& spec, int width, int height);

/// The particles of a picture.
struct ImageParticles {
    Vector half_size{};                        ///< of every particle [m]; z is 0
    std::vector<std::vector<Vector>> position; ///< centres [m], one list per LabelledPicture::bodies
};

/// Fills the places of the grid's particle lattice (cell / particles_per_cell, anchored at the grid's lower corner)
/// that the picture covers. A place belongs to the body or void which covers **the largest area** of it; pixels may be
/// larger or smaller than particles, by any factor; what lies beyond the picture is void. Of equal areas (to 1e-9 of
/// the particle) a body wins over void, and the body named earlier in the legend over the later one. Places outside the
/// grid are left out. Work: proportional to pixels + particles.
ImageParticles image_particles(const ImageSpec& spec, const LabelledPicture& image, const GridSpec& grid);

} // namespace abut
