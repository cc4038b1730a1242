#pragma once
#include "scene/scene.h"

#include <string>
#include <vector>

namespace abut {

/// A body of the model: its name, the index of its material in Scene::materials and its initial velocity.
struct ModelBody {
    std::string name;
    int material = 0; ///< -1: none, it is rigid
    InitialVelocity velocity;
    std::optional<RigidSpec> rigid{};
};

/// Material points before the first step, as geometry makes them: one entry a particle in each array.
struct Model {
    std::vector<ModelBody> bodies;
    std::vector<Vector> position;  ///< of particle centres [m]
    std::vector<Vector> half_size; ///< half the edges of the undeformed particle domain [m]
    std::vector<int> body;         ///< index into `bodies`
    /// How far particles' domains are turned counter-clockwise in the plane [rad]; empty: not at all.
    std::vector<double> angle;

    std::size_t size() const { return position.size(); }
};

} // namespace abut
