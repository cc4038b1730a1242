#pragma once
/// Small scenes by chance, what must hold in each, and smaller ones in which it still does not.

#include "stability/hard.h"

#include <optional>

namespace test {

/// A body of n particles along each axis, two to a cell.
struct RandomBody {
    std::array<int, 3> n{};
    Vector lower{};    ///< [cells]
    Vector velocity{}; ///< [cells / s]
    int material = 0;
};

/// All that a scene is made of: printed, it can be built again.
struct RandomScene {
    int dimension = 2;
    ShapeKind shape = ShapeKind::ugimp;
    TransferSpec transfer;
    StressUpdate stress = StressUpdate::usl;
    NormalMethod normal = NormalMethod::logistic_regression;
    SeparationMethod separation = SeparationMethod::particle_edges;
    LawType law = LawType::friction;
    double friction = 0.3;
    bool contact = true, walls = false, gravity = false, plane_stress = false;
    double cfl = 0.4, cell = 1;
    MaterialModel model = MaterialModel::neo_hookean;
    double contrast = 1; ///< of the second material's stiffness and, inversely, density
    std::vector<RandomBody> bodies;
    int steps = 40;
    int thinnest = 1; ///< particles across a body that it may be shrunk to
};

/// What is drawn from.
enum class Choice {
    /// What advice() and the time steps of the README leave: stress last, not linear, steps up to 0.4, FMPM up to order
    /// 4, bodies at least a cell thick.
    advised,
    anything
};

/// The same seed gives the same scene on every machine.
RandomScene random_scene(std::uint64_t seed, Choice choice);

Scene scene_of(const RandomScene& random);
Model model_of(const RandomScene& random);

/// Runs it. \return what does not hold; empty: all holds
/// \param threads_too also with two threads, for the same bits
std::string what_fails(const RandomScene& random, bool threads_too, Figures* figures = nullptr);

/// A smaller scene for which `fails` still says something: fewer bodies, fewer particles, fewer steps, plainer options.
RandomScene shrunk(RandomScene random, const std::function<std::string(const RandomScene&)>& fails);

/// As C++: what a test would build it from.
std::string text_of(const RandomScene& random);

} // namespace test
