#pragma once
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

} // namespace test
