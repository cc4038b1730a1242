#include "geometry/packing/pack_scene.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace abut {

namespace {

std::string shape_json(const ShapeSpec& grain, double pixel) {
    // fmt writes the fewest digits that read back as the same number.
    const auto numbers = [&](std::vector<double> values) {
        for (double& value : values) value *= pixel;
        return fmt::format("[{}]", fmt::join(values, ", "));
    };
    if (const auto* disk = std::get_if<Disk>(&grain))
        return fmt::format("\"disk\": {{ \"center\": {}, \"radius\": {} }}",
                           numbers({disk->center[0], disk->center[1]}), disk->radius * pixel);
    if (const auto* ball = std::get_if<Ball>(&grain))
        return fmt::format("\"ball\": {{ \"center\": {}, \"radius\": {} }}",
                           numbers({ball->center[0], ball->center[1], ball->center[2]}), ball->radius * pixel);
    if (const auto* ellipse = std::get_if<Ellipse>(&grain))
        return fmt::format("\"ellipse\": {{ \"center\": {}, \"semi_axes\": {}, \"angle\": {} }}",
                           numbers({ellipse->center[0], ellipse->center[1]}),
                           numbers({ellipse->semi_axes[0], ellipse->semi_axes[1]}), ellipse->angle);
    std::vector<std::string> points;
    for (const PlanePoint& point : std::get<Polygon>(grain).points) points.push_back(numbers({point[0], point[1]}));
    return fmt::format("\"polygon\": {{ \"points\": [{}] }}", fmt::join(points, ", "));
}

} // namespace

std::string scene_of(const PackedGrains& packed, double pixel, const std::string& material, const std::string& title) {
    const bool balls = packed.kind == GrainKind::balls;
    std::vector<double> upper{packed.width * pixel, packed.height * pixel};
    if (balls) upper.push_back(packed.depth * pixel);
    double box = 1;
    for (const double length : upper) box *= length;
    // About ten cells across a grain.
    const double spacing =
        std::pow(box / static_cast<double>(packed.grains.size()), 1.0 / static_cast<double>(upper.size()));
    const double cell = std::min(0.1 * spacing, *std::min_element(upper.begin(), upper.end()));
    const auto quoted = [](const std::string& text) {
        return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
    };
    std::string text = fmt::format(
        "{{\n  \"title\": {},\n  \"analysis\": \"{}\",\n  \"grid\": {{ \"cell\": {:.3g}, \"lower\": {}, \"upper\": "
        "[{}] }},\n"
        "  \"time\": {{ \"end\": \"1 us\" }},\n  \"materials\": {{\n    {}: {{ \"model\": \"neo-hookean-isochoric\", "
        "\"density\": \"2.78 g/cm^3\",\n      \"bulk_modulus\": \"78.09 GPa\", \"shear_modulus\": \"27.6 GPa\" }}\n  "
        "}},\n"
        "  \"contact\": {{}},\n  \"bodies\": [\n",
        quoted(title), balls ? "3d" : "plane-strain", cell, balls ? "[0, 0, 0]" : "[0, 0]", fmt::join(upper, ", "),
        quoted(material));
    const int digits = static_cast<int>(std::to_string(packed.grains.size()).size());
    for (std::size_t k = 0; k < packed.grains.size(); ++k)
        text +=
            fmt::format("    {{ \"name\": \"grain-{:0{}}\", \"material\": {}, {} }}{}\n", k + 1, digits,
                        quoted(material), shape_json(packed.grains[k], pixel), k + 1 < packed.grains.size() ? "," : "");
    return text + "  ]\n}\n";
}

} // namespace abut
