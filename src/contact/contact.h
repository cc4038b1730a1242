#pragma once
#include "contact/law/contact_law.h"
#include "grid/velocity_fields.h"

#include <vector>

namespace abut {

/// Body a at a contact node against body b, or against all others lumped (contact paper §3.4).
template <int D>
struct ContactPoint {
    std::int32_t slot_a = -1;
    std::int32_t slot_b = -1; ///< -1: all other active bodies of the node, lumped
    std::int32_t body_a = -1;
    std::int32_t body_b = -1;       ///< the one whose law counts: the other with the most mass
    Vec<D> normal = Vec<D>::Zero(); ///< unit, from a to b; zero: none found
    double separation = 0;          ///< [m], < 0 in overlap
    double overlap = 0;             ///< close to the node, beyond what steps in the edges explain [m], >= 0
    std::int32_t cloud_size = 0;
    std::int32_t iterations = 0;
    double parting = 0; ///< normal velocity at which overlapping bodies shall part [m/s]
    /// Normal velocity of b to a that bodies in contact have at the node, which may lie off their interface: 0, but at
    /// rigid bodies (see rigid_edge()) [m/s].
    double at_node = 0;
    bool light = false;              ///< touching, and one body has next to no mass here: see ContactSpec::screening
    Vec<D> sliding = Vec<D>::Zero(); ///< tangential velocity of b to a that a light pair keeps [m/s]
    double carried_separation = 0;   ///< at the time of the pass [m]
    bool touching = false;           ///< overlapping in the second pass
    bool rigid_a = false;            ///< body a moves as prescribed
    bool rigid_b = false;            ///< body b, or one of those lumped, does
    Vec<D> impulse = Vec<D>::Zero(); ///< on a in the second pass [N s]
    /// On a besides, where particles get it too: that of the first pass with PIC, which takes velocities and not
    /// accelerations from the grid, and what FMPM gives behind the full mass matrix [N s].
    Vec<D> extra_impulse = Vec<D>::Zero();

    // === Only for laws that need them
    double area = 0;                       ///< contact area [m^2] (Effects::volumes)
    Vec<D> discontinuity = Vec<D>::Zero(); ///< displacement of b less that of a [m] (Effects::displacements)
    double interface_energy = 0;           ///< stored at the end of the step [J]
};

/// The active bodies of one contact node: those whose share of the node's mass is not negligible (notes 4.1).
template <int D>
struct ContactGroup {
    Index<D> node;
    std::int32_t first = 0, last = 0;             ///< in Contact::active
    std::int32_t first_point = 0, last_point = 0; ///< one for each pair, or for each body if lumped
    /// Points of the bodies lumped beside those of the pairs (ThreeOrMore::up_to_two); else none.
    std::int32_t first_lumped = 0, last_lumped = 0;
    std::int32_t rigid_slot = -1; ///< of the rigid body among them, the first if there are several; -1: none
    bool uses_lumped = false;     ///< the present pass corrects these, not the pairs
};

/// Some of Contact::points.
struct Range {
    std::int32_t first, last;
};

/// What contact keeps from the search to the two passes of a step. Scenes without contact keep it empty.
template <int D>
struct Contact {
    LawTable laws;
    ThreeOrMore three_or_more = ThreeOrMore::lumped;
    std::vector<std::int32_t> active; ///< slots, group by group
    std::vector<ContactGroup<D>> groups;
    std::vector<ContactPoint<D>> points;

    /// Particles that each group sees, `cloud_capacity` places each (Effects::clouds).
    std::vector<std::int32_t> group_of_slot; ///< -1: not in a group
    std::vector<std::int32_t> cloud_size;
    std::vector<std::int32_t> cloud_particles;
    std::int32_t cloud_capacity = 32;

    /// By slot, at contact nodes only.
    std::vector<Pack> volume_gradient;   ///< Ω^α | g^α, notes 2.5, 2.6 (Effects::gradients, Effects::volumes)
    std::vector<Pack> mass_position;     ///< - | Σ S M (X − origin) (Effects::positions)
    std::vector<Pack> mass_displacement; ///< - | Σ S M ΔX, notes 2.4 (Effects::displacements)
};

} // namespace abut
