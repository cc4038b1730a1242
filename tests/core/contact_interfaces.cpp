/// Imperfect interfaces (notes chapter 5) against closed forms, the notes' equations and integration of the motion in
/// small steps.

#include "support.h"

#include "contact/law/contact_law.h"

namespace {

using namespace test;

/// m δ'' = f − F(δ) by many small steps: δ, m δ' and ∫ F dt at the end.
struct Integrated {
    double displacement, momentum, impulse;
};
template <class Force>
Integrated integrate(double displacement, double momentum, double force, double mass, double time, Force&& F) {
    constexpr int steps = 200000;
    const double dt = time / steps;
    double impulse = 0;
    for (int i = 0; i < steps; ++i) { // leapfrog
        displacement += 0.5 * dt * momentum / mass;
        const double spring = F(displacement);
        momentum += dt * (force - spring);
        impulse += dt * spring;
        displacement += 0.5 * dt * momentum / mass;
    }
    return {displacement, momentum, impulse};
}

constexpr double mass = 0.6;
constexpr double dt = 0.01;
constexpr double area = 0.4;

/// A node in the second pass: δ(0), d = m δ'(0) and f along both directions.
Meeting<2> node(const Vec<2>& displacement, const Vec<2>& momentum, const Vec<2>& force) {
    Meeting<2> at;
    at.normal = {0, 1};
    at.mass = mass;
    at.dt = dt;
    at.area = area;
    at.cell = 1;
    at.second_pass = true;
    at.discontinuity = displacement;
    at.start = momentum;
    at.stick = momentum + force * dt;
    return at;
}

/// Stiffness with a phase κ Δt.
double stiffness(double phase) {
    return mass * phase * phase / (dt * dt * area);
}

LawSpec springs(LawType type, double tension, double tangential, std::optional<double> compression = {}) {
    LawSpec spec;
    spec.type = type;
    spec.tension_stiffness = tension;
    spec.tangential_stiffness = tangential;
    spec.compression_stiffness = compression;
    return spec;
}

InterfaceStep<2> step_of(const LawSpec& spec, const Meeting<2>& at) {
    return apply_law<2>(make_contact_law(spec), at);
}

/// Case 12 of the list of cases: one node pair, the closed form (5.27), (5.43), (5.46), in extended precision.
TEST(Interfaces, TheOscillatorHasTheClosedForm) {
    using Long = long double;
    std::mt19937 random(1);
    std::uniform_real_distribution<double> in(-1, 1);
    double worst = 0;
    for (int trial = 0; trial < 500; ++trial) {
        const double phi = 0.01 + 1.5 * trial / 500;
        const double d0 = in(random)*1e-3;
        const double d = in(random)*mass * 0.1;
        const double f = in(random)*mass * 10;
        const double kappa = phi / dt;
        const Oscillation end = swing({d0, d / mass}, kappa, f / mass, dt);
        const Long p = phi, m = Long(mass) / dt, updated = Long(d) + Long(f) * dt;
        const Long spring = Long(mass) * kappa * kappa; // D_t A
        const Long closed =
            d / (Long(mass) * kappa) * std::sin(p) + (d0 - f / spring) * std::cos(p) + f / spring; // 5.27
        const Long by_updated = d0 * std::cos(p) + updated / m * std::sin(p) / p +
                                f * dt / m * ((1 - std::cos(p)) / (p * p) - std::sin(p) / p); // 5.46
        const double scale = static_cast<double>(std::abs(d0) + std::abs(d) / m + std::abs(f) * dt / m);
        worst = std::max({worst, static_cast<double>(std::abs(end.displacement - closed)) / scale,
                          static_cast<double>(std::abs(end.displacement - by_updated)) / scale});
        // The notes' effective force, 5.45, from our end.
        const Long effective = 2 * m * d0 * (1 - std::cos(p)) + 2 * updated * (1 - std::sin(p) / p) +
                               f * dt * (2 * std::sin(p) / p - 2 * (1 - std::cos(p)) / (p * p) - 1);
        EXPECT_NEAR(displacement_impulse(d0, end, mass, dt, d + f * dt, f * dt), static_cast<double>(effective),
                    1e-13 * static_cast<double>(m) * scale);
    }
    std::printf("[ figures  ] interface oscillator: displacement within %.1e of the closed form; aim: round-off\n",
                worst);
    EXPECT_LT(worst, 2e-15);
}

/// Exactly where the springs change (below); else to g φ²/12 and 2 (m/Δt) δ(0) φ⁴/24, see oscillator.h.
TEST(Interfaces, TheImpulseIsNearlyTheIntegralOfTheSpringsForce) {
    const auto difference = [](double displacement, double force, double phi) {
        return 1.01 * (force * dt * phi * phi / 12 + 2 * mass / dt * displacement * std::pow(phi, 4) / 24) + 1e-9;
    };
    for (const double phi : {0.05, 0.2, 0.9}) {
        const LawSpec spec = springs(LawType::linear_interface, stiffness(0.8 * phi), stiffness(phi));
        const Meeting<2> at = node({2e-4, 1e-4}, {0.01, -0.02}, {3, 2});
        const InterfaceStep<2> step = step_of(spec, at);
        const double D_t = stiffness(phi) * area, D_n = stiffness(0.8 * phi) * area;
        const Integrated t = integrate(2e-4, 0.01, 3, mass, dt, [&](double x) { return D_t * x; });
        const Integrated n = integrate(1e-4, -0.02, 2, mass, dt, [&](double x) { return D_n * x; });
        EXPECT_NEAR(step.impulse[0], t.impulse, difference(2e-4, 3, phi));
        EXPECT_NEAR(step.impulse[1], n.impulse, difference(1e-4, 2, phi));
        EXPECT_NEAR(step.energy,
                    0.5 * D_t * t.displacement * t.displacement + 0.5 * D_n * n.displacement * n.displacement, 1e-8);
    }
}

/// Starts on either side, crosses zero or not; also debonded in tension and stiffer in compression.
TEST(Interfaces, BilinearSpringsChangeWhereTheyCrossZero) {
    std::mt19937 random(2);
    std::uniform_real_distribution<double> in(-1, 1);
    int crossed = 0;
    for (int trial = 0; trial < 60; ++trial) {
        const double tension = trial % 3 == 0 ? 0 : stiffness(0.2 + 0.6 * std::abs(in(random)));
        const double compression = stiffness(0.2 + 1.2 * std::abs(in(random)));
        const double d0 = 1e-4 * in(random), d = mass * 0.05 * in(random), f = mass * 4 * in(random);
        const Meeting<2> at = node({0, d0}, {0, d}, {0, f});
        const InterfaceStep<2> step = step_of(springs(LawType::bilinear_interface, tension, 0, compression), at);
        const Integrated exact =
            integrate(d0, d, f, mass, dt, [&](double x) { return (x > 0 ? tension : compression) * area * x; });
        if (exact.displacement * d0 < 0) {
            ++crossed;
            EXPECT_NEAR(step.impulse[1], exact.impulse, 2e-6 * mass * 0.05) << trial;
        } else { // as with one spring
            const LawSpec one = springs(LawType::linear_interface, d0 > 0 ? tension : compression, 0);
            EXPECT_NEAR(step.impulse[1], step_of(one, at).impulse[1], 1e-15) << trial;
        }
    }
    EXPECT_GT(crossed, 10);
}

TEST(Interfaces, PerfectCompressionStopsWhatMeets) {
    const LawSpec spec = springs(LawType::bilinear_interface, stiffness(0.5), 0);
    // Apart, meets within the step: stays at zero with no velocity (5.141).
    const Meeting<2> meets = node({0, 1e-5}, {0, -mass * 0.1}, {0, -mass * 3});
    EXPECT_NEAR(step_of(spec, meets).impulse[1], meets.stick[1], 1e-15);
    EXPECT_NEAR(step_of(spec, meets).energy, 0, 1e-18);
    // In contact and pressed: as one, in both passes.
    Meeting<2> pressed = node({0, 0}, {0, 0}, {0, -mass * 3});
    EXPECT_EQ(step_of(spec, pressed).impulse, pressed.stick);
    pressed.second_pass = false;
    EXPECT_EQ(step_of(spec, pressed).impulse, pressed.stick);
    // In contact and pulled: the tensile springs.
    const Meeting<2> pulled = node({0, 0}, {0, 0}, {0, mass * 3});
    EXPECT_NEAR(step_of(spec, pulled).impulse[1], spring_impulse(0.5, 0, 0, mass * 3 * dt, mass, dt), 1e-15);
    // Debonded: nothing.
    EXPECT_NEAR(step_of(springs(LawType::bilinear_interface, 0, 0), pulled).impulse.norm(), 0, 1e-16);
}

TEST(Interfaces, StickWhereTheSpringsAreTooStiffForTheStep) {
    for (const double phase : {1.5, 1.7, 30.0}) {
        const LawSpec spec = springs(LawType::linear_interface, stiffness(phase), stiffness(phase));
        Meeting<2> at = node({2e-4, 1e-4}, {0.01, -0.02}, {3, 2});
        const bool sticks = phase > M_PI / 2;
        EXPECT_EQ(step_of(spec, at).impulse.isApprox(at.stick, 1e-14), sticks) << phase;
        at.second_pass = false;
        EXPECT_TRUE(step_of(spec, at).impulse.isApprox(sticks ? at.stick : Vec<2>(0, 0), 1e-14)) << phase;
    }
}

/// Steps of a node pair alone, moved as FLIP moves particles: V' = V + J, X' = X + (V + V')/2 Δt.
/// \param impulse J(δ, d)
template <class Impulse>
double energy_after(int steps, double phi, Impulse&& impulse) {
    double displacement = 1e-3, momentum = 0;
    const double D = mass * phi * phi / (dt * dt);
    const auto energy = [&] { return 0.5 * D * displacement * displacement + 0.5 * momentum * momentum / mass; };
    const double before = energy();
    for (int i = 0; i < steps; ++i) {
        const double old = momentum;
        momentum -= impulse(displacement, momentum);
        displacement += 0.5 * (old + momentum) / mass * dt;
    }
    return energy() / before;
}

/// Why the solver doesn't take the effective forces of the notes; see oscillator.h.
TEST(Interfaces, OscillationsNeitherGrowNorDecay) {
    for (const double phi : {0.1, 0.3, 1.0, 1.5}) {
        const double kappa = phi / dt;
        const int steps = static_cast<int>(50 * 2 * M_PI / phi); // 50 periods
        const LawSpec spring = springs(LawType::linear_interface, 0, stiffness(phi));
        const Cohesion linear{stiffness(phi) * 1e6 / std::exp(1), 1e6}; // so large a peak that it is linear
        const double ours = energy_after(steps, phi, [&](double x, double d) {
            return step_of(spring, node({x, 0}, {d, 0}, {0, 0})).impulse[0];
        });
        const double nonlinear = energy_after(steps, phi, [&](double x, double d) {
            return conserving_step(linear, node({x, 0}, {d, 0}, {0, 0}), x, d / mass, 0).first;
        });
        const double published = energy_after(steps, phi, [&](double x, double d) {
            return displacement_impulse(x, swing({x, d / mass}, kappa, 0, dt), mass, dt, d, 0);
        });
        const double published_nonlinear = energy_after(steps, phi, [&](double x, double d) {
            return first_order_impulse(linear, node({x, 0}, {d, 0}, {0, 0}), x, d / mass, 0);
        });
        std::printf("[ figures  ] interface oscillator, phase %.1f, energy after 50 periods: x %.4g linear, x %.4g "
                    "non-linear law; by notes (5.45) x %.3g, (5.59) x %.3g\n",
                    phi, ours, nonlinear, published, published_nonlinear);
        EXPECT_GT(ours, 1 - 1e-9);
        EXPECT_LT(ours, 4 * std::pow(std::tan(phi / 2) / phi, 2) + 1e-9) << "it swings, but stays";
        EXPECT_NEAR(nonlinear, 1, 1e-4);
        EXPECT_GT(published, 100);
        EXPECT_GT(published_nonlinear, 100);
    }
}

/// Released at rest, the displacement is δ(0) cos κt for ever, also under a constant force.
TEST(Interfaces, ThePeriodIsExact) {
    for (const double phi : {0.1, 1.0}) {
        const LawSpec spring = springs(LawType::linear_interface, 0, stiffness(phi));
        const double force = 0.3;
        const double rest = force / (stiffness(phi) * area);
        double x = rest + 1e-3, d = 0, worst = 0;
        for (int n = 1; n <= 10000; ++n) {
            const double after = d + force * dt - step_of(spring, node({x, 0}, {d, 0}, {force, 0})).impulse[0];
            x += 0.5 * (d + after) / mass * dt;
            d = after;
            worst = std::max(worst, std::abs(x - rest - 1e-3 * std::cos(n * phi)));
        }
        std::printf("[ figures  ] interface oscillator, phase %.1f: within %.1e of cos κt over 10000 steps; aim: "
                    "round-off\n",
                    phi, worst / 1e-3);
        EXPECT_LT(worst, 1e-9 * 1e-3);
    }
}

TEST(Interfaces, CohesionIsTheDerivativeOfItsEnergyAndFollowsTheMotion) {
    const Cohesion c{300, 2e-3};
    for (const double x : {-5e-3, -1e-3, 1e-4, 2e-3, 7e-3}) {
        constexpr double h = 1e-8;
        EXPECT_NEAR(c.traction(x), (c.energy(x + h) - c.energy(x - h)) / (2 * h), 1e-4);
        EXPECT_NEAR(c.slope(x), (c.traction(x + h) - c.traction(x - h)) / (2 * h), 1e-2);
    }
    EXPECT_NEAR(c.traction(2e-3), 300, 1e-10);

    LawSpec spec;
    spec.type = LawType::cohesive_interface;
    spec.strength = spec.shear_strength = 20;
    spec.opening = spec.sliding = 2e-3;
    double error[2];
    for (int half = 0; half < 2; ++half) { // of the order of Δt² over a given time
        double x = 1e-3, d = 0.02, time = 0;
        const double step = half ? dt / 8 : dt / 4;
        Vec<2> momentum(d, 0);
        while (time < 0.1 - 1e-9) {
            Meeting<2> at = node({x, 0}, momentum, {0.5, 0});
            at.dt = step;
            at.stick = momentum + Vec<2>(0.5 * step, 0);
            const Vec<2> after = at.stick - step_of(spec, at).impulse;
            x += 0.5 * step * (momentum[0] + after[0]) / mass;
            momentum = after;
            time += step;
        }
        const Integrated exact = integrate(1e-3, d, 0.5, mass, 0.1, [&](double y) {
            return area * Cohesion{20, 2e-3}.traction(y);
        });
        error[half] = std::abs(x - exact.displacement);
    }
    std::printf("[ figures  ] cohesive interface: displacement error %.2e m, %.2e m with half the step: order %.2f\n",
                error[0], error[1], std::log2(error[0] / error[1]));
    EXPECT_GT(std::log2(error[0] / error[1]), 1.7);
}

/// A node pair on a cohesive interface with springs in compression bounces for ever with the same energy.
TEST(Interfaces, CohesiveBodiesBounce) {
    LawSpec spec;
    spec.type = LawType::cohesive_interface;
    spec.strength = spec.shear_strength = 20;
    spec.opening = spec.sliding = 2e-3;
    spec.compression_stiffness = stiffness(0.1);
    double x = 1e-3, momentum = 0;
    const auto energy = [&] {
        const double stored = x > 0 ? area * Cohesion{20, 2e-3}.energy(x) : 0.5 * area * stiffness(0.1) * x * x;
        return stored + 0.5 * momentum * momentum / mass;
    };
    const double before = energy();
    double deepest = 0, lowest = 1e300, highest = 0;
    for (int i = 0; i < 2000; ++i) {
        const double after = momentum - step_of(spec, node({0, x}, {0, momentum}, {0, 0})).impulse[1];
        x += 0.5 * dt * (momentum + after) / mass;
        momentum = after;
        deepest = std::min(deepest, x);
        lowest = std::min(lowest, energy());
        highest = std::max(highest, energy());
    }
    std::printf("[ figures  ] cohesive bodies bounce 2000 steps: energy between %.4f and %.4f of that at the start\n",
                lowest / before, highest / before);
    EXPECT_LT(deepest, -1e-5);
    EXPECT_GT(lowest, (1 - 1e-9) * before);
    EXPECT_LT(highest, (1 + 1e-9) * before);
}

TEST(Interfaces, SteepCohesionSticksAndSteepSofteningDebonds) {
    LawSpec spec;
    spec.type = LawType::cohesive_interface;
    spec.strength = spec.shear_strength = stiffness(3) * 1e-4;
    spec.opening = spec.sliding = 1e-4;
    const Meeting<2> rising = node({1e-6, 1e-6}, {1e-5, 1e-5}, {0, 0});
    EXPECT_TRUE(step_of(spec, rising).impulse.isApprox(rising.stick, 1e-14));
    const Meeting<2> softening = node({1.6e-4, 1.6e-4}, {1e-5, 1e-5}, {0, 0});
    EXPECT_TRUE(step_of(spec, softening).impulse.isZero(1e-16));
}

} // namespace
