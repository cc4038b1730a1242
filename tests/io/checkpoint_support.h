#pragma once
/// \file checkpoint_support.h
/// Small states of every kind, checkpoints as documents that can be changed at will, and what is the same.

#include "core/support.h"
#include "io/results_support.h"

#include "io/checkpoint/checkpoint.h"
#include "io/checkpoint/hdf5_file.h"
#include "results/history.h"
#include "step/watch.h"

#include <cstring>
#include <hdf5.h>
#include <map>

namespace abut::test {

// === Checkpoints as documents

/// A data set of a file; one of its three kinds of values is used.
struct Dataset {
    enum class Kind { reals, integers, text } kind{};
    Shape shape;
    std::vector<double> reals;
    std::vector<std::int64_t> integers;
    std::string text;
};

/// All data sets of an HDF5 file by their names.
using Document = std::map<std::string, Dataset>;

/// Reads a file by HDF5 alone.
inline Document read_document(const std::filesystem::path& path) {
    Document document;
    const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
    const auto visit = [](hid_t root, const char* name, const H5O_info_t* info, void* to) -> herr_t {
        if (info->type != H5O_TYPE_DATASET) return 0;
        Dataset& set = (*static_cast<Document*>(to))[name];
        const hid_t data = H5Dopen2(root, name, H5P_DEFAULT);
        const hid_t space = H5Dget_space(data);
        const hid_t type = H5Dget_type(data);
        std::vector<hsize_t> extents(static_cast<std::size_t>(H5Sget_simple_extent_ndims(space)));
        H5Sget_simple_extent_dims(space, extents.data(), nullptr);
        set.shape.assign(extents.begin(), extents.end());
        const auto count = static_cast<std::size_t>(H5Sget_simple_extent_npoints(space));
        const auto read = [&](auto& values, hid_t as) {
            values.resize(count);
            H5Dread(data, as, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
        };
        if (H5Tget_class(type) == H5T_FLOAT) {
            set.kind = Dataset::Kind::reals;
            read(set.reals, H5T_NATIVE_DOUBLE);
        } else if (H5Tget_size(type) == 8) {
            set.kind = Dataset::Kind::integers;
            read(set.integers, H5T_NATIVE_INT64);
        } else {
            set.kind = Dataset::Kind::text;
            read(set.text, H5T_NATIVE_CHAR);
        }
        H5Tclose(type);
        H5Sclose(space);
        H5Dclose(data);
        return 0;
    };
    H5Ovisit2(file, H5_INDEX_NAME, H5_ITER_INC, visit, &document, H5O_INFO_BASIC);
    H5Fclose(file);
    return document;
}

inline void write_document(const std::filesystem::path& path, const Document& document) {
    Hdf5Writer file(path, path);
    for (const auto& [name, set] : document) {
        if (set.kind == Dataset::Kind::reals)
            file.reals(name, set.reals, set.shape);
        else if (set.kind == Dataset::Kind::integers)
            file.integers(name, set.integers, set.shape);
        else
            file.text(name, set.text);
    }
    file.close();
}

// === States

/// A run in code.
struct Case {
    std::string name;
    Scene scene;
    Model model;
};

/// Two blocks that slide over each other, pressed together.
inline Case two_blocks(const std::string& name) {
    using namespace ::test;
    Case c{name, plane_scene(1, 0, 0, 12, 8, material(1, 200, 80)), {}};
    c.scene.contact = contact(LawType::friction, 0.3);
    add_box(c.model, add_body(c.model, "lower", {1, 0.5, 0}), 2, 2, 7, 4, 10, 4);
    add_box(c.model, add_body(c.model, "upper", {-1, -0.5, 0}), 4, 4, 9, 6, 10, 4);
    return c;
}

/// What a state may hold: rings, the stretch across the plane, tractions, rigid bodies, springs between bodies,
/// transfers now and then, walls, prestress.
inline std::vector<Case> plane_cases() {
    using namespace ::test;
    std::vector<Case> cases;
    cases.push_back(two_blocks("friction"));
    add_wall(cases.back().scene, "floor", 1, Side::lower, 2);
    cases.push_back(two_blocks("plane stress"));
    cases.back().scene.analysis = Analysis::plane_stress;
    cases.push_back(two_blocks("rings"));
    cases.back().scene.analysis = Analysis::axisymmetric;
    cases.push_back(two_blocks("springs"));
    cases.back().scene.contact->law.type = LawType::linear_interface;
    cases.back().scene.contact->law.coefficient = 0;
    cases.back().scene.contact->law.tension_stiffness = 50;
    cases.back().scene.contact->law.tangential_stiffness = 20;
    cases.push_back(two_blocks("periodic fmpm"));
    cases.back().scene.method.transfer = transfer(TransferScheme::fmpm, 3);
    cases.back().scene.method.transfer.every_cfl = 1.5;
    cases.push_back(two_blocks("one field"));
    cases.back().scene.contact.reset();
    cases.back().scene.method.shape = ShapeKind::b2spline;
    cases.push_back(two_blocks("tractions"));
    TractionSpec traction;
    traction.body = "upper";
    traction.axis = 1;
    traction.side = Side::upper;
    traction.pressure = TimeFunction(5);
    cases.back().scene.boundaries.push_back({"load", traction});
    cases.push_back(two_blocks("rigid"));
    RigidSpec rigid;
    rigid.velocity[1] = -0.3;
    rigid.angular_velocity = 0.2;
    cases.back().model.bodies[1] = {"upper", -1, {}, rigid};
    cases.back().scene.bodies.emplace_back().rigid = rigid;
    cases.push_back(two_blocks("prestress"));
    cases.back().model.bodies[0].stress = {3, -2, 1, 0.5, 0, 0};
    return cases;
}

inline Case two_cubes() {
    using namespace ::test;
    Case c{"space", space_scene(1, 0, 8, material(1, 200, 80)), {}};
    c.scene.contact = contact(LawType::friction, 0.2);
    add_cube(c.model, add_body(c.model, "a", {1, 0.2, 0.5}), {1.5, 2, 2}, 2, 4);
    add_cube(c.model, add_body(c.model, "b", {-1, 0, 0}), {3.5, 2, 2.2}, 2, 4);
    return c;
}

template <int D>
void advance_by(State<D>& state, int steps) {
    auto tasks = step_tasks<D>(state.scene);
    for (int i = 0; i < steps; ++i) {
        state.dt = next_step(state, 1e3);
        advance(state, tasks);
    }
}

/// As a run leaves it that looks at the energy and has halved its time step twice.
template <int D>
State<D> state_after(const Case& c, int steps) {
    State<D> state = make_state<D>(c.scene, c.model);
    state.step_reductions = 2;
    state.setback = {Trouble::left_grid, 0.5, {1, 2, 3}, 1};
    for (int i = 0; i < 2; ++i) {
        const Totals all = deformable_totals(state, body_totals(state));
        watch_energy(state, all.kinetic_energy + all.strain_energy, all.mass);
        advance_by(state, i == 0 ? steps / 2 : steps - steps / 2);
    }
    return state;
}

/// What one whole state holds that differs between runs, as bytes. By itself, not by visit_state(), which it is to
/// check.
template <int D>
std::map<std::string, std::string> bytes_of(const State<D>& state) {
    std::map<std::string, std::string> all;
    const auto add = [&](const std::string& name, const auto& values) {
        if (!values.empty())
            all[name].append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(values[0]));
    };
    const auto add_one = [&](const std::string& name, auto value) { add(name, std::vector{value}); };
    const Particles<D>& p = state.particles;
    add("position", p.position);
    add("velocity", p.velocity);
    add("deformation_gradient", p.deformation_gradient);
    add("stress", p.stress);
    add("mass", p.mass);
    add("volume", p.volume);
    add("half_size", p.half_size);
    add("across", p.across);
    add("prestress", p.prestress);
    add("body", p.body);
    add("id", p.id);
    for (const Tile<D>& tile : state.tiling.tiles)
        add("tiles", std::vector<std::int32_t>{tile.block, tile.body, tile.field, tile.first, tile.last});
    for (const BlockTiles& block : state.tiling.blocks)
        add("blocks", std::vector<std::int32_t>{block.block, block.first, block.last});
    for (const auto& colour : state.tiling.colours) {
        add_one("colours", colour.size());
        add("colours", colour);
    }
    add_one("stride", state.tiling.stride);
    for (const TractionFace& face : state.traction_faces)
        add("traction_faces", std::vector<std::int32_t>{face.id, face.particle, face.tile});
    const Ledger& l = state.ledger;
    add("ledger", std::vector<double>{l.external_work, l.contact_work, l.friction_work, l.interface_energy});
    const EnergyWatch& w = state.energy_watch;
    add("energy_watch", std::vector<double>{w.initial, w.given, w.lowest, w.external_work, w.contact_work});
    for (const Boundary& boundary : state.boundaries) add("boundaries", boundary.impulse);
    for (const auto& [pair, t] : state.pair_totals) {
        add("pairs", std::vector<std::int32_t>{pair.first, pair.second});
        add("pairs", t.impulse);
        add("pairs", std::vector<double>{t.work, t.friction_work, t.interface_energy, t.area});
    }
    for (const auto& [body, t] : state.rigid_totals) {
        add_one("rigid", body);
        add("rigid", t.impulse);
        add("rigid", t.angular_impulse);
    }
    add("clock", std::vector<double>{state.time, state.dt, state.largest_wave_speed, state.since_transfer});
    add_one("step", state.step);
    add_one("transfers", int{state.transfers});
    add_one("step_reductions", state.step_reductions);
    if (state.setback) {
        add("setback", std::vector<int>{static_cast<int>(state.setback->trouble), state.setback->returns});
        add_one("setback", state.setback->time);
        add("setback", state.setback->place);
    }
    return all;
}

template <int D>
void expect_same(const State<D>& a, const State<D>& b, const std::string& what) {
    const auto first = bytes_of(a);
    const auto second = bytes_of(b);
    EXPECT_EQ(first.size(), second.size()) << what;
    for (const auto& [name, bytes] : first)
        EXPECT_TRUE(second.contains(name) && second.at(name) == bytes) << what << ": " << name << " differs";
}

} // namespace abut::test
