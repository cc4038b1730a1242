#include "scene/suggest.h"
#include "scene/turn.h"
#include "scene/validate_parts.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <variant>

namespace abut {

namespace {

using Problems = std::vector<Problem>;

/// Adds one problem for each side of the grid's box over which [lower, upper] reaches.
void check_inside(const Vector& lower, const Vector& upper, const Scene& scene, const std::string& pointer,
                  Problems& problems) {
    const GridSpec& grid = scene.grid;
    for (std::size_t axis = 0; axis < axes(scene); ++axis) {
        const double tolerance = place_rounding * (grid.upper[axis] - grid.lower[axis]);
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
    demand(extent >= cell * (1 - place_rounding), pointer,
           "cell larger than the body: " + what + " is " + metres(extent) + ", a cell " + metres(cell), problems);
}

/// The checks of one body; one overload for each shape.
struct BodyCheck {
    const Scene& scene;
    const std::string pointer;
    Problems& problems;

    void operator()(const Box& box) const {
        if (box.angle != 0 && scene.analysis == Analysis::three_d) return; // its model is checked
        const Vector cell = turned_cell(scene.grid.cell, box.angle);
        Vector half{};
        for (std::size_t axis = 0; axis < axes(scene); ++axis) {
            const double edge = box.upper[axis] - box.lower[axis];
            const std::string name = axis_names[axis];
            half[axis] = edge / 2;
            demand(edge > 0, pointer + "/box/upper", "must lie above \"lower\" along " + name, problems);
            if (edge > 0)
                check_larger_than_cell(edge, cell[axis],
                                       "its edge along " + (box.angle == 0 ? name : "its own " + name),
                                       pointer + "/box", problems);
        }
        if (box.angle == 0)
            check_inside(box.lower, box.upper, scene, pointer + "/box", problems);
        else
            check_around(center(box), turned_reach(half, box.angle), "/box");
    }

    /// Shapes whose extents only the model knows.
    template <class Other>
    void operator()(const Other&) const {}

    void operator()(const Ball& ball) const {
        if (scene.analysis != Analysis::three_d) {
            problems.push_back({pointer + "/ball", "only 3d scenes have balls; a disk is the shape for this one"});
            return;
        }
        if (!(ball.radius > 0)) {
            problems.push_back({pointer + "/ball/radius", "must be greater than 0 m"});
            return;
        }
        const double cell = *std::max_element(scene.grid.cell.begin(), scene.grid.cell.end());
        check_larger_than_cell(2 * ball.radius, cell, "its diameter", pointer + "/ball", problems);
        check_around(ball.center, {ball.radius, ball.radius, ball.radius}, "/ball");
    }

    void operator()(const Disk& disk) const {
        check_round(disk.center, {disk.radius, disk.radius}, 0, "/disk", "radius", "its diameter");
    }

    void operator()(const Ellipse& ellipse) const {
        check_round(ellipse.center, ellipse.semi_axes, ellipse.angle, "/ellipse", "semi_axes", "its smaller diameter");
    }

    void check_round(const Vector& center, const std::array<double, 2>& semi_axes, double angle,
                     const std::string& shape, const std::string& size_key, const std::string& diameter) const {
        if (scene.analysis == Analysis::three_d) {
            problems.push_back({pointer + shape, "only plane scenes have this shape"});
            return;
        }
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
        check_around(center, half, shape);
    }

    /// A shape that reaches by `half` to both sides of its centre.
    void check_around(const Vector& center, const Vector& half, const std::string& shape) const {
        Vector lower = center;
        Vector upper = center;
        for (std::size_t axis = 0; axis < axes(scene); ++axis) {
            lower[axis] -= half[axis];
            upper[axis] += half[axis];
        }
        check_inside(lower, upper, scene, pointer + shape, problems);
    }
};

bool is_zero(const Vector& v) {
    return v[0] == 0 && v[1] == 0 && v[2] == 0;
}

/// What is wrong with a shape wherever it is used; one overload for each that can be wrong.
struct ShapeCheck {
    const Scene& scene;
    const std::string pointer;
    Problems& problems;

    template <class Other>
    void operator()(const Other&) const {}

    void operator()(const Box& box) const {
        check_axis(box.axis, "/box");
        if (pointer.starts_with("/bodies")) return; // BodyCheck does it
        for (std::size_t axis = 0; axis < axes(scene); ++axis)
            demand(box.lower[axis] < box.upper[axis], pointer + "/box/upper",
                   "must lie above \"lower\" along " + std::string(axis_names[axis]), problems);
    }
    void operator()(const Ellipsoid& ellipsoid) const { check_axis(ellipsoid.axis, "/ellipsoid"); }
    void operator()(const Path& path) const { check_axis(path.placement.axis, "/path"); }
    void operator()(const Surface& surface) const { check_axis(surface.placement.axis, "/surface"); }

    void operator()(const Ring& ring) const {
        demand(ring.inner_radius < ring.outer_radius, pointer + "/ring/inner_radius",
               "must be smaller than the outer radius, " + metres(ring.outer_radius), problems);
    }
    void operator()(const Cylinder& cylinder) const {
        demand(cylinder.from != cylinder.to, pointer + "/cylinder/to", "must not be the same place as \"from\"",
               problems);
    }
    void operator()(const Cone& cone) const {
        demand(cone.from != cone.to, pointer + "/cone/to", "must not be the same place as \"from\"", problems);
    }
    void operator()(const Implicit& implicit) const {
        for (std::size_t axis = 0; axis < 3; ++axis)
            demand(implicit.lower[axis] < implicit.upper[axis], pointer + "/implicit/upper",
                   "must lie above \"lower\" along " + std::string(axis_names[axis]), problems);
    }

    void check_axis(const Vector& axis, const std::string& shape) const {
        demand(!is_zero(axis), pointer + shape + "/axis", "must not have the length 0", problems);
    }
};

bool fits_dimension(int connectivity, Analysis analysis) {
    if (connectivity == 0) return true;
    if (analysis == Analysis::three_d) return connectivity == 6 || connectivity == 18 || connectivity == 26;
    return connectivity == 4 || connectivity == 8;
}

void check_crop(const ImageSpec& image, const std::string& pointer, Problems& problems) {
    if (!image.crop) return;
    const std::array names{"columns", "rows", "slices"};
    for (std::size_t i = 0; i < names.size(); ++i) {
        const auto [first, last] = (*image.crop)[i];
        demand(last == -1 || first <= last, pointer + "/crop/" + names[i], "the last must not come before the first",
               problems);
    }
}

/// In plane stress nothing may press across the plane, and nothing may turn an axisymmetric body over.
void check_initial_state(const InitialState& state, const Scene& scene, const std::string& pointer,
                         Problems& problems) {
    demand(!state.stress || scene.analysis != Analysis::plane_stress || (*state.stress)[2] == 0, pointer + "/stress/zz",
           "must be 0 in plane stress", problems);
    demand(scene.analysis != Analysis::axisymmetric || state.angular_velocity[2] == 0, pointer + "/angular_velocity",
           "must be 0 in an axisymmetric scene: a ring can't rotate in the plane", problems);
}

void check_legend(const ImageSpec& image, const Scene& scene, const std::string& pointer, Problems& problems) {
    for (std::size_t k = 0; k < image.legend.size(); ++k) {
        const LegendEntry& entry = image.legend[k];
        const std::string at = pointer + "/legend/" + std::to_string(k);
        if (entry.grey_range)
            demand((*entry.grey_range)[0] <= (*entry.grey_range)[1], at + "/grey_range",
                   "the highest grey must not be below the lowest", problems);
        check_initial_state(entry.state, scene, at, problems);
        if (entry.rigid && image.bodies != BodiesBy::legend)
            problems.push_back({at + "/rigid", "a rigid body is one body; it needs \"bodies\": \"legend\""});
    }
}

void check_images(const Scene& scene, Problems& problems) {
    for (std::size_t i = 0; i < scene.images.size(); ++i) {
        const ImageSpec& image = scene.images[i];
        const std::string pointer = "/images/" + std::to_string(i);
        demand(image.particles_per_cell >= 1, pointer + "/particles_per_cell", "must be at least 1", problems);
        if (image.size[0] > 0 && image.size[1] > 0) {
            Vector upper = image.lower;
            for (std::size_t axis = 0; axis < axes(scene); ++axis) upper[axis] += image.size[axis];
            check_inside(image.lower, upper, scene, pointer, problems);
        }
        demand(fits_dimension(image.connectivity, scene.analysis), pointer + "/connectivity",
               scene.analysis == Analysis::three_d ? "must be 6, 18 or 26 in a 3d scene"
                                                   : "must be 4 or 8 in a plane scene",
               problems);
        check_crop(image, pointer, problems);
        check_legend(image, scene, pointer, problems);
    }
}

} // namespace

void validate_matter(const Scene& scene, Problems& problems) {
    if (scene.bodies.empty() && scene.images.empty())
        problems.push_back({"/bodies", "the scene is empty; it needs an entry in \"bodies\" or \"images\""});
    for (const NamedShapeSpec& named : scene.shapes)
        std::visit(ShapeCheck{scene, "/shapes/" + pointer_token(named.name), problems}, named.shape);
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
        const std::string pointer = "/bodies/" + std::to_string(i);
        std::visit(ShapeCheck{scene, pointer, problems}, scene.bodies[i].shape);
        const BodySpec& body = scene.bodies[i];
        check_initial_state(body.state, scene, pointer, problems);
        if (body.arrangement == Arrangement::fitted && scene.analysis == Analysis::three_d)
            if (const auto* box = std::get_if<Box>(&body.shape); box && box->angle != 0)
                problems.push_back({pointer + "/arrangement",
                                    "a box that is turned in 3d can only be filled from the grid's lattice: \"grid\""});
        std::visit(BodyCheck{scene, pointer, problems}, scene.bodies[i].shape);
        demand(scene.bodies[i].particles_per_cell >= 1, pointer + "/particles_per_cell", "must be at least 1",
               problems);
    }
    check_images(scene, problems);
}

} // namespace abut
