#pragma once
#include "contact/normal/unit.h"

namespace abut {

/// Normal of body a by its own volume gradient, n = g_a/|g_a| (notes 3.1, 3.5). The other body's is not the opposite,
/// so each is corrected by itself, against all others lumped, and momentum is not conserved: for comparison with early
/// MPM only.
/// \param a volume | volume gradient of body a
template <int D>
Vec<D> own_gradient(const Pack& a) {
    return unit<D>(vector_of<D>(a));
}

} // namespace abut
