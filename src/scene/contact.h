#pragma once
#include "scene/space.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace abut {

enum class NormalMethod {
    logistic_regression,
    linear_regression, ///< its first iterate
    irls_regression,   ///< the same by maximum likelihood (notes 3.4.6)
    average_gradient,
    maximum_gradient,
    maximum_volume,
    own_gradient, ///< each body its own, and apart from the others: does not conserve momentum
    specified     ///< ContactSpec::direction everywhere
};
enum class SeparationMethod { particle_edges, critical_position, fitted_position, displacement, none };
/// Fits of fitted_position from extrapolated positions to edges.
enum class PositionFit { power_law, two_per_cell, one_per_cell };
/// At nodes that see three or more bodies.
enum class ThreeOrMore {
    lumped,    ///< each body against all the others as one (contact paper Eq. 50); does not conserve momentum exactly
    explicit_, ///< every touching pair with its own normal, all pairs at once
    up_to_two  ///< explicit where at most two pairs touch, lumped elsewhere (contact paper §3.4)
};
enum class LawType {
    frictionless,
    friction, ///< Coulomb's
    stick,    ///< no sliding while pressed together
    perfect,  ///< bonded: one body
    adhesion, ///< bonded while touching up to a strength, friction beyond
    viscous_friction,
    linear_interface,   ///< springs between the bodies (notes 5.3)
    bilinear_interface, ///< springs that differ in tension and compression (notes 5.5, 5.6)
    cohesive_interface  ///< elastic traction law with a peak (notes 5.4)
};

struct LawSpec {
    LawType type = LawType::frictionless;
    double coefficient = 0;                     ///< µ of friction, viscous friction and adhesion that has failed
    std::optional<double> static_coefficient{}; ///< friction: at rest; not given: as `coefficient`
    double decay_velocity = 0;                  ///< friction: over which the static one decays [m/s]; 0: at once
    double viscosity = 0;                       ///< viscous friction: shear traction by sliding velocity [Pa s/m]
    std::optional<double> contact_stiffness{};  ///< (friction, frictionless) softened contact [Pa/m], notes 5.7

    double strength = 0;       ///< tensile: of adhesion, and the peak of a cohesive interface [Pa]
    double shear_strength = 0; ///< the same in shear [Pa]
    double reach = 0.1;        ///< adhesion, viscous friction: separation up to which they hold [cells]

    double tension_stiffness = 0;                  ///< D_nt of interfaces [Pa/m]
    std::optional<double> compression_stiffness{}; ///< D_nc [Pa/m]; not given: bodies don't penetrate
    double tangential_stiffness = 0;               ///< D_t [Pa/m]
    double opening = 0;                            ///< cohesive: separation at the peak [m]
    double sliding = 0;                            ///< cohesive: sliding displacement at the peak [m]
};

struct PairLawSpec {
    std::array<std::string, 2> bodies;
    LawSpec law;
};

struct ContactSpec {
    NormalMethod normal = NormalMethod::logistic_regression;
    SeparationMethod separation = SeparationMethod::particle_edges;
    Vector direction{};  ///< of a specified normal, of any length but 0: from the body listed first to the later one
    double offset = 0.8; ///< of critical_position, in cells
    PositionFit fit = PositionFit::power_law; ///< of fitted_position
    double exponent = 0.58;                   ///< of its power law
    int corrections = 2;                      ///< 1 or 2 a step
    ThreeOrMore three_or_more = ThreeOrMore::explicit_;
    /// Share of an overlap of two bodies that a step removes (particle-edges, not lumped). Contact laws stop bodies
    /// that approach, but don't part bodies that already overlap, so that small errors of many steps would add up.
    double overlap_correction = 0.01;
    /// Where a body has a smaller share of a pair's mass at a node, and the two touch, the pair is accelerated as one:
    /// its sliding velocity at the start of the step is kept. Forces that few particles spread over a node where they
    /// have next to no mass would else throw them along the interface.
    double screening = 1e-3;
    /// At a rigid body the normal is its own volume gradient's where that, times this, is at least as large as the
    /// other body's (notes 3.5); 0: never.
    double rigid_bias = 0;
    LawSpec law; ///< of every pair not named in `laws`
    std::vector<PairLawSpec> laws;
};

} // namespace abut
