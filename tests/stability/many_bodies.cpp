/// Two thousand grains, each its own body: memory and time follow the slots in use, and bodies that never touch cost no
/// contact.

#include "core/support.h"

#include <chrono>
#include <cstdio>

namespace {

using namespace test;

/// Square grains of n × n particles on a lattice, `gap` cells between neighbours; every one a body of its own, or all
/// one.
State<2> grains(int per_side, int n, double gap, bool own_bodies) {
    const double size = n / 2.0; // 2 particles a cell
    const double pitch = size + gap;
    Scene scene =
        plane_scene(1, 0, 0, std::ceil(per_side * pitch) + 4, std::ceil(per_side * pitch) + 4, material(1, 1000, 400));
    scene.method.shape = ShapeKind::ugimp;
    if (own_bodies) scene.contact = contact(LawType::friction, 0.3);
    Model model;
    int body = own_bodies ? -1 : add_body(model, "all");
    for (int j = 0; j < per_side; ++j)
        for (int i = 0; i < per_side; ++i) {
            if (own_bodies)
                body = add_body(model, std::to_string(j * per_side + i), {0.02 * std::sin(i), 0.02 * std::cos(j), 0});
            const double x = 2 + i * pitch, y = 2 + j * pitch;
            add_box(model, body, x, y, x + size, y + size, n, n);
        }
    return make_state<2>(scene, model);
}

double seconds_of(State<2>& state, int steps) {
    auto tasks = step_tasks<2>(state.scene);
    const auto start = std::chrono::steady_clock::now();
    for (int s = 0; s < steps; ++s) {
        state.dt = next_step(state, 1e9);
        advance(state, tasks);
    }
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

TEST(ManyBodies, ApartTheyCostNoContact) {
    State<2> own = grains(45, 5, 3.5, true);
    State<2> one = grains(45, 5, 3.5, false);
    EXPECT_EQ(own.bodies.size(), 2025U);
    const double of_own = seconds_of(own, 20), of_one = seconds_of(one, 20);
    EXPECT_TRUE(own.fields.contact_nodes.empty());
    EXPECT_TRUE(own.contact.groups.empty() && own.contact.points.empty());
    EXPECT_EQ(own.contact.cloud_particles.size(), 0U);
    EXPECT_TRUE(own.pair_totals.empty());
    std::printf(
        "[ figures  ] 2025 grains apart: %.0f ns a particle and step as bodies, %.0f as one body; slots %zu and "
        "%zu\n",
        1e9 * of_own / (20.0 * own.particles.size()), 1e9 * of_one / (20.0 * one.particles.size()), own.fields.size(),
        one.fields.size());
    // Windows of tiles are boxes: a body of its own has them to itself.
    EXPECT_LE(own.fields.size(), 1.5 * one.fields.size());
}

TEST(ManyBodies, PackedTheyCollideAndKeepTheirMomentum) {
    State<2> state = grains(45, 5, 0, true);
    prepare(state);
    const Totals before = totals(state);
    const double seconds = seconds_of(state, 100);
    const Totals after = totals(state);
    EXPECT_GT(state.pair_totals.size(), 2 * 45U * 44U * 9 / 10) << "nearly all neighbours have met";
    for (int a = 0; a < 2; ++a) EXPECT_NEAR(after.momentum[a], before.momentum[a], 1e-11 * before.mass * 0.02);
    EXPECT_LE(after.kinetic_energy + after.strain_energy, before.kinetic_energy * 1.001);
    const double slots = static_cast<double>(state.fields.size());
    std::printf("[ figures  ] 2025 grains in contact: %zu pairs, %.0f slots, %.1f a particle, %.0f ns a particle and "
                "step\n",
                state.pair_totals.size(), slots, slots / static_cast<double>(state.particles.size()),
                1e9 * seconds / (100.0 * static_cast<double>(state.particles.size())));
    EXPECT_LT(slots, 3.0 * static_cast<double>(state.particles.size()));
}

/// Twice the grains, twice the slots and contact nodes.
TEST(ManyBodies, CostGrowsWithTheSlotsInUse) {
    State<2> small = grains(22, 5, 0, true), large = grains(44, 5, 0, true);
    const double of_small = seconds_of(small, 20) / 20, of_large = seconds_of(large, 20) / 20;
    const double slots = static_cast<double>(large.fields.size()) / static_cast<double>(small.fields.size());
    const double nodes =
        static_cast<double>(large.contact.groups.size()) / static_cast<double>(small.contact.groups.size());
    std::printf("[ figures  ] 484 and 1936 grains: slots x %.2f, contact nodes x %.2f, time of a step x %.2f\n", slots,
                nodes, of_large / of_small);
    EXPECT_NEAR(slots, 4, 0.4);
    EXPECT_NEAR(nodes, 4, 0.4);
}

} // namespace
