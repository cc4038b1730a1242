#pragma once
#include "boundary/boundary.h"
#include "boundary/rigid_motion.h"
#include "boundary/traction.h"
#include "contact/contact.h"
#include "grid/grid.h"
#include "grid/tile.h"
#include "grid/velocity_fields.h"
#include "material/material.h"
#include "particles/particles.h"
#include "plan/effects.h"
#include "shape/stencil_store.h"
#include "step/trouble.h"

#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace abut {

/// Node quantities, one entry a slot. Lane 0 of a pack is the nodal mass where noted, else unused. Arrays that the
/// effects of a scene don't name stay empty.
template <int D>
struct NodeArrays {
    std::vector<Pack> momentum;       ///< mass | momentum extrapolated from the particles, p^α0
    std::vector<Pack> force;          ///< - | internal force, then all force but contact and walls
    std::vector<Pack> traction;       ///< - | force of tractions, part of `force` (Effects::tractions)
    std::vector<Pack> velocity;       ///< mass | v^α at the start of the step, after the first contact pass
    std::vector<Pack> end_velocity;   ///< mass | v^α+ = m^-1 p^α+ at the end of the step
    std::vector<Pack> delta_velocity; ///< - | Δv^α of the first contact pass (Effects::delta_velocity)
    /// - | XPIC: m_k^-1 p^α; FMPM: v^α+ = m_k^-1 p^α+, which moves and deforms the particles (Effects::extra_orders)
    std::vector<Pack> filtered;
    std::vector<Pack> deforming;  ///< - | `filtered`, but lumped where lumped bodies touch (Effects::contact_strain)
    std::vector<Pack> round_trip; ///< - | m S+ S applied to `filtered` (Effects::extra_orders)
};

/// Sums since the start of the run, for the energy balance.
struct Ledger {
    double external_work = 0;    ///< of boundaries and gravity [J]
    double contact_work = 0;     ///< of the contact forces on all bodies together [J]
    double friction_work = 0;    ///< the part of it along the interfaces, but of springs between bodies [J]
    double interface_energy = 0; ///< stored in springs between bodies, at present [J] (Effects::interfaces)
};

/// What two bodies have done to each other since the last row of pairs.csv.
struct PairTotals {
    Vector impulse{};            ///< on the body with the lower number [N s]
    double work = 0;             ///< of the contact forces on both [J]
    double friction_work = 0;    ///< the part of it along the interface [J]
    double interface_energy = 0; ///< stored at the end of the last step [J]
    double area = 0;             ///< contact area in the last step [m^2], if areas were found
};

/// What contact has given to a rigid body since the last row of history.csv.
struct RigidTotals {
    Vector impulse{};         ///< [N s]
    Vector angular_impulse{}; ///< about its centre [N m s]
};

/// What watch_energy() has seen so far.
struct EnergyWatch {
    double initial = 0;       ///< energy when it first looked [J]
    double given = 0;         ///< energy at the start and all work since, each without its sign [J]; 0: not begun
    double lowest = 0;        ///< least of energy − initial energy − works [J]
    double external_work = 0; ///< at the last look [J]
    double contact_work = 0;  ///< likewise [J]
};

/// Everything that a run changes.
template <int D>
struct State {
    Scene scene;
    Effects effects;
    std::vector<ModelBody> bodies;
    std::vector<Material> materials;
    std::vector<Vec<D>> initial_position; ///< by particle id
    std::vector<double> temperature;      ///< [K], by particle id; empty: no body has one
    std::vector<double> orientation;      ///< of the material's x axis [rad], likewise
    Grid<D> grid;
    Particles<D> particles;
    Tiling<D> tiling;
    VelocityFields<D> fields;
    StencilStore<D> stencil_store; ///< empty for shapes that are expanded on the spot
    NodeArrays<D> nodes;
    Contact<D> contact;
    std::vector<RigidPose> poses; ///< of rigid bodies at the start of the step, by body (Effects::rigid)
    std::vector<Boundary> boundaries;
    std::vector<Control> controls; ///< of the present step (Effects::velocity_conditions)
    std::vector<TractionFace> traction_faces;
    std::vector<ShapedFace<D>> shaped_faces; ///< the same at the beginning of the present step
    Ledger ledger;
    EnergyWatch energy_watch;
    std::map<std::pair<std::int32_t, std::int32_t>, PairTotals>
        pair_totals;                                  ///< by bodies a < b that have been in contact
    std::map<std::int32_t, RigidTotals> rigid_totals; ///< by body
    double time = 0;                                  ///< [s]
    double dt = 0;                                    ///< of the present step [s]
    long step = 0;
    int step_reductions = 0;        ///< how often the time step was halved after trouble
    std::optional<Setback> setback; ///< the last such trouble
    double speed_limit = 0;         ///< of a particle [m/s], see step/watch.h
    double largest_wave_speed = 0;  ///< over all particles, of the present state [m/s]
    double since_transfer = 0;      ///< time since the last step with the scheme's transfer [s] (Effects::periodic)
    bool wants_areas = false;       ///< the present step finds contact areas for a row of pairs.csv (Effects::pairs)
    bool transfers = true; ///< the present step uses the scheme's transfer, not FLIP between (Effects::periodic)

    const Material& material_of(int body) const { return materials[bodies[body].material]; }
    /// Whether this step applies the full mass matrix or the XPIC filter.
    bool filters() const { return effects.extra_orders > 0 && transfers; }
    /// Whether velocity conditions act on the lumped velocities, before any full mass matrix calculation.
    bool conditions_on_lumped() const {
        return effects.velocity_conditions &&
               !(effects.fmpm && transfers && scene.method.velocity_conditions == VelocityConditions::velocity);
    }
    template <class Source>
    StencilSource<D, Source> stencils(const Tile<D>& tile) const {
        return {grid, particles, fields, stencil_store, tile};
    }
};

/// Calls work(source) with where a run's kernels get their stencils from.
template <int D, class Work>
decltype(auto) with_stencils(const State<D>& state, Work&& work) {
    return with_stencils<D>(state.scene.method.shape, state.effects.stored_stencils, state.effects.ring,
                            std::forward<Work>(work));
}

/// A run at its start: particles of the model at rest strain, time 0.
template <int D>
State<D> make_state(const Scene& scene, const Model& model);

} // namespace abut
