#include "scene/suggest.h"
#include "scene/validate.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

namespace abut {

namespace {

using Problems = std::vector<Problem>;

constexpr std::array axis_names{"x", "y", "z"};
/// Part of a length by which rounding may put something over an edge it lies on.
constexpr double rounding = 1e-9;

std::string text(double value, const char* unit) {
    std::array<char, 64> buffer{};
    std::snprintf(buffer.data(), buffer.size(), "%.6g %s", value, unit);
    return buffer.data();
}

std::string metres(double value) {
    return text(value, "m");
}

/// Adds a problem unless `good`; comparisons with NaN are false and so never good.
void demand(bool good, const std::string& pointer, const std::string& message, Problems& problems) {
    if (!good) problems.push_back({pointer, message});
}

std::size_t axes(const Scene& scene) {
    return std::size_t(dimension(scene.analysis));
}

/// Adds one problem for each side of the grid's box over which [lower, upper] reaches.
void check_inside(const Vector& lower, const Vector& upper, const Scene& scene, const std::string& pointer,
                  Problems& problems) {
    const GridSpec& grid = scene.grid;
    for (std::size_t axis = 0; axis < axes(scene); ++axis) {
        const double tolerance = rounding * (grid.upper[axis] - grid.lower[axis]);
        const std::string name = axis_names[axis];
        demand(lower[axis] >= grid.lower[axis] - tolerance, pointer,
               "reaches out of the grid: down to " + name + " = " + metres(lower[axis]) + ", the grid begins at " +
                   metres(grid.lower[axis]),
               problems);
        demand(upper[axis] <= grid.upper[axis] + tolerance, pointer,
               "reaches out of the grid: up to " + name + " = " + metres(upper[axis]) + ", the grid ends at " +
                   metres(grid.upper[axis]),
               problems);
    }
}

void check_larger_than_cell(double extent, double cell, const std::string& what, const std::string& pointer,
                            Problems& problems) {
    demand(extent >= cell * (1 - rounding), pointer,
           "cell larger than the body: " + what + " is " + metres(extent) + ", a cell " + metres(cell), problems);
}

void check_grid(const Scene& scene, Problems& problems) {
    const GridSpec& grid = scene.grid;
    for (std::size_t axis = 0; axis < axes(scene); ++axis) {
        const double extent = grid.upper[axis] - grid.lower[axis];
        const std::string along = std::string(" along ") + axis_names[axis];
        demand(extent > 0, "/grid/upper",
               "must lie above \"lower\"" + along + ": it is at " + metres(grid.upper[axis]) + ", lower at " +
                   metres(grid.lower[axis]),
               problems);
        demand(grid.cell[axis] > 0, "/grid/cell", "must be greater than 0" + along, problems);
        if (extent > 0) {
            demand(!(grid.cell[axis] > extent * (1 + rounding)), "/grid/cell",
                   "larger than the grid" + along + ": a cell is " + metres(grid.cell[axis]) + ", the grid " +
                       metres(extent),
                   problems);
        }
    }
}

void check_time(const TimeSpec& time, Problems& problems) {
    demand(time.end > 0, "/time/end", "must be greater than 0 s", problems);
    if (time.step) {
        demand(*time.step > 0, "/time/step", "must be greater than 0 s", problems);
    } else {
        demand(time.cfl > 0 && time.cfl <= 1, "/time/cfl", "must be greater than 0 and at most 1", problems);
    }
}

void check_materials(const Scene& scene, Problems& problems) {
    for (const MaterialSpec& material : scene.materials) {
        const std::string pointer = "/materials/" + pointer_token(material.name);
        demand(material.density > 0, pointer + "/density", "must be greater than 0 kg/m^3", problems);
        demand(material.bulk_modulus > 0, pointer, "the bulk modulus must be greater than 0 Pa", problems);
        demand(material.shear_modulus >= 0, pointer, "the shear modulus must not be negative", problems);
    }
}

/// The checks of one body; one overload for each shape.
struct BodyCheck {
    const Scene& scene;
    const std::string pointer;
    Problems& problems;

    void operator()(const Box& box) const {
        for (std::size_t axis = 0; axis < axes(scene); ++axis) {
            const double edge = box.upper[axis] - box.lower[axis];
            const std::string name = axis_names[axis];
            demand(edge > 0, pointer + "/box/upper", "must lie above \"lower\" along " + name, problems);
            if (edge > 0)
                check_larger_than_cell(edge, scene.grid.cell[axis], "its edge along " + name, pointer + "/box",
                                       problems);
        }
        check_inside(box.lower, box.upper, scene, pointer + "/box", problems);
    }

    void operator()(const Disk& disk) const {
        check_round(disk.center, {disk.radius, disk.radius}, 0, "/disk", "radius", "its diameter");
    }

    void operator()(const Ellipse& ellipse) const {
        check_round(ellipse.center, ellipse.semi_axes, ellipse.angle, "/ellipse", "semi_axes", "its smaller diameter");
    }

    void check_round(const Vector& center, const std::array<double, 2>& semi_axes, double angle,
                     const std::string& shape, const std::string& size_key, const std::string& diameter) const {
        const auto [a, b] = semi_axes;
        if (!(a > 0 && b > 0)) {
            problems.push_back({pointer + shape + "/" + size_key, "must be greater than 0 m"});
            return;
        }
        const double cell = std::max(scene.grid.cell[0], scene.grid.cell[1]);
        check_larger_than_cell(2 * std::min(a, b), cell, diameter, pointer + shape, problems);
        // Extents of x = c + a cosφ e₁ + b sinφ e₂: the largest x is √((a e₁x)² + (b e₂x)²) from the centre.
        const double c = std::cos(angle);
        const double s = std::sin(angle);
        const Vector half{std::hypot(a * c, b * s), std::hypot(a * s, b * c), 0};
        Vector lower = center;
        Vector upper = center;
        for (std::size_t axis = 0; axis < 2; ++axis) {
            lower[axis] -= half[axis];
            upper[axis] += half[axis];
        }
        check_inside(lower, upper, scene, pointer + shape, problems);
    }
};

void check_images(const Scene& scene, Problems& problems) {
    for (std::size_t i = 0; i < scene.images.size(); ++i) {
        const ImageSpec& image = scene.images[i];
        const std::string pointer = "/images/" + std::to_string(i);
        demand(image.particles_per_cell >= 1, pointer + "/particles_per_cell", "must be at least 1", problems);
        if (image.size[0] > 0 && image.size[1] > 0) {
            const Vector upper{image.lower[0] + image.size[0], image.lower[1] + image.size[1], image.lower[2]};
            check_inside(image.lower, upper, scene, pointer, problems);
        } else {
            demand(image.pixel[0] > 0 && image.pixel[1] > 0, pointer, "needs \"pixel\" or \"size\", greater than 0 m",
                   problems);
        }
    }
}

void check_walls(const Scene& scene, Problems& problems) {
    for (std::size_t i = 0; i < scene.boundaries.size(); ++i) {
        const WallSpec& wall = scene.boundaries[i].wall;
        const std::string pointer = "/boundaries/" + std::to_string(i) + "/wall";
        if (wall.axis < 0 || std::size_t(wall.axis) >= axes(scene)) {
            problems.push_back({pointer + "/axis", "plane scenes have the axes x and y"});
            continue;
        }
        const double lower = scene.grid.lower[std::size_t(wall.axis)];
        const double upper = scene.grid.upper[std::size_t(wall.axis)];
        const double tolerance = rounding * (upper - lower);
        const auto inside = [&](double position) {
            return position >= lower - tolerance && position <= upper + tolerance;
        };
        const std::string box = "the grid reaches from " + metres(lower) + " to " + metres(upper);
        const double end = wall.position + wall.velocity * scene.time.end;
        if (!inside(wall.position)) {
            problems.push_back({pointer + "/position", "outside the grid at " + metres(wall.position) + "; " + box});
        } else if (!inside(end)) {
            const double leaves = ((wall.velocity < 0 ? lower : upper) - wall.position) / wall.velocity;
            problems.push_back({pointer + "/velocity", "the wall moves out of the grid at t = " + text(leaves, "s") +
                                                           ", before the end; " + box});
        }
        demand(wall.depth >= 0, pointer + "/depth", "must not be negative", problems);
    }
}

void check_contact(const ContactSpec& contact, Problems& problems) {
    demand(contact.corrections == 1 || contact.corrections == 2, "/contact/corrections", "must be 1 or 2", problems);
    demand(contact.law.coefficient >= 0, "/contact/law/coefficient", "must not be negative", problems);
    for (std::size_t i = 0; i < contact.laws.size(); ++i) {
        demand(contact.laws[i].law.coefficient >= 0, "/contact/laws/" + std::to_string(i) + "/law/coefficient",
               "must not be negative", problems);
    }
}

} // namespace

std::vector<Problem> validate_numbers(const Scene& scene) {
    Problems problems;
    demand(scene.thickness > 0, "/thickness", "must be greater than 0 m", problems);
    check_grid(scene, problems);
    check_time(scene.time, problems);
    demand(scene.method.transfer.order >= 1, "/method/transfer/order", "must be at least 1", problems);
    check_materials(scene, problems);
    if (scene.bodies.empty() && scene.images.empty())
        problems.push_back({"/bodies", "the scene is empty; it needs an entry in \"bodies\" or \"images\""});
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
        const std::string pointer = "/bodies/" + std::to_string(i);
        std::visit(BodyCheck{scene, pointer, problems}, scene.bodies[i].shape);
        demand(scene.bodies[i].particles_per_cell >= 1, pointer + "/particles_per_cell", "must be at least 1",
               problems);
    }
    check_images(scene, problems);
    if (scene.contact) check_contact(*scene.contact, problems);
    check_walls(scene, problems);
    demand(scene.output.every >= 0, "/output/every", "must not be negative", problems);
    if (scene.output.history_every)
        demand(*scene.output.history_every > 0, "/output/history_every", "must be greater than 0 s", problems);
    return problems;
}

} // namespace abut
