#include "io/scene/specification_sections.h"

#include "io/scene/words.h"

#include <iterator>

namespace abut {

namespace {

std::vector<Key> material_keys() {
    return {
        {.path = "/materials", .kind = Kind::map, .required = true, .meaning = "The materials, by name."},
        {.path = "/materials/*", .kind = Kind::object, .meaning = "A constitutive law with its constants."},
        {.path = "/materials/*/model",
         .kind = Kind::word,
         .words = texts(model_words),
         .required = true,
         .meaning = "Constitutive law: `neo-hookean` is W = λ/2((J²−1)/2 − ln J) + G/2(I₁ − 3 − 2 ln J), "
                    "`neo-hookean-isochoric` is W = G/2(I₁/J^⅔ − 3) + K/2((J²−1)/2 − ln J), `linear-elastic` is "
                    "W = G‖V−I‖² + λ/2 tr(V−I)² (V: left stretch), Hooke's law that follows rotations, for small "
                    "strains."},
        {.path = "/materials/*/density",
         .kind = Kind::quantity,
         .dimension = dimensions::density,
         .required = true,
         .range = above(0),
         .meaning = "Density of the undeformed material."},
        {.path = "/materials/*/bulk_modulus",
         .kind = Kind::quantity,
         .dimension = dimensions::pressure,
         .range = above(0),
         .meaning = "Bulk modulus K."},
        {.path = "/materials/*/shear_modulus",
         .kind = Kind::quantity,
         .dimension = dimensions::pressure,
         .range = at_least(0),
         .meaning = "Shear modulus G."},
        {.path = "/materials/*/youngs_modulus",
         .kind = Kind::quantity,
         .dimension = dimensions::pressure,
         .range = above(0),
         .meaning = "Young's modulus E."},
        {.path = "/materials/*/poissons_ratio",
         .kind = Kind::number,
         .range = {-1, 0.5, true, true},
         .hint = "at 0.5 a solid is incompressible and has an infinite bulk modulus; use e.g. 0.49",
         .meaning = "Poisson's ratio ν."},
        {.path = "/materials/*/lame_lambda",
         .kind = Kind::quantity,
         .dimension = dimensions::pressure,
         .meaning = "Lamé's first constant λ."},
    };
}

/// The keys of a rigid body's motion that stands at `path`.
std::vector<Key> rigid_keys(const std::string& path, const std::optional<OnlyWith>& only_with = {}) {
    return {
        {.path = path,
         .kind = Kind::object,
         .only_with = only_with,
         .meaning = "Makes the body rigid: it moves as prescribed, whatever pushes it, has no material, and acts on "
                    "others by contact. history.csv gives the force and the torque on it as `force_NAME_x` and "
                    "`torque_NAME_x` and so on."},
        {.path = path + "/velocity",
         .kind = Kind::functions,
         .dimension = dimensions::velocity,
         .meaning = "Velocity of its centre; not given: 0."},
        {.path = path + "/angular_velocity",
         .kind = Kind::function,
         .dimension = dimensions::angular_velocity,
         .otherwise = "0",
         .meaning = "Angular velocity about its centre, counter-clockwise."},
        {.path = path + "/axis",
         .kind = Kind::vector,
         .only_with = only_in_3d,
         .meaning = "Direction of the axis of rotation, of any length but 0; not given: z."},
        {.path = path + "/center",
         .kind = Kind::vector,
         .dimension = dimensions::length,
         .meaning = "Centre of rotation at time 0, about which torques are given; not given: the body's own centre."},
    };
}

/// What a body at `path` may have at time 0 besides its velocity.
std::vector<Key> initial_state_keys(const std::string& path, const std::optional<OnlyWith>& only_with = {}) {
    std::vector<Key> keys{
        {.path = path + "/angular_velocity",
         .kind = Kind::spin,
         .dimension = dimensions::angular_velocity,
         .only_with = only_with,
         .unless = "rigid",
         .meaning = "Adds a rotation about its centre of mass to its initial velocity, counter-clockwise."},
        {.path = path + "/temperature",
         .kind = Kind::quantity,
         .dimension = dimensions::temperature,
         .range = above(0),
         .only_with = only_with,
         .unless = "rigid",
         .meaning = "Initial temperature; particle files then have it. No law of this version depends on it."},
        {.path = path + "/orientation",
         .kind = Kind::quantity,
         .dimension = dimensions::angle,
         .only_with = only_with,
         .unless = "rigid",
         .meaning =
             "Direction of the material's own x axis, counter-clockwise from x; particle files then have it. All "
             "materials of this version are isotropic, so that it changes nothing else."},
        {.path = path + "/stress",
         .kind = Kind::object,
         .only_with = only_with,
         .unless = "rigid",
         .meaning = "Stress at time 0 (Cauchy, positive in tension), added to what the law gives as F S Fᵀ/J: it "
                    "turns and stretches with the material, and its work is part of the strain energy, which is 0 at "
                    "time 0."},
    };
    for (const char* component : {"xx", "yy", "zz", "xy", "yz", "xz"})
        keys.push_back(
            {.path = path + "/stress/" + component,
             .kind = Kind::quantity,
             .dimension = dimensions::pressure,
             .otherwise = "0",
             .only_with = component[1] == 'z' && component[0] != 'z' ? std::optional(only_in_3d) : std::nullopt,
             .meaning = std::string("Component ") + component + "."});
    return keys;
}

std::vector<Key> body_name_keys() {
    return {
        {.path = "/bodies",
         .kind = Kind::list,
         .otherwise = "[]",
         .meaning = "Bodies of shapes; a body is a set of particles that share one velocity field."},
        {.path = "/bodies/#", .kind = Kind::object, .meaning = "A body."},
        {.path = "/bodies/#/name", .kind = Kind::name, .required = true, .meaning = "Name of the body, unique."},
        {.path = "/bodies/#/material",
         .kind = Kind::name,
         .required = true,
         .unless = "rigid",
         .meaning = "Name of its material; rigid bodies have none."},
    };
}

std::vector<Key> body_matter_keys() {
    return {
        {.path = "/bodies/#/velocity",
         .kind = Kind::vector,
         .dimension = dimensions::velocity,
         .otherwise = "[0, 0]",
         .unless = "rigid",
         .meaning = "Initial velocity of all its particles."},
        {.path = "/bodies/#/velocity_gradient",
         .kind = Kind::matrix,
         .dimension = dimensions::rate,
         .unless = "rigid",
         .meaning = "Gradient L of the initial velocity, row by row: a particle at x begins with `velocity` + "
                    "L (x − `velocity_center`)."},
        {.path = "/bodies/#/velocity_center",
         .kind = Kind::vector,
         .dimension = dimensions::length,
         .otherwise = "[0, 0]",
         .only_with = OnlyWith{"velocity_gradient", {}},
         .meaning = "Where the gradient adds nothing to the initial velocity."},
        {.path = "/bodies/#/particles_per_cell",
         .kind = Kind::integer,
         .otherwise = "2",
         .range = from_to(1, 100),
         .meaning = "Particles in a cell along each axis."},
        {.path = "/bodies/#/fill",
         .kind = Kind::word,
         .words = {std::string(text_of(fill_words, Fill::centre)),
                   std::string(text_of(fill_words, Fill::covered_fraction))},
         .otherwise = quoted("centre"),
         .meaning = "Which places of the particle lattice it takes: `centre`: those whose centre lies inside, as whole "
                    "particles; `covered-fraction`: all that it covers in part, by particles with the area (volume), "
                    "centre and proportions of what is covered, so that area and outline are those of the shape."},
        {.path = "/bodies/#/arrangement",
         .kind = Kind::word,
         .words = texts(arrangement_words),
         .meaning =
             "Where its particle lattice begins: `grid`: at the grid's lower corner, one lattice for all bodies; "
             "`fitted`: at the shape's own lower corner, with particles so much larger or smaller that they end "
             "at its upper one. Not given: `fitted` for a box (but one turned in 3D), else `grid`."},
    };
}

} // namespace

std::vector<Key> matter_keys() {
    const OnlyWith not_void{"void", {"false"}};
    std::vector<Key> keys = material_keys();
    for (std::vector<Key>& more : std::vector{
             shapes_keys(), body_name_keys(), shape_keys("/bodies/#"), body_matter_keys(),
             initial_state_keys("/bodies/#"), rigid_keys("/bodies/#/rigid"), image_keys(),
             initial_state_keys("/images/#/legend/#", not_void), rigid_keys("/images/#/legend/#/rigid", not_void)})
        keys.insert(keys.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
    return keys;
}

} // namespace abut
