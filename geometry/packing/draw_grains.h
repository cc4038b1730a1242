#pragma once
/// \file draw_grains.h
/// Pictures of packed grains.

#include "geometry/images/image.h"
#include "geometry/packing/pack.h"
#include "geometry/packing/shades.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace abut {

/// How grains are drawn.
struct DrawingStyle {
    int shades = 20;                          ///< number of greys; fewer than bodies: grains far apart share one
    std::optional<double> neighbour_distance; ///< grains nearer than this [pixels] have different greys; not given: the
                                              ///< largest of 8, 4, 2 and 1 with which the shades suffice
    int background = 255;                     ///< grey of the void
    std::uint64_t seed = 1;                   ///< which grain gets which grey
    bool all_alike = false;                   ///< neighbours need not differ
};

/// \throws std::invalid_argument when a value makes no sense; so before the grains are packed
void check_style(const DrawingStyle& style);

/// The greys of grains.
struct ShadedGrains {
    std::vector<int> shade;        ///< grey of each
    std::vector<int> shades;       ///< all the greys, ascending
    int background = 255;          ///< grey of the void
    double neighbour_distance = 0; ///< grains nearer than this have different greys [pixels]
    double fraction = 0;           ///< pixels of grains over all pixels
    int width = 0, height = 0, slices = 1;
    /// The label of each pixel of a slice, rows from the top: k + 1 where its centre lies in grain k, else 0.
    std::function<std::vector<int>(int slice)> labels;
};

/// Chooses a grey for each grain. Greys are evenly spaced from 10 to 240. \throws std::invalid_argument when a value
/// makes no sense; std::runtime_error when a grain is smaller than a pixel or the shades don't suffice
ShadedGrains shade_grains(const PackedGrains& packed, const DrawingStyle& style);

/// The picture, or slice of the volume, with sharp edges.
Image draw(const ShadedGrains& shaded, int slice = 0);

/// What the `legend` and, with fewer shades than bodies, `bodies` of an image in a scene file are: one body per grey,
/// grain-01, grain-02, ... by ascending grey, or all "grain" and `"bodies": "by-component"`; the background is void.
std::string legend_json(const ShadedGrains& shaded, const std::string& material);

/// Label of each pixel of a slice; see ShadedGrains::labels.
std::vector<int> rasterize(const std::vector<ShapeSpec>& grains, int width, int height, int slice = 0);

} // namespace abut
