/// Contact paper §3.4 and figure 4 (case 3): one block over two, compressed by 5 %, against one body.

#include "core/support.h"

#include "results/interpenetration.h"

#include <cstdio>

namespace {

using namespace test;

constexpr double mm = 1e-3;

struct Compressed {
    double stress;  ///< mean axial [Pa]
    double opening; ///< of the joint between the lower blocks near its top: largest distance of their edges [cells]
};

Compressed compress(std::optional<ThreeOrMore> three_or_more) {
    const MaterialSpec m = material(1000, 2450e6, 940e6);
    Scene scene = plane_scene(5 * mm, -40 * mm, 0, 40 * mm, 80 * mm, m);
    scene.method.shape = ShapeKind::ugimp;
    scene.method.transfer = transfer(TransferScheme::flip);
    const double v = 0.001 * wave_speed(m);
    add_wall(scene, "bottom", 1, Side::lower, 0);
    add_wall(scene, "top", 1, Side::upper, 80 * mm, -v);
    if (three_or_more) {
        scene.contact = contact(LawType::friction, 0.2);
        scene.contact->three_or_more = *three_or_more;
    }
    Model model;
    const int left = add_body(model, "left");
    const int right = three_or_more ? add_body(model, "right") : left;
    const int upper = three_or_more ? add_body(model, "upper") : left;
    add_box(model, left, -30 * mm, 0, 0, 40 * mm, 12, 16);
    add_box(model, right, 0, 0, 30 * mm, 40 * mm, 12, 16);
    add_box(model, upper, -30 * mm, 40 * mm, 30 * mm, 80 * mm, 24, 16);
    State<2> state = make_state<2>(scene, model);
    run(state, 0.05 * 80 * mm / v);
    // Particles were 16 rows of 12 + 12; the joint's top particles are the last of row 16 left, the first right.
    Vec<2> a, b;
    for (std::size_t p = 0; p < state.particles.size(); ++p) {
        if (state.particles.id[p] == 12 * 15 + 11) a = state.particles.position[p];
        if (state.particles.id[p] == 12 * 16 + 12 * 15) b = state.particles.position[p];
    }
    return {totals(state).mean_stress()[1], (b[0] - a[0]) / (5 * mm) - 0.5};
}

TEST(ThreeBodies, OneBlockOverTwo) {
    const Compressed one = compress({});
    const Compressed pairs = compress(ThreeOrMore::explicit_);
    const Compressed lumped = compress(ThreeOrMore::lumped);
    std::printf(
        "[ figures  ] one block over two at 5 %%: explicit %+.4f %%, joint %+.4f cells; lumped %+.4f %%, joint "
        "%+.4f cells; single body %+.4f cells; published: lumped opens the joint, force close; explicit mends it\n",
        100 * (pairs.stress / one.stress - 1), pairs.opening, 100 * (lumped.stress / one.stress - 1), lumped.opening,
        one.opening);
    EXPECT_NEAR(pairs.stress / one.stress, 1, 0.005);
    EXPECT_NEAR(pairs.opening, one.opening, 0.01);
    EXPECT_NEAR(lumped.stress / one.stress, 1, 0.05) << "global force close to single body";
}

} // namespace
