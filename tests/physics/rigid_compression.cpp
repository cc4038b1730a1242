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

/// Δy / ε of the corner particle on the moving plate, by least squares from a strain of 0.2 % to 1 %; half the
/// difference of both corners, since the block may slide along the plates as a whole.
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
    double products = 0, squares = 0;
    run(state, end, [&] {
        const double strain = -moving.velocity[0].integral(state.time) / width;
        if (strain < 0.002) return;
        double bulge = 0;
        for (std::size_t p = 0; p < state.particles.size(); ++p) {
            const int id = state.particles.id[p];
            if (id == n * n - 1) bulge += state.particles.position[p][1] - state.initial_position[id][1];
            if (id == n - 1) bulge -= state.particles.position[p][1] - state.initial_position[id][1];
        }
        products += strain * 0.5 * bulge;
        squares += strain * strain;
    });
    return products / squares;
}

TEST(RigidCompression, TheCornerMovesAsTheTheorySays) {
    for (const double cell : {0.5 * mm, 0.25 * mm}) {
        const double inside = (width / 2 - cell / 4) / (width / 2); // where the corner particle's centre is
        for (const auto& [name, normal, separation] :
             {std::tuple{"logistic-regression", NormalMethod::logistic_regression, SeparationMethod::particle_edges},
              std::tuple{"linear-regression", NormalMethod::linear_regression, SeparationMethod::particle_edges},
              std::tuple{"average-gradient", NormalMethod::average_gradient, SeparationMethod::particle_edges}}) {
            const double s = slope(normal, separation, cell);
            const double error = s / theory - 1;
            std::printf("[ figures  ] rigid compression, cells %.2f mm, %s: %.5f mm per %%, theory 0.02143: "
                        "%+.1f %% (at the particle's place %.5f)\n",
                        cell / mm, name, s / mm / 100, 100 * error, theory * inside / mm / 100);
            if (normal == NormalMethod::logistic_regression) {
                EXPECT_LT(std::abs(error), cell > 0.3 * mm ? 0.03 : 0.04);
            } else {
                EXPECT_GT(std::abs(error), 0.1);
            }
        }
    }
}

} // namespace
