#pragma once
#include "math/linear_algebra.h"

namespace abut {

/// v/|v|, or zero if v has no direction: no plane, no contact.
template <int D>
Vec<D> unit(const Vec<D>& v) {
    const double length = v.norm();
    return length > 0 ? Vec<D>(v / length) : Vec<D>::Zero();
}

} // namespace abut
