#include "plan/fields.h"

#include "contact/contact.h"
#include "particles/particles.h"

namespace abut {

template <int D>
std::vector<Field> fields_of(const Effects& effects) {
    std::vector<Field> fields;
    const auto add = [&](bool needed, const char* name, const char* place, const char* reason, std::size_t bytes) {
        if (needed) fields.push_back({name, place, reason, bytes});
    };
    add(true, "position, velocity, deformation gradient, stress, mass, volume, half size, body, id", "particle",
        "always", bytes_per_particle<D>());
    add(effects.ring || effects.free_across, "stretch across the plane", "particle",
        effects.ring ? "axisymmetric: stretch around the axis" : "plane stress: solved from the law", sizeof(double));
    add(effects.prestress, "initial stress", "particle", "a body has one", sizeof(Stress<D>));
    add(true, "initial position", "particle", "displacement in the results", sizeof(Vec<D>));
    add(effects.stored_stencils, "node, shape functions, gradient", "stencil entry",
        effects.reextrapolate ? "the last extrapolation needs those of the step's beginning" : "dear to expand",
        sizeof(std::int32_t) + (1 + D + effects.ring) * sizeof(double));
    add(effects.stored_stencils, "nodes seen, first entry", "particle", "where a particle's stencil is stored",
        sizeof(Window<D>) + sizeof(std::size_t));
    add(true, "mass and momentum", "slot", "always", sizeof(Pack));
    add(true, "force", "slot", "always", sizeof(Pack));
    add(true, "velocity at the start of the step", "slot", "always", sizeof(Pack));
    add(true, "velocity at the end of the step", "slot", "always", sizeof(Pack));
    add(effects.extra_orders > 0, "filtered velocity, round trip", "slot", "xpic or fmpm of order 2 or more",
        2 * sizeof(Pack));
    add(effects.delta_velocity, "velocity change of the first contact pass", "slot", "xpic or fmpm with contact",
        sizeof(Pack));
    add(effects.contact_strain, "velocity that deforms", "slot", "fmpm with contact", sizeof(Pack));
    add(effects.tractions, "force of tractions", "slot", "the scene has tractions", sizeof(Pack));
    add(effects.gradients || effects.volumes, "volume, volume gradient", "slot",
        effects.gradients ? "normals by volume gradients" : "a contact law needs areas", sizeof(Pack));
    add(effects.displacements, "mass times displacement", "slot", "a contact law or separation by displacements",
        sizeof(Pack));
    add(effects.positions, "mass times position", "slot", "separations by extrapolated positions", sizeof(Pack));
    add(effects.contact, "bodies, normal, separation, impulse", "contact node", "the scene has contact",
        sizeof(ContactGroup<D>) + sizeof(ContactPoint<D>));
    add(effects.clouds, "point cloud", "contact node",
        effects.regression ? "normals by regression" : "separations by particle edges", 32 * sizeof(std::int32_t));
    return fields;
}

template std::vector<Field> fields_of<2>(const Effects&);
template std::vector<Field> fields_of<3>(const Effects&);

} // namespace abut
