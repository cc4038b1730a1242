#pragma once
#include "math/linear_algebra.h"

namespace abut {

/// Two bodies at a node, as a contact law finds them. What the law gives back is the momentum change Δp' of body a;
/// body b gets −Δp' (contact paper Eq. 7).
template <int D>
struct Meeting {
    Vec<D> stick;             ///< Δp(0): what would make both move together [N s]
    Vec<D> normal;            ///< unit, from a to b
    double mass = 0;          ///< reduced mass m_a m_b / (m_a + m_b); m_a if b is rigid [kg]
    double dt = 0;            ///< [s]
    double separation = 0;    ///< of their edges at the time of the pass, < 0 in overlap [m]
    double cell = 0;          ///< cell size [m]
    double crossing = 0;      ///< time in which waves cross a cell [s]
    bool second_pass = false; ///< after the momentum update

    // === Only for laws that say so
    Vec<D> force = Vec<D>::Zero(); ///< that keeps them together, from what is extrapolated: m (f_b/m_b − f_a/m_a) [N]
    double area = 0;               ///< contact area A_c [m^2] (needs_area)
    Vec<D> start = Vec<D>::Zero(); ///< m (v_b − v_a) at the start of the step [N s]; in the first pass `stick`
    Vec<D> discontinuity = Vec<D>::Zero(); ///< δ(0): displacement of b less that of a [m] (interfaces)
    double separation_at_start = 0;        ///< of their edges [m] (softened contact)

    bool touching() const { return separation < 0; }
    /// Compressive impulse N_c A_c Δt that would stop them [N s]; negative in tension.
    double compression() const { return -stick.dot(normal); }
    /// The part of Δp(0) along the interface [N s].
    Vec<D> tangential() const { return stick + compression() * normal; }
};

} // namespace abut
