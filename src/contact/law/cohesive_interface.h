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
    /// Bound of |F| up to |δ| = d.
    double strongest(double) const { return strength; }
    /// ∫ F dδ from 0 [J/m^2].
    double energy(double d) const {
        const double x = std::abs(d) / peak;
        return strength * peak * std::numbers::e * (1 - (1 + x) * std::exp(-x));
    }
};

/// The normal component with springs in compression.
struct CohesionAcross {
    Cohesion tension;
    double compression = 0; ///< D_nc [Pa/m]
    double peak = tension.peak;

    double traction(double d) const { return d > 0 ? tension.traction(d) : compression * d; }
    double slope(double d) const { return d > 0 ? tension.slope(d) : compression; }
    double energy(double d) const { return d > 0 ? tension.energy(d) : 0.5 * compression * d * d; }
    double strongest(double d) const { return std::max(tension.strength, compression * std::abs(d)); }
};

/// What the bodies do at a node where an interface's slope is too steep for the step (notes 5.4, item 1).
enum class Stiffness { carried, sticks, debonds };

template <int D, class Component>
Stiffness stiffness_at(const Component& component, const Meeting<D>& at, double displacement) {
    const double slope = component.slope(displacement);
    if (!std::isinf(frequency(at, std::abs(slope)))) return Stiffness::carried;
    return slope > 0 ? Stiffness::sticks : Stiffness::debonds;
}

/// The first-order method of the notes (5.57-5.59): the mean of the traction at δ(0) and that at the mean displacement
/// <δ> = δ(0) − F(δ(0)) A Δt²/6m + d Δt/2m + f Δt²/6m. The solver doesn't use it: on a linear spring its steps have the
/// determinant 1 + φ²/4 − ..., it makes energy (see oscillator.h). \return f_INT Δt [N s]
template <int D, class Component>
double first_order_impulse(const Component& component, const Meeting<D>& at, double start, double velocity,
                           double acceleration) {
    const double dt = at.dt;
    const double own = component.traction(start) * at.area / at.mass;
    const double mean = start + velocity * dt / 2 + (acceleration - own) * dt * dt / 6;
    return 0.5 * (component.traction(start) + component.traction(mean)) * at.area * dt;
}

/// One component of a step, with exactly the energy that the bodies lose: J = A Δt (E(δ') − E(δ))/(δ' − δ), where
/// δ' = δ + Δt (d + d'')/2m as particles move, d'' = d + f Δt − J. For the linear spring this is the trapezoidal rule.
/// The equation for δ' is solved by bisection: F' Δt² A/m < (π/2)² where the step carries it, so that there is one
/// solution close to where the bodies would go freely.
/// \param start δ(0); \param velocity δ'(0); \param acceleration without the interface
/// \return impulse [N s] and δ at the end of the step
template <int D, class Component>
std::pair<double, double> conserving_step(const Component& component, const Meeting<D>& at, double start,
                                          double velocity, double acceleration) {
    const double dt = at.dt;
    const double free = start + velocity * dt + 0.5 * acceleration * dt * dt;
    const auto impulse = [&](double end) {
        const double way = end - start;
        const double mean = std::abs(way) > 1e-6 * component.peak
                                ? (component.energy(end) - component.energy(start)) / way
                                : component.traction(0.5 * (start + end));
        return at.area * dt * mean;
    };
    const auto beyond = [&](double end) { return end - free + 0.5 * dt / at.mass * impulse(end); };
    // The springs pull back by at most this much.
    const double strongest = component.strongest(std::max(std::abs(start), std::abs(free)));
    const double most = 0.5 * dt * dt / at.mass * at.area * strongest;
    double low = free - most, high = free + most;
    double end = free;
    for (int i = 0; i < 60; ++i) {
        end = 0.5 * (low + high);
        if (end <= low || end >= high) break;
        (beyond(end) > 0 ? high : low) = end;
    }
    return {impulse(end), end};
}

/// One component of a step, as far as the step can carry the interface's slope at δ(0), by which both passes decide
/// alike. \param updated m δ'(0) + f Δt: what would stop the bodies \return impulse [N s] and δ at the end of the step,
/// 0 where the bodies stick
template <int D, class Component>
std::pair<double, double> cohesive_step(const Component& component, const Meeting<D>& at, double start, double velocity,
                                        double updated) {
    const double acceleration = (updated / at.mass - velocity) / at.dt;
    switch (stiffness_at(component, at, start)) {
    case Stiffness::sticks:
        return {updated, 0};
    case Stiffness::carried:
        if (at.second_pass) return conserving_step(component, at, start, velocity, acceleration);
        break;
    case Stiffness::debonds:
        break;
    }
    return {0, start + at.dt * (velocity + 0.5 * acceleration * at.dt)};
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
    const double opening = at.discontinuity.dot(at.normal);
    const double updated = at.stick.dot(at.normal);
    const double velocity = at.start.dot(at.normal) / at.mass;
    const bool presses = std::isinf(frequency(at, law.compression)); // instead of springing
    if (!presses) {
        const CohesionAcross across{law.normal, law.compression};
        const auto [impulse, end] = cohesive_step(across, at, opening, velocity, updated);
        step.impulse = impulse * at.normal;
        step.energy = at.area * across.energy(end);
    } else if (opening > 0 || updated > 0) {
        auto [impulse, end] = cohesive_step(law.normal, at, std::max(opening, 0.0), velocity, updated);
        if (end < 0 && at.second_pass) impulse = updated; // bodies that meet don't pass each other
        step.impulse = impulse * at.normal;
        step.energy = at.area * law.normal.energy(std::max(end, 0.0));
    } else {
        step.impulse = updated * at.normal;
    }

    // Along the way that the sliding displacement takes; in 3D what is across that way is free in this step.
    const Vec<D> along = at.tangential();
    const Vec<D> sliding = at.discontinuity - opening * at.normal;
    Vec<D> way = sliding + along * (at.dt / at.mass);
    const double length = way.norm();
    if (length == 0) return step;
    way /= length;
    const auto [impulse, end] =
        cohesive_step(law.tangential, at, sliding.dot(way), at.start.dot(way) / at.mass, along.dot(way));
    const bool sticks = stiffness_at(law.tangential, at, sliding.dot(way)) == Stiffness::sticks;
    step.impulse += sticks ? along : Vec<D>(impulse * way);
    step.energy += at.area * law.tangential.energy(end);
    return step;
}

} // namespace abut
