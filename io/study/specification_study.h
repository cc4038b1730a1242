#pragma once
/// \file specification_study.h
/// The table of everything that a study file may hold, as specification.h has one of scenes.

#include "io/scene/specification.h"
#include "io/scene/words.h"
#include "io/study/study.h"

#include <array>
#include <string>

namespace abut {

const SpecificationNode& study_specification();

/// The reference of the study file, as Markdown: a section for each object with a table of its keys.
std::string study_reference();

inline constexpr std::array metric_words{Word{"history", MetricType::history},
                                         Word{"particles", MetricType::particles},
                                         Word{"convergence", MetricType::convergence},
                                         Word{"energy-loss", MetricType::energy_loss},
                                         Word{"balance-error", MetricType::balance_error},
                                         Word{"interpenetration", MetricType::interpenetration},
                                         Word{"momentum-error", MetricType::momentum_error},
                                         Word{"symmetry-error", MetricType::symmetry_error}};
inline constexpr std::array reduction_words{Word{"end", Reduction::end}, Word{"max", Reduction::max},
                                            Word{"rms", Reduction::rms}, Word{"mean", Reduction::mean}};
inline constexpr std::array weight_words{Word{"none", Weight::none}, Word{"mass", Weight::mass},
                                         Word{"volume", Weight::volume}};

} // namespace abut
