#include "io/scene/bind_parts.h"

namespace abut {

namespace {

/// A checked function of time that is no word.
TimeFunction bind_function(const Json& json) {
    if (json.is_number()) return {json.get<double>()};
    if (const Json* pulse = find(json, "pulse"))
        return TimeFunction::pulse((*pulse)["start"].get<double>(), (*pulse)["width"].get<double>(),
                                   (*pulse)["peak"].get<double>());
    return {json["times"].get<std::vector<double>>(), json["values"].get<std::vector<double>>()};
}

void copy_function(const Json& object, const char* key, TimeFunction& member) {
    if (const Json* value = find(object, key)) member = bind_function(*value);
}

void copy_functions(const Json& object, const char* key, std::array<TimeFunction, 3>& member) {
    const Json& functions = part(object, key);
    for (std::size_t i = 0; i < std::min(functions.size(), member.size()); ++i) member[i] = bind_function(functions[i]);
}

Box bind_box(const Json& json) {
    Box box;
    copy_components(json, "lower", box.lower);
    copy_components(json, "upper", box.upper);
    return box;
}

WallSpec bind_wall(const Json& json) {
    WallSpec wall;
    copy_word(json, "axis", axis_words, wall.axis);
    copy_word(json, "side", side_words, wall.side);
    copy(json, "position", wall.position);
    copy_function(json, "velocity", wall.velocity);
    copy(json, "depth", wall.depth);
    const Json* gradient = find(json, "gradient");
    wall.estimated_gradient = gradient && *gradient == estimated_word;
    if (!wall.estimated_gradient) copy_function(json, "gradient", wall.gradient);
    copy(json, "grip", wall.grip);
    return wall;
}

VelocitySpec bind_velocity(const Json& json) {
    VelocitySpec velocity;
    copy_components(json, "lower", velocity.lower);
    copy_components(json, "upper", velocity.upper);
    copy_components(json, "direction", velocity.direction);
    copy_function(json, "value", velocity.velocity);
    return velocity;
}

TractionSpec bind_traction(const Json& json) {
    TractionSpec traction;
    copy(json, "body", traction.body);
    copy_word(json, "axis", axis_words, traction.axis);
    copy_word(json, "side", side_words, traction.side);
    if (const Json* within = find(json, "within")) traction.within = bind_box(*within);
    copy_functions(json, "stress", traction.traction);
    copy_function(json, "pressure", traction.pressure);
    return traction;
}

} // namespace

RigidSpec bind_rigid(const Json& json) {
    RigidSpec rigid;
    copy_functions(json, "velocity", rigid.velocity);
    copy_function(json, "angular_velocity", rigid.angular_velocity);
    copy_components(json, "axis", rigid.axis);
    if (find(json, "center")) copy_components(json, "center", rigid.center.emplace());
    return rigid;
}

BoundarySpec bind_boundary(const Json& json) {
    BoundarySpec boundary;
    copy(json, "name", boundary.name);
    if (const Json* velocity = find(json, "velocity")) {
        boundary.condition = bind_velocity(*velocity);
    } else if (const Json* traction = find(json, "traction")) {
        boundary.condition = bind_traction(*traction);
    } else {
        boundary.condition = bind_wall(part(json, "wall"));
    }
    return boundary;
}

} // namespace abut
