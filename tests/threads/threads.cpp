/// Results are bit-identical for any number of threads.

#include "core/support.h"

#include <omp.h>

namespace {

using namespace test;

struct Outcome {
    std::vector<std::vector<double>> history;
    Particles<2> particles;
};

Outcome outcome(int threads, ShapeKind shape, const ContactSpec& spec, double until = 3) {
    omp_set_num_threads(threads);
    Scene scene = plane_scene(0.25, -4, -3, 4, 3, material(1, 8, 4));
    scene.method.shape = shape;
    scene.method.transfer = transfer(TransferScheme::xpic, 5);
    scene.gravity = {0, -0.02, 0};
    scene.contact = spec;
    add_wall(scene, "floor", 1, Side::lower, -2.2, 0, false);
    RigidSpec turning; // meets the disks from below
    turning.velocity[1] = 0.2;
    turning.angular_velocity = 0.3;
    scene.bodies.emplace_back().rigid = turning;
    Model model;
    model.bodies.push_back({"ram", -1, {}, turning});
    add_box(model, 0, -0.5, -1.9, 0.5, -1.5, 8, 4);
    add_disk(model, add_body(model, "left", {0.3, 0, 0}), -1.2, -0.3, 1, 0.125);
    add_disk(model, add_body(model, "right", {-0.3, 0, 0}), 1.2, 0.2, 1, 0.125);
    add_disk(model, add_body(model, "third", {0, -0.4, 0}), 0.1, 1.7, 0.7, 0.125);
    State<2> state = make_state<2>(scene, model);
    Outcome result;
    run(state, until, [&] {
        if (state.step % 5 == 0)
            result.history.push_back(history_row(state, deformable_totals(state, body_totals(state)), 0.1));
    });
    result.particles = state.particles;
    omp_set_num_threads(1);
    return result;
}

template <class T>
void expect_same_bits(const std::vector<T>& a, const std::vector<T>& b, const char* what) {
    ASSERT_EQ(a.size(), b.size());
    std::size_t different = 0;
    for (std::size_t i = 0; i < a.size(); ++i) different += !(a[i] == b[i]);
    EXPECT_EQ(different, 0u) << what;
}

/// Short enough for the thread sanitizer (tests/run.sh --tsan): bodies that meet, and two threads.
TEST(Threads, TwoInAShortRunOfContact) {
    const ContactSpec regression = contact(LawType::friction, 0.3);
    for (const ShapeKind shape : {ShapeKind::cpdi, ShapeKind::ugimp}) {
        const Outcome one = outcome(1, shape, regression, 1.5);
        const Outcome two = outcome(2, shape, regression, 1.5);
        ASSERT_FALSE(one.history.empty());
        EXPECT_NE(one.history.back()[7], 0) << "contact works";
        EXPECT_EQ(two.history, one.history);
        expect_same_bits(two.particles.position, one.particles.position, "position");
        expect_same_bits(two.particles.velocity, one.particles.velocity, "velocity");
    }
}

TEST(Threads, OneTwoAndThreeGiveTheSameBits) {
    ContactSpec regression = contact(LawType::friction, 0.3);
    ContactSpec gradient = regression;
    gradient.normal = NormalMethod::average_gradient;
    gradient.separation = SeparationMethod::fitted_position;
    ContactSpec bonds = regression; // areas
    bonds.three_or_more = ThreeOrMore::up_to_two;
    bonds.law.type = LawType::adhesion;
    bonds.law.strength = bonds.law.shear_strength = 0.05;
    ContactSpec springs = regression; // areas and displacements
    springs.law.type = LawType::bilinear_interface;
    springs.law.tension_stiffness = springs.law.tangential_stiffness = 0.5;
    springs.law.compression_stiffness = 2;
    for (const ShapeKind shape : {ShapeKind::cpdi, ShapeKind::ugimp})
        for (const ContactSpec& spec : {regression, gradient, bonds, springs}) {
            const Outcome one = outcome(1, shape, spec);
            ASSERT_GT(one.history.size(), 10u);
            EXPECT_NE(one.history.back()[7], 0) << "contact works";
            for (const int threads : {2, 3}) {
                const Outcome more = outcome(threads, shape, spec);
                EXPECT_EQ(more.history, one.history) << threads << " threads";
                expect_same_bits(more.particles.position, one.particles.position, "position");
                expect_same_bits(more.particles.velocity, one.particles.velocity, "velocity");
                expect_same_bits(more.particles.deformation_gradient, one.particles.deformation_gradient, "F");
                expect_same_bits(more.particles.stress, one.particles.stress, "stress");
                expect_same_bits(more.particles.mass, one.particles.mass, "mass");
                expect_same_bits(more.particles.body, one.particles.body, "body");
                expect_same_bits(more.particles.id, one.particles.id, "order");
            }
        }
}

} // namespace
