#include "io/render/preset.h"

#include "io/render/series_source.h"
#include "io/render/values.h"
#include "results/arrays.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace abut {
namespace {

enum class Arrows { none, normals, separations };

struct Preset {
    const char *name, *array;
    Arrows arrows = Arrows::none;
    /// Particles that fill little of their domains, at the edges of bodies, have stresses far beyond all others.
    bool has_outliers = false;
};

constexpr std::array presets{Preset{"bodies", "body"},
                             Preset{"stress", "von_mises_stress", Arrows::none, true},
                             Preset{"contact", "body", Arrows::separations},
                             Preset{"temperature", "temperature"},
                             Preset{"energy", "strain_energy_density", Arrows::none, true},
                             Preset{"pressure", "pressure"},
                             Preset{"velocity", "velocity"},
                             Preset{"normals", "body", Arrows::normals},
                             Preset{"von-mises", "von_mises_stress", Arrows::none, true}};

/// "this scene has no temperature", of an array that only some scenes have.
std::string lacking(const PointFrame& frame, const RenderOptions& options) {
    std::vector<std::string> drawable;
    for (const Preset& preset : presets)
        if (preset.arrows == Arrows::none && find_array(frame, preset.array)) drawable.emplace_back(preset.name);
    const std::string there_is =
        frame.arrays.empty() ? "nothing, since the files have no arrays"
        : drawable.empty()   ? fmt::format("no preset, but --array with one of {}", fmt::join(array_names(frame), ", "))
                             : fmt::format("{}", fmt::join(drawable, ", "));
    for (const ArrayInfo& info : particle_arrays())
        if (info.name == options.array && !info.only.empty())
            return fmt::format("this scene has no {}; what can be drawn: {}", options.array, there_is);
    return fmt::format("the results have no array \"{}\" (see particle_arrays of the scene's output); what can be "
                       "drawn: {}",
                       options.array, there_is);
}

void check(const RenderOptions& options) {
    const auto unfit = [](int size) { return size < 100 || size > 8192; };
    if (unfit(options.width) || (options.height != 0 && unfit(options.height)))
        throw RenderRequestError("the width and height of pictures must be from 100 to 8192 pixels");
    if (options.percentile && !(*options.percentile > 50 && *options.percentile <= 100))
        throw RenderRequestError(fmt::format("a percentile of {} for the range of colours; it must be above 50 and at "
                                             "most 100",
                                             *options.percentile));
    if (options.percentile && options.range)
        throw RenderRequestError("the colours have either a range or a percentile, not both");
    if (options.range && !std::isfinite(options.range->second - options.range->first))
        throw RenderRequestError(fmt::format("the ends of the range of colours must be finite and not too far apart, "
                                             "not {} and {}",
                                             options.range->first, options.range->second));
    if (options.range && !(options.range->first < options.range->second))
        throw RenderRequestError(fmt::format("the range of colours must rise, not go from {} to {}",
                                             options.range->first, options.range->second));
    const auto& region = options.region;
    if (!region.empty() && region.size() != 4 && region.size() != 6)
        throw RenderRequestError(
            fmt::format("a region has 4 numbers, X0,Y0,X1,Y1, or in 3D 6, X0,Y0,Z0,X1,Y1,Z1; not {}", region.size()));
    if (!std::all_of(region.begin(), region.end(), [](double number) { return std::isfinite(number); }))
        throw RenderRequestError("the numbers of a region must be finite");
    for (std::size_t k = 0; k < region.size() / 2; ++k)
        if (!(region[k] < region[k + region.size() / 2]))
            throw RenderRequestError(fmt::format("the region is empty along {}: from {} m to {} m", "xyz"[k], region[k],
                                                 region[k + region.size() / 2]));
}

} // namespace

const std::vector<std::string>& render_presets() {
    static const std::vector<std::string> names = [] {
        std::vector<std::string> result;
        for (const Preset& preset : presets) result.emplace_back(preset.name);
        return result;
    }();
    return names;
}

RenderOptions resolved(RenderOptions options) {
    check(options);
    if (options.preset.empty()) return options;
    const auto preset =
        std::find_if(presets.begin(), presets.end(), [&](const Preset& p) { return options.preset == p.name; });
    if (preset == presets.end()) throw RenderRequestError(no_such("preset", options.preset, render_presets()));
    options.array = preset->array;
    options.component = -1;
    options.normals = preset->arrows == Arrows::normals;
    options.separations = preset->arrows == Arrows::separations;
    if (preset->has_outliers && !options.range && !options.percentile) options.percentile = 99;
    return options;
}

const Array& chosen_array(const PointFrame& frame, const RenderOptions& options, const std::string& where) {
    const Array* array = find_array(frame, options.array);
    if (!array && !options.preset.empty())
        throw RenderRequestError(fmt::format("{}: {}", where, lacking(frame, options)));
    if (!array)
        throw RenderRequestError(fmt::format("{}: {}", where, no_such("array", options.array, array_names(frame))));
    if (options.component >= array->components)
        throw RenderRequestError(fmt::format("{}: array \"{}\" has components 0 to {}, not {}", where, options.array,
                                             array->components - 1, options.component));
    return *array;
}

void check_contact_arrays(const PointFrame& contact, const RenderOptions& options, const std::string& where) {
    std::vector<const char*> needed{"normal", "in_contact"};
    if (options.separations) needed.push_back("separation");
    if (!options.bodies.empty()) needed.insert(needed.end(), {"body_a", "body_b"});
    for (const char* name : needed)
        if (!find_array(contact, name))
            throw RenderRequestError(fmt::format("{}: its files lack the array \"{}\", which these pictures need (see "
                                                 "contact_arrays of the scene's output)",
                                                 where, name));
}

bool by_body(const RenderOptions& options) {
    return options.array == "body";
}

bool with_contact(const RenderOptions& options) {
    return options.normals || options.separations;
}

} // namespace abut
