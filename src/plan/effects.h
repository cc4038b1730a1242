#pragma once
#include "scene/scene.h"

namespace abut {

/// The effects that a scene calls for. Every array and every task beyond the bare single-body step hangs on one of
/// these.
struct Effects {
    bool contact = false;        ///< two contact passes, contact nodes
    bool clouds = false;         ///< point clouds of contact nodes: regression normals or particle edges
    bool regression = false;     ///< normals by regression
    bool gradients = false;      ///< volume gradients at contact nodes: gradient normals
    bool positions = false;      ///< extrapolated positions at contact nodes: grid separations
    bool delta_velocity = false; ///< Δv of the first contact pass is kept: XPIC of order 2 and more
    int extra_orders = 0;        ///< gather-scatter sweeps of XPIC: order - 1
    bool stress_first = false;   ///< USF: stress is updated between the extrapolations
    bool gravity = false;
    bool stored_stencils = false; ///< the shape is dear to expand: stencils are kept for the sweeps of a step
};

Effects effects_of(const Scene& scene);

} // namespace abut
