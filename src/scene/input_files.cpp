#include "scene/input_files.h"

namespace abut {

std::vector<std::filesystem::path> input_files(const Scene& scene) {
    std::vector<std::filesystem::path> files;
    const auto add_shape = [&](const ShapeSpec& shape) {
        if (const auto* path = std::get_if<Path>(&shape)) files.push_back(path->file);
        if (const auto* surface = std::get_if<Surface>(&shape)) files.push_back(surface->file);
    };
    for (const NamedShapeSpec& named : scene.shapes) add_shape(named.shape);
    for (const BodySpec& body : scene.bodies) add_shape(body.shape);
    for (const ImageSpec& image : scene.images) {
        files.push_back(image.file);
        if (image.temperature) files.push_back(image.temperature->file);
        if (image.orientation) files.push_back(image.orientation->file);
    }
    return files;
}

} // namespace abut
