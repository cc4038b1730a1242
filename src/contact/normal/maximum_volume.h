#pragma once
#include "contact/normal/unit.h"

namespace abut {

/// Normal by the volume gradient of the body with more volume at the node: g_a if Ω_a > Ω_b, else −g_b (notes 3.4).
/// \param a volume | volume gradient of body a; likewise b
template <int D>
Vec<D> maximum_volume(const Pack& a, const Pack& b) {
    return a[0] > b[0] ? unit<D>(vector_of<D>(a)) : unit<D>(-vector_of<D>(b));
}

} // namespace abut
