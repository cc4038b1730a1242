/// Bodies with a stress at time 0: it turns with the material, derives from an energy, and relaxes as it should.
#include "material/prestress.h"

#include "support.h"

#include <Eigen/Dense>

#include <cstdio>
#include <numbers>

namespace {

using namespace test;

template <int D>
Stress<D> random_stress(std::mt19937& engine) {
    std::uniform_real_distribution<double> uniform(-1, 1);
    Stress<D> s;
    for (int c = 0; c < static_cast<int>(s.size()); ++c) s[c] = uniform(engine);
    return s;
}

template <int D>
Mat<D> random_gradient(std::mt19937& engine) {
    std::uniform_real_distribution<double> uniform(-0.3, 0.3);
    Mat<D> F = Mat<D>::Identity();
    for (int i = 0; i < D; ++i)
        for (int j = 0; j < D; ++j) F(i, j) += uniform(engine);
    return F;
}

/// τ = ∂W/∂F Fᵀ, by central differences of the energy.
template <int D>
void expect_stress_is_derivative() {
    std::mt19937 engine(3);
    for (int round = 0; round < 50; ++round) {
        const Stress<D> S = random_stress<D>(engine);
        const Mat<D> F = random_gradient<D>(engine);
        Mat<D> P;
        for (int i = 0; i < D; ++i)
            for (int j = 0; j < D; ++j) {
                Mat<D> more = F, less = F;
                more(i, j) += 1e-5;
                less(i, j) -= 1e-5;
                P(i, j) = (prestress_energy<D>(S, more, 1.2) - prestress_energy<D>(S, less, 1.2)) / 2e-5;
            }
        const Mat<D> expected = P * F.transpose();
        EXPECT_LT((matrix_of<D>(pushed_forward<D>(S, F, 1.2)) - expected).norm(), 1e-9);
    }
}

TEST(Prestress, StressIsTheDerivativeOfTheEnergy) {
    expect_stress_is_derivative<2>();
    expect_stress_is_derivative<3>();
}

TEST(Prestress, TurnsWithTheMaterialAndCostsNoEnergyThen) {
    std::mt19937 engine(4);
    for (int round = 0; round < 20; ++round) {
        const Stress<3> S = random_stress<3>(engine);
        const Mat<3> R = Eigen::Quaterniond::UnitRandom().toRotationMatrix();
        const Mat<3> expected = R * matrix_of<3>(S) * R.transpose();
        EXPECT_LT((matrix_of<3>(pushed_forward<3>(S, R, 1)) - expected).norm(), 1e-14);
        EXPECT_NEAR(prestress_energy<3>(S, R, 1), 0, 1e-15);
    }
    Stress<2> plane = Stress<2>::Zero();
    plane[2] = 5; // across the plane
    EXPECT_DOUBLE_EQ(pushed_forward<2>(plane, Mat<2>::Identity(), 1.1)[2], 5 * 1.21);
    EXPECT_DOUBLE_EQ(prestress_energy<2>(plane, Mat<2>::Identity(), 1.1), 5 * (1.21 - 1) / 2);
}

Model stressed_block(double angle) {
    Model model;
    const int body = add_body(model, "block");
    model.bodies[0].stress = {3e3, -1e3, 500, 700, 0, 0};
    add_box(model, body, -0.5, -0.25, 0.5, 0.25, 20, 10);
    if (angle != 0) model.angle.assign(model.size(), angle);
    return model;
}

TEST(Prestress, IsTheStressAtTheStartAlsoOfTurnedDomains) {
    const Scene scene = plane_scene(0.1, -1, -1, 1, 1, material(1000, 2e6, 1e6));
    for (const double angle : {0.0, 0.4}) {
        State<2> state = make_state<2>(scene, stressed_block(angle));
        for (std::size_t p = 0; p < state.particles.size(); ++p) {
            EXPECT_EQ(state.particles.stress[p], (Stress<2>{3e3, -1e3, 500, 700}));
            const Stress<2> pushed =
                pushed_forward<2>(state.particles.prestress[p], state.particles.deformation_gradient[p], 1);
            EXPECT_LT((pushed - state.particles.stress[p]).norm(), 1e-9);
        }
        EXPECT_NEAR(totals(state).strain_energy, 0, 1e-12);
    }
}

TEST(Prestress, OfOthersIsNotStored) {
    Model model;
    add_box(model, add_body(model, "block"), -0.5, -0.25, 0.5, 0.25, 20, 10);
    EXPECT_TRUE(
        make_state<2>(plane_scene(0.1, -1, -1, 1, 1, material(1000, 2e6, 1e6)), model).particles.prestress.empty());
}

/// A bar in tension that lets go: it shrinks by T (1 − ν²)/E (plane strain, free sides) and ends without stress.
TEST(Prestress, RelaxesToTheStressFreeLength) {
    Scene scene = plane_scene(0.1, -1, -1, 1, 1, material(1000, 2e6, 1e6, MaterialModel::linear_elastic));
    scene.method.transfer = transfer(TransferScheme::pic);
    Model model = stressed_block(0);
    constexpr double T = 2e3;
    model.bodies[0].stress = {T, 0, 0, 0, 0, 0};
    State<2> state = make_state<2>(scene, model);
    run(state, 0.4);
    const double E = 9 * 2e6 * 1e6 / (3 * 2e6 + 1e6), nu = (3 * 2e6 - 2e6) / (2 * (3 * 2e6 + 1e6));
    double left = 1, right = -1, largest = 0;
    for (std::size_t p = 0; p < state.particles.size(); ++p) {
        left = std::min(left, state.particles.position[p][0]);
        right = std::max(right, state.particles.position[p][0]);
        largest = std::max(largest, std::abs(state.particles.stress[p][0]));
    }
    const double shrunk = 1 - (right - left) / 0.95;
    std::printf("shrinks by %.4e (%.4e), stress left %.1e of %.0e\n", shrunk, T * (1 - nu * nu) / E, largest, T);
    EXPECT_NEAR(shrunk / (T * (1 - nu * nu) / E), 1, 0.01);
    EXPECT_LT(largest, 0.02 * T);
}

/// The same without damping: momentum stays 0 and strain energy becomes kinetic and comes back.
TEST(Prestress, ConservesEnergy) {
    Scene scene = plane_scene(0.05, -1, -1, 1, 1, material(1000, 2e6, 1e6));
    scene.method.stress_update = StressUpdate::usavg_plus;
    scene.time.cfl = 0.2;
    State<2> state = make_state<2>(scene, stressed_block(0));
    double most_kinetic = 0, worst = 0;
    while (state.time < 0.05) {
        run(state, state.time + 0.0005);
        const Totals all = totals(state);
        most_kinetic = std::max(most_kinetic, all.kinetic_energy);
        worst = std::max(worst, std::abs(all.kinetic_energy + all.strain_energy));
        EXPECT_NEAR(all.momentum[0], 0, 1e-9);
        EXPECT_NEAR(all.momentum[1], 0, 1e-9);
    }
    std::printf("kinetic energy up to %.3e J, energy made or lost at most %.2e of it\n", most_kinetic,
                worst / most_kinetic);
    EXPECT_GT(most_kinetic, 0.3);
    EXPECT_LT(worst, 0.05 * most_kinetic);
}

} // namespace
