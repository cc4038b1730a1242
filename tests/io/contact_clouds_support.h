#pragma once
/// Bodies in contact, for the files of their contact nodes.

#include "contact/inspect.h"
#include "results/frames.h"
#include "results_support.h"
#include "step/step.h"

#include <cmath>
#include <vtkNew.h>
#include <vtkSmartPointer.h>

namespace abut::test {

struct Choice {
    Analysis analysis = Analysis::plane_strain;
    bool rigid = false;
    NormalMethod normal = NormalMethod::logistic_regression;
    SeparationMethod separation = SeparationMethod::particle_edges;
};

inline BodySpec body_spec(const std::string& name, bool rigid) {
    BodySpec body;
    body.name = name;
    if (rigid) {
        body.rigid = RigidSpec{};
        body.rigid->velocity[1] = -0.2;
        body.rigid->angular_velocity = 0.1;
    } else {
        body.material = "solid";
    }
    return body;
}

/// Three bodies that press on one another, after some steps, `look`ed at.
template <int D>
State<D> pressed(const Choice& choice = {}) {
    Scene scene;
    scene.analysis = D == 3 ? Analysis::three_d : choice.analysis;
    scene.grid = {{1, 1, D == 3 ? 1.0 : 0.0}, {0, 0, 0}, {8, 8, D == 3 ? 6.0 : 0.0}};
    scene.time.end = 100;
    scene.method.shape = ShapeKind::cpdi;
    MaterialSpec material;
    material.name = "solid";
    material.density = 2;
    material.bulk_modulus = 10;
    material.shear_modulus = 4;
    scene.materials = {material};
    scene.contact.emplace();
    scene.contact->normal = choice.normal;
    scene.contact->separation = choice.separation;
    scene.contact->law = {LawType::friction, 0.3};
    scene.bodies = {body_spec("left", false), body_spec("right, \"b\"", false), body_spec("upper", choice.rigid)};
    Model model;
    for (const BodySpec& body : scene.bodies) model.bodies.push_back({body.name, body.rigid ? -1 : 0, {}, body.rigid});
    model.bodies[0].velocity.value = {0.4, 0.1, 0};
    model.bodies[1].velocity.value = {-0.4, 0, 0};
    model.bodies[2].velocity.value = {0, -0.4, 0};
    const auto box = [&](int body, Vector lower, int nx, int ny, int nz) {
        for (int k = 0; k < (D == 3 ? nz : 1); ++k)
            for (int j = 0; j < ny; ++j)
                for (int i = 0; i < nx; ++i) {
                    model.position.push_back(
                        {lower[0] + 0.5 * i + 0.25, lower[1] + 0.5 * j + 0.25, D == 3 ? lower[2] + 0.5 * k + 0.25 : 0});
                    model.half_size.push_back({0.25, 0.25, D == 3 ? 0.25 : 0});
                    model.body.push_back(body);
                }
    };
    box(0, {2.1, 2, 2}, 4, 4, 3);
    box(1, {4.15, 2.1, 2}, 4, 4, 3);
    box(2, {3, 4.15, 2}, 4, 4, 3);
    State<D> state = make_state<D>(scene, model);
    auto tasks = step_tasks<D>(scene);
    for (int step = 0; step < 12; ++step) {
        state.dt = next_step(state, 100);
        advance(state, tasks);
    }
    look(state);
    return state;
}

template <int D>
std::vector<Index<D>> all_nodes(const State<D>& state) {
    std::vector<Index<D>> nodes;
    for (const ContactGroup<D>& group : state.contact.groups) {
        nodes.push_back(group.node);
        for (int& i : nodes.back()) i -= grid_margin;
    }
    return nodes;
}

/// The data that a VTK reader finds in a file.
template <class Reader>
auto read(const std::filesystem::path& path) {
    vtkNew<Reader> reader;
    reader->SetFileName(path.c_str());
    reader->Update();
    EXPECT_EQ(reader->GetErrorCode(), 0u) << path;
    return vtkSmartPointer<std::remove_pointer_t<decltype(reader->GetOutput())>>(reader->GetOutput());
}

/// The same bits, NaN included.
inline void expect_same(double a, double b) {
    if (std::isnan(b))
        EXPECT_TRUE(std::isnan(a));
    else
        EXPECT_EQ(a, b);
}

} // namespace abut::test
