#include "geometry/labels/label_image.h"

#include "geometry/labels/components.h"
#include "geometry/labels/name_bodies.h"
#include "geometry/labels/pixel_order.h"
#include "geometry/labels/speckles.h"
#include "geometry/labels/split.h"
#include "geometry/labels/used_part.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace abut {

namespace {

void check(const ImageSpec& spec, int dimension) {
    if (dimension == 2 && spec.quarter_turns != 0 && spec.turn_axis != 2)
        throw std::runtime_error("can be turned about z only in a plane scene");
    if (spec.split && spec.bodies != BodiesBy::component)
        throw std::runtime_error("can be divided at necks (\"split\") only where bodies go by \"component\"");
    if (spec.split && !(*spec.split > 0 && std::isfinite(*spec.split)))
        throw std::runtime_error(fmt::format("needs a \"split\" larger than 0 pixels, not {}", *spec.split));
}

/// The used slices, as numbers of colours.
std::vector<std::vector<std::int32_t>> numbered_slices(const UsedPart& used, const StackInfo& info,
                                                       const ReadSlices& read, ColourTable& colours) {
    std::vector<std::vector<std::int32_t>> slices;
    read(used[2][0], used[2][1], [&](int slice, const Image& image) {
        if (image.width != info.width || image.height != info.height)
            throw std::runtime_error(fmt::format("has {} x {} pixels in slice {}, but {} x {} elsewhere", image.width,
                                                 image.height, slice, info.width, info.height));
        slices.push_back(colours.count(image, used[0], used[1]));
    });
    const int wanted = used[2][1] - used[2][0] + 1;
    if (static_cast<int>(slices.size()) != wanted)
        throw std::runtime_error(fmt::format("gave {} slices instead of {}", slices.size(), wanted));
    return slices;
}

/// Puts slices where they lie in the scene, freeing them one by one.
LabelVolume assemble(std::vector<std::vector<std::int32_t>> slices, const PixelOrder& order,
                     const std::array<int, 2>& columns_and_rows, const std::vector<std::int32_t>& label_of_colour) {
    LabelVolume volume;
    volume.size = order.size;
    volume.label.resize(static_cast<std::size_t>(order.size[0]) * order.size[1] * order.size[2]);
    std::ptrdiff_t slice_start = order.first;
    for (std::vector<std::int32_t>& slice : slices) {
        const std::int32_t* colour = slice.data();
        for (int row = 0; row < columns_and_rows[1]; ++row) {
            std::ptrdiff_t place = slice_start + row * order.step[1];
            for (int column = 0; column < columns_and_rows[0]; ++column, place += order.step[0])
                volume.label[static_cast<std::size_t>(place)] = label_of_colour[static_cast<std::size_t>(*colour++)];
        }
        slice = std::vector<std::int32_t>();
        slice_start += order.step[2];
    }
    return volume;
}

/// Size of a pixel along x, y, z, of which only the ratios are needed: as the scene gives it, or the file, or equal.
std::array<double, 3> shape_of_pixel(const ImageSpec& spec, int dimension, const LabelledImage& image) {
    std::array<double, 3> shape{1, 1, 1};
    bool given = true, whole = true, stated = true;
    for (std::size_t a = 0; a < 3 && static_cast<int>(a) < dimension; ++a) {
        given = given && spec.pixel[a] > 0;
        whole = whole && spec.size[a] > 0;
        stated = stated && image.spacing[a] > 0;
    }
    for (std::size_t a = 0; a < 3 && static_cast<int>(a) < dimension; ++a) {
        if (given)
            shape[a] = spec.pixel[a];
        else if (whole)
            shape[a] = spec.size[a] / image.volume.size[a];
        else if (stated)
            shape[a] = image.spacing[a];
    }
    if (dimension == 2) shape[2] = std::max(shape[0], shape[1]);
    return shape;
}

void check_number(std::int32_t components, const ImageSpec& spec) {
    if (components <= most_bodies) return;
    throw std::runtime_error(fmt::format("has {} components that would each be a body, more than {}: probably noise; "
                                         "raise \"speckle\"{}, or smooth the image",
                                         components, most_bodies, spec.split ? " or \"split\"" : ""));
}

void find_components(LabelledImage& image, const ImageSpec& spec, int dimension, const std::vector<PixelKind>& kinds) {
    const int connectivity = used_connectivity(spec, dimension);
    Components found = connected_components(image.volume, connectivity);
    check_number(found.count, spec);
    std::vector<int> entries(static_cast<std::size_t>(found.count));
    for (std::size_t p = 0; p < image.volume.label.size(); ++p)
        if (const std::int32_t body = found.volume.label[p]; body > 0)
            entries[static_cast<std::size_t>(body - 1)] =
                kinds[static_cast<std::size_t>(image.volume.label[p] - 1)].entry;
    image.volume.label = std::vector<std::int32_t>(); // not needed any more, and the division needs much memory
    if (spec.split) {
        std::vector<int> of_parts;
        for (const std::int32_t component :
             split_at_necks(found, connectivity, shape_of_pixel(spec, dimension, image), *spec.split))
            of_parts.push_back(entries[static_cast<std::size_t>(component - 1)]);
        entries = std::move(of_parts);
        check_number(found.count, spec);
    }
    image.volume = std::move(found.volume);
    const std::vector<std::string> names = names_by_component(entries, spec.legend);
    for (std::size_t k = 0; k < names.size(); ++k) image.bodies.push_back({names[k], entries[k], 0});
}

/// Kinds that are left become bodies; others vanish.
void find_colours(LabelledImage& image, const ImageSpec& spec, const std::vector<PixelKind>& kinds) {
    std::vector<std::int32_t> body(kinds.size() + 1, 0);
    for (const std::int32_t label : image.volume.label) body[static_cast<std::size_t>(label)] = 1;
    body[0] = 0;
    std::vector<PixelKind> left;
    for (std::size_t label = 1; label < body.size(); ++label) {
        if (body[label] == 0) continue;
        left.push_back(kinds[label - 1]);
        body[label] = static_cast<std::int32_t>(left.size());
    }
    for (std::int32_t& label : image.volume.label) label = body[static_cast<std::size_t>(label)];
    const std::vector<std::string> names = names_by_colour(left, spec.legend);
    for (std::size_t k = 0; k < names.size(); ++k) image.bodies.push_back({names[k], left[k].entry, 0});
}

} // namespace

LabelledImage label_stack(const ImageSpec& spec, int dimension, const StackInfo& info, const ReadSlices& read) {
    check(spec, dimension);
    const int connectivity = used_connectivity(spec, dimension);
    const UsedPart used = used_part(spec, dimension, info);
    std::array<int, 3> extent{};
    for (std::size_t a = 0; a < 3; ++a) extent[a] = used[a][1] - used[a][0] + 1;

    ColourTable colours;
    std::vector<std::vector<std::int32_t>> slices = numbered_slices(used, info, read, colours);
    MatchedColours matched = match_colours(colours.colours(), spec.legend);
    const PixelKinds kinds = pixel_kinds(spec, colours.colours(), matched.entry);

    const PixelOrder order = pixel_order(spec, extent);
    LabelledImage image;
    image.volume = assemble(std::move(slices), order, {extent[0], extent[1]}, kinds.of_colour);
    image.pixels_of_entry = std::move(matched.pixels_of_entry);
    image.unmatched = std::move(matched.unmatched);
    if (info.spacing)
        for (std::size_t a = 0; a < 3; ++a) image.spacing[static_cast<std::size_t>(order.axis[a])] = (*info.spacing)[a];

    const RemovedSpeckles removed = remove_speckles(image.volume, connectivity, spec.speckle);
    image.speckle_pixels = removed.pixels;
    image.speckles = removed.components;

    if (spec.bodies == BodiesBy::component)
        find_components(image, spec, dimension, kinds.kinds);
    else if (spec.bodies == BodiesBy::colour)
        find_colours(image, spec, kinds.kinds);
    else
        for (const PixelKind& kind : kinds.kinds)
            image.bodies.push_back({spec.legend[static_cast<std::size_t>(kind.entry)].body, kind.entry, 0});
    for (const std::int32_t label : image.volume.label)
        if (label > 0) ++image.bodies[static_cast<std::size_t>(label - 1)].pixels;
    return image;
}

LabelledImage label_image(const ImageSpec& spec, int dimension, const std::filesystem::path& file) {
    return label_stack(spec, dimension, read_stack_info(file),
                       [&](int first, int last, const auto& visit) { read_stack(file, first, last, visit); });
}

} // namespace abut
