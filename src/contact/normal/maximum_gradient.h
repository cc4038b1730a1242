#pragma once
#include "contact/normal/unit.h"

namespace abut {

/// Normal by the longer of both bodies' volume gradients: g_a if |g_a| > |g_b|, else −g_b (notes 3.3).
/// \param a volume | volume gradient of body a; likewise b
template <int D>
Vec<D> maximum_gradient(const Pack& a, const Pack& b) {
    return dot(a, a) > dot(b, b) ? unit<D>(vector_of<D>(a)) : unit<D>(-vector_of<D>(b));
}

} // namespace abut
