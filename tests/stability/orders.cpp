/// XPIC and FMPM of every order, and every method on one crash.

#include "stability/hard.h"

#include "step/run_error.h"

namespace {

using namespace test;

/// Two squares of 4 cells that hit each other off centre.
State<2> crash(const Scene& scene) {
    Model model;
    add_box(model, add_body(model, "left", {0.6, 0.1, 0}), 3.3, 4.1, 7.3, 8.1, 8, 8);
    add_box(model, add_body(model, "right", {-0.6, 0, 0}), 7.5, 5.2, 11.5, 9.2, 8, 8);
    return make_state<2>(scene, model);
}

Scene crash_scene() {
    Scene scene = plane_scene(1, 0, 0, 15, 13, material(1, 100, 50));
    scene.contact = contact(LawType::friction, 0.3);
    return scene;
}

TEST(Orders, OneToSixteenOfXpicAndFmpm) {
    Figures figures("XPIC and FMPM of orders 1 to 16");
    for (const ShapeKind shape : {ShapeKind::ugimp, ShapeKind::gimp, ShapeKind::cpdi, ShapeKind::b2spline,
                                  ShapeKind::b2gimp, ShapeKind::b2cpdi})
        for (const TransferScheme scheme : {TransferScheme::xpic, TransferScheme::fmpm})
            for (int order = 1; order <= 16; ++order) {
                Scene scene = crash_scene();
                scene.method.shape = shape;
                scene.method.transfer = {scheme, order, {}, {}};
                const std::string name = std::string(name_of(shape)) + ", " + name_of(scene.method.transfer);
                SCOPED_TRACE(name);
                State<2> state = crash(scene);
                const auto watch = run_watched(state, 1.5);
                watch.expect_energy(figures, name);
                watch.expect_momentum(figures, name);
            }
}

struct Combination {
    ShapeKind shape;
    TransferSpec transfer;
    NormalMethod normal;
    SeparationMethod separation = SeparationMethod::particle_edges;
    StressUpdate stress = StressUpdate::usl;
};

constexpr NormalMethod all_normals[] = {NormalMethod::logistic_regression, NormalMethod::linear_regression,
                                        NormalMethod::irls_regression,     NormalMethod::average_gradient,
                                        NormalMethod::maximum_gradient,    NormalMethod::maximum_volume,
                                        NormalMethod::own_gradient,        NormalMethod::specified};
constexpr const char* normal_names[] = {"logistic",         "linear",         "irls", "average",
                                        "maximum gradient", "maximum volume", "own",  "specified"};

std::string words_of(const Combination& c) {
    constexpr const char* separations[] = {"edges", "critical", "fitted", "displacement", "none"};
    constexpr const char* updates[] = {"usf", "usavg", "usl", "usl+", "usavg+"};
    return std::string(name_of(c.shape)) + ", " + name_of(c.transfer) + ", " +
           normal_names[static_cast<int>(c.normal)] + ", " + separations[static_cast<int>(c.separation)] + ", " +
           updates[static_cast<int>(c.stress)];
}

void expect_crash_goes_well(Figures& figures, const Combination& c) {
    const std::string name = words_of(c);
    SCOPED_TRACE(name);
    Scene scene = crash_scene();
    scene.method.shape = c.shape;
    scene.method.transfer = c.transfer;
    scene.method.stress_update = c.stress;
    scene.contact->normal = c.normal;
    scene.contact->separation = c.separation;
    scene.contact->direction = {1, 0, 0};
    State<2> state = crash(scene);
    double contact_work = 0;
    const auto watch =
        run_watched(state, 1.5, [&] { contact_work = std::max(contact_work, state.ledger.contact_work); });
    watch.expect_energy(figures, name, contact_work / watch.largest);
    if (c.normal != NormalMethod::own_gradient) watch.expect_momentum(figures, name); // see advice()
}

TEST(Combinations, EveryShapeTransferAndNormalOnOneCrash) {
    Figures figures("every shape, transfer, normal");
    for (const ShapeKind shape : all_shapes)
        for (const TransferSpec& scheme : usual_transfers())
            for (const NormalMethod normal : all_normals) {
                Combination c{shape, scheme, normal};
                if (shape == ShapeKind::linear) c.stress = StressUpdate::usf; // see advice()
                expect_crash_goes_well(figures, c);
            }
}

TEST(Combinations, FullEverySeparationAndStressUpdateToo) {
    Figures figures("every shape, transfer, normal, separation, stress update");
    for (const ShapeKind shape : all_shapes)
        for (const TransferSpec& scheme : usual_transfers())
            for (const NormalMethod normal : all_normals)
                for (const SeparationMethod separation :
                     {SeparationMethod::particle_edges, SeparationMethod::critical_position,
                      SeparationMethod::fitted_position, SeparationMethod::displacement, SeparationMethod::none})
                    for (const StressUpdate stress : {StressUpdate::usf, StressUpdate::usavg, StressUpdate::usl,
                                                      StressUpdate::usl_plus, StressUpdate::usavg_plus})
                        if (shape != ShapeKind::linear || stress != StressUpdate::usl)
                            expect_crash_goes_well(figures, {shape, scheme, normal, separation, stress});
}

} // namespace
