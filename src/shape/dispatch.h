#pragma once
#include "shape/b2cpdi.h"
#include "shape/b2gimp.h"
#include "shape/b2spline.h"
#include "shape/cpdi.h"
#include "shape/gimp.h"
#include "shape/linear.h"
#include "shape/ugimp.h"

namespace abut {

/// Calls work(shape) with the policy object of a shape.
template <class Work>
decltype(auto) with_shape(ShapeKind kind, Work&& work) {
    switch (kind) {
    case ShapeKind::linear:
        return work(LinearShape{});
    case ShapeKind::ugimp:
        return work(UgimpShape{});
    case ShapeKind::gimp:
        return work(GimpShape{});
    case ShapeKind::cpdi:
        return work(CpdiShape{});
    case ShapeKind::b2spline:
        return work(B2splineShape{});
    case ShapeKind::b2gimp:
        return work(B2gimpShape{});
    case ShapeKind::b2cpdi:
        break;
    }
    return work(B2cpdiShape{});
}

/// Stencils that kernels read from the store. A ring has hoop shape functions T.
template <bool Ring>
struct StoredStencils {
    static constexpr bool stored = true;
    static constexpr bool ring = Ring;
};

/// Stencils that kernels expand on the spot.
template <class Shape>
struct ExpandedStencils : Shape {
    static constexpr bool stored = false;
    static constexpr bool ring = false;
};

/// Calls work(source) with where the kernels of a scene get their stencils from: they are compiled for each.
template <int D, class Work>
decltype(auto) with_stencils(ShapeKind kind, bool stored, bool ring, Work&& work) {
    if constexpr (D == 2)
        if (ring) return work(StoredStencils<true>{});
    if (stored) return work(StoredStencils<false>{});
    return with_shape(kind, [&](auto shape) -> decltype(auto) {
        using Shape = decltype(shape);
        if constexpr (Shape::stored)
            return work(StoredStencils<false>{});
        else
            return work(ExpandedStencils<Shape>{});
    });
}

} // namespace abut
