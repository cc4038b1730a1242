#pragma once
#include "shape/cpdi.h"
#include "shape/linear.h"
#include "shape/ugimp.h"

namespace abut {

/// Calls work(shape) with the policy object of a shape: the kernels are compiled for each.
template <class Work>
decltype(auto) with_shape(ShapeKind kind, Work&& work) {
    switch (kind) {
    case ShapeKind::linear:
        return work(LinearShape{});
    case ShapeKind::ugimp:
        return work(UgimpShape{});
    case ShapeKind::cpdi:
        break;
    }
    return work(CpdiShape{});
}

} // namespace abut
