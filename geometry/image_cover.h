#pragma once
/// \file image_cover.h
/// Pixels to places of a lattice.

#include "geometry/cover.h"
#include "geometry/labels/label_volume.h"

#include <array>
#include <vector>

namespace abut {

/// How an image lies in the scene.
struct ImageFrame {
    Vector lower{};                ///< its lower corner [m]
    std::array<double, 3> pixel{}; ///< edges of a pixel [m]
};

/// The places of a lattice that the bodies of an image take, per body (label - 1), x fastest; only places 0 to places -
/// 1 along each axis. Fill::majority: a place belongs, whole, to the body or void which covers **the largest area**
/// (volume) of it; of equal shares (to 1e-9 of the place) the one has it that lies lower in the place, or else farther
/// left, which biases no area; if they lie alike, the body of the lowest label. Fill::covered_fraction: each body that
/// covers any of it gets its part. Shares are exact for any sizes of pixels and places; what lies beyond the image is
/// void. Work: proportional to pixels + places.
std::vector<std::vector<Covered>> cover_image(const LabelVolume& image, std::size_t bodies, const ImageFrame& frame,
                                              const Lattice& lattice, const Place& places, Fill fill);

/// The mean of a value per pixel over a body's own pixels (those of `label` in the image) in each of its places, or
/// over all pixels there if it has none.
std::vector<double> mean_over_places(const LabelVolume& values, const LabelVolume& image, std::int32_t label,
                                     const ImageFrame& frame, const Lattice& lattice, const std::vector<Place>& places);

/// The value of the pixel at a point; that of the nearest pixel beyond the image.
std::int32_t value_at(const LabelVolume& values, const ImageFrame& frame, std::size_t dimension, const Vector& x);

} // namespace abut
