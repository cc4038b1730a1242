#include "geometry/image_parts.h"

#include "geometry/images/image.h"
#include "geometry/image_particles.h"
#include "geometry/labels/legend.h"
#include "grid/effective_cell.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <limits>
#include <stdexcept>

namespace abut {

namespace {

constexpr std::array<char, 2> axis_name{'x', 'y'};

void check_legend_covers(const LabelledPicture& image, const std::string& pointer, std::vector<Problem>& problems) {
    if (image.unmatched.empty()) return;
    constexpr std::size_t named = 8;
    std::vector<std::string> names;
    for (std::size_t k = 0; k < std::min(named, image.unmatched.size()); ++k)
        names.push_back(fmt::format("{} ({})", colour_name(image.unmatched[k].rgb),
                                    count_text(image.unmatched[k].pixels, "pixel")));
    std::string text = fmt::format("no entry covers {}", fmt::join(names, ", "));
    if (image.unmatched.size() > named) text += " and " + count_text(image.unmatched.size() - named, "more colour");
    problems.push_back({pointer + "/legend", text + "; add entries, or a tolerance to the ones there"});
}

void check_inside_grid(const ImageSpec& spec, const Image& image, const GridSpec& grid, const std::string& pointer,
                       std::vector<Problem>& problems) {
    const std::array<double, 2> pixel = pixel_size(spec, image.width, image.height);
    for (std::size_t axis = 0; axis < 2; ++axis) {
        const double upper = spec.lower[axis] + pixel[axis] * (axis == 0 ? image.width : image.height);
        const double slack = 0.5 * pixel[axis] * (1 + 1e-9); // sizes rounded to a few digits don't add up exactly
        if (spec.lower[axis] >= grid.lower[axis] - slack && upper <= grid.upper[axis] + slack) continue;
        problems.push_back(
            {pointer,
             fmt::format("the image reaches beyond the grid along {}: it goes from {} to {}, the grid from {} to {}",
                         axis_name[axis], length_text(spec.lower[axis]), length_text(upper),
                         length_text(grid.lower[axis]), length_text(grid.upper[axis]))});
    }
}

/// Whether the body's colours (those of all the entries that name it) are absent, or cover too little.
std::string why_no_particles(const std::string& body, const ImageSpec& spec, const LabelledPicture& image,
                             const Vector& half_size) {
    std::vector<std::string> colours;
    std::int64_t pixels = 0;
    for (std::size_t k = 0; k < spec.legend.size(); ++k) {
        if (spec.legend[k].is_void || spec.legend[k].body != body) continue;
        colours.push_back(colour_name(spec.legend[k].rgb));
        pixels += image.pixels_of_entry[k];
    }
    const bool one = colours.size() == 1;
    if (pixels == 0)
        return fmt::format("no pixel of the image has its colour{} {}", one ? "" : "s", fmt::join(colours, ", "));
    return fmt::format("its colour{} {} cover{} {}, nowhere the largest part of a particle ({})", one ? "" : "s",
                       fmt::join(colours, ", "), one ? "s" : "", count_text(static_cast<std::size_t>(pixels), "pixel"),
                       edges_text(half_size));
}

void check_size(const Part& part, const GridSpec& grid, std::vector<Problem>& problems) {
    const Vector cell = effective_cell(grid);
    for (std::size_t axis = 0; axis < 2; ++axis) {
        double lower = std::numeric_limits<double>::max(), upper = std::numeric_limits<double>::lowest();
        for (const Vector& centre : part.position) {
            lower = std::min(lower, centre[axis]);
            upper = std::max(upper, centre[axis]);
        }
        const double extent = upper - lower + 2 * part.half_size[axis];
        if (extent < cell[axis] * (1 - 1e-9))
            problems.push_back(
                {part.pointer, fmt::format("body \"{}\" is smaller than a cell along {}: {} against {}", part.body_name,
                                           axis_name[axis], length_text(extent), length_text(cell[axis]))});
    }
}

} // namespace

std::vector<Part> image_parts(const ImageSpec& spec, const GridSpec& grid, const std::string& pointer,
                              const std::string& scene_name, std::vector<Problem>& problems) {
    Image image;
    try {
        image = read_image(std::filesystem::path(scene_name).parent_path() / spec.file);
    } catch (const std::runtime_error& error) {
        problems.push_back({pointer + "/file", error.what()});
        return {};
    }
    if (spec.particles_per_cell < 1) {
        problems.push_back({pointer + "/particles_per_cell", "must be at least 1"});
        return {};
    }
    const std::array<double, 2> pixel = pixel_size(spec, image.width, image.height);
    if (!(pixel[0] > 0) || !(pixel[1] > 0)) {
        problems.push_back({pointer, "needs the size of a pixel, or of the whole image, larger than 0"});
        return {};
    }
    check_inside_grid(spec, image, grid, pointer, problems);
    const LabelledPicture labelled = label_pixels(image, spec.legend);
    check_legend_covers(labelled, pointer, problems);

    ImageParticles particles = image_particles(spec, labelled, grid);
    std::vector<Part> parts;
    for (std::size_t k = 0; k < labelled.bodies.size(); ++k) {
        const std::string& body = labelled.bodies[k];
        const auto entry = std::find_if(spec.legend.begin(), spec.legend.end(),
                                        [&](const LegendEntry& each) { return !each.is_void && each.body == body; });
        const std::string entry_pointer = fmt::format("{}/legend/{}", pointer, entry - spec.legend.begin());
        Part part{entry_pointer, body, 0, particles.half_size, std::move(particles.position[k]), 0};
        if (part.position.empty())
            problems.push_back({entry_pointer, fmt::format("body \"{}\" got no particles: {}", body,
                                                           why_no_particles(body, spec, labelled, part.half_size))});
        else
            check_size(part, grid, problems);
        parts.push_back(std::move(part));
    }
    return parts;
}

} // namespace abut
