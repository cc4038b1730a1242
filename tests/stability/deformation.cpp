/// Bodies stretched until the grid no longer sees them as one, bodies that spin, bodies at rest for long.

#include "stability/hard.h"

#include "step/run_error.h"

namespace {

using namespace test;

/// A bar of 8 x 2 cells that flies apart, its ends three times faster than elastic stresses could stop them.
/// \return the largest stretch of a particle along the bar
double stretch_bar(Figures& figures, ShapeKind shape, const TransferSpec& scheme) {
    const std::string name = std::string(name_of(shape)) + ", " + name_of(scheme);
    SCOPED_TRACE(name);
    Scene scene = plane_scene(1, 0, 0, 72, 8, material(1, 100, 50, MaterialModel::neo_hookean));
    scene.method.shape = shape;
    scene.method.transfer = scheme;
    if (shape == ShapeKind::linear) scene.method.stress_update = StressUpdate::usf;
    Model model;
    add_box(model, add_body(model, "bar"), 32, 3, 40, 5, 16, 4);
    model.bodies[0].velocity.center = {36, 4, 0};
    model.bodies[0].velocity.gradient[0] = {12, 0, 0};
    State<2> state = make_state<2>(scene, model);
    double stretch = 0;
    const auto watch = run_watched(state, 0.6, [&] {
        for (std::size_t p = 0; p < state.particles.size(); ++p)
            stretch = std::max(stretch, state.particles.deformation_gradient[p].col(0).norm());
    });
    watch.expect_energy(figures, name);
    watch.expect_momentum(figures, name);
    return stretch;
}

TEST(Stretching, UntilNumericalFractureAndBeyond) {
    Figures figures("bar that flies apart");
    for (const ShapeKind shape : all_shapes)
        for (const TransferSpec& scheme : usual_transfers()) {
            const double stretch = stretch_bar(figures, shape, scheme);
            std::printf("[ figures  ] %s, %s: stretched to %.2f\n", name_of(shape), name_of(scheme).c_str(), stretch);
            EXPECT_GT(stretch, 2) << "or particles two to a cell have not been parted by more than a cell";
        }
}

struct Spin {
    double energy = 0, angular_momentum = 0, radius = 0; ///< at the end over those at the start
    std::string name;
};

/// A disk of radius 3 cells whose rim has a fifth of the wave speed.
Spin spin(const TransferSpec& scheme, ShapeKind shape, int turns) {
    Scene scene = plane_scene(1, 0, 0, 12, 12, material(1, 100, 50));
    scene.method.shape = shape;
    scene.method.transfer = scheme;
    Model model;
    add_disk(model, add_body(model, "disk"), 6, 6, 3, 0.5);
    const double omega = 0.2 * wave_speed(scene.materials[0]) / 3;
    model.bodies[0].velocity.center = {6, 6, 0};
    model.bodies[0].velocity.gradient[0] = {0, -omega, 0};
    model.bodies[0].velocity.gradient[1] = {omega, 0, 0};
    State<2> state = make_state<2>(scene, model);
    prepare(state);
    const auto spin_of = [&](Totals& t) {
        const Vector x = t.center();
        return t.angular_momentum_z - (x[0] * t.momentum[1] - x[1] * t.momentum[0]);
    };
    const auto radius_of = [](const Totals& t) {
        const Vector x = t.center();
        return std::sqrt(t.second_moment / t.mass - x[0] * x[0] - x[1] * x[1]);
    };
    Totals before = totals(state);
    run(state, turns * 2 * M_PI / omega);
    EXPECT_TRUE(is_sound(state));
    Totals after = totals(state);
    return {(after.kinetic_energy + after.strain_energy) / before.kinetic_energy, spin_of(after) / spin_of(before),
            radius_of(after) / radius_of(before), std::string(name_of(shape)) + ", " + name_of(scheme)};
}

void print(const Spin& s, int turns) {
    std::printf("[ figures  ] %d turns, %s: energy %.5f, angular momentum %.5f, radius %.5f of the start's\n", turns,
                s.name.c_str(), s.energy, s.angular_momentum, s.radius);
}

TEST(Spinning, ATenthOfAHundredTurns) {
    for (const TransferSpec& scheme : usual_transfers())
        for (const ShapeKind shape : {ShapeKind::cpdi, ShapeKind::b2spline, ShapeKind::ugimp}) print(spin(scheme, shape, 10), 10);
}

TEST(Spinning, FullAHundredTurns) {
    for (const TransferSpec& scheme : usual_transfers())
        for (const ShapeKind shape : {ShapeKind::cpdi, ShapeKind::b2spline, ShapeKind::ugimp}) print(spin(scheme, shape, 100), 100);
}

} // namespace
