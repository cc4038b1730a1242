/// Case 1 for planes in any direction: two free blocks approach each other along the normal of the faces that will
/// meet. They must touch when the gap is closed, wherever the faces lie in the grid and however many particles fill a
/// cell.

#include "core/support.h"

#include <cstdio>

namespace {

using namespace test;

constexpr double gap = 1.5;    // [cells]
constexpr double width = 6;    // of the faces [cells]
constexpr double height = 3;   // of the blocks [cells]
constexpr double speed = 5e-3; // of the approach, over the wave speed

struct Setup {
    double angle = 0;  ///< of the faces against the x axis [degrees]
    double offset = 0; ///< of the place where the faces meet, from a grid line, along the normal [cells]
    int per_cell = 2;  ///< particles along an axis
};

/// Times over the time that closes the gap.
struct Contact {
    double first = 0;    ///< when a first particle is touched, be it at a node that has next to no mass
    double pressing = 0; ///< when a hundredth of the momentum has been exchanged, as in closing_gap.cpp
};
Contact contact_time(const Setup& setup, const ContactSpec& spec) {
    const MaterialSpec m = material(1, 2.45, 0.94);
    Scene scene = plane_scene(1, -10, -10, 10, 10, m);
    scene.method.shape = ShapeKind::cpdi;
    scene.contact = spec;
    const double angle = setup.angle * M_PI / 180;
    const Vec<2> along(std::cos(angle), std::sin(angle));
    const Vec<2> normal(-along[1], along[0]);
    if (spec.normal == NormalMethod::specified) scene.contact->direction = {normal[0], normal[1], 0};
    const double v = speed * wave_speed(m);
    Model model;
    const auto block = [&](double lowest, double sign) {
        const Vec<2> velocity = -sign * v / 2 * normal;
        const int body = add_body(model, sign < 0 ? "lower" : "upper", {velocity[0], velocity[1], 0});
        const double d = 1.0 / setup.per_cell;
        for (int j = 0; j < height * setup.per_cell; ++j)
            for (int i = 0; i < width * setup.per_cell; ++i) {
                const Vec<2> x = (d * (i + 0.5) - width / 2) * along + (lowest + d * (j + 0.5)) * normal;
                add_particle(model, body, x[0], x[1], d / 2, d / 2);
                model.angle.push_back(angle);
            }
    };
    block(setup.offset - gap / 2 - height, -1);
    block(setup.offset + gap / 2, 1);
    State<2> state = make_state<2>(scene, model);
    const Vec<2> free = -v / 2 * normal; // of the upper block
    auto tasks = step_tasks<2>(scene);
    const double closing = gap / v;
    Contact contact;
    while (contact.pressing == 0 && state.time < 1.2 * closing) {
        state.dt = next_step(state, 1.3 * closing);
        advance(state, tasks);
        Vec<2> mean = Vec<2>::Zero();
        double largest = 0;
        for (std::size_t p = 0; p < state.particles.size(); ++p) {
            if (state.particles.body[p] == 0) continue;
            const Vec<2> change = state.particles.velocity[p] - free;
            largest = std::max(largest, change.norm());
            mean += change / (0.5 * static_cast<double>(state.particles.size()));
        }
        const double now = (state.time - 0.5 * state.dt) / closing;
        if (contact.first == 0 && largest > 1e-6 * v) contact.first = now;
        if (mean.dot(normal) > 0.01 * v / 2) contact.pressing = now - 0.01 * height / wave_speed(m) / closing;
    }
    return contact;
}

struct Range {
    double first = 1e9;
    double last = -1e9;
    void add(double x) {
        first = std::min(first, x);
        last = std::max(last, x);
    }
    double worst() const { return std::max(std::abs(first - 1), std::abs(last - 1)); }
};

struct Ranges {
    Range first, pressing;
};
Ranges over_offsets(double angle, int per_cell, const ContactSpec& spec, std::initializer_list<double> offsets) {
    Ranges ranges;
    for (const double offset : offsets) {
        const Contact contact = contact_time({angle, offset, per_cell}, spec);
        ranges.first.add(contact.first);
        ranges.pressing.add(contact.pressing);
    }
    return ranges;
}

ContactSpec method(NormalMethod normal, SeparationMethod separation, PositionFit fit = PositionFit::power_law) {
    ContactSpec spec = contact(LawType::friction, 0.2);
    spec.normal = normal;
    spec.separation = separation;
    spec.fit = fit;
    return spec;
}

void check_logistic(std::initializer_list<double> angles, std::initializer_list<int> per_cells,
                    std::initializer_list<double> offsets) {
    const ContactSpec spec = contact(LawType::friction, 0.2);
    for (const double angle : angles)
        for (const int per_cell : per_cells) {
            const auto& [first, pressing] = over_offsets(angle, per_cell, spec, offsets);
            std::printf("[ figures  ] LR, plane at %2.0f degrees, %d per cell: contact at %.4f to %.4f of the closing "
                        "time, first touch of a particle at %.4f to %.4f; theory: 1\n",
                        angle, per_cell, pressing.first, pressing.last, first.first, first.last);
            EXPECT_LT(pressing.worst(), 0.005) << angle << " " << per_cell;
        }
}
TEST(InclinedGap, LogisticRegressionMeetsTheContactTime) {
    check_logistic({10, 30, 45}, {1, 2, 3}, {0.3});
}
TEST(InclinedGap, FullLogisticRegressionMeetsTheContactTime) {
    check_logistic({0, 10, 30, 45}, {1, 2, 3, 4}, {0, 0.3, 0.5, 0.75});
}

struct Row {
    const char* name;
    ContactSpec spec;
};
std::vector<Row> older_methods() {
    using N = NormalMethod;
    using S = SeparationMethod;
    return {
        {"linear-regression, edges", method(N::linear_regression, S::particle_edges)},
        {"irls-regression, edges", method(N::irls_regression, S::particle_edges)},
        {"average-gradient, edges", method(N::average_gradient, S::particle_edges)},
        {"maximum-gradient, edges", method(N::maximum_gradient, S::particle_edges)},
        {"maximum-volume, edges", method(N::maximum_volume, S::particle_edges)},
        {"own-gradient, edges", method(N::own_gradient, S::particle_edges)},
        {"specified, edges", method(N::specified, S::particle_edges)},
        {"logistic, fitted", method(N::logistic_regression, S::fitted_position)},
        {"specified, fitted", method(N::specified, S::fitted_position)},
        {"average-gradient, fitted", method(N::average_gradient, S::fitted_position)},
        {"average-gradient, two-per-cell", method(N::average_gradient, S::fitted_position, PositionFit::two_per_cell)},
        {"average-gradient, critical 0.8", method(N::average_gradient, S::critical_position)},
        {"average-gradient, none", method(N::average_gradient, S::none)}};
}

/// What the older methods make of it. All but a specified normal tilt somewhere along the faces.
TEST(InclinedGap, FullOlderMethods) {
    for (const Row& row : older_methods()) {
        std::printf("[ figures  ] %-31s contact at", row.name);
        for (const double angle : {0.0, 10.0, 30.0, 45.0}) {
            const Range range = over_offsets(angle, 2, row.spec, {0, 0.3, 0.5}).pressing;
            std::printf(" %.3f to %.3f (%.0f degrees)", range.first, range.last, angle);
            if (row.spec.normal == NormalMethod::specified && row.spec.separation == SeparationMethod::particle_edges) {
                EXPECT_LT(range.worst(), 0.002) << "with the right normal edges are exact";
            }
            if (row.spec.separation == SeparationMethod::none) {
                EXPECT_LT(range.last, 0.7) << "approach alone is far too early";
            }
        }
        std::printf(" of the closing time; theory: 1\n");
    }
}

} // namespace
