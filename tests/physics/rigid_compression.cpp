/// Case 11 (notes 3.4.5): a block between rigid plates that are wider than it. If the contact normal at the block's
/// corner is right, the corner particle moves sideways by Δy = ν W ε / (2 (1 − ν)), plane strain.

#include "core/support.h"

#include <cstdio>

namespace {

using namespace test;

constexpr double mm = 1e-3;
constexpr double width = 10 * mm;
constexpr double nu = 0.3;
constexpr double theory = nu * width / (2 * (1 - nu)); // Δy / ε

/// Δy / ε of the corner particle, by least squares from a strain of 0.2 % to 1 %.
double slope(NormalMethod normal, SeparationMethod separation, double cell) {
    const double E = 1e9;
    const MaterialSpec m = material(1000, E / (3 * (1 - 2 * nu)), E / (2 * (1 + nu)));
    Scene scene = plane_scene(cell, -5 * mm, -10 * mm, 15 * mm, 10 * mm, m);
    scene.method.shape = ShapeKind::ugimp;
    scene.method.transfer = transfer(TransferScheme::xpic, 2);
    scene.contact = contact(LawType::frictionless);
    scene.contact->normal = normal;
    scene.contact->separation = separation;
    scene.contact->rigid_bias = 0;
    RigidSpec moving; // begins slowly, so that no wave runs through the block
    const double speed = 0.001 * wave_speed(m);
    const double end = 2 * 0.01 * width / speed;
    moving.velocity[0] = TimeFunction({0, end}, {0, -speed});
    BodySpec declared;
    declared.rigid = moving;
    scene.bodies.push_back(declared);
    Model model;
    const int n = static_cast<int>(std::lround(2 * width / cell));
    const int plate = static_cast<int>(std::lround(32 * mm / cell));
    add_box(model, add_body(model, "block"), 0, -width / 2, width, width / 2, n, n);
    model.bodies.push_back({"left", -1, {}, RigidSpec{}});
    model.bodies.push_back({"right", -1, {}, moving});
    add_box(model, 1, -2 * cell, -8 * mm, 0, 8 * mm, 4, plate);
    add_box(model, 2, width, -8 * mm, width + 2 * cell, 8 * mm, 4, plate);
    State<2> state = make_state<2>(scene, model);
    const int corner = n * n - 1; // the last particle of the block
    double products = 0, squares = 0;
    run(state, end, [&] {
        const double strain = -moving.velocity[0].integral(state.time) / width;
        if (strain < 0.002) return;
        for (std::size_t p = 0; p < state.particles.size(); ++p) {
            if (state.particles.id[p] != corner) continue;
            products += strain * (state.particles.position[p][1] - state.initial_position[corner][1]);
            squares += strain * strain;
        }
    });
    return products / squares;
}

TEST(RigidCompression, TheCornerMovesAsTheTheorySays) {
    const double cell = 0.25 * mm; // the corner particle lies 1/8 mm... 1.25 % of the half width inside the corner
    const double inside = (width / 2 - cell / 4) / (width / 2);
    double error[2];
    int i = 0;
    for (const auto& [name, normal, separation] :
         {std::tuple{"logistic-regression, particle-edges", NormalMethod::logistic_regression,
                     SeparationMethod::particle_edges},
          std::tuple{"average-gradient, fitted-position", NormalMethod::average_gradient,
                     SeparationMethod::fitted_position}}) {
        const double s = slope(normal, separation, cell);
        error[i++] = s / (theory * inside) - 1;
        std::printf(
            "[ figures  ] rigid compression, %s: %.5f mm per %%, theory 0.02143 (at the particle's place %.5f): "
            "%+.1f %% (%+.1f %%)\n",
            name, s / mm / 100, theory * inside / mm / 100, 100 * (s / theory - 1), 100 * error[i - 1]);
    }
    EXPECT_LT(std::abs(error[0]), 0.03);
    EXPECT_LT(std::abs(error[0]), std::abs(error[1]));
}

} // namespace
