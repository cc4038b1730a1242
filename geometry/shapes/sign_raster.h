#pragma once
/// \file sign_raster.h
/// Where an expression is negative, seen at the points of a raster.

#include "scene/scene.h"

#include <functional>
#include <vector>

namespace abut {

/// What the raster saw of the surface that parts negative from other values.
struct SignRaster {
    std::vector<Vector> points; ///< on the surface, some on each of its connected pieces that the raster saw
    double volume = 0;          ///< of what is negative, estimated
    double doubt = 0;           ///< largest error of it: all the boxes that the surface passes through
};

/// Samples `value` at `count`³ points (first and last on the faces of the box) of the box.
/// \throws std::runtime_error if it is NaN somewhere or negative on a face of the box; says where, in multiples of
/// `unit`
SignRaster sample_signs(const std::function<double(const Vector&)>& value, const Vector& lower, const Vector& upper,
                        double unit, int count);

} // namespace abut
