#pragma once
#include "grid/velocity_fields.h"

#include <string>
#include <vector>

namespace abut {

/// A moving wall in a run (FMPM paper §2.5).
template <int D>
struct Wall {
    std::string name;
    WallSpec spec;
    /// A slot that the wall controls in the present step.
    struct Controlled {
        std::int32_t slot;
        double velocity; ///< wanted, along the axis [m/s]
        double impulse;  ///< given to the node this step [N s]
    };
    std::vector<Controlled> controlled;
    double impulse = 0; ///< along the axis, on the bodies, since the last row of history [N s]

    double position(double time) const { return spec.position + spec.velocity * time; }
};

/// Finds the slots that a wall controls at `time`: v_i = v + ∇v (x_i − x_wall) at nodes at most `depth` cells inside
/// the wall and at all nodes outside it.
template <int D>
void find_controlled(Wall<D>& wall, const Grid<D>& grid, const VelocityFields<D>& fields, double time);

/// Sets the normal velocity of the controlled slots (mass in lane 0) and adds up the impulses (notes 2.7-2.12).
template <int D>
void impose(Wall<D>& wall, std::vector<Pack>& velocity);

/// Closes a step: adds its impulses to Wall::impulse.
/// \return the work done on the bodies, impulse times the velocity of the wall where it acts [J]
template <int D>
double settle(Wall<D>& wall);

} // namespace abut
