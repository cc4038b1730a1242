/// Axisymmetric and plane stress analyses against closed forms.

#include "core/support.h"

#include <cstdio>

namespace {

using namespace test;

constexpr double E = 1;
constexpr double nu = 0.3;

MaterialSpec elastic(MaterialModel model = MaterialModel::linear_elastic) {
    return material(1, E / (3 * (1 - 2 * nu)), E / (2 * (1 + nu)), model);
}

/// 0 to `value` over [0, until] without a jump in speed.
TimeFunction smooth_ramp(double until, double value) {
    TimeFunction f;
    f.time.clear();
    f.value.clear();
    for (int i = 0; i <= 50; ++i) {
        f.time.push_back(until * i / 50);
        f.value.push_back(value * 0.5 * (1 - std::cos(M_PI * i / 50)));
    }
    return f;
}

/// A ring from a to b under pressure from one side, held above and below.
State<2> cylinder(double a, double b, double cell, double pressure, Side side, ShapeKind shape, double until) {
    Scene scene = plane_scene(cell, 0, 0, 2.5, 0.5, elastic());
    scene.analysis = Analysis::axisymmetric;
    scene.method.shape = shape;
    scene.method.transfer = {TransferScheme::fmpm, 2, {}, {}};
    scene.time.end = until;
    // Nodes that these hold at both ends are all of the cylinder's but for splines: plane strain.
    add_wall(scene, "floor", 1, Side::lower, 0, 0, true, 10);
    add_wall(scene, "lid", 1, Side::upper, 0.5, 0, true, 10);
    TractionSpec traction;
    traction.body = "cylinder";
    traction.axis = 0;
    traction.side = side;
    traction.pressure = smooth_ramp(0.8 * until, pressure);
    scene.boundaries.push_back({"pressure", traction});
    Model model;
    const int rows = static_cast<int>(std::lround(1 / cell));
    add_box(model, add_body(model, "cylinder"), a, 0, b, 0.5, static_cast<int>(std::lround(2 * (b - a) / cell)), rows);
    State<2> state = make_state<2>(scene, model);
    run(state, until);
    return state;
}

/// Lamé's solution in plane strain.
struct Lame {
    double a, b, p;
    double scale() const { return p * a * a / (b * b - a * a); }
    double radial(double r) const { return scale() * (1 - b * b / (r * r)); }
    double hoop(double r) const { return scale() * (1 + b * b / (r * r)); }
    double displacement(double r) const { return (1 + nu) / E * scale() * ((1 - 2 * nu) * r + b * b / r); }
};

TEST(Axisymmetric, ThickCylinderUnderPressureIsLames) {
    const double p = 1e-3;
    const Lame lame{1, 2, p};
    for (const ShapeKind shape : {ShapeKind::ugimp, ShapeKind::gimp, ShapeKind::cpdi, ShapeKind::b2spline,
                                  ShapeKind::b2gimp, ShapeKind::b2cpdi}) {
        double error[2];
        for (int i = 0; i < 2; ++i) {
            const double cell = 0.1 / (1 << i);
            const State<2> state = cylinder(1, 2, cell, p, Side::lower, shape, 150);
            double stress = 0;
            double moved = 0;
            for (std::size_t q = 0; q < state.particles.size(); ++q) {
                const double r = state.particles.position[q][0];
                const double R = state.initial_position[state.particles.id[q]][0];
                stress += std::pow(state.particles.stress[q][0] - lame.radial(r), 2) +
                          std::pow(state.particles.stress[q][2] - lame.hoop(r), 2);
                moved = std::max(moved, std::abs(r - R - lame.displacement(R)) / lame.displacement(R));
            }
            error[i] = std::sqrt(stress / static_cast<double>(state.particles.size())) / p;
            std::printf(
                "[ figures  ] shape %d, %2.0f cells across: RMS stress error %.4f of the pressure, displacement "
                "%.2f %%\n",
                static_cast<int>(shape), 1 / cell, error[i], 100 * moved);
            EXPECT_LT(moved, 0.02);
        }
        EXPECT_LT(error[1], 0.04);
        EXPECT_LT(error[1], error[0]) << static_cast<int>(shape);
    }
}

TEST(Axisymmetric, SolidCylinderIsUniformUpToTheAxis) {
    const double p = 1e-3;
    for (const ShapeKind shape : {ShapeKind::ugimp, ShapeKind::gimp, ShapeKind::cpdi, ShapeKind::b2spline,
                                  ShapeKind::b2gimp, ShapeKind::b2cpdi}) {
        const State<2> state = cylinder(0, 1, 0.1, p, Side::upper, shape, 120);
        double worst = 0;
        for (std::size_t q = 0; q < state.particles.size(); ++q)
            for (const int c : {0, 2}) worst = std::max(worst, std::abs(state.particles.stress[q][c] / -p - 1));
        std::printf("[ figures  ] shape %d: solid cylinder under pressure, worst stress error %.2f %%\n",
                    static_cast<int>(shape), 100 * worst);
        EXPECT_LT(worst, 0.05) << static_cast<int>(shape);
    }
}

TEST(PlaneStress, SheetInTension) {
    // Uniaxial stress: the sheet gets narrower and thinner by ν ε; for large strains as the law says.
    const std::pair<MaterialModel, const char*> models[] = {
        {MaterialModel::linear_elastic, "linear-elastic"},
        {MaterialModel::neo_hookean, "neo-hookean"},
        {MaterialModel::neo_hookean_isochoric, "neo-hookean-isochoric"}};
    for (const auto& [model_kind, name] : models) {
        for (const double stress : {1e-4, 0.2}) {
            Scene scene = plane_scene(0.25, -4, -2, 4, 2, elastic(model_kind));
            scene.analysis = Analysis::plane_stress;
            scene.method.transfer = {TransferScheme::fmpm, 2, {}, {}};
            scene.time.end = 200;
            for (const Side side : {Side::lower, Side::upper}) {
                TractionSpec traction;
                traction.body = "sheet";
                traction.side = side;
                traction.pressure = smooth_ramp(150, -stress);
                scene.boundaries.push_back({side == Side::lower ? "left" : "right", traction});
            }
            Model model;
            add_box(model, add_body(model, "sheet"), -2, -1, 2, 1, 32, 16);
            State<2> state = make_state<2>(scene, model);
            run(state, scene.time.end);
            Mat<2> F = Mat<2>::Zero();
            double across = 0, sigma = 0, lateral = 0, thickness_stress = 0;
            const double n = static_cast<double>(state.particles.size());
            for (std::size_t p = 0; p < state.particles.size(); ++p) {
                const double J = state.particles.deformation_gradient[p].determinant() * state.particles.across[p];
                F += state.particles.deformation_gradient[p] / n;
                across += state.particles.across[p] / n;
                sigma += state.particles.stress[p][0] / J / n;
                lateral += state.particles.stress[p][1] / J / n;
                thickness_stress = std::max(thickness_stress, std::abs(state.particles.stress[p][2]));
            }
            std::printf("[ figures  ] %-22s traction %.4f: stress %.5f (across it %.1e), stretch %.5f, narrower %.5f, "
                        "thinner %.5f\n",
                        name, stress, sigma, lateral, F(0, 0), F(1, 1), across);
            EXPECT_NEAR(sigma, stress, 0.02 * stress);
            EXPECT_LT(std::abs(lateral), 0.02 * stress);
            EXPECT_LT(thickness_stress, 1e-12);
            EXPECT_NEAR(F(1, 1), across, 0.01 * (1 - across)) << "isotropic";
            if (stress < 1e-3) {
                EXPECT_NEAR(F(0, 0) - 1, stress / E, 0.02 * stress / E);
                EXPECT_NEAR(F(1, 1) - 1, -nu * stress / E, 0.03 * stress / E);
            }
        }
    }
}

} // namespace
