#include "io/scene/specification_sections.h"

#include "io/scene/words.h"

#include <iterator>

namespace abut {

namespace {

constexpr const char* axis_hint = "plane scenes have the axes x and y";

std::vector<Key> wall_keys() {
    return {
        {.path = "/boundaries/#/wall",
         .kind = Kind::object,
         .meaning = "A wall across one axis that sets the normal velocity and slips along itself."},
        {.path = "/boundaries/#/wall/axis",
         .kind = Kind::word,
         .words = texts(axis_words),
         .required = true,
         .hint = axis_hint,
         .meaning = "Axis the wall is perpendicular to; `z` in `3d` only."},
        {.path = "/boundaries/#/wall/side",
         .kind = Kind::word,
         .words = texts(side_words),
         .required = true,
         .meaning = "Which side of the material the wall is on; `lower`: material lies above the wall."},
        {.path = "/boundaries/#/wall/position",
         .kind = Kind::quantity,
         .dimension = dimensions::length,
         .required = true,
         .meaning = "Position along the axis at time 0."},
        {.path = "/boundaries/#/wall/velocity",
         .kind = Kind::function,
         .dimension = dimensions::velocity,
         .otherwise = "0",
         .meaning = "Velocity of the wall along the axis."},
        {.path = "/boundaries/#/wall/depth",
         .kind = Kind::number,
         .otherwise = "1",
         .range = at_least(0),
         .meaning = "How far inside the wall nodes still move with it, in cells; 0: only nodes on and behind it."},
        {.path = "/boundaries/#/wall/gradient",
         .kind = Kind::function,
         .dimension = dimensions::rate,
         .words = {estimated_word},
         .otherwise = "0",
         .meaning = "Gradient of the normal velocity along the axis at the wall; `estimated` fits it to the velocities "
                    "of the material there in each step."},
        {.path = "/boundaries/#/wall/grip",
         .kind = Kind::boolean,
         .otherwise = "true",
         .meaning = "Whether the wall holds material that would move away from it; `false`: it only pushes."},
    };
}

std::vector<Key> velocity_keys() {
    return {
        {.path = "/boundaries/#/velocity",
         .kind = Kind::object,
         .meaning = "A velocity component that is set at all nodes in a box; the box does not move."},
        {.path = "/boundaries/#/velocity/lower",
         .kind = Kind::vector,
         .dimension = dimensions::length,
         .required = true,
         .meaning = "Lower corner of the box; nodes on its faces belong to it."},
        {.path = "/boundaries/#/velocity/upper",
         .kind = Kind::vector,
         .dimension = dimensions::length,
         .required = true,
         .meaning = "Upper corner of the box."},
        {.path = "/boundaries/#/velocity/direction",
         .kind = Kind::vector,
         .required = true,
         .meaning = "Direction of the component, of any length but 0."},
        {.path = "/boundaries/#/velocity/value",
         .kind = Kind::function,
         .dimension = dimensions::velocity,
         .otherwise = "0",
         .meaning = "Velocity along `direction`; what is perpendicular to it stays free."},
    };
}

std::vector<Key> traction_keys() {
    return {
        {.path = "/boundaries/#/traction",
         .kind = Kind::object,
         .meaning = "A traction on the outer faces of a body; the faces are those of the undeformed body and deform "
                    "with it."},
        {.path = "/boundaries/#/traction/body",
         .kind = Kind::name,
         .required = true,
         .meaning = "Name of the body that is loaded."},
        {.path = "/boundaries/#/traction/axis",
         .kind = Kind::word,
         .words = texts(axis_words),
         .required = true,
         .hint = axis_hint,
         .meaning = "Axis that the faces are perpendicular to before any deformation; `z` in `3d` only."},
        {.path = "/boundaries/#/traction/side",
         .kind = Kind::word,
         .words = texts(side_words),
         .required = true,
         .meaning = "Whether it is the faces at the lower or the upper end of the body along the axis."},
        {.path = "/boundaries/#/traction/within",
         .kind = Kind::object,
         .meaning = "Only the faces of particles whose centres lie in this box at time 0; not given: all of them."},
        {.path = "/boundaries/#/traction/within/lower",
         .kind = Kind::vector,
         .dimension = dimensions::length,
         .required = true,
         .meaning = "Lower corner of the box."},
        {.path = "/boundaries/#/traction/within/upper",
         .kind = Kind::vector,
         .dimension = dimensions::length,
         .required = true,
         .meaning = "Upper corner of the box."},
        {.path = "/boundaries/#/traction/stress",
         .kind = Kind::functions,
         .dimension = dimensions::pressure,
         .meaning = "Force per deformed area, by component; its direction is fixed in space."},
        {.path = "/boundaries/#/traction/pressure",
         .kind = Kind::function,
         .dimension = dimensions::pressure,
         .meaning = "Force per deformed area against the outward normal of the deformed faces: positive pushes."},
    };
}

} // namespace

std::vector<Key> boundary_keys() {
    std::vector<Key> keys{
        {.path = "/boundaries",
         .kind = Kind::list,
         .otherwise = "[]",
         .meaning = "Boundary conditions. The faces of the grid are none: material passes them freely."},
        {.path = "/boundaries/#", .kind = Kind::object, .meaning = "A boundary condition."},
        {.path = "/boundaries/#/name",
         .kind = Kind::name,
         .required = true,
         .meaning = "Name, unique; history.csv gives its force as `force_NAME_x` and so on."},
    };
    for (std::vector<Key>& more : std::vector{wall_keys(), velocity_keys(), traction_keys()})
        keys.insert(keys.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
    return keys;
}

} // namespace abut
