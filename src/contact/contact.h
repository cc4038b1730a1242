#pragma once
#include "contact/law/law.h"
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
    double parting = 0;              ///< normal velocity at which overlapping bodies shall part [m/s]
    bool light = false;              ///< touching, and one body has next to no mass here: see ContactSpec::screening
    Vec<D> sliding = Vec<D>::Zero(); ///< tangential velocity of b to a that a light pair keeps [m/s]
    bool touching = false;           ///< in contact in the second pass
    Vec<D> impulse = Vec<D>::Zero(); ///< on a in the second pass [N s]
};

/// The active bodies of one contact node: those whose share of the node's mass is not negligible (notes 4.1).
template <int D>
struct ContactGroup {
    Index<D> node;
    std::int32_t first = 0, last = 0;             ///< in Contact::active
    std::int32_t first_point = 0, last_point = 0; ///< one for each pair, or for each body if lumped
    /// One for each body lumped, beside the pairs, at nodes where ThreeOrMore::up_to_two takes the one or the other.
    std::int32_t first_lumped = 0, last_lumped = 0;
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
