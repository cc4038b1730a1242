/// Bodies whose particles' domains are turned from the start (Model::angle).

#include "turned_box.h"

#include "boundary/traction.h"

#include <gmock/gmock.h>
#include <numbers>
#include <set>

namespace {

using namespace test;

TractionSpec pressure_on(int axis, Side side, double pressure) {
    TractionSpec traction;
    traction.body = "a";
    traction.axis = axis;
    traction.side = side;
    traction.pressure = pressure;
    return traction;
}

/// Ids go row by row along the box's own x.
TEST(TurnedDomains, HaveTheFacesThatTheyHadBeforeTheTurn) {
    const Scene scene = plane_scene(1, 0, 0, 6, 6, material(1, 10, 3));
    for (const double angle : {0.2, std::numbers::pi / 4, 1.3, 2.5}) {
        Model model;
        add_turned_box(model, add_body(model, "a"), {3, 3, 0}, 2, 1.5, 4, 3, angle);
        const Particles<2> particles = make_particles<2>(model, scene);
        const auto ids = [&](int axis, Side side) {
            std::set<int> found;
            for (const TractionFace& face : find_faces(pressure_on(axis, side, 1), 0, 0, particles))
                found.insert(face.id);
            return found;
        };
        EXPECT_THAT(ids(0, Side::lower), testing::ElementsAre(0, 4, 8)) << angle;
        EXPECT_THAT(ids(0, Side::upper), testing::ElementsAre(3, 7, 11)) << angle;
        EXPECT_THAT(ids(1, Side::lower), testing::ElementsAre(0, 1, 2, 3)) << angle;
        EXPECT_THAT(ids(1, Side::upper), testing::ElementsAre(8, 9, 10, 11)) << angle;
    }
}

/// Free from all else: after the first step momentum is p A Δt against the turned outward normal, in a line through the
/// centre (where interpolation to particles keeps angular momentum, and where the face is seen where it is).
TEST(TurnedDomains, ArePressedAlongTheirTurnedNormals) {
    constexpr double angle = 0.5, pressure = 0.01;
    for (const ShapeKind shape : {ShapeKind::cpdi, ShapeKind::b2cpdi, ShapeKind::ugimp, ShapeKind::gimp})
        for (const int axis : {0, 1})
            for (const Side side : {Side::lower, Side::upper}) {
                Scene scene = plane_scene(1, 0, 0, 8, 8, material(1, 10, 3));
                scene.method.shape = shape;
                scene.boundaries = {{"push", pressure_on(axis, side, pressure)}};
                Model model;
                add_turned_box(model, add_body(model, "a"), {4, 4, 0}, 3, 2, 6, 4, angle);
                State<2> state = make_state<2>(scene, model);
                auto tasks = step_tasks<2>(scene);
                state.dt = 0.01;
                advance(state, tasks);
                prepare(state);
                const double outward = side == Side::lower ? -1 : 1;
                const double turned = angle + (axis == 0 ? 0 : std::numbers::pi / 2);
                const double impulse = -outward * pressure * (axis == 0 ? 2 : 3) * 0.01;
                const Totals all = totals(state);
                EXPECT_NEAR(all.momentum[0], impulse * std::cos(turned), 1e-14) << name_of(shape);
                EXPECT_NEAR(all.momentum[1], impulse * std::sin(turned), 1e-14) << name_of(shape);
                if (shape != ShapeKind::cpdi && shape != ShapeKind::b2cpdi) continue;
                const double lever = (all.angular_momentum_z - 4 * (all.momentum[1] - all.momentum[0])) / impulse;
                EXPECT_NEAR(lever, 0, 0.01) << name_of(shape);
            }
}

/// Nothing acts: the body flies on as it is, with no stress and no strain, as a plane body or a ring.
TEST(TurnedDomains, AreFreeOfStress) {
    for (const Analysis analysis : {Analysis::plane_strain, Analysis::plane_stress, Analysis::axisymmetric})
        for (const MaterialModel law :
             {MaterialModel::neo_hookean, MaterialModel::neo_hookean_isochoric, MaterialModel::linear_elastic})
            for (const ShapeKind shape : all_shapes) {
                Scene scene = plane_scene(1, 0, 0, 10, 10, material(2, 10, 3, law));
                scene.analysis = analysis;
                scene.method.shape = shape;
                Model model;
                add_turned_box(model, add_body(model, "a", {0, 0.3, 0}), {5, 4, 0}, 4, 3, 8, 6, 0.7);
                State<2> state = make_state<2>(scene, model);
                run(state, 2);
                double largest = 0, slope = 0;
                for (std::size_t p = 0; p < state.particles.size(); ++p) {
                    const Mat<2>& F = state.particles.deformation_gradient[p];
                    largest = std::max(largest, state.particles.stress[p].cwiseAbs().maxCoeff());
                    slope = std::max(slope, std::abs(std::atan2(F(1, 0), F(0, 0)) - 0.7));
                }
                EXPECT_LT(largest, 1e-12) << name_of(shape);
                EXPECT_LT(slope, 1e-13) << name_of(shape);
                // Pappus: a ring is its section times the way of the centre, however it is turned.
                const double depth = analysis == Analysis::axisymmetric ? 2 * std::numbers::pi * 5 : 1;
                EXPECT_NEAR(totals(state).mass, 2 * 4 * 3 * depth, 1e-11) << name_of(shape);
            }
}

} // namespace
