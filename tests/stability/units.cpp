/// Tiny and huge units, cells that are no squares, particles that leave the grid.

#include "stability/hard.h"

#include "results/interpenetration.h"
#include "step/run_error.h"

namespace {

using namespace test;

/// Units of length, time and mass of a scene. Powers of two: numbers in these units have the same digits.
struct Units {
    double length, time, mass;
};

template <int D>
struct Outcome {
    std::vector<Vec<D>> position, velocity;
    std::vector<Mat<D>> deformation;
    double energy, overlap = 0;
    long steps;
};

ContactSpec contact_of(NormalMethod normal, SeparationMethod separation) {
    ContactSpec c = contact(LawType::friction, 0.3);
    c.normal = normal;
    c.separation = separation;
    return c;
}

/// Two disks and a floor, in 3D two cubes and a floor.
template <int D>
Outcome<D> run_in(const Units& u, const TransferSpec& scheme, ContactSpec spec) {
    const double L = u.length, T = u.time;
    const double pascal = u.mass / (L * T * T);
    const MaterialSpec m = material(u.mass / (L * L * L), 100 * pascal, 50 * pascal);
    Scene scene = D == 2 ? plane_scene(L, 0, 0, 14 * L, 14 * L, m) : space_scene(L, 0, 10 * L, m);
    if (D == 2) scene.thickness = L;
    scene.method.transfer = scheme;
    scene.contact = spec;
    scene.gravity = {0, -0.25 * L / (T * T), 0};
    add_wall(scene, "floor", 1, Side::lower, 2 * L, 0, false);
    const double v = 0.5 * L / T;
    Model model;
    if (D == 2) {
        add_disk(model, add_body(model, "a", {v, 0, 0}), 4.4 * L, 4.6 * L, 2.2 * L, 0.5 * L);
        add_disk(model, add_body(model, "b", {-v, -v, 0}), 9 * L, 5.3 * L, 2.2 * L, 0.5 * L);
    } else {
        add_cube(model, add_body(model, "a", {v, 0, 0}), {2 * L, 2.25 * L, 3 * L}, 3 * L, 6);
        add_cube(model, add_body(model, "b", {-v, -v, 0}), {5.125 * L, 2.5 * L, 3.5 * L}, 3 * L, 6);
    }
    State<D> state = make_state<D>(scene, model);
    run(state, (D == 2 ? 4 : 1) * T);
    EXPECT_TRUE(is_sound(state));
    Outcome<D> out;
    const Totals all = totals(state);
    const double joule = u.mass * L * L / (T * T);
    out.energy = (all.kinetic_energy + all.strain_energy) / joule;
    out.steps = state.step;
    out.position.resize(model.size());
    out.velocity.resize(model.size());
    out.deformation.resize(model.size());
    for (std::size_t p = 0; p < state.particles.size(); ++p) {
        const auto id = static_cast<std::size_t>(state.particles.id[p]);
        out.position[id] = state.particles.position[p] / L;
        out.velocity[id] = state.particles.velocity[p] * (T / L);
        out.deformation[id] = state.particles.deformation_gradient[p];
    }
    if constexpr (D == 2) out.overlap = interpenetration(state.particles).fraction();
    return out;
}

template <int D>
void expect_same_in_all_units(const TransferSpec& scheme, const ContactSpec& spec) {
    const Outcome<D> metres = run_in<D>({1, 1, 1}, scheme, spec);
    for (const Units& u : {Units{0x1p-30, 0x1p-36, 0x1p-76}, Units{0x1p10, 0x1p4, 0x1p40}, Units{1, 1, 0x1p-60}}) {
        const Outcome<D> other = run_in<D>(u, scheme, spec);
        EXPECT_EQ(other.steps, metres.steps);
        std::size_t different = 0;
        double largest = 0;
        for (std::size_t p = 0; p < metres.position.size(); ++p) {
            different += other.position[p] != metres.position[p] || other.velocity[p] != metres.velocity[p] ||
                         other.deformation[p] != metres.deformation[p];
            largest = std::max(largest, (other.position[p] - metres.position[p]).norm());
        }
        EXPECT_EQ(different, 0U) << "units of " << u.length << " m, " << u.time << " s, " << u.mass
                                 << " kg; positions differ by up to " << largest << " cells";
        EXPECT_EQ(other.energy, metres.energy);
    }
}

constexpr NormalMethod searched_normals[] = {NormalMethod::logistic_regression, NormalMethod::linear_regression,
                                             NormalMethod::irls_regression,     NormalMethod::average_gradient,
                                             NormalMethod::maximum_gradient,    NormalMethod::maximum_volume};

/// Nanometres and picoseconds, kilometres and seconds, and an odd unit of mass give the same bits.
TEST(Units, NanometresAndKilometresGiveTheSameBits) {
    for (const TransferSpec& scheme : usual_transfers()) {
        SCOPED_TRACE(name_of(scheme));
        expect_same_in_all_units<2>(scheme, contact(LawType::friction, 0.3));
    }
    for (const NormalMethod normal : searched_normals)
        for (const SeparationMethod separation :
             {SeparationMethod::particle_edges, SeparationMethod::critical_position, SeparationMethod::fitted_position,
              SeparationMethod::displacement, SeparationMethod::none}) {
            SCOPED_TRACE("normal " + std::to_string(static_cast<int>(normal)) + ", separation " +
                         std::to_string(static_cast<int>(separation)));
            expect_same_in_all_units<2>(transfer(TransferScheme::xpic, 3), contact_of(normal, separation));
        }
}

TEST(Units, AndInSpace) {
    for (const NormalMethod normal : {NormalMethod::logistic_regression, NormalMethod::average_gradient}) {
        SCOPED_TRACE("normal " + std::to_string(static_cast<int>(normal)));
        expect_same_in_all_units<3>(transfer(TransferScheme::fmpm, 2),
                                    contact_of(normal, SeparationMethod::particle_edges));
    }
}

// === Cells four times as long as high

TEST(Cells, FourTimesAsLongAsHigh) {
    Figures figures("cells 4 : 1");
    for (const bool tall : {false, true})
        for (const ShapeKind shape : {ShapeKind::ugimp, ShapeKind::cpdi, ShapeKind::b2spline})
            for (const TransferSpec& scheme : usual_transfers()) {
                const std::string name =
                    std::string(tall ? "tall, " : "long, ") + name_of(shape) + ", " + name_of(scheme);
                SCOPED_TRACE(name);
                const double cx = tall ? 0.5 : 2, cy = tall ? 2 : 0.5;
                Scene scene = plane_scene(1, 0, 0, 32, 32, material(1, 100, 50));
                scene.grid.cell = {cx, cy, 0};
                scene.method.shape = shape;
                scene.method.transfer = scheme;
                scene.contact = contact(LawType::friction, 0.3);
                Model model;
                const int nx = static_cast<int>(6 * 2 / cx), ny = static_cast<int>(6 * 2 / cy);
                add_box(model, add_body(model, "left", {0.6, 0.2, 0}), 8, 10, 14, 16, nx, ny);
                add_box(model, add_body(model, "right", {-0.6, 0, 0}), 15, 12, 21, 18, nx, ny);
                State<2> state = make_state<2>(scene, model);
                double overlap = 0;
                const auto watch = run_watched(state, 2, [&] {
                    if (state.step % 10 == 0) overlap = std::max(overlap, interpenetration(state.particles).fraction());
                });
                figures.at_most("interpenetration", name, overlap, 0.02);
                watch.expect_energy(figures, name);
                watch.expect_momentum(figures, name);
            }
}

// === Particles that leave the grid

std::string message_of(const std::function<void()>& work) {
    try {
        work();
    } catch (const RunError& error) {
        return error.what();
    }
    return "nothing was thrown";
}

void expect_says(const std::string& message, const std::vector<std::string>& words) {
    for (const std::string& word : words) EXPECT_NE(message.find(word), std::string::npos) << message;
}

TEST(LeavingTheGrid, SaysWhoWhereAndWhen) {
    for (const ShapeKind shape : all_shapes)
        for (const auto& [vx, vy] : {std::pair{-3.0, 0.0}, {3.0, 0.0}, {0.0, -3.0}, {0.0, 3.0}, {3.0, 3.0}}) {
            Scene scene = plane_scene(1, 0, 0, 10, 10, material(1, 100, 50));
            scene.method.shape = shape;
            scene.contact = contact(LawType::friction, 0.3);
            Model model;
            add_box(model, add_body(model, "stays"), 1, 1, 3, 3, 4, 4);
            add_box(model, add_body(model, "leaves", {vx, vy, 0}), 4, 4, 6, 6, 4, 4);
            State<2> state = make_state<2>(scene, model);
            const std::string message = message_of([&] { run(state, 10); });
            expect_says(message, {"step ", "time ", "particle ", "of body \"leaves\"", " at (", "left the grid"});
            // A cell's margin at most: the particle's own step takes it out.
            EXPECT_LT(state.time, 10 / 3.0 + 1);
        }
}

TEST(LeavingTheGrid, InSpace) {
    Scene scene = space_scene(1, 0, 6, material(1, 100, 50));
    Model model;
    add_cube(model, add_body(model, "leaves", {0, 0, 3}), {2, 2, 2}, 2, 4);
    State<3> state = make_state<3>(scene, model);
    const std::string message = message_of([&] { run(state, 10); });
    expect_says(message, {"step ", "time ", "particle ", "of body \"leaves\"", " at (", "left the grid"});
    const std::size_t open = message.find(" at (");
    const std::string place = message.substr(open, message.find(')', open) - open);
    EXPECT_EQ(std::count(place.begin(), place.end(), ','), 2) << "three coordinates: " << message;
}

} // namespace
