#pragma once
#include "io/study/metrics.h"
#include "io/study/variants.h"

#include <filesystem>

namespace abut {

/// What building a variant's model tells of it.
struct VariantModel {
    VariantColumns columns;
    std::size_t particles = 0;
    double steps = 0; ///< about
    double work = 0;  ///< about, in particle updates and extra sweeps: for the time to go
};

/// Builds the model of a variant; throws SceneError (of no file) if its scene only now shows to be wrong.
VariantModel examine(const Variant& variant);

/// The same for a variant whose results are there, without building anything; times are not known.
VariantModel examine_results(const Variant& variant, const std::filesystem::path& results);

} // namespace abut
