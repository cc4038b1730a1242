#pragma once
/// Scenes, models and runs in code, for the tests of the solver's rooms.

#include "results/history.h"
#include "step/step.h"
#include "step/tasks.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

namespace test {

using namespace abut;

inline MaterialSpec material(double density, double K, double G,
                             MaterialModel model = MaterialModel::neo_hookean_isochoric) {
    MaterialSpec m;
    m.name = "solid";
    m.model = model;
    m.density = density;
    m.bulk_modulus = K;
    m.shear_modulus = G;
    return m;
}

/// Speed of longitudinal waves at rest.
inline double wave_speed(const MaterialSpec& m) {
    return std::sqrt((m.bulk_modulus + 4.0 / 3 * m.shear_modulus) / m.density);
}

inline Scene plane_scene(double cell, double x0, double y0, double x1, double y1, const MaterialSpec& m) {
    Scene scene;
    scene.grid = {{cell, cell, 0}, {x0, y0, 0}, {x1, y1, 0}};
    scene.materials = {m};
    scene.time.end = 1;
    return scene;
}

/// A cubic box in 3D.
inline Scene space_scene(double cell, double lower, double upper, const MaterialSpec& m) {
    Scene scene;
    scene.analysis = Analysis::three_d;
    scene.grid = {{cell, cell, cell}, {lower, lower, lower}, {upper, upper, upper}};
    scene.materials = {m};
    scene.time.end = 1;
    return scene;
}

/// \param position not given: FLIP's own rule, and end_velocity for the others
inline TransferSpec transfer(TransferScheme scheme, int order = 2, std::optional<PositionUpdate> position = {}) {
    if (!position && scheme != TransferScheme::flip) position = PositionUpdate::end_velocity;
    return {scheme, order, position, {}};
}

inline ContactSpec contact(LawType law, double coefficient = 0) {
    ContactSpec c;
    c.law = {law, coefficient};
    return c;
}

inline void add_wall(Scene& scene, const std::string& name, int axis, Side side, double position, double velocity = 0,
                     bool grip = true, double depth = 1) {
    scene.boundaries.push_back({name, WallSpec{axis, side, position, velocity, depth, 0.0, false, grip}});
}

inline int add_body(Model& model, const std::string& name, Vector velocity = {}) {
    model.bodies.push_back({name, 0, {velocity}});
    return static_cast<int>(model.bodies.size()) - 1;
}

inline void add_particle(Model& model, int body, double x, double y, double half_x, double half_y) {
    model.position.push_back({x, y, 0});
    model.half_size.push_back({half_x, half_y, 0});
    model.body.push_back(body);
}

inline void add_particle(Model& model, int body, const Vector& x, const Vector& half) {
    model.position.push_back(x);
    model.half_size.push_back(half);
    model.body.push_back(body);
}

/// n particles per axis that fill a cube.
inline void add_cube(Model& model, int body, const Vector& lower, double edge, int n) {
    const double d = edge / n;
    for (int k = 0; k < n; ++k)
        for (int j = 0; j < n; ++j)
            for (int i = 0; i < n; ++i)
                add_particle(model, body,
                             {lower[0] + (i + 0.5) * d, lower[1] + (j + 0.5) * d, lower[2] + (k + 0.5) * d},
                             {d / 2, d / 2, d / 2});
}

/// nx times ny particles that fill a box.
inline void add_box(Model& model, int body, double x0, double y0, double x1, double y1, int nx, int ny) {
    const double dx = (x1 - x0) / nx;
    const double dy = (y1 - y0) / ny;
    for (int j = 0; j < ny; ++j)
        for (int i = 0; i < nx; ++i)
            add_particle(model, body, x0 + (i + 0.5) * dx, y0 + (j + 0.5) * dy, dx / 2, dy / 2);
}

/// Particles of a disk, on the lattice that has a corner at the origin.
inline void add_disk(Model& model, int body, double x, double y, double radius, double spacing) {
    const auto first = [&](double c) { return static_cast<int>(std::floor((c - radius) / spacing)); };
    const auto last = [&](double c) { return static_cast<int>(std::ceil((c + radius) / spacing)); };
    for (int j = first(y); j <= last(y); ++j)
        for (int i = first(x); i <= last(x); ++i) {
            const double px = (i + 0.5) * spacing;
            const double py = (j + 0.5) * spacing;
            if (std::hypot(px - x, py - y) <= radius) add_particle(model, body, px, py, spacing / 2, spacing / 2);
        }
}

/// Totals of all bodies.
template <int D>
Totals totals(State<D>& state) {
    Totals all;
    for (const Totals& body : body_totals(state)) all += body;
    return all;
}

/// Runs to a time; `each` is called after every step.
template <int D>
void run(
    State<D>& state, double until, const std::function<void()>& each = [] {}) {
    auto tasks = step_tasks<D>(state.scene);
    while (state.time < until) {
        state.dt = next_step(state, until);
        if (!(state.dt > 1e-14 * until)) break; // what round-off left
        advance(state, tasks);
        each();
    }
}

/// Sorts the particles and numbers the slots, so that totals can be made before the first step.
template <int D>
void prepare(State<D>& state) {
    find_velocity_fields(state);
    if (state.effects.stored_stencils) store_stencils(state);
}

/// A deformation gradient with det F in about [0.2, 4] and any rotation.
template <int D>
Mat<D> random_deformation(std::mt19937& random, double amount) {
    std::uniform_real_distribution<double> in(-amount, amount);
    Mat<D> F;
    do {
        F.setIdentity();
        for (int i = 0; i < D; ++i)
            for (int j = 0; j < D; ++j) F(i, j) += in(random);
    } while (F.determinant() < 0.15);
    return F;
}

template <int D>
Mat<D> random_rotation(std::mt19937& random) {
    std::normal_distribution<double> in;
    Mat<D> Q;
    for (int i = 0; i < D; ++i)
        for (int j = 0; j < D; ++j) Q(i, j) = in(random);
    for (int i = 0; i < D; ++i) { // Gram and Schmidt
        for (int j = 0; j < i; ++j) Q.col(i) -= Q.col(j).dot(Q.col(i)) * Q.col(j);
        Q.col(i).normalize();
    }
    if (Q.determinant() < 0) Q.col(0) *= -1;
    return Q;
}

/// Any rotation before and after principal stretches in [smallest, largest].
template <int D>
Mat<D> stretched_and_turned(std::mt19937& random, double smallest, double largest) {
    std::uniform_real_distribution<double> logarithm(std::log(smallest), std::log(largest));
    Vec<D> stretch;
    for (int a = 0; a < D; ++a) stretch[a] = std::exp(logarithm(random));
    return random_rotation<D>(random) * stretch.asDiagonal() * random_rotation<D>(random).transpose();
}

constexpr ShapeKind all_shapes[] = {ShapeKind::linear,   ShapeKind::ugimp,  ShapeKind::gimp,  ShapeKind::cpdi,
                                    ShapeKind::b2spline, ShapeKind::b2gimp, ShapeKind::b2cpdi};

inline const char* name_of(ShapeKind kind) {
    constexpr const char* names[] = {"linear", "ugimp", "gimp", "cpdi", "b2spline", "b2gimp", "b2cpdi"};
    return names[static_cast<int>(kind)];
}

} // namespace test
