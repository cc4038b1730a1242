#pragma once
#include "grid/velocity_fields.h"
#include "scene/scene.h"

#include <string>
#include <vector>

namespace abut {

/// A boundary condition of a run.
struct Boundary {
    std::string name;
    std::variant<WallSpec, VelocitySpec, TractionSpec> condition;
    Vector impulse{}; ///< given to the bodies since the last row of history [N s]
};

/// A slot whose velocity along `direction` a boundary condition sets in the present step.
struct Control {
    std::int32_t slot;
    std::int32_t boundary;    ///< -1: the axis of axisymmetric scenes
    Pack direction;           ///< unit vector in the vector lanes
    double velocity;          ///< wanted, along `direction` [m/s]
    double push = 0;          ///< 1 or -1: may only be changed to that side; 0: either
    bool of_box = false;      ///< of a velocity condition, not of a wall
    std::int32_t mirror = -1; ///< else: minus the velocity of this slot is wanted instead of `velocity`
    double impulse = 0;       ///< given to the node this step [N s]
};

/// Position of a wall [m].
inline double wall_position(const WallSpec& wall, double time) {
    return wall.position + wall.velocity.integral(time);
}

/// Appends the slots that a wall controls in the step from `time` to time + dt: v_i = v + ∇v (x_i − x_wall) at nodes
/// at most `depth` cells inside the wall and at all nodes outside it (FMPM paper §2.5). The wall's velocity is that at
/// the end of the step; its position and gradient are those at the beginning, where the particles are.
/// \param velocity extrapolated from the particles, mass in lane 0; read if the gradient is to be estimated
template <int D>
void control_wall(const WallSpec& wall, std::int32_t boundary, const Grid<D>& grid, const VelocityFields<D>& fields,
                  const std::vector<Pack>& velocity, double time, double dt, std::vector<Control>& controls);

/// The nodes in a condition's box; may be none.
template <int D>
Window<D> nodes_in(const VelocitySpec& condition, const Grid<D>& grid);

/// Appends the slots of the nodes in the condition's box.
template <int D>
void control_box(const VelocitySpec& condition, std::int32_t boundary, const Grid<D>& grid,
                 const VelocityFields<D>& fields, double time, double dt, std::vector<Control>& controls);

/// Appends the slots on the axis r = 0, whose radial velocity is zero, and beyond it, where it mirrors that inside
/// (only splines reach there; what the mirrored nodes give and take is not in the ledger).
void control_axis(const Grid<2>& grid, const VelocityFields<2>& fields, std::vector<Control>& controls);

/// Where velocity conditions control a slot, makes the directions of all conditions there orthogonal to each other,
/// with velocities such that imposing one after the other fulfils all (notes 2.3.2). Velocity conditions in the same
/// direction add up (notes 2.12) and go before walls; one that depends on others before it is dropped. Slots that only
/// walls control stay as they are: of two across one axis the later wins.
void make_orthogonal(std::vector<Control>& controls, std::size_t slots);

/// Sets the controlled components of the velocities (mass in lane 0) and adds up the impulses: the forces of notes
/// (2.7)-(2.12) times the time step.
void impose(std::vector<Control>& controls, std::vector<Pack>& velocity);
/// The same without adding up.
void impose_untracked(const std::vector<Control>& controls, std::vector<Pack>& velocity);

/// Closes a step: adds its impulses to their boundaries.
/// \return the work done on the bodies, impulse times velocity where it acts [J]
double settle(std::vector<Control>& controls, std::vector<Boundary>& boundaries);

} // namespace abut
