#pragma once
/// \file variants.h
/// The runs of a study.

#include "expression/expression.h"
#include "io/scene/read_scene.h"
#include "io/study/study.h"

#include <optional>
#include <string>
#include <vector>

namespace abut {

/// A run of the family, ready to be written.
struct Variant {
    std::string name;                         ///< levels in words: "1 mm, FMPM(2), cpdi"
    std::string folder;                       ///< the same as a file name, different for each variant
    std::vector<std::size_t> levels;          ///< one an axis
    std::vector<std::optional<double>> sizes; ///< number of each axis in the resolved scene, SI
    std::vector<Constant> parameters;         ///< of the study, in this scene
    int threads = 1;
    LoadedScene scene;
    std::string key; ///< checksum of the resolved scene, the files it names, threads and version
};

/// The levels of each variant in the study's order, none twice. Throws SceneError if there is none.
std::vector<std::vector<std::size_t>> variant_levels(const Study& study);

/// Loads the scenes of all variants. What is written is what the metrics need: the first and the last frame of
/// particles (all frames if a metric asks for them) and the tables; the study's own settings come after and win.
/// Throws SceneError with the problems of all of them, each told once.
std::vector<Variant> make_variants(const Study& study);

} // namespace abut
