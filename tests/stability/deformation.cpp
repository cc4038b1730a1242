/// Bodies stretched until the grid no longer sees them as one, bodies that spin, bodies at rest for long.

#include "stability/hard.h"

#include "step/run_error.h"

namespace {

using namespace test;

/// A bar of 8 x 2 cells that flies apart, its ends faster than elastic stresses could stop them. The bound of the energy
/// is for small strains: in a step of 0.4 cells / wave speed this bar would be stretched by more than a third, so steps
/// are a quarter of that. And while it flies apart the logarithmic strain of a step, 1/λ, falls; ½ Σ Δσ Δε, what a step's
/// trapezoid leaves out, is then not ½ σ Δε of the end, but with stresses that grow as λ² up to 2λ/(λ + 1) < 2 times its
/// largest value.
/// \return the largest stretch of a particle along the bar
double stretch_bar(Figures& figures, ShapeKind shape, const TransferSpec& scheme) {
    const std::string name = std::string(name_of(shape)) + ", " + name_of(scheme);
    SCOPED_TRACE(name);
    Scene scene = plane_scene(1, 0, 0, 72, 8, material(1, 100, 50, MaterialModel::neo_hookean));
    scene.time.cfl = 0.1;
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
    watch.expect_energy(figures, name, watch.half_change / watch.largest);
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
Spin spin(const TransferSpec& scheme, ShapeKind shape, int turns, double R = 3, double rim = 0.2) {
    Scene scene = plane_scene(1, 0, 0, 4 * R, 4 * R, material(1, 100, 50));
    scene.method.shape = shape;
    scene.method.transfer = scheme;
    Model model;
    add_disk(model, add_body(model, "disk"), 2 * R, 2 * R, R, 0.5);
    const double omega = rim * wave_speed(scene.materials[0]) / R;
    model.bodies[0].velocity.center = {2 * R, 2 * R, 0};
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

TEST(Spinning, Study) {
    std::vector<TransferSpec> all{transfer(TransferScheme::flip)};
    for (int k : {4, 8, 16}) all.push_back({TransferScheme::fmpm, k, {}, {}});
    for (int k : {2, 16}) all.push_back({TransferScheme::fmpm, k, PositionUpdate::end_velocity, {}});
    for (int k : {2, 8, 16}) all.push_back({TransferScheme::xpic, k, {}, {}});
    all.push_back({TransferScheme::fmpm, 4, {}, 4.0});
    all.push_back({TransferScheme::xpic, 5, {}, 4.0});
    for (double R : {3., 6.})
        for (double rim : {0.2})
            for (int turns : {3})
                for (auto t : all) {
                    std::printf("R %g rim %g every %g pos %d\n", R, rim, t.every_cfl.value_or(0), t.position ? int(*t.position) : -1);
                    print(spin(t, ShapeKind::cpdi, turns, R, rim), turns);
                }
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
