#pragma once
#include "contact/law/interface.h"

namespace abut {

/// One component of a non-linear interface: the traction F(δ) = T (δ/δ_p) e^(1 − δ/δ_p), which peaks with the strength
/// T at δ_p and softens beyond. Elastic: it closes along the same curve.
struct Cohesion {
    double strength = 0; ///< T [Pa]
    double peak = 1;     ///< δ_p [m]

    double traction(double d) const { return strength * (d / peak) * std::exp(1 - std::abs(d) / peak); }
    double slope(double d) const { // F'
        return strength / peak * (1 - std::abs(d) / peak) * std::exp(1 - std::abs(d) / peak);
    }
    /// ∫ F dδ from 0 [J/m^2].
    double energy(double d) const {
        const double x = std::abs(d) / peak;
        return strength * peak * std::numbers::e * (1 - (1 + x) * std::exp(-x));
    }
};

/// What the bodies do at a node where an interface's slope is too steep for the step (notes 5.4, item 1).
enum class Stiffness { carried, sticks, debonds };

template <int D, class Component>
Stiffness stiffness_at(const Component& component, const Meeting<D>& at, double displacement) {
    const double slope = component.slope(displacement);
    if (!std::isinf(frequency(at, std::abs(slope)))) return Stiffness::carried;
    return slope > 0 ? Stiffness::sticks : Stiffness::debonds;
}

/// One component of a step by the first-order method of notes 5.4: the traction at the mean displacement
/// <δ> = δ(0) − F(δ(0)) A Δt²/6m + d Δt/2m + f Δt²/6m (5.57) acts through the step (5.58). The notes average it with
/// F(δ(0)) (5.59); but that force makes energy, as (5.19) does (see oscillator.h): on a linear spring its steps have
/// the determinant 1 + φ²/4, with (5.58) alone 1 − φ⁴/12. \param start δ(0); \param velocity at the start; \param
/// acceleration without the interface \return impulse [N s] and δ at the end of the step; \param state what the step
/// can carry
template <int D, class Component>
std::pair<double, double> first_order_step(const Component& component, const Meeting<D>& at, double start,
                                           double velocity, double acceleration, Stiffness& state) {
    const double dt = at.dt;
    const double own = component.traction(start) * at.area / at.mass; // deceleration by the interface at the start
    const double mean = start + velocity * dt / 2 + (acceleration - own) * dt * dt / 6;
    state = stiffness_at(component, at, start);
    if (state == Stiffness::carried) state = stiffness_at(component, at, mean);
    const double updated = at.mass * (velocity + acceleration * dt);
    double impulse = 0;
    if (state == Stiffness::sticks) impulse = updated;
    if (state == Stiffness::carried) impulse = component.traction(mean) * at.area * dt;
    const double end = start + dt * (velocity + acceleration * dt / 2) - impulse * dt / (2 * at.mass);
    return {impulse, end};
}

/// A cohesive interface: cohesions across and along it, springs or no penetration in compression.
struct CohesiveInterface {
    Cohesion normal;
    Cohesion tangential;
    double compression = std::numeric_limits<double>::infinity(); ///< D_nc [Pa/m]
    static constexpr bool needs_area = true;
};

template <int D>
InterfaceStep<D> interface_step(const CohesiveInterface& law, const Meeting<D>& at) {
    InterfaceStep<D> step;
    step.impulse.setZero();
    const double dt = at.dt;
    Stiffness state{};

    const double opening = at.discontinuity.dot(at.normal);
    const double updated = at.stick.dot(at.normal);
    const double u = at.start.dot(at.normal) / at.mass;
    const double a = (updated / at.mass - u) / dt;
    const bool opens = opening > 0 || updated > 0;
    if (!opens) {
        const auto [impulse, end] = normal_step(at, 0, law.compression, opening);
        step.impulse += impulse * at.normal;
        if (!std::isinf(law.compression)) step.energy += 0.5 * at.area * law.compression * end * end;
    } else {
        auto [impulse, end] = first_order_step(law.normal, at, std::max(opening, 0.0), u, a, state);
        if (!at.second_pass) impulse = state == Stiffness::sticks ? updated : 0;
        // Bodies that meet within the step don't pass each other.
        if (at.second_pass && end < 0) impulse = std::isinf(law.compression) ? updated : impulse;
        step.impulse += impulse * at.normal;
        step.energy += at.area * law.normal.energy(std::max(end, 0.0));
    }

    // Along the way that the sliding displacement takes; in 3D what is across that way is free in this step.
    const Vec<D> along = at.tangential();
    const Vec<D> sliding = at.discontinuity - opening * at.normal;
    Vec<D> way = sliding + along * (dt / at.mass);
    const double length = way.norm();
    if (length == 0) return step;
    way /= length;
    const double v = at.start.dot(way) / at.mass;
    auto [impulse, end] =
        first_order_step(law.tangential, at, sliding.dot(way), v, (along.dot(way) / at.mass - v) / dt, state);
    if (state == Stiffness::sticks)
        step.impulse += along;
    else if (at.second_pass)
        step.impulse += impulse * way;
    step.energy += at.area * law.tangential.energy(end);
    return step;
}

} // namespace abut
