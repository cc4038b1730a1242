#pragma once
#include "plan/effects.h"

#include <cstddef>
#include <string>
#include <vector>

namespace abut {

/// Memory that a scene's effects take.
struct Field {
    std::string name;
    std::string place;  ///< "particle", "stencil entry" (a node that a particle sees), "slot" (a body at a node),
                        ///< "contact node"
    std::string reason; ///< why this scene needs it
    std::size_t bytes_each = 0;
};

/// The particle, node and contact fields that a scene's effects need, with reasons.
template <int D>
std::vector<Field> fields_of(const Effects& effects);

} // namespace abut
