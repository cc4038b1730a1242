#include "results/frames.h"

#include "results/arrays.h"

#include "dense.h"

#include "contact/find_contacts.h"

#include <gmock/gmock.h>

namespace {

using namespace test;

const std::vector<double>& numbers(const std::vector<Array>& arrays, const std::string& name) {
    for (const Array& array : arrays)
        if (array.name == name) return std::get<std::vector<double>>(array.values);
    throw std::runtime_error("no array " + name);
}

/// Two blocks pressed together along a plane of given height.
State<2> two_blocks(double interface, ShapeKind shape, TransferScheme scheme = TransferScheme::flip) {
    Scene scene = plane_scene(1, 0, 0, 12, 12, material(1, 100, 40));
    scene.method.shape = shape;
    scene.method.transfer = transfer(scheme, 3);
    scene.contact = contact(LawType::friction, 0.2);
    Model model;
    const int below = add_body(model, "below", {0, 0.4, 0});
    const int above = add_body(model, "above", {0.1, -0.4, 0});
    add_box(model, below, 2.25, interface - 4, 9.25, interface, 14, 8);
    add_box(model, above, 2.25, interface, 9.25, interface + 4, 14, 8);
    return make_state<2>(scene, model);
}

TEST(Frames, ContactAreasAddUpToTheInterface) {
    for (const ShapeKind shape : {ShapeKind::ugimp, ShapeKind::cpdi})
        for (const double height : {6.0, 6.13, 6.5, 5.71}) {
            State<2> state = two_blocks(height, shape);
            look(state);
            const PointFrame frame = contact_frame(state);
            double sum = 0;
            for (const double area : numbers(frame.arrays, "area")) sum += area;
            EXPECT_NEAR(sum, 7, 0.02 * 7) << height;
        }
}

/// Everything that the next step reads, by particle id.
std::vector<double> fingerprint(const State<2>& state) {
    const auto& particles = state.particles;
    std::vector<double> values(particles.size() * 14);
    for (std::size_t p = 0; p < particles.size(); ++p) {
        double* to = values.data() + 14 * particles.id[p];
        for (int a = 0; a < 2; ++a) *to++ = particles.position[p][a];
        for (int a = 0; a < 2; ++a) *to++ = particles.velocity[p][a];
        for (int c = 0; c < 4; ++c) *to++ = particles.deformation_gradient[p](c / 2, c % 2);
        for (int c = 0; c < 4; ++c) *to++ = particles.stress[p][c];
    }
    values.push_back(state.time);
    values.push_back(state.ledger.contact_work);
    values.push_back(state.ledger.external_work);
    return values;
}

TEST(Frames, LookingChangesNothingThatFollows) {
    for (const ShapeKind shape : {ShapeKind::ugimp, ShapeKind::cpdi})
        for (const TransferScheme scheme : {TransferScheme::flip, TransferScheme::xpic}) {
            State<2> plain = two_blocks(6, shape, scheme);
            State<2> watched = two_blocks(6, shape, scheme);
            for (State<2>* state : {&plain, &watched}) {
                for (auto& v : state->particles.velocity) v += Vec<2>(1.3, 0.4); // drifts over blocks
                add_wall(state->scene, "right", 0, Side::upper, 11);
                state->boundaries.push_back({"right", state->scene.boundaries.back().condition, {}});
                state->effects = effects_of(state->scene);
            }
            look(watched);
            const auto all_frames = [&] {
                if (watched.step % 3 != 0) return;
                look(watched);
                particle_frame(watched);
                grid_frame(watched);
                contact_frame(watched);
            };
            for (const double until : {0.3, 2.0}) {
                run(plain, until);
                run(watched, until, all_frames);
                EXPECT_EQ(plain.step, watched.step);
                EXPECT_EQ(fingerprint(plain), fingerprint(watched));
                State<2> copy = plain;
                look(copy);
                look(watched);
                const std::vector<double> force = numbers(contact_frame(copy).arrays, "force");
                EXPECT_EQ(force, numbers(contact_frame(watched).arrays, "force"));
                EXPECT_EQ(until < 1, std::count(force.begin(), force.end(), 0.0) < std::ssize(force)) << "they part";
            }
        }
}

TEST(Frames, ParticlesComeInTheModelsOrderWithCauchyStress) {
    State<2> state = two_blocks(6, ShapeKind::cpdi);
    const auto initial = state.initial_position;
    run(state, 0.5);
    const PointFrame frame = particle_frame(state);
    const auto& particles = state.particles;
    const auto& stress = numbers(frame.arrays, "stress");
    const auto& volume = numbers(frame.arrays, "volume");
    const auto& displacement = numbers(frame.arrays, "displacement");
    const auto& pressure = numbers(frame.arrays, "pressure");
    EXPECT_EQ(frame.time, state.time);
    for (std::size_t p = 0; p < particles.size(); ++p) {
        const std::size_t i = particles.id[p];
        const double J = particles.deformation_gradient[p].determinant();
        EXPECT_NEAR(volume[i], J * 0.25, 1e-14);
        EXPECT_NEAR(stress[6 * i], particles.stress[p][0] / J, 1e-12);
        EXPECT_NEAR(stress[6 * i + 3], particles.stress[p][3] / J, 1e-12);
        EXPECT_NEAR(pressure[i], -(particles.stress[p][0] + particles.stress[p][1] + particles.stress[p][2]) / 3 / J,
                    1e-12);
        for (int a = 0; a < 2; ++a) {
            EXPECT_EQ(frame.points[3 * i + a], particles.position[p][a]);
            EXPECT_NEAR(displacement[3 * i + a], particles.position[p][a] - initial[i][a], 1e-15);
        }
    }
}

TEST(Frames, TheGridCarriesMassAndMomentumOfTheParticles) {
    State<2> state = two_blocks(6.3, ShapeKind::ugimp);
    run(state, 0.5);
    look(state);
    const GridFrame frame = grid_frame(state);
    const auto& mass = numbers(frame.arrays, "mass");
    const auto& velocity = numbers(frame.arrays, "velocity");
    const Totals all = totals(state);
    ASSERT_EQ(mass.size(), 13u * 13u);
    double sum = 0, momentum = 0, moment = 0;
    for (std::size_t i = 0; i < mass.size(); ++i) {
        sum += mass[i];
        momentum += mass[i] * velocity[3 * i + 1];
        moment += mass[i] * (frame.origin[1] + static_cast<double>(i / 13) * frame.spacing[1]);
    }
    EXPECT_NEAR(sum, all.mass, 1e-12 * all.mass);
    EXPECT_NEAR(momentum, all.momentum[1], 1e-12 * all.mass);
    EXPECT_NEAR(moment, all.first_moment[1], 1e-12 * all.mass * 12);
}

/// Clouds against brute force: all particles with a positive weight at the node.
TEST(Frames, CloudsAreTheParticlesThatANodeSees) {
    for (const ShapeKind shape : {ShapeKind::ugimp, ShapeKind::cpdi}) {
        State<2> state = two_blocks(6.13, shape);
        run(state, 1.5);
        look(state);
        const auto& contact = state.contact;
        ASSERT_GT(contact.groups.size(), 5u);
        for (std::size_t g = 0; g < contact.groups.size(); ++g) {
            const auto first = contact.cloud_particles.begin() + static_cast<long>(g) * contact.cloud_capacity;
            std::vector<int> found(first, first + contact.cloud_size[g]);
            std::vector<int> expected;
            for (std::size_t p = 0; p < state.particles.size(); ++p)
                if (reference_weight<2>(shape, state.grid, domain_of(state.particles, p), contact.groups[g].node).S >
                    1e-12)
                    expected.push_back(static_cast<int>(p));
            for (const int p : expected) EXPECT_THAT(found, testing::Contains(p));
            for (const int p : found) {
                const double S =
                    reference_weight<2>(shape, state.grid, domain_of(state.particles, p), contact.groups[g].node).S;
                EXPECT_GT(S, -1e-15);
            }
            std::sort(found.begin(), found.end());
            EXPECT_EQ(std::adjacent_find(found.begin(), found.end()), found.end()) << "no particle twice";
            EXPECT_LE(found.size(), expected.size() + 2) << "round-off at the rim";
        }
    }
}

std::vector<std::string> names_of(const std::vector<Array>& arrays) {
    std::vector<std::string> names;
    for (const Array& array : arrays) names.push_back(array.name);
    return names;
}

TEST(Frames, HaveTheArraysOfTheTableWithTheirUnits) {
    State<2> state = two_blocks(6, ShapeKind::cpdi);
    state.temperature.assign(state.particles.size(), 293);
    state.orientation.assign(state.particles.size(), 0.5);
    look(state);
    const auto expect = [](const std::vector<Array>& arrays, std::span<const ArrayInfo> table) {
        EXPECT_EQ(arrays.size(), table.size());
        for (const ArrayInfo& info : table) {
            const auto found = std::find_if(arrays.begin(), arrays.end(), [&](auto& a) { return a.name == info.name; });
            ASSERT_NE(found, arrays.end()) << info.name;
            EXPECT_EQ(found->components, info.components) << info.name;
            EXPECT_EQ(found->unit, info.unit) << info.name;
        }
    };
    expect(particle_frame(state).arrays, particle_arrays());
    expect(grid_frame(state).arrays, grid_arrays());
    expect(contact_frame(state).arrays, contact_arrays());
}

TEST(Frames, AChoiceOfArraysLeavesTheirValuesAsTheyAre) {
    State<2> state = two_blocks(6, ShapeKind::cpdi);
    run(state, 0.7);
    look(state);
    const PointFrame particles = particle_frame(state, {{"stress", "id"}, {}});
    EXPECT_THAT(names_of(particles.arrays), testing::UnorderedElementsAre("stress", "id"));
    EXPECT_EQ(numbers(particles.arrays, "stress"), numbers(particle_frame(state).arrays, "stress"));
    EXPECT_THAT(names_of(grid_frame(state, {{"mass"}, {}}).arrays), testing::ElementsAre("mass"));
    const PointFrame contact = contact_frame(state, {{"separation"}, {}});
    EXPECT_THAT(names_of(contact.arrays), testing::ElementsAre("separation"));
    EXPECT_EQ(numbers(contact.arrays, "separation"), numbers(contact_frame(state).arrays, "separation"));
}

/// Bodies "grain-1", "grain-2" of the legend entry "grain", and "grain-3", which is a body of its own.
TEST(Frames, BodiesAreChosenByTheirOwnNamesOrTheirGroups) {
    State<2> state = two_blocks(6, ShapeKind::cpdi);
    state.bodies[0].name = "grain-1";
    state.bodies[0].group = "grain";
    state.bodies[1].name = "grain-3";
    const auto chosen = [&](const std::vector<std::string>& names) {
        state.scene.output.bodies = names;
        return chosen_bodies(state);
    };
    EXPECT_EQ(chosen({}), std::vector<bool>{});
    EXPECT_EQ(chosen({"grain"}), (std::vector<bool>{true, false}));
    EXPECT_EQ(chosen({"grain-3"}), (std::vector<bool>{false, true}));
    EXPECT_EQ(chosen({"grain-3", "grain-1"}), (std::vector<bool>{true, true}));
}

TEST(Frames, AChoiceOfBodiesKeepsIdsAndContactsWithOthers) {
    State<2> state = two_blocks(6, ShapeKind::cpdi);
    run(state, 0.7);
    look(state);
    const PointFrame all = particle_frame(state);
    const PointFrame above = particle_frame(state, {{}, {false, true}});
    const auto whole = [](const PointFrame& frame, const std::string& name) -> const std::vector<std::int32_t>& {
        const auto found = std::find_if(frame.arrays.begin(), frame.arrays.end(),
                                        [&](const Array& array) { return array.name == name; });
        return std::get<1>(found->values);
    };
    const auto& ids = whole(above, "id");
    ASSERT_EQ(ids.size(), 14u * 8u);
    const auto& stress = numbers(all.arrays, "stress");
    for (std::size_t i = 0; i < ids.size(); ++i) {
        const auto id = static_cast<std::size_t>(ids[i]);
        EXPECT_EQ(whole(all, "body")[id], 1) << "the body";
        for (std::size_t k = 0; k < 6; ++k) EXPECT_EQ(numbers(above.arrays, "stress")[6 * i + k], stress[6 * id + k]);
        for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(above.points[3 * i + k], all.points[3 * id + k]);
    }
    EXPECT_EQ(contact_frame(state, {{}, {false, true}}).points, contact_frame(state).points);
    EXPECT_TRUE(contact_frame(state, {{}, {false, false}}).points.empty());
}

TEST(Frames, StrainEnergyDensityAddsUpToTheHistorys) {
    State<2> state = two_blocks(6, ShapeKind::cpdi);
    run(state, 1.5);
    const PointFrame frame = particle_frame(state);
    double sum = 0;
    for (std::size_t p = 0; p < state.particles.size(); ++p)
        sum += numbers(frame.arrays, "strain_energy_density")[p] * numbers(frame.arrays, "volume")[p];
    const double expected = totals(state).strain_energy;
    EXPECT_GT(expected, 0);
    EXPECT_NEAR(sum, expected, 1e-12 * expected);
}

} // namespace
