#pragma once
/// Help for the tests of whole models.

#include "geometry/build_model.h"
#include "geometry/shape_parts.h"
#include "support.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace test {

inline abut::BodySpec box(const std::string& name, abut::Vector lower, abut::Vector upper,
                          const std::string& material = "steel") {
    return {name, material, {}, abut::Box{lower, upper}, {}, 2};
}

/// The particles of one shape.
struct ShapeParticles {
    abut::Vector half_size{};
    std::vector<abut::Vector> position;
    double angle = 0;
};

/// Fills a shape, whatever else is wrong with it.
inline ShapeParticles shape_particles(const abut::ShapeSpec& shape, int particles_per_cell, const abut::GridSpec& grid,
                                      int dimension) {
    abut::Scene scene;
    if (dimension == 3) scene.analysis = abut::Analysis::three_d;
    scene.grid = grid;
    scene.bodies.push_back({"body", "steel", {}, shape, {}, particles_per_cell});
    std::vector<std::string> notes;
    std::vector<abut::Problem> ignored;
    const abut::Part part = abut::shape_parts(scene, "scene.json", false, notes, ignored).at(0);
    ShapeParticles particles{part.lattice.half_size(), {}, part.turn};
    for (const abut::PlacedParticle& particle : part.particle) {
        EXPECT_EQ(particle.half_size, particles.half_size);
        EXPECT_EQ(particle.angle, particles.angle);
        particles.position.push_back(particle.position);
    }
    return particles;
}

/// "POINTER: MESSAGE" of every problem.
inline std::vector<std::string> problems(const abut::Scene& scene, const std::string& name = "scene.json") {
    std::vector<std::string> result;
    try {
        abut::build_model(scene, name);
    } catch (const abut::SceneError& error) {
        for (const abut::Problem& problem : error.problems())
            result.push_back(problem.pointer + ": " + problem.message);
    }
    return result;
}

} // namespace test
