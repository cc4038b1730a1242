/// FMPM paper §3.3, figure 6 (case 8): a triangular traction pulse runs along a bar.

#include "core/support.h"

#include <cstdio>

namespace {

using namespace test;

constexpr double mm = 1e-3;
constexpr double peak = 500;   // Pa
constexpr double width = 1e-3; // s
constexpr double length = 0.198;

Scene pulse_scene(double cell, TransferSpec transfer, ShapeKind shape) {
    // E = 10 MPa, ν = 0: K = E/3, G = E/2.
    Scene scene = plane_scene(cell, -10 * mm, -10 * mm, 210 * mm, 10 * mm,
                              material(1000, 1e7 / 3, 1e7 / 2, MaterialModel::linear_elastic));
    scene.analysis = Analysis::plane_stress;
    scene.method.shape = shape;
    scene.method.transfer = transfer;
    scene.time.cfl = 0.2;
    scene.time.end = 1.5e-3;
    TractionSpec traction;
    traction.body = "bar";
    traction.traction[0] = TimeFunction::pulse(0, width, -peak);
    scene.boundaries.push_back({"pulse", traction});
    return scene;
}

double theory(double x) {
    const double u = (0.150 - x) / 0.100;
    return u > 0 && u < 1 ? peak * (1 - std::abs(2 * u - 1)) : 0;
}

struct Pulse {
    double rms;    ///< error of σ_xx over the particles, in Pa
    double summit; ///< where the mean stress over the section is largest [mm]
    double height; ///< the largest stress over the peak
};

Pulse run_pulse(double cell, TransferSpec transfer, ShapeKind shape = ShapeKind::b2spline) {
    const Scene scene = pulse_scene(cell, transfer, shape);
    Model model;
    add_box(model, add_body(model, "bar"), 0, -5 * mm, length, 5 * mm, static_cast<int>(std::lround(2 * length / cell)),
            static_cast<int>(std::lround(20 * mm / cell)));
    State<2> state = make_state<2>(scene, model);
    run(state, scene.time.end);
    Pulse pulse{};
    std::map<long, std::pair<double, int>> sections;
    for (std::size_t p = 0; p < state.particles.size(); ++p) {
        const double x = state.particles.position[p][0];
        const double s = state.particles.stress[p][0]; // Kirchhoff; J = 1 to 5e-5
        pulse.rms += (s - theory(x)) * (s - theory(x));
        auto& [sum, count] = sections[std::lround(x / (cell / 2) - 0.5)];
        sum += s;
        ++count;
    }
    pulse.rms = std::sqrt(pulse.rms / static_cast<double>(state.particles.size()));
    for (const auto& [place, section] : sections)
        if (const double mean = section.first / section.second; mean > pulse.height * peak) {
            pulse.height = mean / peak;
            pulse.summit = (static_cast<double>(place) + 0.5) * cell / 2 / mm;
        }
    // What the traction did is in the bar: momentum ½ T A t.
    EXPECT_NEAR(totals(state).momentum[0] / (-0.5 * peak * 10 * mm * width), 1, 1e-6);
    const bool is_pic = transfer.scheme == TransferScheme::fmpm && transfer.order == 1; // it dissipates
    const double energy = totals(state).kinetic_energy + totals(state).strain_energy;
    EXPECT_NEAR(state.ledger.external_work / energy, 1, is_pic ? 1 : 0.02);
    return pulse;
}

TransferSpec fmpm(int order) {
    return {TransferScheme::fmpm, order, {}, {}};
}

TEST(TractionPulse, ConvergesWithFirstOrder) {
    std::printf("[ figures  ] cells 4, 2, 1 mm; published (Fig. 6A): first order, FMPM(k >= 2) below FLIP, FMPM(1) "
                "above\n");
    std::map<int, double> finest;
    for (const int k : {0, 1, 2, 4, 8}) {
        double rms[3];
        for (int i = 0; i < 3; ++i) rms[i] = run_pulse(4 * mm / (1 << i), k ? fmpm(k) : TransferSpec{}).rms;
        std::printf("[ figures  ] %s(%d): RMS error %.3f %.3f %.3f Pa, orders %.2f, %.2f\n", k ? "FMPM" : "FLIP", k,
                    rms[0], rms[1], rms[2], std::log2(rms[0] / rms[1]), std::log2(rms[1] / rms[2]));
        finest[k] = rms[2];
        if (k != 1) {
            EXPECT_GT(std::log2(rms[0] / rms[2]) / 2, 0.75) << k;
        }
    }
    EXPECT_GT(finest[1], 2 * finest[0]);
    for (const int k : {2, 4, 8}) EXPECT_LT(finest[k], 0.5 * finest[0]) << k;
}

TEST(TractionPulse, FmpmPutsThePeakInItsPlace) {
    const Pulse flip = run_pulse(1 * mm, {});
    const Pulse second = run_pulse(1 * mm, fmpm(2));
    const Pulse fourth = run_pulse(1 * mm, fmpm(4));
    std::printf(
        "[ figures  ] cells 1 mm, peak at 100 mm: FLIP %.2f mm, height %.3f; FMPM(2) %.2f mm, %.3f; FMPM(4) %.2f "
        "mm, %.3f; published (Fig. 6B): FLIP 2 mm off, FMPM not, less rounded as k grows\n",
        flip.summit, flip.height, second.summit, second.height, fourth.summit, fourth.height);
    EXPECT_NEAR(flip.summit, 98.5, 0.8);
    EXPECT_NEAR(second.summit, 100, 0.8);
    EXPECT_NEAR(fourth.summit, 100, 0.8);
    EXPECT_GT(second.height, flip.height);
    EXPECT_GT(fourth.height, second.height);
}

TEST(TractionPulse, EveryShapeCarriesIt) {
    const std::pair<ShapeKind, const char*> shapes[] = {{ShapeKind::ugimp, "ugimp"},
                                                        {ShapeKind::gimp, "gimp"},
                                                        {ShapeKind::cpdi, "cpdi"},
                                                        {ShapeKind::b2gimp, "b2gimp"},
                                                        {ShapeKind::b2cpdi, "b2cpdi"}};
    for (const auto& [shape, name] : shapes) {
        const Pulse pulse = run_pulse(2 * mm, fmpm(4), shape);
        std::printf("[ figures  ] FMPM(4), %s, cells 2 mm: RMS error %.3f Pa, peak at %.1f mm\n", name, pulse.rms,
                    pulse.summit);
        EXPECT_LT(pulse.rms, 7) << name;
        EXPECT_NEAR(pulse.summit, 100, 2.1) << name;
    }
}

} // namespace
