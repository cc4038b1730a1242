#pragma once
#include "math/linear_algebra.h"
#include "scene/scene.h"

#include <cstdint>
#include <utility>
#include <vector>

namespace abut {

/// Momentum change Δp' of body a by a contact law (contact paper Eq. 8-10; notes 4.9-4.12).
/// \param stick  Δp(0): what would make both bodies move together [N s]
/// \param normal unit normal from a to b
/// \param touching the separation is negative
template <int D>
inline Vec<D> law_impulse(const LawSpec& law, const Vec<D>& stick, const Vec<D>& normal, bool touching) {
    if (law.type == LawType::perfect) return stick;
    const double compression = -stick.dot(normal); // N_c A_c Δt
    if (!touching || compression <= 0) return Vec<D>::Zero();
    switch (law.type) {
    case LawType::stick:
        return stick;
    case LawType::friction: {
        // S_slide = µ N_c: slide if sticking needs more.
        const Vec<D> tangential = stick + compression * normal;
        const double sticking = tangential.norm();
        const double sliding = law.coefficient * compression;
        if (sticking <= sliding) return stick;
        return -compression * normal + (sliding / sticking) * tangential;
    }
    case LawType::frictionless:
    case LawType::perfect:
        break;
    }
    return -compression * normal;
}

/// Which law holds between two bodies.
struct LawTable {
    struct Pair {
        std::int32_t a, b; ///< a < b
        LawSpec law;
    };
    LawSpec standard;
    std::vector<Pair> pairs; ///< sorted by (a, b)

    const LawSpec& between(std::int32_t a, std::int32_t b) const {
        if (pairs.empty()) return standard;
        if (a > b) std::swap(a, b);
        for (const Pair& pair : pairs)
            if (pair.a == a && pair.b == b) return pair.law;
        return standard;
    }
};

} // namespace abut
