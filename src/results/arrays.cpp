#include "results/arrays.h"

#include <array>

namespace abut {

namespace {

constexpr std::array<ArrayInfo, 14> of_particles{{
    {"velocity", 3, "m/s", "Velocity."},
    {"displacement", 3, "m", "Present position less that at time 0."},
    {"stress", 6, "Pa", "Cauchy stress; xx yy zz xy yz xz."},
    {"pressure", 1, "Pa", "A third of the stress's trace, positive in compression."},
    {"von_mises_stress", 1, "Pa", "Von Mises's equivalent of the stress."},
    {"deformation_gradient", 9, "", "F, row by row: xx xy xz yx yy yz zx zy zz."},
    {"mass", 1, "kg", "Mass; 0 in rigid bodies."},
    {"volume", 1, "m^3", "Present volume."},
    {"strain_energy_density", 1, "J/m^3", "Strain energy in the present volume."},
    {"body", 1, "", "Number of the body, from 0; its name is in the field data `body_names`."},
    {"id", 1, "", "Number of the particle, the same in all frames."},
    {"half_size", 3, "m", "Half of the undeformed particle's edges; F times these are the deformed domain's."},
    {"temperature", 1, "K", "Temperature.", "a body has one"},
    {"orientation", 1, "rad", "Direction of the material's x axis.", "a body has one"},
}};

constexpr std::array<ArrayInfo, 5> of_nodes{{
    {"mass", 1, "kg", "Mass of all deformable bodies at the node."},
    {"velocity", 3, "m/s", "Velocity of their common centre of mass."},
    {"body_count", 1, "", "Number of deformable bodies that the node sees."},
    {"contact_normal", 3, "", "Normal of the first pair of bodies at the node, unit; zero at other nodes.",
     "the scene has contact"},
    {"contact_separation", 1, "m", "Their separation, negative in overlap; 0 at other nodes.", "the scene has contact"},
}};

constexpr std::array<ArrayInfo, 9> of_contacts{{
    {"normal", 3, "", "Unit normal from `body_a` to `body_b`."},
    {"separation", 1, "m", "Distance of the bodies along the normal, negative in overlap."},
    {"in_contact", 1, "", "1 if a force acted in the last step, else 0."},
    {"body_a", 1, "", "Number of the first body."},
    {"body_b", 1, "", "Number of the second; of several lumped together the one with the most mass."},
    {"area", 1, "m^2", "The node's share of the interface."},
    {"force", 3, "N", "Contact force on `body_a` in the last step."},
    {"cloud_size", 1, "", "Number of particles that the search saw; 0 if it looked at none."},
    {"iterations", 1, "", "Iterations of the regression; 0 without one."},
}};

} // namespace

std::span<const ArrayInfo> particle_arrays() {
    return of_particles;
}

std::span<const ArrayInfo> grid_arrays() {
    return of_nodes;
}

std::span<const ArrayInfo> contact_arrays() {
    return of_contacts;
}

std::string_view unit_of_array(std::string_view name) {
    for (const auto& arrays : {particle_arrays(), grid_arrays(), contact_arrays()})
        for (const ArrayInfo& array : arrays)
            if (array.name == name) return array.unit;
    return "";
}

} // namespace abut
