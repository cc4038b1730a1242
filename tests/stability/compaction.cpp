/// Random packings of ellipses crushed to a quarter of their height, and to 15 %.

#include "stability/hard.h"

#include "geometry/packing/ellipse_packing.h"
#include "results/interpenetration.h"

namespace {

using namespace test;

/// Particles whose centres lie in the ellipse, two to a cell.
void add_ellipse(Model& model, int body, const Ellipse& e, double cells) {
    const double c = std::cos(e.angle), s = std::sin(e.angle), spacing = 0.5;
    const double reach = std::max(e.semi_axes[0], e.semi_axes[1]) * cells;
    const double x0 = e.center[0] * cells, y0 = e.center[1] * cells;
    for (double y = std::floor((y0 - reach) / spacing) * spacing; y < y0 + reach; y += spacing)
        for (double x = std::floor((x0 - reach) / spacing) * spacing; x < x0 + reach; x += spacing) {
            const double dx = x + 0.25 - x0, dy = y + 0.25 - y0;
            if (std::hypot((c * dx + s * dy) / (e.semi_axes[0] * cells),
                           (c * dy - s * dx) / (e.semi_axes[1] * cells)) <= 1)
                add_particle(model, body, x + 0.25, y + 0.25, 0.25, 0.25);
        }
}

struct Packing {
    int grains;
    double width; ///< [cells]; the box is twice as high
    std::uint64_t seed;
};

/// The published bed crushed like this keeps the overlap below 1.5 % of the area and the pressure within 15 % of the
/// solid's at 35 cells (tests/physics/ellipses.cpp). Grains of fewer cells have more surface in proportion, and what
/// overlaps or gapes at a surface is a share of a particle's width.
double in_proportion(double at_35_cells, const Packing& p) {
    return at_35_cells * std::max(1.0, 35 / p.width);
}

void crush(Figures& figures, const Packing& p, double compaction) {
    const std::string name = std::to_string(p.grains) + " grains, " + std::to_string(static_cast<int>(p.width)) +
                             " cells wide, seed " + std::to_string(p.seed);
    SCOPED_TRACE(name);
    PackingRequest request;
    request.width = 1;
    request.height = 2;
    request.bodies = p.grains;
    request.max_aspect = 2.5;
    request.area_fraction = 0.5;
    request.gap = 0.01;
    request.seed = p.seed;
    const double height = 2 * p.width;
    Scene scene = plane_scene(1, 0, 0, p.width, height, material(1, 78.09, 27.6));
    scene.method.transfer = transfer(TransferScheme::xpic, 5);
    scene.contact = contact(LawType::frictionless);
    const double speed = 100.0 / 6400 * wave_speed(scene.materials[0]); // as published
    add_wall(scene, "left", 0, Side::lower, 0, 0, false, 0);
    add_wall(scene, "right", 0, Side::upper, p.width, 0, false, 0);
    add_wall(scene, "floor", 1, Side::lower, 0, 0, false, 0);
    add_wall(scene, "piston", 1, Side::upper, height, -speed, false, 0.5);
    Model model;
    for (const Ellipse& e : pack_ellipses(request))
        add_ellipse(model, add_body(model, std::to_string(model.bodies.size())), e, p.width);
    State<2> state = make_state<2>(scene, model);
    Watch<2> watch(state);
    double overlap = 0;
    auto tasks = step_tasks<2>(scene);
    const double end = compaction * height / speed;
    while (state.time < end * (1 - 1e-12)) {
        state.dt = next_step(state, end);
        advance(state, tasks);
        if (state.step % 4 == 0) watch();
        if (state.step % 200 == 0) overlap = std::max(overlap, interpenetration(state.particles).fraction());
    }
    overlap = std::max(overlap, interpenetration(state.particles).fraction());
    EXPECT_TRUE(is_sound(state));
    const Totals all = totals(state);
    const double J = (1 - compaction) * 2 * p.width * p.width / watch.start.volume;
    const auto stress = all.mean_stress();
    const double pressure = -(stress[0] + stress[1] + stress[2]) / 3;
    std::printf("[ figures  ] %s, %.0f %%: J %.3f, pressure %.3f of the solid's, interpenetration %.4f, %ld steps\n",
                name.c_str(), 100 * compaction, J, pressure / (78.09 / 2 * (1 / J - J)), overlap, state.step);
    const std::string kind = std::to_string(static_cast<int>(100 * compaction + 0.5)) + " %: ";
    figures.at_most(kind + "interpenetration", name, overlap, in_proportion(0.015, p));
    // The grains fill the box: as stiff as the solid.
    figures.at_most(kind + "pressure error", name, std::abs(pressure / (78.09 / 2 * (1 / J - J)) - 1),
                    in_proportion(0.15, p));
    // Grains that overlap are parted, against their pressure: that work is in the ledger. What walls and the first
    // contact pass do to the velocities at the start of a step is not: at the surfaces, and 2 % at 35 cells
    // (survival.cpp).
    const double work = state.ledger.external_work;
    const double contact = std::max(0.0, state.ledger.contact_work);
    std::printf("[ figures  ] energy %.4f of the piston's work, contact's work %.4f of it\n", watch.energy() / work,
                state.ledger.contact_work / work);
    figures.at_most(kind + "energy / work of piston and contact", name, watch.energy() / (work + contact),
                    1 + in_proportion(0.02, p));
}

TEST(Compaction, SixEllipsesToAQuarterOfTheirHeight) {
    Figures figures("compaction");
    crush(figures, {6, 12, 1}, 0.75);
}

TEST(Compaction, FullThreeResolutionsAndPackings) {
    Figures figures("compaction");
    for (const double width : {18.0, 24.0, 36.0})
        for (const std::uint64_t seed : {1, 2, 3})
            for (const double compaction : {0.75, 0.85}) crush(figures, {20, width, seed}, compaction);
}

} // namespace
