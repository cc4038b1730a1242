#include "geometry/image_parts.h"

#include "geometry/image_cover.h"
#include "geometry/labels/label_image.h"
#include "geometry/labels/value_image.h"
#include "grid/effective_cell.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <limits>
#include <stdexcept>

namespace abut {

namespace {

constexpr std::array<char, 3> axis_name{'x', 'y', 'z'};

/// What the steps from an image to its parts share.
struct Work {
    const ImageSpec& spec;
    const GridSpec& grid;
    std::size_t dimension;
    std::string pointer; ///< of the image: "/images/0"
    std::filesystem::path folder;
    ImageFrame frame{};
    std::vector<Problem>& problems;

    void report(const std::string& where, const std::string& what) const {
        problems.push_back({pointer + where, what});
    }
};

/// Edges of a pixel: as given, or the given size of the whole image divided by its pixels, or what the file says.
bool find_frame(Work& work, const LabelledImage& image) {
    work.frame.lower = work.spec.lower;
    for (std::size_t a = 0; a < work.dimension; ++a) {
        double& pixel = work.frame.pixel[a];
        pixel = work.spec.pixel[a] > 0  ? work.spec.pixel[a]
                : work.spec.size[a] > 0 ? work.spec.size[a] / image.volume.size[a]
                                        : image.spacing[a];
        if (pixel > 0) continue;
        work.report(
            "", "needs \"pixel\", the size of a pixel, or \"size\", that of the whole image; the file itself has none");
        return false;
    }
    return true;
}

void check_legend_covers(const Work& work, const LabelledImage& image) {
    if (image.unmatched.empty()) return;
    constexpr std::size_t named = 8;
    std::vector<std::string> names;
    for (std::size_t k = 0; k < std::min(named, image.unmatched.size()); ++k)
        names.push_back(fmt::format("{} ({})", colour_name(image.unmatched[k].rgb),
                                    count_text(static_cast<std::size_t>(image.unmatched[k].pixels), "pixel")));
    std::string text = fmt::format("no entry covers {}", fmt::join(names, ", "));
    if (image.unmatched.size() > named) text += " and " + count_text(image.unmatched.size() - named, "more colour");
    work.report("/legend", text + "; add entries, a tolerance to the ones there, or a \"grey_range\"");
}

void check_inside_grid(const Work& work, const LabelledImage& image) {
    for (std::size_t a = 0; a < work.dimension; ++a) {
        const double lower = work.frame.lower[a];
        const double extent = work.frame.pixel[a] * image.volume.size[a];
        const double slack =
            0.5 * work.frame.pixel[a] * (1 + 1e-9); // sizes rounded to a few digits don't add up exactly
        if (lower >= work.grid.lower[a] - slack && lower + extent <= work.grid.upper[a] + slack) continue;
        const double room = work.grid.upper[a] - work.grid.lower[a];
        work.report(
            "", fmt::format("the image reaches beyond the grid along {}: it goes from {} to {}, the grid from {} to "
                            "{}{}",
                            axis_name[a], length_text(lower), length_text(lower + extent),
                            length_text(work.grid.lower[a]), length_text(work.grid.upper[a]),
                            extent > 100 * room ? fmt::format("; it is {:.0f} times larger than the grid: are the "
                                                              "units of \"pixel\" right?",
                                                              extent / room)
                                                : ""));
    }
}

/// Whether the body's colours (those of all the entries that name it) are absent, or cover too little.
std::string why_no_particles(const Work& work, const LabelledImage& image, const LabelledBody& body,
                             const Vector& half_size) {
    if (work.spec.bodies == BodiesBy::legend) {
        std::vector<std::string> colours;
        std::int64_t pixels = 0;
        for (std::size_t k = 0; k < work.spec.legend.size(); ++k) {
            const LegendEntry& entry = work.spec.legend[k];
            if (entry.is_void || entry.body != body.name) continue;
            colours.push_back(entry.grey_range
                                  ? fmt::format("greys {} to {}", (*entry.grey_range)[0], (*entry.grey_range)[1])
                                  : colour_name(entry.rgb));
            pixels += image.pixels_of_entry[k];
        }
        const bool one = colours.size() == 1;
        if (pixels == 0)
            return fmt::format("no pixel of the image has its colour{} {}", one ? "" : "s", fmt::join(colours, ", "));
        if (body.pixels == 0)
            return fmt::format("its {} are speckles", count_text(static_cast<std::size_t>(pixels), "pixel"));
        return fmt::format("its colour{} {} cover{} {}, nowhere the largest part of a particle ({})", one ? "" : "s",
                           fmt::join(colours, ", "), one ? "s" : "",
                           count_text(static_cast<std::size_t>(pixels), "pixel"), edges_text(half_size));
    }
    return fmt::format("it has {}, nowhere the largest part of a particle ({})",
                       count_text(static_cast<std::size_t>(body.pixels), "pixel"), edges_text(half_size));
}

void check_size(const Work& work, const Part& part) {
    const Vector cell = effective_cell(work.grid);
    for (std::size_t a = 0; a < work.dimension; ++a) {
        auto first = std::numeric_limits<std::int32_t>::max();
        auto last = std::numeric_limits<std::int32_t>::min();
        for (const Place& place : part.place) {
            first = std::min(first, place[a]);
            last = std::max(last, place[a]);
        }
        const double extent = (last - first + 1) * part.lattice.edge[a];
        if (extent < cell[a] * (1 - 1e-9))
            work.problems.push_back(
                {part.pointer, fmt::format("body \"{}\" is smaller than a cell along {}: {} against {}", part.body_name,
                                           axis_name[a], length_text(extent), length_text(cell[a]))});
    }
}

/// The greys of a second image in the axes of the scene, and how large they can be.
std::optional<ValueVolume> read_values(const Work& work, const ValueImage& image, const std::string& key,
                                       const std::array<int, 3>& size) {
    try {
        ValueVolume values = value_image(work.spec, static_cast<int>(work.dimension), work.folder / image.file);
        if (values.volume.size == size) return values;
        work.report("/" + key + "/file", fmt::format("has {} pixels where the image of the bodies has {}",
                                                     fmt::join(values.volume.size, " × "), fmt::join(size, " × ")));
    } catch (const std::runtime_error& error) {
        work.report("/" + key + "/file", error.what());
    }
    return {};
}

void add_values(const Work& work, const LabelledImage& image, std::vector<ImagePart>& parts) {
    if (work.spec.temperature)
        if (const auto values = read_values(work, *work.spec.temperature, "temperature", image.volume.size)) {
            const double black = work.spec.temperature->black;
            const double per_grey = (work.spec.temperature->white - black) / values->highest;
            for (std::size_t k = 0; k < parts.size(); ++k) // part k is that of label k + 1
                for (const double grey :
                     mean_over_places(values->volume, image.volume, static_cast<std::int32_t>(k + 1), work.frame,
                                      parts[k].part.lattice, parts[k].part.place))
                    parts[k].part.temperature.push_back(black + per_grey * grey);
        }
    if (work.spec.orientation)
        if (const auto values = read_values(work, *work.spec.orientation, "orientation", image.volume.size)) {
            const double black = work.spec.orientation->black;
            const double per_grey = (work.spec.orientation->white - black) / values->highest;
            // Not a mean: that of 1 and 179 degrees is no direction of either.
            for (ImagePart& each : parts)
                for (const PlacedParticle& particle : each.part.particle)
                    each.part.orientation.push_back(
                        black + per_grey * value_at(values->volume, work.frame, work.dimension, particle.position));
        }
}

} // namespace

std::vector<ImagePart> image_parts(const Scene& scene, std::size_t index, const std::string& scene_name,
                                   std::vector<std::string>& notes, std::vector<Problem>& problems) {
    const ImageSpec& spec = scene.images[index];
    Work work{spec,
              scene.grid,
              static_cast<std::size_t>(dimension(scene.analysis)),
              fmt::format("/images/{}", index),
              std::filesystem::path(scene_name).parent_path(),
              {},
              problems};
    if (spec.particles_per_cell < 1) {
        work.report("/particles_per_cell", "must be at least 1");
        return {};
    }
    LabelledImage image;
    try {
        image = label_image(spec, dimension(scene.analysis), work.folder / spec.file);
    } catch (const std::runtime_error& error) {
        work.report("/file", error.what());
        return {};
    }
    if (!find_frame(work, image)) return {};
    check_inside_grid(work, image);
    check_legend_covers(work, image);
    if (image.speckles > 0)
        notes.push_back(fmt::format("{}: {} of {} became what surrounds {}", work.pointer,
                                    count_text(static_cast<std::size_t>(image.speckles), "speckle"),
                                    count_text(static_cast<std::size_t>(image.speckle_pixels), "pixel"),
                                    image.speckles == 1 ? "it" : "them"));

    const Lattice lattice = grid_lattice(scene.grid, spec.particles_per_cell, work.dimension);
    Place places{1, 1, 1};
    for (std::size_t a = 0; a < work.dimension; ++a) places[a] = cell_counts(scene.grid)[a] * spec.particles_per_cell;
    std::vector<std::vector<Covered>> covered =
        cover_image(image.volume, image.bodies.size(), work.frame, lattice, places, spec.fill);
    double pixel = 1;
    for (std::size_t a = 0; a < work.dimension; ++a) pixel *= work.frame.pixel[a];

    std::vector<ImagePart> parts;
    for (std::size_t k = 0; k < image.bodies.size(); ++k) {
        const LabelledBody& body = image.bodies[k];
        ImagePart each;
        each.entry = static_cast<std::size_t>(body.entry);
        Part& part = each.part;
        part.pointer = fmt::format("{}/legend/{}", work.pointer, body.entry);
        part.body_name = body.name;
        part.lattice = lattice;
        part.exact = pixel * static_cast<double>(body.pixels);
        if (spec.particles_per_cell > 1) join_slivers(covered[k]); // ugimp has room for a cell's width at most
        add_particles(part, covered[k], sees_turns(scene.method));
        if (part.size() == 0)
            problems.push_back({part.pointer, fmt::format("body \"{}\" got no particles: {}", body.name,
                                                          why_no_particles(work, image, body, lattice.half_size()))});
        else
            check_size(work, part);
        parts.push_back(std::move(each));
    }
    add_values(work, image, parts);
    return parts;
}

} // namespace abut
