#include "support.h"

#include "material/material.h"

#include <map>

namespace {

using namespace test;

State<2> moving_cloud(int seed) {
    Scene scene = plane_scene(1, 0, 0, 20, 20, material(3, 50, 20));
    scene.thickness = 0.7;
    scene.contact = contact(LawType::frictionless);
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> in(0, 1);
    Model model;
    for (const char* name : {"a", "b", "c"}) add_body(model, name);
    for (int p = 0; p < 200; ++p) add_particle(model, p % 2, 4 + 12 * in(random), 4 + 12 * in(random), 0.2, 0.3);
    State<2> state = make_state<2>(scene, model);
    for (std::size_t p = 0; p < state.particles.size(); ++p) {
        state.particles.velocity[p] = Vec<2>(in(random), in(random)-1);
        state.particles.deformation_gradient[p] = random_deformation<2>(random, 0.3);
        state.particles.stress[p] << in(random), in(random), in(random), in(random);
    }
    prepare(state);
    return state;
}

TEST(History, TotalsAreTheSumsOverParticles) {
    State<2> state = moving_cloud(1);
    const auto& particles = state.particles;
    const std::vector<Totals> found = body_totals(state);
    ASSERT_EQ(found.size(), 3u);
    EXPECT_EQ(found[2].mass, 0) << "a body without particles";
    for (int body = 0; body < 2; ++body) {
        double mass = 0, volume = 0, kinetic = 0, strain = 0, spin = 0;
        Vec<2> momentum(0, 0), moment(0, 0);
        Stress<2> stress = Stress<2>::Zero();
        for (std::size_t p = 0; p < particles.size(); ++p) {
            if (particles.body[p] != body) continue;
            const Mat<2>& F = particles.deformation_gradient[p];
            const double V0 = 0.4 * 0.6 * 0.7;
            mass += 3 * V0;
            volume += F.determinant() * V0;
            kinetic += 0.5 * 3 * V0 * particles.velocity[p].squaredNorm();
            strain += V0 * NeoHookeanIsochoric{50, 20}.energy(strain_of<2>(F));
            momentum += 3 * V0 * particles.velocity[p];
            moment += 3 * V0 * particles.position[p];
            stress += F.determinant() * V0 * (particles.stress[p] / F.determinant()); // V σ
            spin += 3 * V0 *
                    (particles.position[p][0] * particles.velocity[p][1] -
                     particles.position[p][1] * particles.velocity[p][0]);
        }
        EXPECT_NEAR(found[body].mass, mass, 1e-13 * mass);
        EXPECT_NEAR(found[body].volume, volume, 1e-13 * volume);
        EXPECT_NEAR(found[body].kinetic_energy, kinetic, 1e-13 * kinetic);
        EXPECT_NEAR(found[body].strain_energy, strain, 1e-13 * strain);
        EXPECT_NEAR(found[body].angular_momentum_z, spin, 1e-12 * mass * 20);
        for (int a = 0; a < 2; ++a) {
            EXPECT_NEAR(found[body].momentum[a], momentum[a], 1e-13 * mass);
            EXPECT_NEAR(found[body].center()[a], moment[a] / mass, 1e-12);
            EXPECT_NEAR(found[body].mean_velocity()[a], momentum[a] / mass, 1e-13);
        }
        for (int c = 0; c < 4; ++c) EXPECT_NEAR(found[body].mean_stress()[c], stress[c] / volume, 1e-13);
    }
}

TEST(History, RowsHaveAValueForEveryColumn) {
    State<2> state = moving_cloud(2);
    add_wall(state.scene, "floor", 1, Side::lower, 1);
    state.boundaries.push_back({"floor", state.scene.boundaries[0].condition, {1, 6, 0}});
    const Totals all = totals(state);
    const auto columns = history_columns(state);
    const auto row = history_row(state, all, 2);
    ASSERT_EQ(columns.size(), row.size());
    std::map<std::string, double> value;
    for (std::size_t i = 0; i < row.size(); ++i) value[columns[i]] = row[i];
    ASSERT_EQ(value.size(), columns.size()) << "names are unique";
    EXPECT_EQ(value["total_energy"], all.kinetic_energy + all.strain_energy);
    EXPECT_EQ(value["momentum_y"], all.momentum[1]);
    EXPECT_EQ(value["mean_stress_xy"], all.mean_stress()[3]);
    EXPECT_EQ(value["force_floor_y"], 3);
    EXPECT_EQ(value["force_floor_x"], 0.5);
    EXPECT_EQ(value["force_floor_z"], 0);
    EXPECT_EQ(state.boundaries[0].impulse, Vector{}) << "the next interval has begun";
    EXPECT_EQ(body_columns().size(), body_row(all).size());
}

TEST(History, AngularVelocityOfARotatingDisk) {
    Scene scene = plane_scene(0.1, -2, -2, 2, 2, material(3, 50, 20));
    Model model;
    add_disk(model, add_body(model, "disk"), 0.313, -0.207, 1, 0.05);
    State<2> state = make_state<2>(scene, model);
    for (std::size_t p = 0; p < state.particles.size(); ++p) {
        const Vec<2> arm = state.particles.position[p] - Vec<2>(0.313, -0.207);
        state.particles.velocity[p] = Vec<2>(5 - 0.8 * arm[1], -2 + 0.8 * arm[0]); // moves on as well
    }
    prepare(state);
    EXPECT_NEAR(body_totals(state)[0].angular_velocity_z(), 0.8, 1e-13);
}

} // namespace
