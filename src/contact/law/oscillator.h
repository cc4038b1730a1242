#pragma once
/// \file oscillator.h
/// Motion of two bodies at a node with springs between them during one step (notes chapter 5): m δ'' + F(δ) = f, one
/// component of the displacement discontinuity δ, m the reduced mass, f the force that the step would apply without the
/// interface. Normal components may have different stiffnesses in tension (δ > 0) and compression, or be perfect there.
///
/// What the step needs of it is the impulse J = ∫ F dt, after which the bodies have the velocity that the motion gives
/// them at its end: m u(Δt) = d' − J. The notes add the constant force that leads to the right displacement instead,
/// f_INT Δt = 2 [m (δ(0) − δ(Δt))/Δt + d'] − f Δt (5.19). The two differ by O(φ²), φ = κ Δt. Particles move by the mean
/// of the velocities at start and end, so that with (5.19) a node pair on a linear spring steps by a matrix of
/// determinant 2 sin φ/φ − cos φ = 1 + φ²/6 + ...: its oscillation grows by φ²/12 a step and the run makes energy. With
/// J the determinant is cos φ + φ sin φ/2 = 1 − φ⁴/24 + ...: it never grows, and its period is right to φ²/24. Both are
/// here; the solver takes J.

#include <cmath>
#include <limits>

namespace abut {

/// δ and its rate.
struct Oscillation {
    double displacement = 0; ///< δ [m]
    double velocity = 0;     ///< u [m/s]
};

inline double sine_ratio(double x) { // sin x / x
    return std::abs(x) < 1e-4 ? 1 - x * x / 6 : std::sin(x) / x;
}
inline double versine_ratio(double x) { // (1 − cos x) / x²
    return std::abs(x) < 1e-3 ? 0.5 - x * x / 24 : 2 * std::pow(std::sin(0.5 * x) / x, 2);
}

/// A harmonic oscillator of angular frequency κ (0: free flight) under the acceleration a after the time t
/// (notes 5.27).
inline Oscillation swing(Oscillation at, double kappa, double acceleration, double t) {
    const double phi = kappa * t;
    const double c = std::cos(phi);
    const double s = sine_ratio(phi) * t;
    return {at.displacement * c + at.velocity * s + acceleration * versine_ratio(phi) * t * t,
            at.velocity * c + (acceleration - kappa * kappa * at.displacement) * s};
}

/// Frequencies in tension and compression; compression may be infinitely stiff.
struct Springs {
    double tension = 0;                                           ///< κ for δ > 0 [1/s]
    double compression = std::numeric_limits<double>::infinity(); ///< κ for δ < 0 [1/s]
};

/// The first time in (0, limit] at which a swing that starts on one side of δ = 0, or there, is on the other one; limit
/// if it isn't. Steps are short against the period (κ Δt < π/2), so that it gets there at most once or turns back.
inline double crossing_time(Oscillation from, double kappa, double acceleration, double limit) {
    const double side = from.displacement != 0 ? from.displacement : from.velocity != 0 ? from.velocity : acceleration;
    const auto beyond = [&](double t) { return swing(from, kappa, acceleration, t).displacement * side < 0; };
    // A turn back and across again can hide between the ends: look in the middle too.
    constexpr int looks = 4;
    double low = 0;
    double high = limit;
    bool found = false;
    for (int i = 1; i <= looks && !found; ++i) {
        const double t = limit * i / looks;
        if (beyond(t)) {
            high = t;
            found = true;
        } else {
            low = t;
        }
    }
    if (!found) return limit;
    for (int i = 0; i < 100; ++i) {
        const double t = 0.5 * (low + high);
        if (t <= low || t >= high) break;
        (beyond(t) ? high : low) = t;
    }
    return high;
}

/// The motion with bilinear springs over a step (notes 5.5, 5.6): springs change where δ crosses zero. Where
/// compression is perfect, bodies that meet stay together for the rest of the step, as (5.141) has it, unless pulled
/// apart.
inline Oscillation swing(Oscillation at, const Springs& springs, double acceleration, double dt) {
    double left = dt;
    for (int pieces = 0; pieces < 8 && left > 0; ++pieces) {
        const double side = at.displacement != 0 ? at.displacement : at.velocity != 0 ? at.velocity : acceleration;
        const bool apart = side > 0;
        if (!apart && std::isinf(springs.compression)) {
            if (side == 0 || acceleration <= 0) return {0, 0};
            at = {0, 0}; // pressed before, pulled now
            return swing(at, springs.tension, acceleration, left);
        }
        const double kappa = apart ? springs.tension : springs.compression;
        if (std::isinf(kappa)) return {0, 0}; // too stiff to open in this step
        const double t = crossing_time(at, kappa, acceleration, left);
        at = swing(at, kappa, acceleration, t);
        left -= t;
        if (left > 0) at.displacement = 0;
    }
    return at;
}

/// Impulse of the springs over the step: J = d' − m u(Δt). \param updated d' = m u(0) + f Δt [N s]
inline double spring_impulse(const Oscillation& end, double mass, double updated) {
    return updated - mass * end.velocity;
}

/// f_INT Δt of notes (5.19), which the solver doesn't use; see above.
inline double displacement_impulse(double start, const Oscillation& end, double mass, double dt, double updated,
                                   double force_step) {
    return 2 * (mass / dt * (start - end.displacement) + updated) - force_step;
}

} // namespace abut
