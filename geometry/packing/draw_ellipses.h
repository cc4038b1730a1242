#pragma once
/// \file draw_ellipses.h
/// Pictures of densely packed ellipses: pack_grains() and shade_grains() in one.

#include "geometry/images/image.h"
#include "geometry/packing/draw_grains.h"
#include "scene/scene.h"

#include <cstdint>
#include <string>
#include <vector>

namespace abut {

/// What to draw. Lengths in pixels.
struct EllipseDrawing {
    int width = 280, height = 560;
    int bodies = 20;                         ///< number of ellipses
    int shades = 20;                         ///< number of greys; fewer than bodies: ellipses far apart share one
    double min_aspect = 1, max_aspect = 2.5; ///< longer over shorter semi-axis
    SizeDistribution sizes;                  ///< of √(a b)
    double area_fraction = 0.55;             ///< of the picture that ellipses cover
    double gap = 0;                          ///< least distance between two ellipses
    double neighbour_distance = 8;           ///< ellipses nearer than this have different greys
    int background = 255;                    ///< grey of the void
    std::uint64_t seed = 1;
};

/// The picture and what is in it.
struct DrawnImage {
    Image image;                   ///< grey
    std::vector<Ellipse> ellipses; ///< in pixels from the picture's lower left corner, y up
    std::vector<int> shade;        ///< grey of each ellipse
    std::vector<int> shades;       ///< all the greys, ascending
    int background = 255;          ///< grey of the void
    double area_fraction = 0;      ///< pixels of ellipses over all pixels
};

/// Draws ellipses of random sizes, aspects, directions and places, all inside the picture, none over another, with
/// sharp edges: a pixel whose centre is in an ellipse has its grey. The same drawing comes out of the same values on
/// every machine. \throws as pack_grains() and shade_grains()
DrawnImage draw_ellipses(const EllipseDrawing& drawing);

} // namespace abut
