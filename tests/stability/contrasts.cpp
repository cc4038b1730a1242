/// Materials that differ a thousandfold.

#include "stability/hard.h"

#include "results/interpenetration.h"

namespace {

using namespace test;

struct Contrast {
    const char* name;
    double density, stiffness; ///< of the hard body over the soft one's
};

/// A hard bullet hits a soft block that hits a hard wall of matter: no boundary, so that momentum is kept.
TEST(Contrasts, ThousandToOneInStiffnessAndDensity) {
    Figures figures("ThousandToOneInStiffnessAndDensity");
    for (const Contrast& c : {Contrast{"stiffness 1000", 1, 1000}, Contrast{"density 1000", 1000, 1},
                              Contrast{"both 1000", 1000, 1000}, Contrast{"density 1/1000, stiffness 1000", 1e-3, 1000},
                              Contrast{"density 1000, stiffness 1/1000", 1000, 1e-3}})
        for (const TransferSpec& scheme : usual_transfers()) {
            const std::string name = std::string(c.name) + ", " + name_of(scheme);
            SCOPED_TRACE(name);
            Scene scene = plane_scene(1, 0, 0, 24, 12, material(1, 100, 50));
            scene.materials.push_back(material(c.density, 100 * c.stiffness, 50 * c.stiffness));
            scene.method.transfer = scheme;
            scene.contact = contact(LawType::friction, 0.3);
            Model model;
            add_box(model, add_body(model, "soft"), 9, 3, 13, 9, 8, 12);
            add_box(model, add_body(model, "bullet", {1, 0.1, 0}), 5.9, 4.8, 8.9, 6.8, 6, 4);
            add_box(model, add_body(model, "anvil"), 13, 3, 17, 9, 8, 12);
            model.bodies[1].material = model.bodies[2].material = 1;
            State<2> state = make_state<2>(scene, model);
            double overlap = 0;
            // As long as the slow body's waves cross the scene or the bullet moves 1.5 cells, but not forever.
            const double until = c.density * 1000 < 2 ? 0.25 : 1.5;
            const auto watch = run_watched(state, until, [&] {
                if (state.step % 20 == 0) overlap = std::max(overlap, interpenetration(state.particles).fraction());
            });
            figures.at_most("interpenetration", name, overlap, 0.02);
            watch.expect_energy(figures, name);
            watch.expect_momentum(figures, name);
        }
}

} // namespace
