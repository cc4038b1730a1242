#pragma once
/// \file inspect.h
/// A contact node taken apart: what the search saw there, and what every other method would have made of it. Costs
/// nothing unless it is called.

#include "step/state.h"

#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

namespace abut {

/// The separations that each normal gets, in the order of PlaneSeen::separation.
inline constexpr std::array inspected_separations{SeparationMethod::particle_edges, SeparationMethod::critical_position,
                                                  SeparationMethod::fitted_position, SeparationMethod::displacement};

/// What one normal method makes of a point.
template <int D>
struct PlaneSeen {
    NormalMethod method{};
    bool chosen = false; ///< the scene's own
    /// Unit, from body a to b, as a step would use it with the scene's separation; zero: none found.
    Vec<D> normal = Vec<D>::Zero();
    /// As the method found it: the separation `particle-edges` turns normals of regressions a little (widest_gap()).
    Vec<D> fitted = Vec<D>::Zero();
    std::int32_t iterations = 0;
    double angle = 0;                   ///< between `normal` and the scene's own [rad]; NaN where either is missing
    double end_a = 0;                   ///< where the particles of a end along `normal`, from the node [m]
    double end_b = 0;                   ///< where those of b begin [m] (contact paper Eq. 22, 23); NaN without a normal
    std::array<double, 4> separation{}; ///< by inspected_separations [m]; infinite without a normal

    /// Place of the plane along the normal, from the node: halfway between both ends [m].
    double place() const { return 0.5 * (end_a + end_b); }
};

/// A particle of a point's cloud, against the plane of the scene's own method.
template <int D>
struct ParticleSeen {
    std::int32_t id = 0;
    std::int32_t body = 0;
    Vec<D> position = Vec<D>::Zero();             ///< [m]
    Vec<D> half_size = Vec<D>::Zero();            ///< half edges of the undeformed domain [m]
    Mat<D> deformation_gradient = Mat<D>::Zero(); ///< F
    double distance = 0;                          ///< of its centre to the plane, > 0 on the side of b [m]
    double edge_distance = 0; ///< R, from its centre to its edge along the normal [m] (particle_edges.h)
    bool support = false;     ///< it ends where its side ends (to 1e-9 cells)
};

/// A pair of bodies at a node, or a body against all others lumped.
template <int D>
struct PointSeen {
    std::int32_t body_a = -1;
    std::int32_t body_b = -1; ///< of lumped ones the one with the most mass
    bool lumped = false;
    std::vector<PlaneSeen<D>> planes; ///< method by method, in the order of NormalMethod
    std::vector<ParticleSeen<D>> cloud;

    const PlaneSeen<D>& chosen() const;
};

template <int D>
struct NodeSeen {
    Index<D> node; ///< from the grid's lower corner, as the scene counts
    Vec<D> position = Vec<D>::Zero();
    std::vector<PointSeen<D>> points; ///< empty: the node is no contact node
};

/// Takes nodes apart (numbers as in NodeSeen::node). The state must have been `look`ed at (results/frames.h) and its
/// contact must have planes (Effects::planes); it is the same afterwards. Every method is the run's own, run with
/// another choice in the scene, over the nodes asked for. For a pair, `own-gradient` is the normal of body a alone, and
/// its separations are against all others; `specified` is there only if it is the scene's own.
template <int D>
std::vector<NodeSeen<D>> inspect_contact(State<D>& state, const std::vector<Index<D>>& nodes);

/// The pair of a contact node whose normals differ most.
template <int D>
struct Disagreement {
    Index<D> node; ///< as in NodeSeen
    Vec<D> position = Vec<D>::Zero();
    std::int32_t body_a = -1;
    std::int32_t body_b = -1;
    double angle = 0;      ///< the largest between the normals of two methods, as they found them [rad]
    double separation = 0; ///< by the scene's own methods [m]
    std::int32_t cloud_size = 0;
};

/// Bodies farther apart than this share of a cell, by the scene's own separation, have no say in disagreements: no
/// force will act along their normals for many steps.
inline constexpr double disagreement_reach = 0.1;

/// Contact nodes at which the normals of two methods differ by more than an angle, the largest difference first. Only
/// points whose forces act have a say, those of contact.pvd: with `up-to-two`, at nodes where more than two pairs
/// touch, the bodies lumped, elsewhere the pairs. (That is known during a run; a state that was read from a file has
/// the pairs.) A method that finds no normal has no say, nor has `own-gradient`, which is a body's and not a pair's,
/// unless it is the scene's own. Each method runs once over the whole grid. State as for inspect_contact().
template <int D>
std::vector<Disagreement<D>> nodes_in_disagreement(State<D>& state, double angle);

/// The contact node that lies nearest to a place, numbered as in NodeSeen; nothing if there is no contact node.
template <int D>
std::optional<Index<D>> nearest_contact_node(const State<D>& state, const Vec<D>& place);

/// The angle between two vectors, accurate for small ones too [rad]; NaN if one is zero.
template <int D>
double angle_between(const Vec<D>& a, const Vec<D>& b) {
    const Vec<D> x = a * b.norm();
    const Vec<D> y = b * a.norm();
    if (x.isZero(0) || y.isZero(0)) return std::numeric_limits<double>::quiet_NaN();
    return 2 * std::atan2((x - y).norm(), (x + y).norm());
}

} // namespace abut
