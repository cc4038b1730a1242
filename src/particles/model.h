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
    std::string group{}; ///< what the names of the bodies of a legend entry begin with, if it makes several
    /// Stress at time 0, Cauchy, xx yy zz xy yz xz [Pa]; not given: none.
    std::optional<std::array<double, 6>> stress{};

    /// Whether the body is called so, by its own name or with all that came of its legend entry.
    bool is_called(const std::string& called) const { return name == called || (!group.empty() && group == called); }
};

/// Material points before the first step, as geometry makes them: one entry a particle in each array.
struct Model {
    std::vector<ModelBody> bodies;
    std::vector<Vector> position;  ///< of particle centres [m]
    std::vector<Vector> half_size; ///< half the edges of the undeformed particle domain [m]
    std::vector<int> body;         ///< index into `bodies`
    /// How far particles' domains are turned counter-clockwise in the plane [rad]; empty: not at all.
    std::vector<double> angle;
    std::vector<double> temperature; ///< [K]; empty: no body has one. NaN for particles without.
    std::vector<double> orientation; ///< of the material's x axis [rad]; likewise

    std::size_t size() const { return position.size(); }
};

} // namespace abut
