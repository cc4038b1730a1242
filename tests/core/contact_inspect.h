#pragma once
/// Bodies whose contact nodes are taken apart.

#include "support.h"

#include "contact/inspect.h"
#include "results/frames.h"

namespace test {

/// Two blocks of 2 x 2 particles a cell with their faces at y = 4 − gap/2 and 4 + gap/2, a cell being 1.
inline State<2> two_blocks(double gap, NormalMethod normal = NormalMethod::logistic_regression,
                           SeparationMethod separation = SeparationMethod::particle_edges) {
    Scene scene = plane_scene(1, 0, 0, 8, 8, material(1, 10, 3));
    scene.method.shape = ShapeKind::ugimp;
    scene.contact = contact(LawType::frictionless);
    scene.contact->normal = normal;
    scene.contact->separation = separation;
    Model model;
    add_box(model, add_body(model, "lower"), 1, 2 - gap / 2, 7, 4 - gap / 2, 12, 4);
    add_box(model, add_body(model, "upper"), 1, 4 + gap / 2, 7, 6 + gap / 2, 12, 4);
    State<2> state = make_state<2>(scene, model);
    look(state);
    return state;
}

/// Three bodies at random deformation, so that nothing is symmetric.
template <int D>
State<D> random_bodies(NormalMethod normal, SeparationMethod separation, ThreeOrMore three, bool rigid = false) {
    Scene scene = D == 2 ? plane_scene(1, 0, 0, 10, 10, material(1, 10, 3)) : space_scene(1, 0, 8, material(1, 10, 3));
    scene.method.shape = ShapeKind::ugimp;
    scene.contact = contact(LawType::friction, 0.3);
    scene.contact->normal = normal;
    scene.contact->separation = separation;
    scene.contact->three_or_more = three;
    scene.contact->direction = {0.6, -1.2, 0};
    Model model;
    for (const char* name : {"left", "right", "upper"})
        add_body(model, name, {0.01 * double(model.bodies.size()), 0, 0});
    if constexpr (D == 2) {
        add_box(model, 0, 2.2, 2.4, 5.2, 5.4, 6, 6);
        add_box(model, 1, 5.25, 2.3, 8.25, 5.3, 6, 6);
        add_box(model, 2, 3.3, 5.45, 7.3, 8.45, 8, 6);
    } else {
        add_cube(model, 0, {1.9, 2.1, 2.2}, 2, 4);
        add_cube(model, 1, {3.95, 2.2, 2.3}, 2, 4);
        add_cube(model, 2, {2.9, 4.2, 2.1}, 2, 4);
    }
    if (rigid) {
        RigidSpec motion;
        motion.velocity[0] = 0.1;
        model.bodies[1].rigid = motion;
        model.bodies[1].material = -1;
        scene.bodies.resize(1);
        scene.bodies[0].rigid = motion; // so that the scene's effects know of it
    }
    State<D> state = make_state<D>(scene, model);
    std::mt19937 random(1);
    for (std::size_t p = 0; p < state.particles.size(); ++p)
        if (!rigid || state.particles.body[p] != 1)
            state.particles.deformation_gradient[p] = random_deformation<D>(random, 0.1);
    look(state);
    return state;
}

template <int D>
Index<D> in_scene(Index<D> node) {
    for (int& i : node) i -= grid_margin;
    return node;
}

template <int D>
std::vector<Index<D>> all_nodes(const State<D>& state) {
    std::vector<Index<D>> nodes;
    for (const ContactGroup<D>& group : state.contact.groups) nodes.push_back(in_scene<D>(group.node));
    return nodes;
}

} // namespace test
