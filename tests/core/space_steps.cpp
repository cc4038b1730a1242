/// Runs in three dimensions: slots, threads, momentum.

#include "dense.h"

#include <map>
#include <omp.h>
#include <set>

namespace {

using namespace test;

/// Two bodies of random particles all over a box.
State<3> cloud(ShapeKind shape, TransferSpec t, bool with_contact) {
    Scene scene = space_scene(1, 0, 17, material(2, 100, 40));
    scene.method.shape = shape;
    scene.method.transfer = t;
    if (with_contact) scene.contact = contact(LawType::friction, 0.3);
    std::mt19937 random(1);
    std::uniform_real_distribution<double> in(0, 1);
    Model model;
    add_body(model, "a");
    add_body(model, "b");
    for (int p = 0; p < 1500; ++p)
        add_particle(model, p % 2, Vector{1.5 + 14 * in(random), 1.5 + 14 * in(random), 1.5 + 14 * in(random)},
                     Vector{0.2, 0.25, 0.3});
    State<3> state = make_state<3>(scene, model);
    for (std::size_t p = 0; p < state.particles.size(); ++p) {
        state.particles.velocity[p] = Vec<3>(in(random)-0.5, in(random)-0.5, in(random)-0.5);
        Mat<3>& F = state.particles.deformation_gradient[p];
        F = random_deformation<3>(random, 0.15);
        state.particles.stress[p] = std::visit(
            [&](const auto& law) { return law.template kirchhoff<3>(strain_of<3>(F)); }, state.materials[0].law);
    }
    return state;
}

TEST(Space, SlotsAreThoseOfTheWindowsBlockByBlockNodeByNode) {
    for (const ShapeKind shape : {ShapeKind::ugimp, ShapeKind::b2cpdi})
        for (const bool with_contact : {false, true}) {
            State<3> state = cloud(shape, transfer(TransferScheme::flip), with_contact);
            find_velocity_fields(state);
            std::set<std::tuple<int, int, int, Index<3>>> expected; // block, place in it, field, node
            for (const auto& tile : state.tiling.tiles)
                for_each_node(tile.window, [&](const Index<3>& n) {
                    expected.insert({state.grid.block_number({n[0] / 4, n[1] / 4, n[2] / 4}),
                                     n[2] % 4 * 16 + n[1] % 4 * 4 + n[0] % 4, tile.field, n});
                });
            ASSERT_EQ(state.fields.size(), expected.size());
            const auto nodes = slot_nodes(state.fields);
            std::size_t slot = 0;
            for (const auto& [block, place, field, node] : expected) {
                EXPECT_EQ(nodes[slot], node);
                EXPECT_EQ(state.fields.field[slot], field);
                ++slot;
            }
            for (const auto& tile : state.tiling.tiles)
                for_each_node(tile.window, [&](const Index<3>& n) {
                    const int at = state.fields.table[tile.slots + tile.window.local(n)];
                    EXPECT_EQ(nodes[at], n);
                    EXPECT_EQ(state.fields.field[at], tile.field);
                });
            EXPECT_EQ(state.fields.contact_nodes.empty(), !with_contact);
        }
}

TEST(Space, BlocksOfAColourShareNoNodeAndTilesHoldOneBlockOfParticles) {
    State<3> state = cloud(ShapeKind::b2cpdi, transfer(TransferScheme::flip), true);
    find_velocity_fields(state);
    std::size_t coloured = 0;
    for (const auto& colour : state.tiling.colours) {
        std::map<Index<3>, std::int32_t> owner;
        for (const std::int32_t b : colour) {
            ++coloured;
            for (int t = state.tiling.blocks[b].first; t < state.tiling.blocks[b].last; ++t)
                for_each_node(state.tiling.tiles[t].window,
                              [&](const Index<3>& n) { EXPECT_EQ(owner.emplace(n, b).first->second, b); });
        }
    }
    EXPECT_EQ(coloured, state.tiling.blocks.size());
    EXPECT_GT(coloured, 50u);
    EXPECT_GT(coloured, 2 * state.tiling.colours.size());
    std::int32_t next = 0;
    for (const auto& tile : state.tiling.tiles) {
        EXPECT_EQ(tile.first, next);
        next = tile.last;
        for (int p = tile.first; p < tile.last; ++p) {
            const Vec<3> x = state.grid.lattice_position(state.particles.position[p]);
            EXPECT_EQ(tile.block, state.grid.block_number({int(x[0]) / 4, int(x[1]) / 4, int(x[2]) / 4}));
            EXPECT_EQ(state.particles.body[p], tile.body);
        }
    }
    EXPECT_EQ(next, 1500);
}

Vec<3> momentum(const Particles<3>& particles) {
    Vec<3> sum = Vec<3>::Zero();
    for (std::size_t p = 0; p < particles.size(); ++p) sum += particles.mass[p] * particles.velocity[p];
    return sum;
}

TEST(Space, OneStepKeepsMomentumAndIsTheSameForAnyNumberOfThreads) {
    const int threads = omp_get_max_threads();
    for (const TransferScheme scheme : {TransferScheme::flip, TransferScheme::fmpm})
        for (const bool with_contact : {false, true}) {
            std::vector<Particles<3>> results;
            for (const int n : {1, 2, 3}) {
                omp_set_num_threads(n);
                State<3> state = cloud(ShapeKind::cpdi, transfer(scheme, 3), with_contact);
                const Vec<3> before = momentum(state.particles);
                state.dt = 0.01;
                auto tasks = step_tasks<3>(state.scene);
                advance(state, tasks);
                EXPECT_LT((momentum(state.particles) - before).norm(), 1e-13 * 1500);
                results.push_back(state.particles);
            }
            omp_set_num_threads(threads);
            for (const Particles<3>& other : results) {
                EXPECT_EQ(other.id, results[0].id);
                EXPECT_EQ(other.velocity, results[0].velocity);
                EXPECT_EQ(other.position, results[0].position);
                EXPECT_EQ(other.stress, results[0].stress);
                EXPECT_EQ(other.deformation_gradient, results[0].deformation_gradient);
            }
            const State<3> start = cloud(ShapeKind::cpdi, transfer(scheme, 3), with_contact);
            double moved = 0;
            for (std::size_t p = 0; p < results[0].size(); ++p)
                moved += (results[0].velocity[p] - start.particles.velocity[results[0].id[p]]).norm();
            EXPECT_GT(moved, 1) << "something happened";
        }
}

/// A body with λ = 0 that is uniform along z, moving in the plane: without stress across the plane every layer of nodes
/// moves as the nodes in plane strain do, exactly.
template <int D>
State<D> spinning_block(ShapeKind shape, TransferSpec t, StressUpdate update) {
    const MaterialSpec m = material(1, 2.0 / 3 * 40, 40, MaterialModel::neo_hookean);
    Scene scene = D == 2 ? plane_scene(0.5, 0, 0, 6, 6, m) : space_scene(0.5, 0, 6, m);
    scene.method.shape = shape;
    scene.method.transfer = t;
    scene.method.stress_update = update;
    scene.time.step = 0.004;
    scene.gravity = {0.1, -1, 0};
    add_wall(scene, "floor", 1, Side::lower, 1.6, 0.05, false);
    Model model;
    const int a = add_body(model, "a", {0.8, 0.3, 0});
    model.bodies[a].velocity.gradient = {Vector{0, -1, 0}, Vector{1, 0, 0}, Vector{}};
    model.bodies[a].velocity.center = {2.1, 2.2, 0};
    for (int layer = 0; layer < (D == 3 ? 3 : 1); ++layer)
        for (int j = 0; j < 5; ++j)
            for (int i = 0; i < 6; ++i)
                add_particle(model, a, Vector{1.4 + 0.25 * i, 1.7 + 0.25 * j, D == 3 ? 2.2 + 0.25 * layer : 0},
                             Vector{0.125, 0.125, D == 3 ? 0.125 : 0});
    return make_state<D>(scene, model);
}

TEST(Space, AnExtrudedBodyWithoutPoissonEffectMovesAsInThePlane) {
    for (const ShapeKind shape : all_shapes)
        for (const TransferSpec& t : {transfer(TransferScheme::flip), transfer(TransferScheme::xpic, 3),
                                      transfer(TransferScheme::fmpm, 2, PositionUpdate::mean_velocity)})
            for (const StressUpdate update : {StressUpdate::usl, StressUpdate::usavg_plus}) {
                State<2> plane = spinning_block<2>(shape, t, update);
                State<3> space = spinning_block<3>(shape, t, update);
                run(plane, 0.12);
                run(space, 0.12);
                ASSERT_EQ(plane.step, space.step);
                std::vector<int> in_plane(30);
                for (int p = 0; p < 30; ++p) in_plane[plane.particles.id[p]] = p;
                double strain = 0;
                for (int q = 0; q < 90; ++q) {
                    const int p = in_plane[space.particles.id[q] % 30];
                    const Vec<3> x = space.particles.position[q];
                    const Stress<2>& s = plane.particles.stress[p];
                    EXPECT_LT((x.head<2>() - plane.particles.position[p]).norm(), 1e-12) << name_of(shape);
                    EXPECT_NEAR(x[2], 2.2 + 0.25 * (space.particles.id[q] / 30), 1e-12);
                    EXPECT_LT((space.particles.velocity[q].head<2>() - plane.particles.velocity[p]).norm(), 1e-10);
                    EXPECT_LT((space.particles.stress[q].head<4>() - s).norm(), 1e-8);
                    strain = std::max(strain, s.norm());
                }
                EXPECT_GT(strain, 0.1) << "the floor has been hit";
            }
}

/// A cube in free flight and turning, over many blocks: centre and momentum as of a rigid body.
TEST(Space, ACubeFliesAndTurnsAcrossTheGrid) {
    double lost = 1;
    for (const double cell : {0.5, 0.25}) {
        Scene scene = space_scene(cell, 0, 6, material(1, 100, 40));
        scene.method.shape = ShapeKind::cpdi;
        Model model;
        const int a = add_body(model, "a", {1, 0.5, 0.7});
        model.bodies[a].velocity.gradient = {Vector{0, -1, 0.5}, Vector{1, 0, 0}, Vector{-0.5, 0, 0}};
        model.bodies[a].velocity.center = {2.5, 2.5, 2.5};
        add_cube(model, a, {1.5, 1.5, 1.5}, 2, static_cast<int>(std::lround(4 / cell)));
        State<3> state = make_state<3>(scene, model);
        prepare(state);
        const Totals before = totals(state);
        run(state, 0.5);
        const Totals after = totals(state);
        for (int i = 0; i < 3; ++i) {
            EXPECT_NEAR(after.momentum[i], before.momentum[i], 1e-12 * after.mass);
            EXPECT_NEAR(after.center()[i], 2.5 + 0.5 * before.mean_velocity()[i], 1e-12);
        }
        const double energy = (after.kinetic_energy + after.strain_energy) / before.kinetic_energy;
        std::printf("[ figures  ] cube of %.0f cells an edge turned by half a radian: energy %.4f, spin %.4f\n",
                    2 / cell, energy, after.angular_velocity_z() / before.angular_velocity_z());
        EXPECT_NEAR(energy, 1, 0.04);
        EXPECT_LT(std::abs(1 - energy), lost);
        lost = std::abs(1 - energy);
    }
}

} // namespace
