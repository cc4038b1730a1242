#include "dense.h"

#include "grid/parallel.h"
#include "particles/sort.h"
#include "shape/dispatch.h"

#include <map>
#include <numeric>
#include <set>

namespace {

using namespace test;

/// Five bodies of random particles all over the grid, some bodies thin, some stretched.
State<2> cloud_state(ShapeKind shape, bool with_contact, int seed, double stretch = 0.5) {
    Scene scene = plane_scene(1, 0, 0, 23, 17, material(1, 10, 3));
    scene.method.shape = shape;
    if (with_contact) scene.contact = contact(LawType::frictionless);
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> in(0, 1);
    Model model;
    for (const char* name : {"a", "b", "c", "d", "e"}) add_body(model, name);
    for (int i = 0; i < 400; ++i) {
        const int body = static_cast<int>(5 * in(random)*in(random));
        add_particle(model, body, 1.5 + 20 * in(random), 1.5 + 14 * in(random), 0.1 + 0.3 * in(random), 0.25);
    }
    State<2> state = make_state<2>(scene, model);
    for (std::size_t p = 0; p < state.particles.size(); ++p) {
        state.particles.deformation_gradient[p] = random_deformation<2>(random, stretch);
        state.particles.velocity[p] = Vec<2>(in(random), -in(random));
    }
    return state;
}

/// Every (node, field) of every tile's window, and the node's number in the order that the slots promise.
using NodeAndField = std::tuple<int, int, int, int, int>; // block, local, field, node

std::set<NodeAndField> brute_force_slots(const State<2>& state) {
    std::set<NodeAndField> all;
    for (const auto& tile : state.tiling.tiles)
        for (int j = tile.window.lower[1]; j <= tile.window.upper[1]; ++j)
            for (int i = tile.window.lower[0]; i <= tile.window.upper[0]; ++i)
                all.insert({state.grid.block_number({i / 4, j / 4}), j % 4 * 4 + i % 4, tile.field, i, j});
    return all;
}

class Slots : public testing::TestWithParam<std::tuple<ShapeKind, bool>> {};

TEST_P(Slots, AreNumberedByBlockNodeAndField) {
    const auto [shape, with_contact] = GetParam();
    for (int seed = 0; seed < 5; ++seed) {
        State<2> state = cloud_state(shape, with_contact, seed);
        find_velocity_fields(state);
        const auto expected = brute_force_slots(state);
        ASSERT_EQ(state.fields.size(), expected.size());
        const auto nodes = slot_nodes(state.fields);
        std::size_t slot = 0;
        for (const auto& [block, local, field, i, j] : expected) { // a set is in ascending order
            EXPECT_EQ(state.fields.field[slot], field);
            EXPECT_EQ(nodes[slot], (Index<2>{i, j}));
            ++slot;
        }
    }
}

TEST_P(Slots, TheTablesOfTilesLeadToTheirOwnFieldAndNode) {
    const auto [shape, with_contact] = GetParam();
    State<2> state = cloud_state(shape, with_contact, 7);
    find_velocity_fields(state);
    const auto nodes = slot_nodes(state.fields);
    for (const auto& tile : state.tiling.tiles) {
        int seen = 0;
        for (int j = tile.window.lower[1]; j <= tile.window.upper[1]; ++j)
            for (int i = tile.window.lower[0]; i <= tile.window.upper[0]; ++i, ++seen) {
                const int slot = state.fields.table[tile.slots + seen];
                EXPECT_EQ(tile.window.local({i, j}), seen);
                EXPECT_EQ(nodes[slot], (Index<2>{i, j}));
                EXPECT_EQ(state.fields.field[slot], tile.field);
            }
    }
}

TEST_P(Slots, ContactNodesAreThoseThatSeveralFieldsSee) {
    const auto [shape, with_contact] = GetParam();
    State<2> state = cloud_state(shape, with_contact, 8);
    find_velocity_fields(state);
    std::map<std::pair<int, int>, std::set<int>> fields_at;
    for (const auto& [block, local, field, i, j] : brute_force_slots(state)) fields_at[{i, j}].insert(field);
    std::set<std::pair<int, int>> expected;
    for (const auto& [node, fields] : fields_at)
        if (fields.size() > 1) expected.insert(node);
    std::set<std::pair<int, int>> found;
    for (const auto& node : state.fields.contact_nodes) {
        found.insert({node.node[0], node.node[1]});
        EXPECT_EQ(node.count, static_cast<int>(fields_at[{node.node[0], node.node[1]}].size()));
        int slot = node.first;
        for (const int field : fields_at[{node.node[0], node.node[1]}]) EXPECT_EQ(state.fields.field[slot++], field);
    }
    EXPECT_EQ(found, expected);
    EXPECT_EQ(found.empty(), !with_contact);
    for (const auto& tile : state.tiling.tiles) {
        bool touches = false;
        for (const auto& [i, j] : expected)
            touches |= i >= tile.window.lower[0] && i <= tile.window.upper[0] && j >= tile.window.lower[1] &&
                       j <= tile.window.upper[1];
        EXPECT_EQ(tile.contact, touches);
    }
}

TEST_P(Slots, NoTwoBlocksOfAColourShareANode) {
    const auto [shape, with_contact] = GetParam();
    State<2> state = cloud_state(shape, with_contact, 9, 1.2);
    find_velocity_fields(state);
    std::multiset<std::int32_t> coloured;
    for (const auto& colour : state.tiling.colours) {
        std::set<std::pair<int, int>> taken;
        for (const std::int32_t b : colour) {
            coloured.insert(b);
            std::set<std::pair<int, int>> own;
            for (int t = state.tiling.blocks[b].first; t < state.tiling.blocks[b].last; ++t) {
                const Window<2>& w = state.tiling.tiles[t].window;
                for (int j = w.lower[1]; j <= w.upper[1]; ++j)
                    for (int i = w.lower[0]; i <= w.upper[0]; ++i) own.insert({i, j});
            }
            for (const auto& node : own) EXPECT_TRUE(taken.insert(node).second);
        }
    }
    ASSERT_EQ(coloured.size(), state.tiling.blocks.size());
    for (std::size_t b = 0; b < state.tiling.blocks.size(); ++b)
        EXPECT_EQ(coloured.count(static_cast<std::int32_t>(b)), 1u);
}

TEST_P(Slots, TilesCoverAllParticlesOnceAndHoldOneBodyOfOneBlock) {
    const auto [shape, with_contact] = GetParam();
    State<2> state = cloud_state(shape, with_contact, 10);
    find_velocity_fields(state);
    std::int32_t next = 0;
    for (const auto& tile : state.tiling.tiles) {
        EXPECT_EQ(tile.first, next);
        EXPECT_LT(tile.first, tile.last);
        next = tile.last;
        EXPECT_EQ(tile.field, with_contact ? tile.body : 0);
        for (int p = tile.first; p < tile.last; ++p) {
            EXPECT_EQ(state.particles.body[p], tile.body);
            const Vec<2> x = state.grid.lattice_position(state.particles.position[p]);
            EXPECT_EQ(tile.block, state.grid.block_number({int(x[0]) / 4, int(x[1]) / 4}));
        }
    }
    EXPECT_EQ(next, static_cast<int>(state.particles.size()));
}

INSTANTIATE_TEST_SUITE_P(AllShapes, Slots, testing::Combine(testing::ValuesIn(all_shapes), testing::Bool()));

TEST(Sort, KeepsEveryParticleWholeAndTheOrderWithinACell) {
    State<2> state = cloud_state(ShapeKind::linear, true, 20);
    Particles<2> sorted = state.particles;
    sort_particles(sorted, state.grid, true);
    std::set<int> ids;
    for (std::size_t i = 0; i < sorted.size(); ++i) {
        const int p = sorted.id[i]; // before the sort the id was the place
        ids.insert(p);
        EXPECT_EQ(sorted.position[i], state.particles.position[p]);
        EXPECT_EQ(sorted.velocity[i], state.particles.velocity[p]);
        EXPECT_EQ(sorted.deformation_gradient[i], state.particles.deformation_gradient[p]);
        EXPECT_EQ(sorted.stress[i], state.particles.stress[p]);
        EXPECT_EQ(sorted.mass[i], state.particles.mass[p]);
        EXPECT_EQ(sorted.volume[i], state.particles.volume[p]);
        EXPECT_EQ(sorted.half_size[i], state.particles.half_size[p]);
        EXPECT_EQ(sorted.body[i], state.particles.body[p]);
    }
    EXPECT_EQ(ids.size(), sorted.size());
    // Blocks, bodies, cells ascend; within a cell the former order.
    const auto key = [&](std::size_t i) {
        const Vec<2> x = state.grid.lattice_position(sorted.position[i]);
        const int cx = static_cast<int>(x[0]);
        const int cy = static_cast<int>(x[1]);
        return std::make_tuple(state.grid.block_number({cx / 4, cy / 4}), sorted.body[i], cy % 4, cx % 4, sorted.id[i]);
    };
    for (std::size_t i = 1; i < sorted.size(); ++i) EXPECT_LT(key(i - 1), key(i));
    Particles<2> again = sorted;
    sort_particles(again, state.grid, true);
    EXPECT_EQ(again.id, sorted.id);
}

TEST(Sort, FieldsAreFoundAnewWhenParticlesDrift) {
    // Particles cross the whole grid: every number of the running search must agree with a fresh one.
    State<2> state = cloud_state(ShapeKind::cpdi, true, 21);
    const std::size_t n = state.particles.size();
    for (int move = 0; move < 40; ++move) {
        find_velocity_fields(state);
        for (const auto& tile : state.tiling.tiles)
            for (int p = tile.first; p < tile.last; ++p) {
                const Window<2> own = CpdiShape::window(state.grid, domain_of(state.particles, p));
                for (int a = 0; a < 2; ++a) {
                    EXPECT_LE(tile.window.lower[a], own.lower[a]);
                    EXPECT_GE(tile.window.upper[a], own.upper[a]);
                }
            }
        ASSERT_EQ(state.fields.size(), brute_force_slots(state).size());
        EXPECT_LE(state.tiling.needed_stride(state.grid), state.tiling.stride);
        for (std::size_t p = 0; p < n; ++p) {
            Vec<2>& x = state.particles.position[p];
            const double direction = state.particles.id[p] % 2 ? 1 : -1;
            x[0] = std::clamp(x[0] + 0.4 * direction, 1.5, 21.5);
        }
    }
}

} // namespace
