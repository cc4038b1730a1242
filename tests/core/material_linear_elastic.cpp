/// Small-strain elasticity with the rotation split off, and plane stress of all laws. Stress against energy is in
/// material_stress.cpp.

#include "support.h"

#include "material/material.h"

#include <Eigen/Dense>

namespace {

using namespace test;

constexpr double K = 2450;
constexpr double G = 940;
constexpr double lambda = K - 2.0 / 3 * G;
const LinearElastic law{lambda, G};

template <int D>
Eigen::Matrix3d tensor(const Stress<D>& s) {
    Eigen::Matrix3d t;
    if constexpr (D == 2)
        t << s[0], s[3], 0, s[3], s[1], 0, 0, 0, s[2];
    else
        t << s[0], s[3], s[5], s[3], s[1], s[4], s[5], s[4], s[2];
    return t;
}

template <int D>
void check_left_stretch(double smallest, double largest, double tolerance) {
    std::mt19937 random(1);
    for (int trial = 0; trial < 300; ++trial) {
        const Mat<D> F = stretched_and_turned<D>(random, smallest, largest);
        const Strain<D> strain = strain_of<D>(F, 0.8);
        const Eigen::Matrix3d V = tensor<D>(left_stretch(strain));
        EXPECT_LT((V * V - tensor<D>(strain.b)).norm(), tolerance * tensor<D>(strain.b).norm());
        EXPECT_GT(Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(V).eigenvalues().minCoeff(), 0)
            << "the principal root";
    }
}

TEST(LinearElastic, LeftStretchIsThePrincipalRoot) {
    check_left_stretch<2>(0.5, 2, 1e-14);
    check_left_stretch<3>(0.5, 2, 1e-14);
    check_left_stretch<2>(0.1, 8, 1e-13);
    check_left_stretch<3>(0.1, 8, 1e-12);
}

template <int D>
void check_rotations() {
    std::mt19937 random(2);
    for (int trial = 0; trial < 300; ++trial) {
        const Strain<D> strain = strain_of<D>(random_rotation<D>(random));
        EXPECT_LT(law.kirchhoff<D>(strain).norm(), 1e-12 * K);
        EXPECT_LT(law.energy<D>(strain), 1e-24 * K);
    }
}

TEST(LinearElastic, ThereIsNoStressInARotatedBody) {
    check_rotations<2>();
    check_rotations<3>();
}

/// σ = 2G ε + λ tr ε I to second order in the strain, in the frame that turns with the body.
template <int D>
void check_small_strains() {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> in(-1, 1);
    for (int trial = 0; trial < 100; ++trial) {
        const double size = 1e-6;
        Eigen::Matrix3d strain = Eigen::Matrix3d::Zero();
        for (int i = 0; i < D; ++i)
            for (int j = 0; j <= i; ++j) strain(i, j) = strain(j, i) = size * in(random);
        const Mat<D> Q = random_rotation<D>(random);
        Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
        turn.topLeftCorner<D, D>() = Q;
        const Mat<D> F = Q * Mat<D>(Mat<D>::Identity() + Mat<D>(strain.topLeftCorner<D, D>()));
        const Eigen::Matrix3d expected =
            turn * (2 * G * strain + lambda * strain.trace() * Eigen::Matrix3d::Identity()) * turn.transpose();
        const Eigen::Matrix3d found = tensor<D>(law.kirchhoff<D>(strain_of<D>(F)));
        EXPECT_LT((found - expected).norm(), 10 * K * size * size + 1e-11 * K * 1e-3);
    }
}

TEST(LinearElastic, SmallStrainsGiveHookesLaw) {
    check_small_strains<2>();
    check_small_strains<3>();
}

TEST(LinearElastic, PlaneStrainIsSpaceWithoutStretchAcross) {
    std::mt19937 random(4);
    for (int trial = 0; trial < 100; ++trial) {
        const Mat<2> F = stretched_and_turned<2>(random, 0.6, 1.6);
        Mat<3> F3 = 1.1 * Mat<3>::Identity();
        F3.topLeftCorner<2, 2>() = F;
        const Strain<2> s2 = strain_of<2>(F, 1.1);
        const Strain<3> s3 = strain_of<3>(F3);
        EXPECT_LT((tensor<2>(law.kirchhoff<2>(s2)) - tensor<3>(law.kirchhoff<3>(s3))).norm(), 1e-12 * K);
        EXPECT_NEAR(law.energy<2>(s2), law.energy<3>(s3), 1e-12 * K);
    }
}

std::vector<Law> laws() {
    return {NeoHookean{lambda, G}, NeoHookeanIsochoric{K, G}, law};
}

/// Kirchhoff stress and stretch across the plane when there is no stress across it; `guess` is that of the step before.
std::pair<Stress<2>, double> free_across(const Law& any, const Mat<2>& F, double guess = 1) {
    return std::visit(
        [&](const auto& l) {
            const double across = l.stretch_without_stress(strain_of<2>(F, guess), guess);
            return std::pair<Stress<2>, double>(l.template kirchhoff<2>(strain_of<2>(F, across)), across);
        },
        any);
}

TEST(PlaneStress, ThereIsNoStressAcrossThePlane) {
    std::mt19937 random(5);
    for (const Law& any : laws())
        for (int trial = 0; trial < 300; ++trial) {
            const bool small = trial < 200;
            const Mat<2> F =
                small ? stretched_and_turned<2>(random, 0.8, 1.25) : stretched_and_turned<2>(random, 0.5, 2);
            const auto [stress, across] = free_across(any, F, small ? 1 : 1.3);
            if (any.index() == 2 && !(across > 0.2)) continue; // small strains only
            EXPECT_GT(across, 0);
            EXPECT_LT(std::abs(stress[2]), 1e-12 * (K + stress.norm())) << "law " << any.index() << "\n" << F;
        }
}

TEST(PlaneStress, TheStretchDoesNotDependOnTheOneBefore) {
    std::mt19937 random(6);
    for (const Law& any : laws())
        for (int trial = 0; trial < 50; ++trial) {
            const Mat<2> F = stretched_and_turned<2>(random, 0.7, 1.4);
            const double a = free_across(any, F, 0.6).second;
            EXPECT_NEAR(a, free_across(any, F, 1.7).second, 1e-13 * a);
        }
}

/// The lateral stretches that leave only σ_xx, by Newton's method on τ_yy, then slopes at rest: E and ν.
TEST(PlaneStress, SmallUniaxialTensionHasYoungsModulusAndPoissonsRatio) {
    const double E = 9 * K * G / (3 * K + G);
    const double nu = (3 * K - 2 * G) / (2 * (3 * K + G));
    const double e = 1e-5;
    for (const Law& any : laws()) {
        double lateral = 0;
        const auto stress = [&](double y) {
            Mat<2> F;
            F << 1 + e, 0, 0, 1 + y;
            return free_across(any, F);
        };
        for (int i = 0; i < 20; ++i) {
            const double h = 1e-7;
            const double slope = (stress(lateral + h).first[1] - stress(lateral - h).first[1]) / (2 * h);
            lateral -= stress(lateral).first[1] / slope;
        }
        const auto [tau, across] = stress(lateral);
        EXPECT_NEAR(tau[1], 0, 1e-9 * E * e);
        EXPECT_NEAR(tau[0] / e / E, 1, 3 * e) << "law " << any.index();
        EXPECT_NEAR(-lateral / e, nu, 3 * e);
        EXPECT_NEAR(-(across - 1) / e, nu, 3 * e);
        EXPECT_NEAR(tau[3], 0, 1e-12);
    }
}

TEST(LinearElastic, MakeMaterialTurnsTheModuliIntoLames) {
    const Material m = make_material(material(3, K, G, MaterialModel::linear_elastic));
    EXPECT_NEAR(std::get<LinearElastic>(m.law).lambda, lambda, 1e-12);
    EXPECT_EQ(std::get<LinearElastic>(m.law).G, G);
    EXPECT_EQ(m.density, 3);
}

} // namespace
