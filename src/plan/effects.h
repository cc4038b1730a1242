#pragma once
#include "scene/scene.h"

namespace abut {

/// The effects that a scene calls for. Every array and every task beyond the bare single-body step hangs on one of
/// these.
struct Effects {
    bool contact = false;        ///< two contact passes, contact nodes
    bool planes = false;         ///< normals and separations are found: an interface is not perfect
    bool clouds = false;         ///< point clouds of contact nodes: regression normals or particle edges
    bool regression = false;     ///< normals by regression
    bool gradients = false;      ///< volume gradients at contact nodes: gradient normals
    bool volumes = false;        ///< volumes at contact nodes, with the gradients: contact areas, normals by volume
    bool displacements = false;  ///< extrapolated displacements at contact nodes: interfaces, separations
    bool positions = false;      ///< extrapolated positions at contact nodes: grid separations
    bool delta_velocity = false; ///< Δv of the first contact pass is kept: XPIC and FMPM of order 2 and more
    bool pic = false;            ///< particles take their velocities from the grid, not changes of them
    bool rigid = false;          ///< bodies whose motion is prescribed
    bool areas = false;          ///< contact areas: laws with tractions
    bool pairs = false;          ///< contact areas in the steps before a row of pairs.csv
    bool interfaces = false;     ///< contact laws that store energy
    int extra_orders = 0;        ///< gather-scatter sweeps of XPIC and FMPM: order - 1
    bool fmpm = false;           ///< grid velocities by the full mass matrix, order 2 and more
    bool contact_strain = false; ///< FMPM with contact: at nodes of lumped bodies particles deform by other velocities
                                 ///< than they move by
    bool periodic = false;       ///< FLIP steps between those of the scheme
    bool stress_first = false;   ///< USF, USAVG: stress is updated between the extrapolations
    bool stress_last = false;    ///< USL, USAVG: stress is updated at the end of the step
    bool reextrapolate = false;  ///< USL+, USAVG+: the last stress update uses velocities extrapolated anew
    bool gravity = false;
    bool velocity_conditions = false; ///< walls, velocities of nodes, the axis of axisymmetric scenes
    bool tractions = false;
    bool prestress = false;       ///< bodies with a stress at time 0
    bool ring = false;            ///< axisymmetric: hoop terms
    bool free_across = false;     ///< plane stress: the stretch across the plane is solved for
    bool stored_stencils = false; ///< stencils are kept for the sweeps of a step

    /// Whether fields are extrapolated at contact nodes.
    bool contact_fields() const { return gradients || volumes || displacements || positions; }
    /// Share of a step's strain that each of its stress updates takes.
    double stress_share() const { return stress_first && stress_last ? 0.5 : 1.0; }
};

Effects effects_of(const Scene& scene);

} // namespace abut
