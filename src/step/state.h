#pragma once
#include "boundary/wall.h"
#include "contact/contact.h"
#include "grid/grid.h"
#include "grid/tile.h"
#include "grid/velocity_fields.h"
#include "material/material.h"
#include "particles/particles.h"
#include "plan/effects.h"
#include "shape/stencil_store.h"

#include <vector>

namespace abut {

/// Node quantities, one entry a slot. Lane 0 of a pack is the nodal mass where noted, else unused. Arrays that the
/// effects of a scene don't name stay empty.
template <int D>
struct NodeArrays {
    std::vector<Pack> momentum;       ///< mass | momentum extrapolated from the particles, p^α0
    std::vector<Pack> force;          ///< - | internal force, then all force but contact and walls
    std::vector<Pack> velocity;       ///< mass | v^α at the start of the step, after the first contact pass
    std::vector<Pack> end_velocity;   ///< mass | v^α+ at the end of the step
    std::vector<Pack> delta_velocity; ///< - | Δv^α of the first contact pass (Effects::delta_velocity)
    std::vector<Pack> filtered;       ///< - | m_k^-1 applied to the momenta (Effects::extra_orders)
    std::vector<Pack> round_trip;     ///< - | m S+ S applied to `filtered` (Effects::extra_orders)
};

/// Sums since the start of the run, for the energy balance.
struct Ledger {
    double external_work = 0; ///< of walls and gravity [J]
    double contact_work = 0;  ///< of both contact passes [J]
};

/// Everything that a run changes.
template <int D>
struct State {
    Scene scene;
    Effects effects;
    std::vector<ModelBody> bodies;
    std::vector<Material> materials;
    std::vector<Vec<D>> initial_position; ///< by particle id
    Grid<D> grid;
    Particles<D> particles;
    Tiling<D> tiling;
    VelocityFields<D> fields;
    StencilStore<D> stencil_store; ///< empty for shapes that are expanded on the spot
    NodeArrays<D> nodes;
    Contact<D> contact;
    std::vector<Wall<D>> walls;
    Ledger ledger;
    double time = 0; ///< [s]
    double dt = 0;   ///< of the present step [s]
    long step = 0;
    double largest_wave_speed = 0; ///< over all particles, of the present state [m/s]

    const Material& material_of(int body) const { return materials[bodies[body].material]; }
    template <class Shape>
    StencilSource<D, Shape> stencils(const Tile<D>& tile) const {
        return {grid, particles, fields, stencil_store, tile};
    }
};

/// A run at its start: particles of the model at rest strain, time 0.
template <int D>
State<D> make_state(const Scene& scene, const Model& model);

} // namespace abut
