#include "app/commands.h"
#include "geometry/images/image.h"
#include "io/scene/read_scene.h"

#include <fmt/format.h>

#include <stdexcept>

namespace abut {

int render_command(const std::filesystem::path& results, const RenderOptions& options) {
    std::vector<std::filesystem::path> files;
    try {
        files = render_series(results, options);
    } catch (const RenderRequestError& error) {
        throw UsageError(error.what());
    }
    fmt::print("{} pictures; the last: {}\n", files.size(), files.back().string());
    return 0;
}

int draw_ellipses_command(const std::filesystem::path& output, const EllipseDrawing& drawing,
                          const std::string& material) {
    if (output.extension() != ".png" && output.extension() != ".bmp")
        throw UsageError(fmt::format("\"{}\": the name of the picture must end in .png or .bmp", output.string()));
    DrawnImage drawn;
    try {
        drawn = draw_ellipses(drawing);
    } catch (const std::exception& error) { // out of range, or more than there is room for
        throw UsageError(error.what());
    }
    write_image(drawn.image, output);
    fmt::print("{}: {} ellipses cover {:.4f} of the area; a legend for a scene:\n{}\n", output.string(),
               drawn.ellipses.size(), drawn.area_fraction, legend_json(drawn, material));
    return 0;
}

int schema_command() {
    fmt::print("{}", scene_schema());
    return 0;
}

int reference_command() {
    fmt::print("{}", scene_reference());
    return 0;
}

} // namespace abut
