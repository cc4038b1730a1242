/// Contact paper §2.3 and figure 2 (case 1): the upper of two blocks is pushed down over a gap of 1.5 cells. Where the
/// contact plane lies between the grid lines must not matter.

#include "core/support.h"

#include <cstdio>

namespace {

using namespace test;

constexpr double mm = 1e-3;
constexpr double gap = 7.5 * mm;

/// Time at which the stress of the lower block begins to rise, over the time that closes the gap. The upper block is
/// given the piston's velocity from the start, so that it comes as a rigid body.
/// \param offset of the lower block's top from a grid line [cells]
double contact_time(double offset, const ContactSpec& spec, ShapeKind shape = ShapeKind::ugimp) {
    const MaterialSpec m = material(1000, 2450e6, 940e6);
    const double v = 0.0005 * wave_speed(m);
    const double closing = gap / v;
    const double top = 50 * mm - 5 * mm * offset;
    Scene scene = plane_scene(5 * mm, -20 * mm, -20 * mm, 60 * mm, 130 * mm, m);
    scene.method.shape = shape;
    scene.contact = spec;
    add_wall(scene, "bottom", 1, Side::lower, top - 50 * mm);
    add_wall(scene, "top", 1, Side::upper, top + gap + 50 * mm, -v);
    Model model;
    const int lower = add_body(model, "lower");
    const int upper = add_body(model, "upper", {0, -v, 0});
    add_box(model, lower, 0, top - 50 * mm, 40 * mm, top, 16, 20);
    add_box(model, upper, 0, top + gap, 40 * mm, top + gap + 50 * mm, 16, 20);
    State<2> state = make_state<2>(scene, model);
    // Stress behind the first shock of the contact, ρ c v/2: a hundredth of it in the mean over the block counts.
    const double threshold = 0.01 * m.density * wave_speed(m) * v / 2;
    double time = 0;
    run(state, 1.1 * closing, [&] {
        if (time == 0 && -body_totals(state)[0].mean_stress()[1] > threshold) time = state.time;
    });
    // The shock needs time to fill a hundredth of the block.
    return (time - 0.01 * 50 * mm / wave_speed(m)) / closing;
}

TEST(ClosingAGap, LogisticRegressionMeetsTheContactTimeAtEveryOffset) {
    for (const double offset : {0.0, 0.5, 0.25, 0.75, 0.1, 0.4}) {
        const double ratio = contact_time(offset, contact(LawType::friction, 0.2));
        std::printf("[ figures  ] LR, contact plane %.2f cells off a grid line: contact at %.4f of the closing time; "
                    "published: essentially exact\n",
                    offset, ratio);
        EXPECT_NEAR(ratio, 1, 0.005) << offset;
    }
    EXPECT_NEAR(contact_time(0.3, contact(LawType::friction, 0.2), ShapeKind::cpdi), 1, 0.005);
}

TEST(ClosingAGap, GridMethodsAreEarly) {
    ContactSpec spec = contact(LawType::friction, 0.2);
    spec.normal = NormalMethod::average_gradient;
    for (const auto& [separation, name, published] :
         {std::tuple{SeparationMethod::none, "approach velocity", "far too early"},
          std::tuple{SeparationMethod::critical_position, "critical position 0.8", "a little early; mid-cell too soon"},
          std::tuple{SeparationMethod::fitted_position, "fitted position",
                     "nearly exact on a line; mid-cell too soon"}}) {
        spec.separation = separation;
        const double on_line = contact_time(0, spec);
        const double mid_cell = contact_time(0.5, spec);
        std::printf("[ figures  ] %-22s on a line %.4f, mid-cell %.4f of the closing time; published: %s\n", name,
                    on_line, mid_cell, published);
        if (separation == SeparationMethod::none) {
            EXPECT_LT(on_line, 0.6);
            EXPECT_LT(mid_cell, 0.6);
        }
        EXPECT_LT(mid_cell, 0.995);
    }
}

} // namespace
