#include "support.h"

#include "material/material.h"

#include <Eigen/Dense>
#include <Eigen/Eigenvalues>

namespace {

using namespace test;

constexpr double K = 2450;
constexpr double G = 940;

std::vector<Law> laws() {
    return {NeoHookean{K - 2.0 / 3 * G, G}, NeoHookeanIsochoric{K, G}, LinearElastic{K - 2.0 / 3 * G, G}};
}

/// The laws' energies written down again, in long double and three dimensions.
long double energy(const Law& law, const Eigen::Matrix<long double, 3, 3>& F) {
    const long double J = F.determinant();
    const long double I1 = (F * F.transpose()).trace();
    if (std::holds_alternative<LinearElastic>(law)) {
        // |V − I|² and tr(V − I) of the singular values of F, the principal stretches.
        const Eigen::Array<long double, 3, 1> e =
            Eigen::JacobiSVD<Eigen::Matrix<long double, 3, 3>>(F).singularValues().array() - 1;
        return G * e.square().sum() + (K - 2.0L / 3 * G) / 2 * e.sum() * e.sum();
    }
    if (std::holds_alternative<NeoHookean>(law))
        return (K - 2.0L / 3 * G) / 2 * ((J * J - 1) / 2 - std::log(J)) + G / 2.0L * (I1 - 3 - 2 * std::log(J));
    return G / 2.0L * (I1 / std::pow(J, 2.0L / 3) - 3) + K / 2.0L * ((J * J - 1) / 2 - std::log(J));
}

Mat<3> embed(const Mat<2>& F) {
    Mat<3> result = Mat<3>::Identity();
    result.topLeftCorner<2, 2>() = F;
    return result;
}

/// τ = ∂W/∂F Fᵀ by central differences of fourth order.
Mat<3> kirchhoff_by_differences(const Law& law, const Mat<3>& F) {
    Eigen::Matrix<long double, 3, 3> P;
    const long double h = 4e-5L;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
            const auto at = [&](long double step) {
                Eigen::Matrix<long double, 3, 3> moved = F.cast<long double>();
                moved(i, j) += step;
                return energy(law, moved);
            };
            P(i, j) = (8 * (at(h) - at(-h)) - (at(2 * h) - at(-2 * h))) / (12 * h);
        }
    return (P * F.cast<long double>().transpose()).cast<double>();
}

template <int D>
Stress<D> stress(const Law& law, const Mat<D>& F) {
    return std::visit([&](const auto& l) { return l.template kirchhoff<D>(strain_of<D>(F)); }, law);
}

Mat<3> tensor(const Stress<2>& s) {
    Mat<3> t;
    t << s[0], s[3], 0, s[3], s[1], 0, 0, 0, s[2];
    return t;
}
Mat<3> tensor(const Stress<3>& s) {
    Mat<3> t;
    t << s[0], s[3], s[5], s[3], s[1], s[4], s[5], s[4], s[2];
    return t;
}

TEST(Material, StressIsTheDerivativeOfTheEnergy) {
    std::mt19937 random(1);
    for (const Law& law : laws())
        for (int trial = 0; trial < 200; ++trial) {
            const double amount = trial < 100 ? 0.2 : 1.2;
            const Mat<3> F3 = random_deformation<3>(random, amount);
            const Mat<2> F2 = random_deformation<2>(random, amount);
            const Mat<3> oracle3 = kirchhoff_by_differences(law, F3);
            const Mat<3> oracle2 = kirchhoff_by_differences(law, embed(F2));
            EXPECT_LT((tensor(stress<3>(law, F3)) - oracle3).norm(), 1e-9 * (K + oracle3.norm()));
            EXPECT_LT((tensor(stress<2>(law, F2)) - oracle2).norm(), 1e-9 * (K + oracle2.norm()));
        }
}

TEST(Material, EnergyIsAsDefined) {
    std::mt19937 random(2);
    for (const Law& law : laws())
        for (int trial = 0; trial < 200; ++trial) {
            const Mat<2> F = random_deformation<2>(random, 1);
            const double W = std::visit([&](const auto& l) { return l.energy(strain_of<2>(F)); }, law);
            const double oracle = static_cast<double>(energy(law, embed(F).cast<long double>()));
            EXPECT_NEAR(W, oracle, 1e-13 * (K + std::abs(oracle)));
        }
}

TEST(Material, StressTurnsWithTheBody) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> angle(-4, 4);
    for (const Law& law : laws())
        for (int trial = 0; trial < 100; ++trial) {
            const Mat<2> F = random_deformation<2>(random, 0.8);
            const double a = angle(random);
            Mat<2> Q;
            Q << std::cos(a), -std::sin(a), std::sin(a), std::cos(a);
            const Mat<3> before = tensor(stress<2>(law, F));
            const Mat<3> after = tensor(stress<2>(law, Mat<2>(Q * F)));
            EXPECT_LT((after - embed(Q) * before * embed(Q).transpose()).norm(), 1e-13 * (K + before.norm()) * 10);
            // A turn before the deformation changes nothing: isotropy.
            EXPECT_LT((tensor(stress<2>(law, Mat<2>(F * Q))) - before).norm(), 1e-13 * (K + before.norm()) * 10);
        }
}

TEST(Material, AtRestThereIsNoStressAndTheStiffnessIsThatOfLongitudinalWaves) {
    for (const Law& law : laws()) {
        EXPECT_LT(stress<2>(law, Mat<2>::Identity()).norm(), 1e-12);
        EXPECT_LT(stress<3>(law, Mat<3>::Identity()).norm(), 1e-12);
        std::visit(
            [&](const auto& l) {
                EXPECT_NEAR(l.energy(strain_of<2>(Mat<2>::Identity())), 0, 1e-12);
                EXPECT_NEAR(l.stiffness(strain_of<2>(Mat<2>::Identity())), K + 4 * G / 3, 1e-9);
                // In three dimensions a bound.
                EXPECT_GE(l.stiffness(strain_of<3>(Mat<3>::Identity())), K + 4 * G / 3);
            },
            law);
    }
    EXPECT_NEAR(std::get<NeoHookean>(make_material(material(1, K, G, MaterialModel::neo_hookean)).law).lambda,
                K - 2 * G / 3, 1e-12);
}

/// Largest ρ0 c² over directions n and polarisations a in the plane: d²/dε² W((I + ε a⊗n) F).
double largest_acoustic(const Law& law, const Mat<2>& F) {
    double largest = 0;
    const long double h = 1e-3L;
    for (int i = 0; i < 36; ++i)
        for (int j = 0; j < 36; ++j) {
            const double at = M_PI * i / 36;
            const double an = M_PI * j / 36;
            Mat<3> direction = Mat<3>::Zero();
            direction.topLeftCorner<2, 2>() =
                Vec<2>(std::cos(at), std::sin(at)) * Vec<2>(std::cos(an), std::sin(an)).transpose();
            const auto W = [&](long double e) {
                return energy(law, (Mat<3>::Identity().cast<long double>() + e * direction.cast<long double>()) *
                                       embed(F).cast<long double>());
            };
            largest = std::max(largest, static_cast<double>((W(h) - 2 * W(0) + W(-h)) / (h * h)));
        }
    return largest;
}

TEST(Material, StiffnessBoundsTheWaveSpeedOfEveryDirection) {
    std::mt19937 random(4);
    for (const Law& law : laws())
        for (int trial = 0; trial < 60; ++trial) {
            const Mat<2> F = random_deformation<2>(random, trial < 20 ? 0.15 : 0.5);
            const double bound = std::visit([&](const auto& l) { return l.stiffness(strain_of<2>(F)); }, law);
            const double acoustic = largest_acoustic(law, F);
            EXPECT_LE(acoustic, bound * (1 + 1e-5)) << "law " << law.index() << "\n" << F;
            EXPECT_GE(acoustic, bound / 2.5) << "a bound so loose makes steps too short\n" << F;
        }
}

/// Where b differs much between directions the fastest polarisation is not along n.
TEST(Material, StiffnessBoundsTheWaveSpeedInLargeShear) {
    for (const Law& law : laws())
        for (const double shear : {1.0, 2.0, 3.0, 5.0}) {
            Mat<2> F;
            F << 1, shear, 0, 1;
            const double bound = std::visit([&](const auto& l) { return l.stiffness(strain_of<2>(F)); }, law);
            EXPECT_LE(largest_acoustic(law, F), bound * (1 + 1e-5)) << "law " << law.index() << ", shear " << shear;
        }
}

TEST(Material, InverseCubeRootSquaredIsExactToRoundOff) {
    for (int i = 0; i <= 60000; ++i) {
        const double J = std::pow(10.0, -3 + 6.0 * i / 60000);
        const long double root = std::cbrt(static_cast<long double>(J));
        const double oracle = static_cast<double>(1 / (root * root));
        ASSERT_NEAR(inverse_cube_root_squared(J) / oracle, 1, 1e-15) << J;
    }
}

TEST(WaveSpeed, AtRestIsThatOfLongitudinalWavesInAnyDimension) {
    for (const MaterialModel model :
         {MaterialModel::neo_hookean, MaterialModel::neo_hookean_isochoric, MaterialModel::linear_elastic}) {
        const MaterialSpec spec = material(2, 100, 40, model);
        const Material m = make_material(spec);
        std::visit(
            [&](const auto& law) {
                const double plane = law.template stiffness<2>(strain_of<2>(Mat<2>::Identity()));
                const double space = law.template stiffness<3>(strain_of<3>(Mat<3>::Identity()));
                EXPECT_NEAR(std::sqrt(plane / m.density), wave_speed(spec), 1e-12);
                EXPECT_NEAR(std::sqrt(space / m.density), wave_speed(spec), 1e-12);
            },
            m.law);
    }
}

TEST(WaveSpeed, BoundsOfPrincipalStretchesHoldInSpace) {
    std::mt19937 random(77);
    for (int trial = 0; trial < 200; ++trial) {
        const Mat<3> F = random_deformation<3>(random, 0.5);
        const Strain<3> strain = strain_of<3>(F);
        const Vec<3> values = Eigen::SelfAdjointEigenSolver<Mat<3>>(F * F.transpose()).eigenvalues();
        EXPECT_GE(strain.largest(), values[2] * (1 - 1e-12));
        EXPECT_LE(strain.smallest(), values[0] * (1 + 1e-12));
    }
}

} // namespace
