#pragma once
#include "scene/shapes.h"
#include "scene/time_function.h"

#include <array>
#include <optional>
#include <string>
#include <variant>

namespace abut {

/// A virtual moving wall across one axis (FMPM paper §2.5). It sets the normal velocity of the nodes at most `depth`
/// cells inside it and of every node outside it that has mass.
struct WallSpec {
    int axis = 0;                    ///< 0 x, 1 y, 2 z
    Side side = Side::lower;         ///< lower: material lies above the wall
    double position = 0;             ///< at time 0 [m]
    TimeFunction velocity;           ///< along the axis [m/s]
    double depth = 1;                ///< [cells]
    TimeFunction gradient;           ///< of the normal velocity along the axis at the wall [1/s]
    bool estimated_gradient = false; ///< instead: fitted to the extrapolated velocities (FMPM paper Eq. 4)
    bool grip = true;                ///< false: material may leave the wall
};

/// Sets one component of the velocity of all nodes in a box that stays where it is (notes 2.3.2).
struct VelocitySpec {
    Vector lower{}, upper{}; ///< both ends included [m]
    Vector direction{};      ///< of the component, of any length but 0
    TimeFunction velocity;   ///< along `direction` [m/s]
};

/// Traction on the outer faces of a body's particles (FMPM paper §2.4). Faces are chosen in the undeformed body and
/// deform with their particles.
struct TractionSpec {
    std::string body;
    int axis = 0;                           ///< faces across this axis of the undeformed body
    Side side = Side::lower;                ///< ... at the lower or the upper end of their particles
    std::optional<Box> within;              ///< only of particles whose centres lie in this box at time 0
    std::array<TimeFunction, 3> traction{}; ///< force per deformed area, fixed in direction [Pa]
    TimeFunction pressure;                  ///< against the outward normal of the deformed face [Pa]
};

struct BoundarySpec {
    std::string name;
    std::variant<WallSpec, VelocitySpec, TractionSpec> condition;
};

} // namespace abut
