#pragma once
#include "io/scene/json.h"
#include "io/study/study.h"
#include "scene/scene.h"

namespace abut {

/// The /output of a resolved scene as a study's runs have it: what the metrics need and nothing else, so that a study
/// of hundreds of runs leaves no gigabytes. Rows are as often as the scene has them.
Json output_of_variants(const Study& study, const Scene& scene, const Json& output);

} // namespace abut
