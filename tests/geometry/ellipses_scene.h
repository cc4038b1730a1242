#pragma once
/// The scene of examples/ellipses, without the reader of scene files.

#include "support.h"

#include <cmath>

namespace test {

inline abut::Scene ellipses_scene() {
    abut::Scene scene;
    scene.grid = {{14.3e-6, 14.3e-6, 0}, {}, {1e-3, 2e-3, 0}};
    scene.materials.push_back({"aluminium", abut::MaterialModel::neo_hookean_isochoric, 2780, 78.09e9, 27.6e9});
    abut::ImageSpec image;
    image.file = "ellipses.png";
    image.size = {1e-3, 2e-3, 0};
    for (int k = 0; k < 20; ++k) // greys as `abut pack` spaces them
        image.legend.push_back(
            grey(static_cast<int>(std::lround(10 + k / 19.0 * 230)), "grain-" + std::to_string(k + 1), "aluminium"));
    image.legend.push_back(grey(255, ""));
    scene.images = {image};
    return scene;
}

} // namespace test
