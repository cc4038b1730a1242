/// Laws for the sliding traction S_slide(N, v) and adhesion (contact paper Eq. 8-10).

#include "support.h"

#include "contact/law/contact_law.h"

namespace {

using namespace test;

constexpr double area = 0.3;
constexpr double dt = 0.02;

/// Body a under pressure N (tension if negative) with a sliding velocity v of b to a that would be there without
/// contact.
Meeting<2> meeting(double pressure, double sliding, double mass = 2) {
    Meeting<2> at;
    at.normal = {0, 1};
    at.mass = mass;
    at.dt = dt;
    at.area = area;
    at.cell = 1;
    at.separation = -0.01;
    at.second_pass = true;
    at.stick = {mass * sliding, -pressure * area * dt};
    return at;
}

/// Sliding velocity of b to a that an impulse leaves.
double left(const Meeting<2>& at, const Vec<2>& impulse) {
    return (at.stick[0] - impulse[0]) / at.mass;
}

LawSpec law(LawType type, double coefficient) {
    LawSpec spec;
    spec.type = type;
    spec.coefficient = coefficient;
    return spec;
}

Vec<2> impulse_of(const LawSpec& spec, const Meeting<2>& at) {
    return apply_law<2>(make_contact_law(spec), at).impulse;
}

TEST(SlideLaws, StaticFrictionHoldsAndKineticFrictionSlides) {
    LawSpec spec = law(LawType::friction, 0.2);
    spec.static_coefficient = 0.5;
    const double N = 1000;
    const double holds = 0.5 * N * area * dt / 2; // sliding velocity that the static limit can just stop
    EXPECT_NEAR(left(meeting(N, 0.999 * holds), impulse_of(spec, meeting(N, 0.999 * holds))), 0, 1e-14);
    const Meeting<2> beyond = meeting(N, 1.001 * holds);
    EXPECT_NEAR(impulse_of(spec, beyond)[0], 0.2 * N * area * dt, 1e-12) << "kinetic at once";
    EXPECT_NEAR(impulse_of(spec, beyond)[1], -N * area * dt, 1e-12);

    // With a decay velocity: 2 k = d − µ(k) N A Δt at the speed that is left.
    spec.decay_velocity = 0.7;
    for (const double v : {1.2 * holds, 2 * holds, 10 * holds}) {
        const Meeting<2> at = meeting(N, v);
        const double k = left(at, impulse_of(spec, at));
        const double mu = 0.2 + 0.3 * std::exp(-k / 0.7);
        EXPECT_GT(k, 0);
        EXPECT_NEAR(at.mass * k, at.stick[0] - mu * N * area * dt, 1e-12 * at.stick[0]);
    }
}

TEST(SlideLaws, FrictionIsTheSameWhateverAreaAndTimeStep) {
    Meeting<2> at = meeting(800, 3);
    const Vec<2> impulse = impulse_of(law(LawType::friction, 0.3), at);
    at.area *= 7;
    at.dt *= 3;
    EXPECT_EQ(impulse, impulse_of(law(LawType::friction, 0.3), at));
}

TEST(SlideLaws, AViscousFilmHasTheImplicitSolution) {
    LawSpec spec = law(LawType::viscous_friction, 0.1);
    spec.viscosity = 400;
    for (const double v : {0.05, 0.5, 5.0, -5.0}) {
        const Meeting<2> at = meeting(1000, v);
        // m k = m v − (µ N + η k) A Δt
        const double k = std::max(0.0, (2 * std::abs(v) - 0.1 * 1000 * area * dt) / (2 + 400 * area * dt));
        EXPECT_NEAR(left(at, impulse_of(spec, at)), std::copysign(k, v), 1e-13);
    }
    // What a film carries is a force of the step: nothing of it in the first pass.
    Meeting<2> first = meeting(1000, 5);
    first.second_pass = false;
    EXPECT_NEAR(impulse_of(spec, first)[0], 0.1 * 1000 * area * dt, 1e-13);
    // Stiff films stop the sliding and never turn it round.
    spec.viscosity = 1e12;
    const Meeting<2> at = meeting(1000, 5);
    EXPECT_GE(left(at, impulse_of(spec, at)), 0);
    EXPECT_LT(left(at, impulse_of(spec, at)), 1e-8);
}

/// A law of a user's own: one struct.
struct Rising {
    static constexpr bool needs_area = true;
    double slide(double N, double k) const { return N * (0.1 + std::sqrt(k)) + 50 * k * k; }
};

TEST(SlideLaws, AnyLawIsSolvedForTheSpeedThatIsLeft) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> logarithm(-6, 6);
    int slid = 0;
    for (int trial = 0; trial < 500; ++trial) {
        const Meeting<2> at = meeting(std::exp(logarithm(random)), std::exp(logarithm(random)));
        const Vec<2> impulse = law_impulse(Rising{}, at);
        const double k = left(at, impulse);
        const double N = at.compression() / (area * dt);
        EXPECT_GE(k, 0);
        if (k > 0) {
            ++slid;
            EXPECT_NEAR(impulse[0], Rising{}.slide(N, k) * area * dt, 1e-11 * at.stick[0]);
        } else {
            EXPECT_GE(Rising{}.slide(N, 0) * area * dt, at.stick[0] * (1 - 1e-12));
        }
    }
    EXPECT_GT(slid, 100);
}

TEST(SlideLaws, AdhesionHoldsUpToItsStrengths) {
    LawSpec spec = law(LawType::adhesion, 0.4);
    spec.strength = 500;
    spec.shear_strength = 200;
    const auto shear = [](double S) { return S * area * dt / 2; }; // sliding velocity for a traction
    const auto holds = [&](double N, double S) {
        const Meeting<2> at = meeting(N, shear(S));
        return impulse_of(spec, at) == at.stick;
    };
    EXPECT_TRUE(holds(-499, 0));
    EXPECT_FALSE(holds(-501, 0));
    EXPECT_TRUE(holds(0, 199));
    EXPECT_FALSE(holds(0, 201));
    EXPECT_TRUE(holds(-300, 0.99 * 160)) << "(3/5)² + (4/5)² = 1";
    EXPECT_FALSE(holds(-300, 1.01 * 160));
    EXPECT_TRUE(holds(1000, 199 + 400)) << "friction helps under pressure";
    EXPECT_FALSE(holds(1000, 201 + 400));

    // Failed: nothing in tension, friction under pressure.
    EXPECT_TRUE(impulse_of(spec, meeting(-501, 0)).isZero(0));
    EXPECT_NEAR(impulse_of(spec, meeting(1000, shear(900)))[0], 400 * area * dt, 1e-12);
    // Out of reach: nothing; a hair apart: held.
    Meeting<2> apart = meeting(-100, 0);
    apart.separation = 0.05;
    EXPECT_EQ(impulse_of(spec, apart), apart.stick);
    apart.separation = 0.11;
    EXPECT_TRUE(impulse_of(spec, apart).isZero(0));
}

TEST(SlideLaws, SoftenedContactPushesByItsSprings) {
    LawSpec spec = law(LawType::friction, 0.25);
    spec.contact_stiffness = 5;
    Meeting<2> at = meeting(0, 3);
    at.second_pass = true;
    at.separation_at_start = -1e-3;
    at.start = at.stick;
    // Slow springs: the impulse is D_c times overlap, area and time.
    EXPECT_NEAR(impulse_of(spec, at)[1], -5 * 1e-3 * area * dt, 2e-3 * 5 * 1e-3 * area * dt);
    EXPECT_NEAR(impulse_of(spec, at)[0], 0.25 * -impulse_of(spec, at)[1], 1e-15);
    at.separation_at_start = 1e-3;
    EXPECT_TRUE(impulse_of(spec, at).isZero(0)) << "apart";
    at.second_pass = false;
    at.separation_at_start = -1e-3;
    EXPECT_TRUE(impulse_of(spec, at).isZero(0)) << "forces belong to the second pass";
    // Too stiff for the step: contact as ever.
    spec.contact_stiffness = 1e9;
    const Meeting<2> hard = meeting(1000, 3);
    EXPECT_EQ(impulse_of(spec, hard), impulse_of(law(LawType::friction, 0.25), hard));
}

} // namespace
