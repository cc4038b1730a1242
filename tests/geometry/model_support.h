#pragma once
/// Help for the tests of whole models.

#include "geometry/build_model.h"
#include "support.h"

#include <string>
#include <vector>

namespace test {

inline abut::BodySpec box(const std::string& name, abut::Vector lower, abut::Vector upper,
                          const std::string& material = "steel") {
    return {name, material, {}, abut::Box{lower, upper}, {}, 2};
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
