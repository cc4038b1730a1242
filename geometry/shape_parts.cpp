#include "geometry/shape_parts.h"

#include "geometry/shapes/make_solid.h"
#include "scene/turn.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <stdexcept>

namespace abut {

namespace {

constexpr std::array<char, 3> axis_name{'x', 'y', 'z'};

Arrangement arrangement_of(const BodySpec& body, std::size_t dimension) {
    const auto* box = std::get_if<Box>(&body.shape);
    return body.arrangement.value_or(box && (box->angle == 0 || dimension == 2) ? Arrangement::fitted
                                                                                : Arrangement::grid);
}

/// Every place of the lattice that fits a box, in the frame of its own edges.
void fill_box(Part& part, const Box& box, const Lattice& wanted, const Vector& cell) {
    part.turn = box.angle;
    part.pivot = center(box);
    Lattice in_frame = wanted;
    in_frame.edge = turned_cell(wanted.edge, box.angle);
    part.lattice = fitted_lattice(in_frame, turned_cell(cell, box.angle), box.lower, box.upper);
    Place count{1, 1, 1};
    for (std::size_t a = 0; a < wanted.dimension; ++a)
        count[a] = static_cast<std::int32_t>(std::lround((box.upper[a] - box.lower[a]) / part.lattice.edge[a]));
    for (std::int32_t k = 0; k < count[2]; ++k)
        for (std::int32_t j = 0; j < count[1]; ++j)
            for (std::int32_t i = 0; i < count[0]; ++i) {
                const Vector x = part.lattice.centre(Place{i, j, k});
                part.place.push_back({i, j, k});
                part.particle.push_back(
                    {box.angle == 0 ? x : turned_about(part.pivot, x, box.angle), part.lattice.half_size(), box.angle});
            }
}

bool boxes_meet(const Solid& a, const Solid& b, std::size_t dimension) {
    for (std::size_t axis = 0; axis < dimension; ++axis)
        if (!(a.lower[axis] < b.upper[axis] && b.lower[axis] < a.upper[axis])) return false;
    return true;
}

/// What is left of a solid where others come before it.
Solid cut(const Solid& solid, const std::vector<const Solid*>& others) {
    Solid left = solid;
    for (const Solid* other : others)
        for (std::size_t a = 0; a < 2; ++a) {
            left.breaks[a].insert(left.breaks[a].end(), other->breaks[a].begin(), other->breaks[a].end());
            std::sort(left.breaks[a].begin(), left.breaks[a].end());
        }
    left.spans = [solid, others](double x, double y) {
        Spans spans = solid.spans(x, y);
        for (const Solid* other : others)
            if (!spans.empty()) spans = difference(spans, other->spans(x, y));
        return spans;
    };
    return left;
}

/// What two solids both have.
Solid common(const Solid& a, const Solid& b) {
    Solid both = a;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        both.lower[axis] = std::max(a.lower[axis], b.lower[axis]);
        both.upper[axis] = std::min(a.upper[axis], b.upper[axis]);
    }
    for (std::size_t axis = 0; axis < 2; ++axis) {
        both.breaks[axis].insert(both.breaks[axis].end(), b.breaks[axis].begin(), b.breaks[axis].end());
        std::sort(both.breaks[axis].begin(), both.breaks[axis].end());
    }
    both.spans = [&a, &b](double x, double y) { return intersection(a.spans(x, y), b.spans(x, y)); };
    return both;
}

/// Whether only its particles tell where a shape ends: the box of a combination may be larger than what is left.
bool is_combined(const ShapeSpec& shape) {
    return std::holds_alternative<Combination>(shape) || std::holds_alternative<NamedShape>(shape);
}

/// Whether validate() checks the size and place of a shape already: those that it can tell without making it.
bool is_validated(const ShapeSpec& shape, std::size_t dimension) {
    if (const auto* box = std::get_if<Box>(&shape)) return dimension == 2 || box->angle == 0;
    return std::holds_alternative<Disk>(shape) || std::holds_alternative<Ellipse>(shape) ||
           std::holds_alternative<Ball>(shape);
}

/// Adds problems of a shape's size and place. \return whether the shape lies in the grid
bool check_extent(const Solid& solid, const BodySpec& body, const GridSpec& grid, const std::string& pointer,
                  std::size_t dimension, std::vector<Problem>& problems) {
    bool inside = true;
    const Vector cell = effective_cell(grid);
    for (std::size_t a = 0; a < dimension; ++a) {
        const double extent = solid.upper[a] - solid.lower[a];
        const double room = grid.upper[a] - grid.lower[a];
        const double slack = 1e-9 * room;
        // Particles are counted later; but a box many times the grid's would take their number beyond all bounds.
        const double over = is_combined(body.shape) ? room : slack;
        if (solid.lower[a] < grid.lower[a] - over || solid.upper[a] > grid.upper[a] + over) {
            inside = false;
            problems.push_back(
                {pointer,
                 fmt::format("body \"{}\" reaches out of the grid along {}: it goes from {} to {}, the grid from {} "
                             "to {}{}",
                             body.name, axis_name[a], length_text(solid.lower[a]), length_text(solid.upper[a]),
                             length_text(grid.lower[a]), length_text(grid.upper[a]),
                             extent > 100 * room ? fmt::format("; it is {:.0f} times larger than the grid: are its "
                                                               "units right (\"scale\": \"1 mm\")?",
                                                               extent / room)
                                                 : "")});
        } else if (extent < cell[a] * (1 - 1e-9)) {
            problems.push_back({pointer, fmt::format("body \"{}\" is smaller than a cell along {}: {} against {}{}",
                                                     body.name, axis_name[a], length_text(extent), length_text(cell[a]),
                                                     extent < room / 100 ? "; are its units right?" : "")});
        }
    }
    return inside;
}

/// A body's solid with what is known of it before it is filled.
struct Shaped {
    std::optional<Solid> solid;
    bool good = false;
};

Shaped shape_body(const Scene& scene, std::size_t k, const std::filesystem::path& folder,
                  std::vector<std::string>& notes, std::vector<Problem>& problems) {
    const BodySpec& body = scene.bodies[k];
    const std::string pointer = fmt::format("/bodies/{}", k);
    const int axes = dimension(scene.analysis);
    if (body.particles_per_cell < 1) {
        problems.push_back({pointer + "/particles_per_cell", "must be at least 1"});
        return {};
    }
    if (!exists_in(body.shape, axes)) {
        problems.push_back({pointer, fmt::format("body \"{}\" has a {} shape in a {} analysis", body.name,
                                                 axes == 3 ? "plane" : "3d", axes == 3 ? "3d" : "plane")});
        return {};
    }
    const Lattice lattice = grid_lattice(scene.grid, body.particles_per_cell, static_cast<std::size_t>(axes));
    try {
        std::vector<std::string> repairs;
        Shaped shaped{make_solid(body.shape, {scene.shapes, axes, folder, lattice.shortest_edge()}, &repairs), false};
        for (const std::string& repair : repairs) notes.push_back(fmt::format("body \"{}\": {}", body.name, repair));
        shaped.good = is_validated(body.shape, lattice.dimension) ||
                      check_extent(*shaped.solid, body, scene.grid, pointer, lattice.dimension, problems);
        return shaped;
    } catch (const std::runtime_error& error) {
        problems.push_back({pointer, error.what()});
        return {};
    }
}

} // namespace

std::vector<Part> shape_parts(const Scene& scene, const std::string& scene_name, bool wants_exact,
                              std::vector<std::string>& notes, std::vector<Problem>& problems) {
    const auto axes = static_cast<std::size_t>(dimension(scene.analysis));
    const std::filesystem::path folder = std::filesystem::path(scene_name).parent_path();
    std::vector<Shaped> shaped;
    for (std::size_t k = 0; k < scene.bodies.size(); ++k)
        shaped.push_back(shape_body(scene, k, folder, notes, problems));

    std::vector<Part> parts;
    for (std::size_t k = 0; k < scene.bodies.size(); ++k) {
        const BodySpec& body = scene.bodies[k];
        Part part;
        part.pointer = fmt::format("/bodies/{}", k);
        part.body_name = body.name;
        part.lattice = grid_lattice(scene.grid, std::max(1, body.particles_per_cell), axes);
        if (shaped[k].good) {
            const Solid& whole = *shaped[k].solid;
            std::vector<std::size_t> gets;    // who has the choice before this one, where they may meet
            std::vector<const Solid*> before; // their solids
            if (scene.overlap != Overlap::refuse)
                for (std::size_t other = 0; other < shaped.size(); ++other)
                    if (shaped[other].good && (scene.overlap == Overlap::first ? other < k : other > k) &&
                        boxes_meet(whole, *shaped[other].solid, axes)) {
                        gets.push_back(other);
                        before.push_back(&*shaped[other].solid);
                    }
            const Solid solid = before.empty() ? whole : cut(whole, before);
            const auto* box = std::get_if<Box>(&body.shape);
            const Arrangement arrangement = arrangement_of(body, axes);
            if (box && arrangement == Arrangement::fitted && (before.empty() || box->angle != 0)) {
                fill_box(part, *box, part.lattice, effective_cell(scene.grid));
            } else {
                if (arrangement == Arrangement::fitted)
                    part.lattice = fitted_lattice(part.lattice, effective_cell(scene.grid), whole.lower, whole.upper);
                std::vector<Covered> places = body.fill == Fill::covered_fraction
                                                  ? places_by_fraction(solid, part.lattice)
                                                  : places_by_centre(solid, part.lattice);
                // ugimp has room for particles of a cell's width at most.
                if (body.particles_per_cell > 1) join_slivers(places);
                add_particles(part, places, sees_turns(scene.method));
            }
            if (part.size() == 0)
                problems.push_back({part.pointer, fmt::format("body \"{}\" got no particles: {}", body.name,
                                                              before.empty() ? "it is too small for particles of " +
                                                                                   edges_text(part.lattice.half_size())
                                                                             : "others have all of its place")});
            if (wants_exact) {
                const double finest = part.lattice.shortest_edge();
                part.exact = content_of(solid, axes, finest);
                for (const std::size_t other : gets) {
                    const Solid& taken = *shaped[other].solid;
                    const double content = content_of(common(whole, taken), axes, finest);
                    if (content > 0)
                        notes.push_back(fmt::format("body \"{}\" ({}) gave {:.6g} {} to \"{}\" (/bodies/{})", body.name,
                                                    part.pointer, content, axes == 3 ? "m^3" : "m^2",
                                                    scene.bodies[other].name, other));
                }
            }
        }
        parts.push_back(std::move(part));
    }
    return parts;
}

} // namespace abut
