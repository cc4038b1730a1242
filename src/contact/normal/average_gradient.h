#pragma once
#include "contact/normal/unit.h"

namespace abut {

/// Normal by both bodies' volume gradients: n = (g_a − g_b)/|g_a − g_b| (contact paper Eq. 13). Each counts by its
/// volume near the node. (The notes' 3.2 has a plus, g_b being taken as directed from a to b there; 3.3 and 3.4 have
/// the minus.)
/// \param a volume | volume gradient of body a; likewise b
template <int D>
Vec<D> average_gradient(const Pack& a, const Pack& b) {
    return unit<D>(vector_of<D>(a - b));
}

} // namespace abut
