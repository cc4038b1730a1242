#include "io/scene/bind_parts.h"

namespace abut {

namespace {

PlanePoint bind_plane_point(const Json& json) {
    return {json.at(0).get<double>(), json.at(1).get<double>()};
}

std::vector<PlanePoint> bind_points(const Json& json) {
    std::vector<PlanePoint> points;
    for (const Json& point : json) points.push_back(bind_plane_point(point));
    return points;
}

Placement bind_placement(const Json& json) {
    Placement placement;
    copy(json, "scale", placement.scale);
    copy_components(json, "axis", placement.axis);
    copy(json, "angle", placement.angle);
    copy_components(json, "translation", placement.translation);
    return placement;
}

void bind(const Json& json, Box& box) {
    copy_components(json, "lower", box.lower);
    copy_components(json, "upper", box.upper);
    copy(json, "angle", box.angle);
    copy_components(json, "axis", box.axis);
}

void bind(const Json& json, Disk& disk) {
    copy_components(json, "center", disk.center);
    copy(json, "radius", disk.radius);
}

void bind(const Json& json, Ellipse& ellipse) {
    copy_components(json, "center", ellipse.center);
    copy_components(json, "semi_axes", ellipse.semi_axes);
    copy(json, "angle", ellipse.angle);
}

void bind(const Json& json, Ball& ball) {
    copy_components(json, "center", ball.center);
    copy(json, "radius", ball.radius);
}

void bind(const Json& json, Ring& ring) {
    copy_components(json, "center", ring.center);
    copy(json, "inner_radius", ring.inner_radius);
    copy(json, "outer_radius", ring.outer_radius);
}

void bind(const Json& json, Polygon& polygon) {
    polygon.points = bind_points(part(json, "points"));
    copy_list(json, "holes", polygon.holes, bind_points);
}

void bind(const Json& json, Path& path) {
    if (const Json* file = find(json, "file")) path.file = file->get<std::string>();
    path.placement = bind_placement(json);
}

void bind(const Json& json, Ellipsoid& ellipsoid) {
    copy_components(json, "center", ellipsoid.center);
    copy_components(json, "semi_axes", ellipsoid.semi_axes);
    copy_components(json, "axis", ellipsoid.axis);
    copy(json, "angle", ellipsoid.angle);
}

void bind(const Json& json, Cylinder& cylinder) {
    copy_components(json, "from", cylinder.from);
    copy_components(json, "to", cylinder.to);
    copy(json, "radius", cylinder.radius);
}

void bind(const Json& json, Cone& cone) {
    copy_components(json, "from", cone.from);
    copy_components(json, "to", cone.to);
    copy(json, "radius", cone.radius);
    copy(json, "top_radius", cone.top_radius);
}

void bind(const Json& json, Surface& surface) {
    if (const Json* file = find(json, "file")) surface.file = file->get<std::string>();
    surface.placement = bind_placement(json);
    copy(json, "repair", surface.repair);
}

void bind(const Json& json, Implicit& implicit) {
    copy(json, "expression", implicit.expression);
    copy(json, "unit", implicit.unit);
    copy_components(json, "lower", implicit.lower);
    copy_components(json, "upper", implicit.upper);
}

/// Adds the shape if the object has one of this kind.
template <class Shape>
bool takes(const Json& json, const char* kind, ShapeSpec& spec) {
    const Json* object = find(json, kind);
    if (!object) return false;
    Shape shape;
    bind(*object, shape);
    spec = std::move(shape);
    return true;
}

bool takes_names(const Json& json, const char* kind, Operation operation, ShapeSpec& spec) {
    const Json* names = find(json, kind);
    if (names) spec = Combination{operation, names->get<std::vector<std::string>>()};
    return names != nullptr;
}

} // namespace

ShapeSpec bind_shape(const Json& json) {
    ShapeSpec spec = Box{};
    if (const Json* name = find(json, "shape")) return NamedShape{name->get<std::string>()};
    takes<Box>(json, "box", spec) || takes<Disk>(json, "disk", spec) || takes<Ellipse>(json, "ellipse", spec) ||
        takes<Ball>(json, "ball", spec) || takes<Ring>(json, "ring", spec) || takes<Polygon>(json, "polygon", spec) ||
        takes<Path>(json, "path", spec) || takes<Ellipsoid>(json, "ellipsoid", spec) ||
        takes<Cylinder>(json, "cylinder", spec) || takes<Cone>(json, "cone", spec) ||
        takes<Surface>(json, "surface", spec) || takes<Implicit>(json, "implicit", spec) ||
        takes_names(json, "union", Operation::union_, spec) ||
        takes_names(json, "difference", Operation::difference, spec) ||
        takes_names(json, "intersection", Operation::intersection, spec);
    return spec;
}

InitialState bind_initial_state(const Json& json) {
    InitialState state;
    if (const Json* spin = find(json, "angular_velocity"); spin && spin->is_array())
        copy_components(json, "angular_velocity", state.angular_velocity);
    else
        copy(json, "angular_velocity", state.angular_velocity[2]);
    copy(json, "temperature", state.temperature);
    copy(json, "orientation", state.orientation);
    if (const Json* stress = find(json, "stress")) {
        std::array<double, 6> components{};
        const std::array names{"xx", "yy", "zz", "xy", "yz", "xz"};
        for (std::size_t i = 0; i < names.size(); ++i) copy(*stress, names[i], components[i]);
        state.stress = components;
    }
    return state;
}

} // namespace abut
