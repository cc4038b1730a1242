/// Case 2 with every normal and separation: two blocks in contact are compressed to 20 and to 50 %; the error of the
/// mean axial stress is taken against one block moved by the same scheme.

#include "core/support.h"

#include "step/run_error.h"

#include <cstdio>

namespace {

using namespace test;

constexpr double mm = 1e-3;

/// Mean axial stress at every percent of strain, as far as it gets.
std::vector<double> axial_stress(const TransferSpec& scheme, const std::optional<ContactSpec>& spec, int percents) {
    const MaterialSpec m = material(1000, 2450e6, 940e6);
    Scene scene = plane_scene(5 * mm, -20 * mm, 0, 80 * mm, 100 * mm, m);
    scene.method.shape = ShapeKind::ugimp;
    scene.method.transfer = scheme;
    const double v = 0.001 * wave_speed(m);
    scene.time.end = percents * mm / v;
    add_wall(scene, "bottom", 1, Side::lower, 0);
    add_wall(scene, "top", 1, Side::upper, 100 * mm, -v);
    add_wall(scene, "symmetry", 0, Side::lower, 0);
    scene.contact = spec;
    Model model;
    const int lower = add_body(model, "lower");
    const int upper = spec ? add_body(model, "upper") : lower;
    add_box(model, lower, 0, 0, 20 * mm, 50 * mm, 8, 20);
    add_box(model, upper, 0, 50 * mm, 20 * mm, 100 * mm, 8, 20);
    State<2> state = make_state<2>(scene, model);
    std::vector<double> stress;
    try {
        for (int percent = 1; percent <= percents; ++percent) {
            run(state, percent * mm / v);
            stress.push_back(totals(state).mean_stress()[1]);
        }
    } catch (const RunError&) {
        // stopped: what was reached is in `stress`
    }
    return stress;
}

struct Errors {
    std::vector<double> percent; ///< error at every percent of strain [%]
    double at(std::size_t strain) const { return strain <= percent.size() ? percent[strain - 1] : NAN; }
    /// NaN if the run did not get there.
    double worst_to(std::size_t strain) const {
        double largest = strain <= percent.size() ? 0 : NAN;
        for (std::size_t i = 0; i < std::min(strain, percent.size()); ++i)
            largest = std::max(largest, std::abs(percent[i]));
        return strain <= percent.size() ? largest : NAN;
    }
};

Errors errors(const TransferSpec& scheme, const ContactSpec& spec, const std::vector<double>& one) {
    const std::vector<double> two = axial_stress(scheme, spec, static_cast<int>(one.size()));
    Errors e;
    for (std::size_t i = 0; i < two.size(); ++i) e.percent.push_back(100 * (two[i] / one[i] - 1));
    return e;
}

ContactSpec method(NormalMethod normal, SeparationMethod separation, PositionFit fit = PositionFit::power_law) {
    ContactSpec spec = contact(LawType::friction, 0.2);
    spec.normal = normal;
    spec.separation = separation;
    spec.direction = {0, 1, 0};
    spec.fit = fit;
    return spec;
}

struct Row {
    const char* name;
    ContactSpec spec;
};
std::vector<Row> all_methods() {
    using N = NormalMethod;
    using S = SeparationMethod;
    return {
        {"logistic, edges", method(N::logistic_regression, S::particle_edges)},
        {"linear, edges", method(N::linear_regression, S::particle_edges)},
        {"irls, edges", method(N::irls_regression, S::particle_edges)},
        {"average-gradient, edges", method(N::average_gradient, S::particle_edges)},
        {"maximum-gradient, edges", method(N::maximum_gradient, S::particle_edges)},
        {"maximum-volume, edges", method(N::maximum_volume, S::particle_edges)},
        {"own-gradient, edges", method(N::own_gradient, S::particle_edges)},
        {"specified, edges", method(N::specified, S::particle_edges)},
        {"logistic, fitted", method(N::logistic_regression, S::fitted_position)},
        {"average-gradient, fitted", method(N::average_gradient, S::fitted_position)},
        {"average-gradient, two-per-cell", method(N::average_gradient, S::fitted_position, PositionFit::two_per_cell)},
        {"maximum-gradient, fitted", method(N::maximum_gradient, S::fitted_position)},
        {"maximum-volume, fitted", method(N::maximum_volume, S::fitted_position)},
        {"own-gradient, fitted", method(N::own_gradient, S::fitted_position)},
        {"specified, fitted", method(N::specified, S::fitted_position)},
        {"specified, two-per-cell", method(N::specified, S::fitted_position, PositionFit::two_per_cell)},
        {"average-gradient, critical 0.8", method(N::average_gradient, S::critical_position)},
        {"specified, critical 0.8", method(N::specified, S::critical_position)},
        {"logistic, none", method(N::logistic_regression, S::none)},
        {"average-gradient, none", method(N::average_gradient, S::none)},
        {"specified, none", method(N::specified, S::none)},
        {"logistic, displacement", method(N::logistic_regression, S::displacement)},
        {"average-gradient, displacement", method(N::average_gradient, S::displacement)},
        {"specified, displacement", method(N::specified, S::displacement)}};
}

void print(const char* scheme, const char* name, const Errors& e) {
    std::printf("[ figures  ] %-8s %-31s %8.3f %% at 1 %%, %8.3f at 5, %8.3f at 20, %8.3f at 50; worst to 20 %% %.3f, "
                "to 50 %% %.3f\n",
                scheme, name, e.at(1), e.at(5), e.at(20), e.at(50), e.worst_to(20), e.worst_to(50));
}

void table(const char* name, const TransferSpec& scheme, const std::vector<Row>& rows) {
    const std::vector<double> one = axial_stress(scheme, {}, 50);
    ASSERT_EQ(one.size(), 50u) << "a single block gets there";
    for (const Row& row : rows) {
        const Errors e = errors(scheme, row.spec, one);
        print(name, row.name, e);
        if (&row == rows.data()) {
            EXPECT_LT(e.worst_to(20), 0.5) << name;
        }
    }
}

TEST(CompressionMethods, FullFlip) {
    table("flip", transfer(TransferScheme::flip), all_methods());
}
TEST(CompressionMethods, FullXpic5) {
    table("xpic(5)", transfer(TransferScheme::xpic, 5), all_methods());
}
/// The full mass matrix is not good where two bodies are pressed together slowly: orders 3 and 4 diverge within a few
/// percent, whatever the normal, the separation and the law (perfect too), with CPDI and with half the step too; order
/// 2 is 1 to 2 % off. A single block is stable, and so are two with XPIC. Printed, not judged: a known limit.
TEST(CompressionMethods, FullFmpmIsNotGoodEnough) {
    const ContactSpec spec = method(NormalMethod::logistic_regression, SeparationMethod::particle_edges);
    for (const int order : {2, 4}) {
        TransferSpec scheme = transfer(TransferScheme::fmpm, order, PositionUpdate::mean_velocity);
        const std::string name = "fmpm(" + std::to_string(order) + ")";
        const std::vector<double> one = axial_stress(scheme, {}, 5);
        EXPECT_EQ(one.size(), 5u) << "a single block gets there";
        print(name.c_str(), "logistic, edges", errors(scheme, spec, one));
        scheme.every_cfl = 1;
        print(name.c_str(), "the same, every_cfl 1", errors(scheme, spec, axial_stress(scheme, {}, 5)));
    }
}

} // namespace
