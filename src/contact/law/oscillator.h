#pragma once
/// \file oscillator.h
/// Motion of two bodies at a node with springs between them during one step (notes chapter 5): m δ'' + F(δ) = f, one
/// component of the displacement discontinuity δ, m the reduced mass, f the force that the step would apply without the
/// interface. Normal components may have different stiffnesses in tension (δ > 0) and compression, or be perfect there.
///
/// The notes give the bodies the constant force that leads to the exact δ(Δt) (5.19, 5.42): with φ = κ Δt, d = m δ'(0),
///   f_INT Δt = 2 (m/Δt) δ(0) (1 − cos φ) + 2 d (1 − sin φ/φ) + f Δt (1 − 2 (1 − cos φ)/φ²).
/// One step of it is exact in δ but not in δ'; and as particles move by the mean of their velocities at start and end,
/// a node pair steps by a matrix of determinant 2 sin φ/φ − cos φ = 1 + φ²/6 + ...: oscillations grow by φ²/12 a step,
/// and the run makes energy. The impulse
///   J = (1 − cos φ) (2 (m/Δt) δ(0) + d) + f Δt (1 − 2 (1 − cos φ)/φ²)
/// differs in the coefficient of d alone, by φ²/6. Its steps have the determinant 1 and the trace 2 cos φ: δ after n
/// steps is a sine of the exact frequency for ever, and what is pulled by a constant f swings about f/D. The solver
/// takes this where one spring acts all through a step. (Where particles move by other rules than the mean of their
/// velocities at start and end, as with PIC and XPIC, the transfer damps the swinging as it damps any motion.) Where
/// springs change within it, it takes the integral of their force, J = ∫ F dt, of the exact motion, whose determinant
/// cos φ + φ sin φ/2 = 1 − φ⁴/24 + ... is on the safe side.

#include <algorithm>
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

/// How a step with springs ends, and the frequency of the spring that acted all through it; negative if springs
/// changed.
struct Swing {
    Oscillation end;
    double kappa = -1;
};

/// The motion with bilinear springs over a step (notes 5.5, 5.6): springs change where δ crosses zero. Where
/// compression is perfect, bodies that meet stay together for the rest of the step, as (5.141) has it, unless pulled
/// apart; bodies that overlap are free to part.
inline Swing swing(Oscillation at, const Springs& springs, double acceleration, double dt) {
    double left = dt;
    for (int pieces = 0; pieces < 8 && left > 0; ++pieces) {
        const double side = at.displacement != 0 ? at.displacement : at.velocity != 0 ? at.velocity : acceleration;
        double kappa = side > 0 ? springs.tension : springs.compression;
        if (side <= 0 && std::isinf(kappa)) {
            at.velocity = std::max(at.velocity, 0.0);
            if (at.velocity == 0 && acceleration <= 0) return {at};
            kappa = at.displacement < 0 ? 0 : springs.tension;
        }
        if (std::isinf(kappa)) return {{at.displacement, 0}}; // too stiff to open in this step
        const double t = crossing_time(at, kappa, acceleration, left);
        at = swing(at, kappa, acceleration, t);
        left -= t;
        if (left <= 0) return {at, pieces == 0 ? kappa : -1};
        at.displacement = 0;
    }
    return {{0, 0}}; // it rattles: together
}

/// J of one spring over a step; see above. \param force_step f Δt
inline double spring_impulse(double phi, double displacement, double momentum, double force_step, double mass,
                             double dt) {
    return (1 - std::cos(phi)) * (2 * mass / dt * displacement + momentum) + force_step * (1 - 2 * versine_ratio(phi));
}

/// J of a step in which springs change: ∫ F dt. \param updated d' = m δ'(0) + f Δt
inline double integrated_impulse(const Oscillation& end, double mass, double updated) {
    return updated - mass * end.velocity;
}

/// f_INT Δt of notes (5.19), which the solver doesn't use; see above.
inline double displacement_impulse(double start, const Oscillation& end, double mass, double dt, double updated,
                                   double force_step) {
    return 2 * (mass / dt * (start - end.displacement) + updated) - force_step;
}

} // namespace abut
