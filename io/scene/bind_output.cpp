#include "io/scene/bind_parts.h"

namespace abut {

namespace {

SeriesSpec bind_series(const Json& json, const std::string& name, const char* list) {
    SeriesSpec series;
    copy(json, name.c_str(), series.write);
    copy(json, (name + "_every").c_str(), series.every);
    copy(json, list, series.arrays);
    return series;
}

/// The numbers of a list; a wrong entry, which has been told of, holds its place as a text.
Vector numbers_of(const Json& list, Vector numbers) {
    for (std::size_t i = 0; list.is_array() && i < std::min(numbers.size(), list.size()); ++i)
        if (list[i].is_number()) numbers[i] = list[i].get<double>();
    return numbers;
}

ContactCloudsSpec bind_clouds(const Json& json) {
    ContactCloudsSpec clouds;
    copy_list(json, "nodes", clouds.nodes, [](const Json& entry) {
        std::array<int, 3> node{}; // how many are given is checked in validate()
        std::ranges::transform(numbers_of(entry, {-1, -1, -1}), node.begin(),
                               [](double number) { return static_cast<int>(number); });
        return node;
    });
    copy_list(json, "near", clouds.near, [](const Json& entry) { return numbers_of(entry, {}); });
    copy(json, "disagreement", clouds.disagreement);
    return clouds;
}

} // namespace

OutputSpec bind_output(const Json& json) {
    OutputSpec output;
    copy(json, "every", output.every);
    copy(json, "history_every", output.history_every);
    output.particles = bind_series(json, "particles", "particle_arrays");
    output.grid = bind_series(json, "grid", "grid_arrays");
    output.contact = bind_series(json, "contact", "contact_arrays");
    copy(json, "bodies", output.bodies);
    std::string precision;
    copy(json, "precision", precision);
    output.single_precision = precision == "single";
    copy(json, "pairs", output.pairs);
    if (const Json* clouds = find(json, "contact_clouds")) output.contact_clouds = bind_clouds(*clouds);
    copy(json, "checkpoint", output.checkpoint);
    copy(json, "checkpoint_every", output.checkpoint_every);
    copy(json, "checkpoint_every_steps", output.checkpoint_every_steps);
    copy(json, "checkpoint_every_wall", output.checkpoint_every_wall);
    copy(json, "live", output.live);
    copy(json, "live_preset", output.live_preset);
    return output;
}

} // namespace abut
