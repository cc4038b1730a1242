/// Tractions on faces of particles (FMPM paper §2.4): which faces, how they deform, where their force goes.

#include "dense.h"

#include <Eigen/Dense>

#include <gmock/gmock.h>
#include <numbers>
#include <set>

namespace {

using namespace test;

TractionSpec traction_on(const std::string& body, int axis, Side side) {
    TractionSpec t;
    t.body = body;
    t.axis = axis;
    t.side = side;
    return t;
}

std::set<int> ids_of(const std::vector<TractionFace>& faces) {
    std::set<int> ids;
    for (const TractionFace& face : faces) EXPECT_TRUE(ids.insert(face.id).second);
    return ids;
}

/// A block of 4 × 3 particles, numbered along x first, with another body on top of it.
Model block_with_lid() {
    Model model;
    add_box(model, add_body(model, "a"), 2, 2, 4, 3.5, 4, 3);
    add_box(model, add_body(model, "lid"), 2, 3.5, 4, 4, 4, 1);
    return model;
}

TEST(TractionFaces, AreTheOuterOnesOfTheBodyOnTheNamedSide) {
    const Scene scene = plane_scene(1, 0, 0, 6, 6, material(1, 10, 3));
    const Particles<2> particles = make_particles<2>(block_with_lid(), scene);
    const auto faces = [&](int axis, Side side) { return find_faces(traction_on("a", axis, side), 5, 0, particles); };
    EXPECT_THAT(ids_of(faces(0, Side::lower)), testing::ElementsAre(0, 4, 8));
    EXPECT_THAT(ids_of(faces(0, Side::upper)), testing::ElementsAre(3, 7, 11));
    EXPECT_THAT(ids_of(faces(1, Side::lower)), testing::ElementsAre(0, 1, 2, 3));
    EXPECT_THAT(ids_of(faces(1, Side::upper)), testing::ElementsAre(8, 9, 10, 11)) << "the lid is another body";
    for (const TractionFace& face : faces(1, Side::upper)) {
        EXPECT_EQ(face.boundary, 5);
        EXPECT_EQ(face.axis, 1);
        EXPECT_EQ(face.outward, 1);
    }
    TractionSpec within = traction_on("a", 1, Side::upper);
    within.within = Box{{2.5, 0, 0}, {3.3, 9, 0}}; // centres at 2.25, 2.75, 3.25, 3.75
    EXPECT_THAT(ids_of(find_faces(within, 0, 0, particles)), testing::ElementsAre(9, 10));
    within.within = Box{{2.5, 5, 0}, {3.3, 9, 0}};
    EXPECT_TRUE(find_faces(within, 0, 0, particles).empty());
}

TEST(TractionFaces, AreFoundInStepsAndNextToSmallParticles) {
    // Two columns of different height, the second of particles a quarter as large.
    Model model;
    const int a = add_body(model, "a");
    add_box(model, a, 2, 2, 3, 5, 1, 3);
    add_box(model, a, 3, 2, 4, 3, 4, 4);
    const Particles<2> particles = make_particles<2>(model, plane_scene(1, 0, 0, 6, 6, material(1, 10, 3)));
    EXPECT_THAT(ids_of(find_faces(traction_on("a", 1, Side::upper), 0, 0, particles)),
                testing::ElementsAre(2, 15, 16, 17, 18));
    EXPECT_THAT(ids_of(find_faces(traction_on("a", 0, Side::upper), 0, 0, particles)),
                testing::ElementsAre(1, 2, 6, 10, 14, 18));
    EXPECT_THAT(ids_of(find_faces(traction_on("a", 0, Side::lower), 0, 0, particles)), testing::ElementsAre(0, 1, 2));
}

TEST(TractionFaces, OfACubeAreItsSixSides) {
    Model model;
    add_cube(model, add_body(model, "a"), {2, 2, 2}, 1.5, 3);
    const Particles<3> particles = make_particles<3>(model, space_scene(1, 0, 6, material(1, 10, 3)));
    for (int axis = 0; axis < 3; ++axis)
        for (const Side side : {Side::lower, Side::upper}) {
            const auto faces = find_faces(traction_on("a", axis, side), 0, 0, particles);
            EXPECT_EQ(faces.size(), 9u);
            for (const TractionFace& face : faces)
                EXPECT_NEAR(particles.position[face.id][axis], side == Side::lower ? 2.25 : 3.25, 1e-14);
        }
    TractionSpec within = traction_on("a", 2, Side::upper);
    within.within = Box{{2, 2, 0}, {2.5, 3, 9}};
    EXPECT_EQ(find_faces(within, 0, 0, particles).size(), 2u);
}

/// Runs the tasks of a step up to the tractions.
template <int D>
void apply(State<D>& state) {
    prepare(state);
    extrapolate_momenta_and_forces(state);
    apply_tractions(state);
}

template <int D>
Vec<D> total(const std::vector<Pack>& nodes) {
    Vec<D> sum = Vec<D>::Zero();
    for (const Pack& f : nodes) sum += vector_of<D>(f);
    return sum;
}

/// A block under a pulse and a pressure on its upper x side, sheared and turned.
template <int D>
State<D> loaded_block(ShapeKind shape, bool with_pressure, double stretch = 1.3) {
    const MaterialSpec m = material(2, 100, 40);
    Scene scene = D == 2 ? plane_scene(1, 0, 0, 10, 10, m) : space_scene(1, 0, 10, m);
    if (D == 2) scene.thickness = 0.7;
    scene.method.shape = shape;
    TractionSpec t = traction_on("a", 0, Side::upper);
    t.traction = {TimeFunction({1, 2, 3}, {0, 8, 0}), -2.0, D == 3 ? 3.0 : 0.0};
    if (with_pressure) t.pressure = 5.0;
    scene.boundaries.push_back({"pull", t});
    Model model;
    const int a = add_body(model, "a");
    if (D == 2)
        add_box(model, a, 4, 4, 6, 6, 4, 4);
    else
        add_cube(model, a, {4, 4, 4}, 2, 4);
    State<D> state = make_state<D>(scene, model);
    std::mt19937 random(3);
    const Mat<D> F = stretched_and_turned<D>(random, 1 / stretch, stretch);
    for (std::size_t p = 0; p < state.particles.size(); ++p) {
        Vec<D>& x = state.particles.position[p];
        x = (F * (x - Vec<D>::Constant(5)) + Vec<D>::Constant(5)).eval();
        state.particles.deformation_gradient[p] = F;
    }
    state.time = 1.25;
    state.dt = 0.5;
    return state;
}

template <int D>
void check_total_force(ShapeKind shape, bool with_pressure, double stretch) {
    State<D> state = loaded_block<D>(shape, with_pressure, stretch);
    apply(state);
    // The mean of the pulse over [1.25, 1.75] is 4; the face is 2 (× 2) wide.
    const Mat<D>& F = state.particles.deformation_gradient[0];
    Vec<D> normal = Vec<D>::Zero();
    normal[0] = D == 2 ? 2 * 0.7 : 4;
    const Vec<D> nanson = F.determinant() * F.inverse().transpose() * normal;
    Vec<D> T;
    T[0] = 4;
    T[1] = -2;
    if constexpr (D == 3) T[2] = 3;
    const Vec<D> expected = nanson.norm() * T - (with_pressure ? 5.0 : 0.0) * nanson;
    EXPECT_LT((total<D>(state.nodes.traction) - expected).norm(), 1e-12 * expected.norm()) << name_of(shape);
    EXPECT_LT((total<D>(state.nodes.force) - expected).norm(), 1e-12 * expected.norm()) << "part of all force";
    for (int a = 0; a < D; ++a) EXPECT_NEAR(state.boundaries[0].impulse[a], expected[a] * state.dt, 1e-12);
    for (std::size_t slot = 0; slot < state.fields.size(); ++slot)
        if (!(state.nodes.momentum[slot][0] > 0)) {
            EXPECT_EQ(dot(state.nodes.traction[slot], state.nodes.traction[slot]), 0) << "a force on nothing";
        }
}

TEST(Tractions, AllOfTheForceArrives) {
    for (const ShapeKind shape : all_shapes)
        for (const bool with_pressure : {false, true})
            for (const double stretch : {1.0, 1.3, 2.0}) {
                check_total_force<2>(shape, with_pressure, stretch);
                check_total_force<3>(shape, with_pressure, stretch);
            }
}

TEST(Tractions, AllOfTheForceArrivesThoughNoNodeOfTheFaceHasMass) {
    // Stretched sixfold, a particle's face lies cells away from the nodes that shapes without deformation give mass.
    for (const ShapeKind shape : all_shapes) {
        Scene scene = plane_scene(1, 0, 0, 12, 12, material(2, 100, 40));
        scene.method.shape = shape;
        TractionSpec t = traction_on("a", 0, Side::upper);
        t.traction = {3.0, 1.0, 0.0};
        scene.boundaries.push_back({"pull", t});
        Model model;
        add_particle(model, add_body(model, "a"), 5.3, 5.6, 0.4, 0.4);
        State<2> state = make_state<2>(scene, model);
        state.particles.deformation_gradient[0] << 6, 0, 0, 1;
        state.dt = 0.01;
        apply(state);
        EXPECT_LT((total<2>(state.nodes.traction) - 0.8 * Vec<2>(3, 1)).norm(), 1e-13) << name_of(shape);
    }
}

TEST(Tractions, ForcesAreInterpolatedFromTheFaceToTheNodes) {
    // All nodes of the face have mass: the force on a node is ∫ N T dS with N linear along the face, and since grid
    // functions reproduce positions, the moment of the forces is that of the face.
    for (const ShapeKind shape : {ShapeKind::cpdi, ShapeKind::b2cpdi}) { // they see what their corners see
        State<2> state = loaded_block<2>(shape, false, 1.3);
        apply(state);
        const auto nodes = slot_nodes(state.fields);
        Vec<2> moment(0, 0); // Σ f_y x_i
        for (std::size_t slot = 0; slot < nodes.size(); ++slot)
            moment += state.nodes.traction[slot][2] * state.grid.node_position(nodes[slot]);
        const Mat<2>& F = state.particles.deformation_gradient[0];
        const Vec<2> middle = F * Vec<2>(1, 0) + Vec<2>(5, 5);
        EXPECT_LT((moment / total<2>(state.nodes.traction)[1] - middle).norm(), 1e-12) << name_of(shape);
    }
}

/// The impulse of a pulse is the momentum of a body that is free otherwise.
TEST(Tractions, APulseGivesItsImpulse) {
    for (const TransferScheme scheme : {TransferScheme::flip, TransferScheme::xpic, TransferScheme::fmpm})
        for (const ShapeKind shape : {ShapeKind::ugimp, ShapeKind::b2cpdi}) {
            Scene scene = plane_scene(1, 0, 0, 10, 10, material(2, 100, 40));
            scene.method.shape = shape;
            scene.method.transfer = transfer(scheme, 3);
            scene.time.cfl = 0.2; // FMPM(3) with uGIMP is not stable at 0.4
            TractionSpec t = traction_on("a", 1, Side::lower);
            t.traction = {0.0, TimeFunction::pulse(0.05, 0.3, 0.5), 0.0};
            scene.boundaries.push_back({"pull", t});
            Model model;
            add_box(model, add_body(model, "a"), 4, 4, 6, 6, 4, 4);
            State<2> state = make_state<2>(scene, model);
            run(state, 1);
            const Totals all = totals(state);
            EXPECT_NEAR(all.momentum[1], state.boundaries[0].impulse[1], 1e-13);
            EXPECT_NEAR(all.momentum[1], 2 * 0.5 * 0.15, 0.005) << "area times half of peak times width";
            EXPECT_NEAR(all.momentum[0], 0, 1e-13);
            // So coarse a block dissipates; it must not gain energy.
            EXPECT_LE(all.kinetic_energy + all.strain_energy, state.ledger.external_work);
            EXPECT_GE(all.kinetic_energy, 0.5 * all.momentum[1] * all.momentum[1] / all.mass);
        }
}

TEST(Tractions, StayWithinTheNodesOfTheirTilesWhateverIsUpdatedFirst) {
    // Particles deform between the search for nodes and the forces with usf and usavg.
    for (const ShapeKind shape : {ShapeKind::b2cpdi, ShapeKind::cpdi, ShapeKind::gimp, ShapeKind::b2spline})
        for (const StressUpdate update : {StressUpdate::usf, StressUpdate::usavg, StressUpdate::usavg_plus}) {
            Scene scene = plane_scene(1, -6, -4, 14, 8, material(1, 10, 5));
            scene.method.shape = shape;
            scene.method.stress_update = update;
            for (const Side side : {Side::lower, Side::upper}) {
                TractionSpec pull = traction_on("bar", 0, side);
                pull.pressure = -2.0;
                scene.boundaries.push_back({side == Side::lower ? "left" : "right", pull});
            }
            Model model;
            add_box(model, add_body(model, "bar"), 0, 0, 8, 4, 16, 8);
            State<2> state = make_state<2>(scene, model);
            auto tasks = step_tasks<2>(scene);
            for (int step = 0; step < 150; ++step) {
                state.dt = next_step(state, 1e9);
                advance(state, tasks);
                for (std::size_t f = 0; f < state.shaped_faces.size(); ++f) {
                    const Tile<2>& tile = state.tiling.tiles[state.traction_faces[f].tile];
                    for (int q = 0; q < state.shaped_faces[f].count; ++q) {
                        Window<2> seen = tile.window;
                        with_shape(shape, [&](auto s) {
                            seen.include(point_window<typename decltype(s)::GridFunction>(
                                state.grid, state.shaped_faces[f].points[q].position));
                        });
                        ASSERT_TRUE(seen == tile.window) << "step " << step;
                    }
                }
            }
            EXPECT_LT(std::abs(total<2>(state.nodes.traction)[0]), 1e-10) << "the pulls balance";
        }
}

} // namespace
