#include "io/scene/bind_parts.h"

#include <charconv>
#include <string_view>

namespace abut {

namespace {

std::array<int, 3> bind_colour(std::string_view text) {
    std::array<int, 3> rgb{};
    for (std::size_t i = 0; i < 3; ++i) {
        const char* digits = text.data() + 1 + 2 * i;
        std::from_chars(digits, digits + 2, rgb[i], 16);
    }
    return rgb;
}

/// Whether a list was found right; wrong entries are texts.
bool are_two_numbers(const Json& json) {
    return json.size() == 2 && json[0].is_number() && json[1].is_number();
}

/// A list of two whole numbers.
std::array<int, 2> bind_two(const Json& json) {
    return {json.at(0).get<int>(), json.at(1).get<int>()};
}

LegendEntry bind_legend_entry(const Json& json) {
    LegendEntry entry;
    if (const Json* grey = find(json, "grey")) {
        entry.grey = true;
        entry.rgb.fill(grey->get<int>());
    } else if (const Json* range = find(json, "grey_range"); range && are_two_numbers(*range)) {
        entry.grey = true;
        entry.grey_range = bind_two(*range);
    } else if (const Json* rgb = find(json, "rgb")) {
        entry.rgb = bind_colour(rgb->get_ref<const std::string&>());
    }
    copy(json, "tolerance", entry.tolerance);
    copy(json, "void", entry.is_void);
    copy(json, "body", entry.body);
    copy(json, "material", entry.material);
    if (const Json* rigid = find(json, "rigid")) entry.rigid = bind_rigid(*rigid);
    copy_components(json, "velocity", entry.velocity);
    entry.state = bind_initial_state(json);
    return entry;
}

std::array<std::array<int, 2>, 3> bind_crop(const Json& json) {
    constexpr std::array<int, 2> all{0, -1};
    std::array<std::array<int, 2>, 3> crop{all, all, all};
    const std::array names{"columns", "rows", "slices"};
    for (std::size_t i = 0; i < names.size(); ++i)
        if (const Json* range = find(json, names[i]); range && are_two_numbers(*range)) crop[i] = bind_two(*range);
    return crop;
}

std::optional<ValueImage> bind_value_image(const Json& json, const char* key) {
    const Json* object = find(json, key);
    if (!object) return {};
    ValueImage image;
    if (const Json* file = find(*object, "file")) image.file = file->get<std::string>();
    copy(*object, "black", image.black);
    copy(*object, "white", image.white);
    return image;
}

} // namespace

ImageSpec bind_image(const Json& json) {
    ImageSpec image;
    if (const Json* file = find(json, "file")) image.file = file->get<std::string>();
    copy_per_axis(json, "pixel", image.pixel, 3);
    copy_components(json, "size", image.size);
    copy_components(json, "lower", image.lower);
    copy_word(json, "up", up_words, image.first_row_is_up);
    copy(json, "slice", image.slice);
    if (const Json* crop = find(json, "crop")) image.crop = bind_crop(*crop);
    for (const Json& axis : part(json, "flip"))
        if (const auto known = value_of(axis_words, axis.get_ref<const std::string&>()))
            image.flip[static_cast<std::size_t>(*known)] = true;
    copy(json, "quarter_turns", image.quarter_turns);
    copy_word(json, "turn_axis", axis_words, image.turn_axis);
    copy_word(json, "bodies", bodies_words, image.bodies);
    copy(json, "connectivity", image.connectivity);
    copy(json, "split", image.split);
    copy(json, "speckle", image.speckle);
    copy_word(json, "fill", fill_words, image.fill);
    copy(json, "particles_per_cell", image.particles_per_cell);
    copy_list(json, "legend", image.legend, bind_legend_entry);
    image.temperature = bind_value_image(json, "temperature");
    image.orientation = bind_value_image(json, "orientation");
    return image;
}

} // namespace abut
