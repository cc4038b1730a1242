// Case 4 of the published cases at half resolution: twenty ellipses crushed to a quarter of their height.

#include "geometry/build_model.h"
#include "io/scene/read_scene.h"
#include "results/history.h"
#include "results/interpenetration.h"
#include "step/step.h"

#include <gtest/gtest.h>

#include <cstdio>

namespace abut {
namespace {

struct Result {
    std::array<double, 4> stress{}; ///< mean, xx yy zz xy [Pa]
    double overlap = 0;             ///< share of the area
    double solid = 0;               ///< φ, share of the box before compression
    double lost = 0;                ///< share of the mass
};

Result crush(const std::vector<std::string>& overrides) {
    const std::string file = ABUT_SOURCE_DIR "/examples/ellipses/scene.json";
    const Scene scene = load_scene(file, overrides).scene;
    State<2> state = make_state<2>(scene, build_model(scene, file));
    std::vector<Task<2>> tasks = step_tasks<2>(scene);
    Result result;
    double mass = 0;
    for (std::size_t p = 0; p < state.particles.size(); ++p) {
        mass += state.particles.mass[p];
        result.solid += 4 * state.particles.half_size[p].prod() / 2e-6;
    }
    while (state.time < scene.time.end * (1 - 1e-12)) {
        state.dt = next_step(state, scene.time.end);
        advance(state, tasks);
    }
    Totals all;
    for (const Totals& totals : body_totals(state)) all += totals;
    result.stress = all.mean_stress();
    result.overlap = interpenetration(state.particles).fraction();
    result.lost = 1 - all.mass / mass;
    return result;
}

TEST(Ellipses, CrushedToAQuarterStayApartAndAreAsStiffAsTheSolid) {
    const Result result = crush({"/grid/cell=28.6 um", "/time/cfl=0.3"});
    const double pressure = -(result.stress[0] + result.stress[1] + result.stress[2]) / 3;
    const double J = 0.25 / result.solid;
    const double solid_pressure = 78.09e9 / 2 * (1 / J - J);
    std::printf("axial stress at 75 %%: %.1f GPa (published on its own bitmap: 105); pressure %.1f GPa, of the solid "
                "%.1f GPa; interpenetration %.2f %% of the area\n",
                -result.stress[1] / 1e9, pressure / 1e9, solid_pressure / 1e9, 100 * result.overlap);
    EXPECT_GT(pressure, 0.97 * solid_pressure);
    EXPECT_LT(pressure, 1.15 * solid_pressure);
    EXPECT_LT(result.overlap, 0.015);
    EXPECT_NEAR(result.lost, 0, 1e-12);
}

} // namespace
} // namespace abut
