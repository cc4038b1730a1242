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

constexpr ArrayInfo node_of_cell{"node", 3, "", "Numbers of the node along the axes, from `grid/lower`."};
constexpr ArrayInfo pair_of_cell{"pair", 1, "", "Number of the pair of bodies at its node, from 0."};
constexpr ArrayInfo body_a_of_cell{"body_a", 1, "", "Number of the pair's first body."};
constexpr ArrayInfo body_b_of_cell{"body_b", 1, "",
                                   "Number of the second; of several lumped the one with the most mass."};

constexpr std::array<ArrayInfo, 12> of_clouds{{
    node_of_cell,
    pair_of_cell,
    body_a_of_cell,
    body_b_of_cell,
    {"body", 1, "", "Number of the particle's body."},
    {"id", 1, "", "Number of the particle."},
    {"distance", 1, "m",
     "Of its centre to the plane of the scene's own method, positive on the side of `body_b`; NaN without a plane."},
    {"edge_distance", 1, "m", "From its centre to its edge along the normal; NaN without a plane."},
    {"support", 1, "", "1 if its side ends with it, else 0."},
    {"deformation_gradient", 9, "", "F, row by row: xx xy xz yx yy yz zx zy zz."},
    {"half_size", 3, "m", "Half of the undeformed particle's edges."},
    {"centre", 3, "m", "Place of the particle."},
}};

constexpr std::array<ArrayInfo, 17> of_planes{{
    node_of_cell,
    pair_of_cell,
    body_a_of_cell,
    body_b_of_cell,
    {"normal", 3, "", "Unit normal from `body_a` to `body_b`, as a step would use it."},
    {"fitted_normal", 3, "", "The normal as the method found it, before `particle-edges` turned it."},
    {"separation_particle_edges", 1, "m", "Separation along the normal by `particle-edges`, negative in overlap."},
    {"separation_critical_position", 1, "m", "By `critical-position`."},
    {"separation_fitted_position", 1, "m", "By `fitted-position`."},
    {"separation_displacement", 1, "m", "By `displacement`."},
    {"end_a", 1, "m", "Where the particles of `body_a` end along the normal, from the node."},
    {"end_b", 1, "m", "Where those of `body_b` begin."},
    {"iterations", 1, "", "Iterations of the regression; 0 without one."},
    {"angle", 1, "rad", "To the normal of the scene's own method."},
    {"method", 1, "", "Number of the normal method; its name is in the field data `method_names`."},
    {"chosen", 1, "", "1 for the scene's own method, else 0."},
    {"lumped", 1, "", "1 if `body_a` is against all others, else 0."},
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

std::span<const ArrayInfo> cloud_arrays() {
    return of_clouds;
}

std::span<const ArrayInfo> plane_arrays() {
    return of_planes;
}

std::string_view unit_of_array(std::string_view name) {
    for (const auto& arrays : {particle_arrays(), grid_arrays(), contact_arrays(), cloud_arrays(), plane_arrays()})
        for (const ArrayInfo& array : arrays)
            if (array.name == name) return array.unit;
    return "";
}

} // namespace abut
