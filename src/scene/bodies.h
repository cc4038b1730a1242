#pragma once
#include "scene/shapes.h"
#include "scene/time_function.h"

#include <array>
#include <optional>
#include <string>

namespace abut {

enum class MaterialModel { neo_hookean, neo_hookean_isochoric, linear_elastic };

/// A constitutive law with its constants. The reader converts any pair of elastic constants to (K, G).
struct MaterialSpec {
    std::string name;
    MaterialModel model = MaterialModel::neo_hookean;
    double density = 0;       ///< [kg/m^3]
    double bulk_modulus = 0;  ///< K [Pa]
    double shear_modulus = 0; ///< G [Pa]
};

/// Which places of the particle lattice a body takes, and what its particles there are.
enum class Fill {
    centre,          ///< (shapes) places whose centre lies inside: whole particles
    majority,        ///< (images) places of which it covers the largest share: whole particles
    covered_fraction ///< every place it covers in part; particles there have the area and centre of what is covered
};

/// Where the lattice of a shape's particles begins.
enum class Arrangement {
    grid,  ///< at the grid's lower corner: the same for all bodies
    fitted ///< at the shape's own lower corner, its particles a little larger or smaller so that they end at its upper
           ///< one
};

/// Velocities v0 + L (x - x0) of a body's particles at time 0.
struct InitialVelocity {
    Vector value{};                   ///< v0 [m/s]
    std::array<Vector, 3> gradient{}; ///< L, row by row [1/s]
    Vector center{};                  ///< x0, used by the gradient [m]
    Vector at(const Vector& x) const {
        Vector v = value;
        for (std::size_t i = 0; i < 3; ++i)
            for (std::size_t j = 0; j < 3; ++j) v[i] += gradient[i][j] * (x[j] - center[j]);
        return v;
    }
    bool operator==(const InitialVelocity&) const = default;
};

/// What a body has at time 0 besides its place and its velocity. What is not given is neither stored nor computed.
struct InitialState {
    Vector angular_velocity{};                   ///< adds a rotation about the body's centre of mass [rad/s]
    std::optional<double> temperature;           ///< [K]
    std::optional<std::array<double, 6>> stress; ///< Cauchy, xx yy zz xy yz xz [Pa]
    std::optional<double> orientation;           ///< angle of the material's axes, counter-clockwise from x [rad]
    bool operator==(const InitialState&) const = default;
};

/// Prescribed motion of a body that does not deform and that no force moves (notes 4.2.4).
struct RigidSpec {
    std::array<TimeFunction, 3> velocity{}; ///< of its centre [m/s]
    TimeFunction angular_velocity;          ///< about `axis` through its centre, counter-clockwise [rad/s]
    Vector axis{0, 0, 1};                   ///< of any length but 0; z in plane scenes
    std::optional<Vector> center;           ///< at time 0 [m]; not given: the centre of its volume
};

/// Particles that share one velocity field.
struct BodySpec {
    std::string name;
    std::string material; ///< empty if it is rigid
    std::optional<RigidSpec> rigid;
    ShapeSpec shape;
    InitialVelocity velocity;
    int particles_per_cell = 2; ///< per axis
    Fill fill = Fill::centre;
    std::optional<Arrangement> arrangement{}; ///< not given: fitted for boxes, grid for all others
    InitialState state{};
};

/// What happens where bodies claim the same place.
enum class Overlap {
    refuse, ///< an error
    first,  ///< it stays with the one that comes first: bodies in their order, then images
    last    ///< it goes to the one that comes last
};

} // namespace abut
