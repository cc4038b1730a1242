#pragma once
#include "contact/normal/unit.h"

namespace abut {

/// The same normal everywhere, from the body listed first in the scene to the one listed later (notes 3.3).
/// \param body_b of the point; of lumped bodies the one with the most mass
template <int D>
Vec<D> specified(const Vec<D>& direction, int body_a, int body_b) {
    return body_a < body_b ? unit<D>(direction) : unit<D>(-direction);
}

} // namespace abut
