/// Contact where the grid or the bodies have corners, and nodes that see many bodies.

#include "stability/hard.h"

#include "results/interpenetration.h"

namespace {

using namespace test;

/// Sides of 4 cells; centre and velocity.
void add_square(Model& model, const std::string& name, double x, double y, Vector v) {
    add_box(model, add_body(model, name, v), x - 2, y - 2, x + 2, y + 2, 8, 8);
}

struct Meeting {
    const char* name;
    double x, y;   ///< of the second square's centre, seen from the first's
    double vx, vy; ///< of the first; the second has the opposite
};

/// Faces and corners on nodes, on edges of cells, and between.
TEST(Corners, SquaresMeetAtNodesEdgesAndCorners) {
    Figures figures("SquaresMeetAtNodesEdgesAndCorners");
    for (const Meeting& m :
         {Meeting{"faces on cell edges", 4, 0, 0.5, 0}, Meeting{"half faces, corners at nodes", 4, 2, 0.5, 0},
          Meeting{"half faces, corners between nodes", 4.1, 1.7, 0.5, 0.1},
          Meeting{"corner to corner at a node", 4, 4, 0.5, 0.5},
          Meeting{"corner to corner in a cell", 4.3, 4.3, 0.5, 0.5},
          Meeting{"corner past corner", 4.2, 3.9, 0.5, 0.05}})
        for (const TransferSpec& scheme : usual_transfers()) {
            const std::string name = std::string(m.name) + ", " + name_of(scheme);
            SCOPED_TRACE(name);
            Scene scene = plane_scene(1, 0, 0, 20, 20, material(1, 100, 50));
            scene.method.transfer = scheme;
            scene.contact = contact(LawType::friction, 0.3);
            Model model;
            add_square(model, "first", 8, 8, {m.vx, m.vy, 0});
            add_square(model, "second", 8 + m.x, 8 + m.y, {-m.vx, -m.vy, 0});
            State<2> state = make_state<2>(scene, model);
            double overlap = 0;
            const auto watch =
                run_watched(state, 2, [&] { overlap = std::max(overlap, interpenetration(state.particles).overlap); });
            // A corner that pierces another body by half a particle each way.
            figures.at_most("interpenetration / particle", name, overlap / 0.25, 0.5);
            watch.expect_energy(figures, name);
            watch.expect_momentum(figures, name);
        }
}

/// A square that stands on its corner falls on a block, its corner on a node and between nodes.
TEST(Corners, CornerThroughAFace) {
    Figures figures("CornerThroughAFace");
    for (const double shift : {0.0, 0.25, 0.5})
        for (const TransferSpec& scheme : usual_transfers()) {
            const std::string name = "shift " + std::to_string(shift).substr(0, 4) + ", " + name_of(scheme);
            SCOPED_TRACE(name);
            Scene scene = plane_scene(1, 0, 0, 18, 18, material(1, 100, 50));
            scene.method.transfer = scheme;
            scene.contact = contact(LawType::friction, 0.3);
            Model model;
            add_box(model, add_body(model, "block"), 3, 3, 15, 8, 24, 10);
            model.angle.assign(model.size(), 0);
            const int body = add_body(model, "corner", {0, -1, 0});
            const double r = std::sqrt(0.5), x = 9 + shift, y = 8 + 4 * r; // of a square of 4 cells
            for (int j = 0; j < 8; ++j)
                for (int i = 0; i < 8; ++i) {
                    const double a = 0.5 * i - 1.75, b = 0.5 * j - 1.75;
                    add_particle(model, body, x + r * (a - b), y + r * (a + b), 0.25, 0.25);
                    model.angle.push_back(M_PI / 4);
                }
            State<2> state = make_state<2>(scene, model);
            double overlap = 0;
            const auto watch =
                run_watched(state, 2, [&] { overlap = std::max(overlap, interpenetration(state.particles).overlap); });
            figures.at_most("interpenetration / particle", name, overlap / 0.25, 0.5);
            watch.expect_energy(figures, name);
            watch.expect_momentum(figures, name);
        }
}

/// 144 bodies of one particle, four in a cell: two heaps that fly into each other, and some heat.
State<2> powder(const TransferSpec& scheme, ThreeOrMore rule) {
    Scene scene = plane_scene(1, 0, 0, 16, 16, material(1, 100, 50));
    scene.method.transfer = scheme;
    scene.contact = contact(LawType::friction, 0.3);
    scene.contact->three_or_more = rule;
    std::mt19937 random(11);
    std::uniform_real_distribution<double> in(-0.3, 0.3);
    Model model;
    for (int j = 0; j < 12; ++j)
        for (int i = 0; i < 12; ++i) {
            const Vector v{(i < 6 ? 0.5 : -0.5) + in(random), in(random), 0};
            add_particle(model, add_body(model, std::to_string(12 * j + i), v), 5.25 + 0.5 * i, 5.25 + 0.5 * j, 0.25,
                         0.25);
        }
    return make_state<2>(scene, model);
}

/// Share of the contact nodes that see three bodies or more.
double crowded(const State<2>& state) {
    std::size_t many = 0;
    for (const ContactNode<2>& node : state.fields.contact_nodes) many += node.count >= 3;
    return static_cast<double>(many) / static_cast<double>(state.fields.contact_nodes.size());
}

/// A grain's edges may be passed by a fortieth of its width on each of its four sides.
constexpr double most_of_powder = 0.05;

TEST(Powder, EveryNodeSeesManyBodies) {
    Figures figures("powder, explicit");
    for (const TransferSpec& scheme : usual_transfers()) {
        const std::string name = name_of(scheme);
        SCOPED_TRACE(name);
        State<2> state = powder(scheme, ThreeOrMore::explicit_);
        double overlap = 0;
        const auto watch = run_watched(state, 2, [&] {
            if (state.step == 1) {
                EXPECT_GT(crowded(state), 0.8) << "or it is not the case meant";
            }
            overlap = std::max(overlap, interpenetration(state.particles).fraction());
        });
        figures.at_most("interpenetration", name, overlap, most_of_powder);
        watch.expect_energy(figures, name);
        watch.expect_momentum(figures, name);
    }
}

/// One body against all others as one has one normal, and neighbours on opposite sides cancel in it. The rule is there
/// for comparison: grains pass into each other, and the work that it does shows in the ledger. Nothing breaks.
TEST(Powder, LumpedRulesDontHoldItButTheRunGoesOn) {
    Figures figures("powder, lumped or up to two");
    for (const ThreeOrMore rule : {ThreeOrMore::up_to_two, ThreeOrMore::lumped})
        for (const TransferSpec& scheme : usual_transfers()) {
            const std::string name =
                std::string(rule == ThreeOrMore::lumped ? "lumped, " : "up to two, ") + name_of(scheme);
            SCOPED_TRACE(name);
            State<2> state = powder(scheme, rule);
            double overlap = 0, contact_work = 0;
            const auto watch = run_watched(state, 2, [&] {
                overlap = std::max(overlap, interpenetration(state.particles).fraction());
                contact_work = std::max(contact_work, state.ledger.contact_work);
            });
            EXPECT_GT(overlap, 2 * most_of_powder) << "this limit is gone: say so in the table";
            // Each grain may be half inside others, no more.
            figures.at_most("interpenetration", name, overlap, 0.5);
            watch.expect_energy(figures, name, contact_work / watch.largest);
        }
}

} // namespace
