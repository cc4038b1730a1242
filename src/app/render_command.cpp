#include "app/commands.h"
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

int schema_command() {
    fmt::print("{}", scene_schema());
    return 0;
}

int reference_command() {
    fmt::print("{}", scene_reference());
    return 0;
}

} // namespace abut
