#pragma once
/// What the tests on inclined planes share.

#include "support.h"

namespace test {

/// A box of nx times ny particles turned counter-clockwise by an angle about its centre.
inline void add_turned_box(Model& model, int body, const Vector& center, double width, double height, int nx, int ny,
                           double angle) {
    const std::size_t first = model.size();
    add_box(model, body, -width / 2, -height / 2, width / 2, height / 2, nx, ny);
    for (std::size_t p = first; p < model.size(); ++p) {
        const auto [x, y, z] = model.position[p];
        model.position[p] = {center[0] + std::cos(angle) * x - std::sin(angle) * y,
                             center[1] + std::sin(angle) * x + std::cos(angle) * y, 0};
    }
    model.angle.resize(first, 0);
    model.angle.resize(model.size(), angle);
}

/// Runs from one time to another with a gravity that changes smoothly. \param gravity by a share that goes from 0 to 1
inline void ramp(State<2>& state, double from, double to, const std::function<Vector(double)>& gravity) {
    while (state.time < to * (1 - 1e-9)) {
        const double middle = (state.time + 1e-3 - from) / (to - from);
        state.scene.gravity = gravity(0.5 - 0.5 * std::cos(std::acos(-1) * std::min(1.0, middle)));
        run(state, std::min(state.time + 2e-3, to));
    }
    state.scene.gravity = gravity(1);
}

} // namespace test
