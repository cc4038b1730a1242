#pragma once
#include "contact/law/oscillator.h"
#include "contact/law/slide.h"

#include <numbers>

namespace abut {

/// Largest κ Δt that a spring may have (notes 5.3.2, item 5): beyond it, it acts as infinitely stiff in this step.
constexpr double largest_phase = std::numbers::pi / 2;

/// κ of a spring [1/s]; infinite where the step can't carry it.
template <int D>
double frequency(const Meeting<D>& at, double stiffness) {
    const double kappa = std::sqrt(stiffness * at.area / at.mass);
    return kappa * at.dt < largest_phase ? kappa : std::numeric_limits<double>::infinity();
}

/// An interface of springs (notes 5.3 linear, 5.5 bilinear, 5.6 debonded and perfect in compression): tractions D_n
/// δ_n, D_t δ_t. Where springs are too stiff for the step the bodies stick in that direction.
struct LinearInterface {
    double tension = 0;                                           ///< D_nt [Pa/m]; 0: debonded
    double compression = std::numeric_limits<double>::infinity(); ///< D_nc [Pa/m]; infinite: perfect in compression
    double tangential = 0;                                        ///< D_t [Pa/m]
    static constexpr bool needs_area = true;

    /// Energy of an interface of area A displaced by δ (notes 5.39) [J].
    double energy(double area, double normal, double sliding) const {
        const double D_n = normal > 0 ? tension : (normal < 0 ? compression : 0.0);
        return 0.5 * area * (D_n * normal * normal + tangential * sliding * sliding);
    }
};

/// What an interface does in a step.
template <int D>
struct InterfaceStep {
    Vec<D> impulse;    ///< Δp' of body a
    double energy = 0; ///< stored at the end of the step [J]
};

/// The normal component of a step with springs and perfect contact: J_n and δ_n(Δt), 0 where the bodies stick: springs
/// that don't act hold no energy (notes 5.3.2, item 5). \param start δ_n(0)
template <int D>
std::pair<double, double> normal_step(const Meeting<D>& at, double tension, double compression, double start) {
    const double updated = at.stick.dot(at.normal);
    const Springs springs{frequency(at, tension), frequency(at, compression)};
    const bool presses = std::isinf(springs.compression); // instead of springing
    const bool opens = start > 0 || (updated > 0 && (start == 0 || presses));
    if (std::isinf(opens ? springs.tension : springs.compression)) return {updated, 0};
    // Forces belong to the second pass, while what sticks must stick in both (5.3.2, item 4).
    if (!at.second_pass) return {0, start};
    const double velocity = at.start.dot(at.normal) / at.mass;
    const double acceleration = (updated / at.mass - velocity) / at.dt;
    const Swing swung = swing({start, velocity}, springs, acceleration, at.dt);
    if (swung.kappa < 0) return {integrated_impulse(swung.end, at.mass, updated), swung.end.displacement};
    const double d = at.start.dot(at.normal);
    return {spring_impulse(swung.kappa * at.dt, start, d, updated - d, at.mass, at.dt), swung.end.displacement};
}

template <int D>
InterfaceStep<D> interface_step(const LinearInterface& law, const Meeting<D>& at) {
    InterfaceStep<D> step;
    const double opening = at.discontinuity.dot(at.normal);
    const auto [normal, opening_at_end] = normal_step(at, law.tension, law.compression, opening);
    step.impulse = normal * at.normal;
    // The springs along the interface are the same in all its directions, so that vectors obey the scalar solution.
    const Vec<D> updated = at.tangential();
    const Vec<D> sliding = at.discontinuity - opening * at.normal;
    Vec<D> sliding_at_end = Vec<D>::Zero();
    const double kappa = frequency(at, law.tangential);
    if (std::isinf(kappa)) {
        step.impulse += updated;
    } else if (at.second_pass) {
        const Vec<D> start = at.start - at.start.dot(at.normal) * at.normal;
        const double phi = kappa * at.dt;
        const Vec<D> gained = updated - start; // f Δt
        step.impulse += (1 - std::cos(phi)) * (2 * at.mass / at.dt * sliding + start) +
                        (1 - 2 * versine_ratio(phi)) * gained; // as spring_impulse()
        sliding_at_end =
            std::cos(phi) * sliding + at.dt / at.mass * (sine_ratio(phi) * start + versine_ratio(phi) * gained);
    }
    const bool presses = std::isinf(frequency(at, law.compression));
    step.energy = law.energy(at.area, presses ? std::max(opening_at_end, 0.0) : opening_at_end, sliding_at_end.norm());
    return step;
}

/// Softened contact (notes 5.7): bodies apart are free, bodies in contact are pressed apart by springs of stiffness D_c
/// under their overlap, as far as the step can carry it, and slide as the law says under that pressure.
template <class SlideLaw>
struct Softened {
    SlideLaw law;
    double stiffness = 0; ///< D_c [Pa/m]
    static constexpr bool needs_area = true;
};

template <int D, class SlideLaw>
Vec<D> law_impulse(const Softened<SlideLaw>& softened, const Meeting<D>& at) {
    if (std::isinf(frequency(at, softened.stiffness))) return law_impulse(softened.law, at);
    if (!std::isfinite(at.separation_at_start)) return Vec<D>::Zero(); // no plane was found
    if (!at.second_pass) return Vec<D>::Zero();
    const double pressing = -normal_step(at, 0, softened.stiffness, at.separation_at_start).first;
    return pressing > 0 ? slide_under(softened.law, at, pressing) : Vec<D>::Zero();
}

} // namespace abut
