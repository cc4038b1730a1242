#pragma once
/// \file words.h
/// The words of a scene file and the values of scene.h they stand for; the table of keys, the reader and the writers
/// of messages share them.

#include "scene/scene.h"

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace abut {

template <class Value>
struct Word {
    std::string_view text;
    Value value;
};
template <class Value>
Word(const char*, Value) -> Word<Value>;

inline constexpr std::array analysis_words{Word{"plane-strain", Analysis::plane_strain},
                                           Word{"plane-stress", Analysis::plane_stress},
                                           Word{"axisymmetric", Analysis::axisymmetric}, Word{"3d", Analysis::three_d}};
inline constexpr std::array shape_words{Word{"linear", ShapeKind::linear},     Word{"ugimp", ShapeKind::ugimp},
                                        Word{"gimp", ShapeKind::gimp},         Word{"cpdi", ShapeKind::cpdi},
                                        Word{"b2spline", ShapeKind::b2spline}, Word{"b2gimp", ShapeKind::b2gimp},
                                        Word{"b2cpdi", ShapeKind::b2cpdi}};
inline constexpr std::array scheme_words{Word{"flip", TransferScheme::flip}, Word{"pic", TransferScheme::pic},
                                         Word{"xpic", TransferScheme::xpic}, Word{"fmpm", TransferScheme::fmpm}};
inline constexpr std::array three_or_more_words{Word{"lumped", ThreeOrMore::lumped},
                                                Word{"explicit", ThreeOrMore::explicit_},
                                                Word{"up-to-two", ThreeOrMore::up_to_two}};
inline constexpr std::array position_words{Word{"end-velocity", PositionUpdate::end_velocity},
                                           Word{"start-velocity", PositionUpdate::start_velocity},
                                           Word{"mean-velocity", PositionUpdate::mean_velocity}};
inline constexpr std::array stress_update_words{Word{"usf", StressUpdate::usf}, Word{"usavg", StressUpdate::usavg},
                                                Word{"usl", StressUpdate::usl}, Word{"usl+", StressUpdate::usl_plus},
                                                Word{"usavg+", StressUpdate::usavg_plus}};
inline constexpr std::array deformation_increment_words{Word{"exponential", DeformationIncrement::exponential},
                                                        Word{"linear", DeformationIncrement::linear}};
inline constexpr std::array velocity_conditions_words{Word{"combined", VelocityConditions::combined},
                                                      Word{"velocity", VelocityConditions::velocity},
                                                      Word{"lumped", VelocityConditions::lumped}};
inline constexpr std::array on_trouble_words{Word{"stop", OnTrouble::stop},
                                             Word{"shrink-step", OnTrouble::shrink_step}};
inline constexpr std::array model_words{Word{"neo-hookean", MaterialModel::neo_hookean},
                                        Word{"neo-hookean-isochoric", MaterialModel::neo_hookean_isochoric},
                                        Word{"linear-elastic", MaterialModel::linear_elastic}};
inline constexpr std::array normal_words{Word{"logistic-regression", NormalMethod::logistic_regression},
                                         Word{"linear-regression", NormalMethod::linear_regression},
                                         Word{"irls-regression", NormalMethod::irls_regression},
                                         Word{"average-gradient", NormalMethod::average_gradient},
                                         Word{"maximum-gradient", NormalMethod::maximum_gradient},
                                         Word{"maximum-volume", NormalMethod::maximum_volume},
                                         Word{"own-gradient", NormalMethod::own_gradient},
                                         Word{"specified", NormalMethod::specified}};
inline constexpr std::array separation_words{Word{"particle-edges", SeparationMethod::particle_edges},
                                             Word{"critical-position", SeparationMethod::critical_position},
                                             Word{"fitted-position", SeparationMethod::fitted_position},
                                             Word{"displacement", SeparationMethod::displacement},
                                             Word{"none", SeparationMethod::none}};
inline constexpr std::array fit_words{Word{"power-law", PositionFit::power_law},
                                      Word{"two-per-cell", PositionFit::two_per_cell},
                                      Word{"one-per-cell", PositionFit::one_per_cell}};
inline constexpr std::array law_words{Word{"frictionless", LawType::frictionless},
                                      Word{"friction", LawType::friction},
                                      Word{"stick", LawType::stick},
                                      Word{"perfect", LawType::perfect},
                                      Word{"adhesion", LawType::adhesion},
                                      Word{"viscous-friction", LawType::viscous_friction},
                                      Word{"linear-interface", LawType::linear_interface},
                                      Word{"bilinear-interface", LawType::bilinear_interface},
                                      Word{"cohesive-interface", LawType::cohesive_interface}};
inline constexpr std::array axis_words{Word{"x", 0}, Word{"y", 1}, Word{"z", 2}};
inline constexpr std::array side_words{Word{"lower", Side::lower}, Word{"upper", Side::upper}};
inline constexpr std::array fill_words{Word{"centre", Fill::centre}, Word{"majority", Fill::majority},
                                       Word{"covered-fraction", Fill::covered_fraction}};
inline constexpr std::array arrangement_words{Word{"grid", Arrangement::grid}, Word{"fitted", Arrangement::fitted}};
inline constexpr std::array bodies_words{Word{"legend", BodiesBy::legend}, Word{"by-colour", BodiesBy::colour},
                                         Word{"by-component", BodiesBy::component}};
inline constexpr std::array overlap_words{Word{"refuse", Overlap::refuse}, Word{"first", Overlap::first},
                                          Word{"last", Overlap::last}};
/// Instead of a gradient of a wall's velocity.
inline constexpr const char* estimated_word = "estimated";
/// Which row of an image is up.
inline constexpr std::array up_words{Word{"first-row", true}, Word{"last-row", false}};

/// The texts of a list of words.
template <class Words>
std::vector<std::string> texts(const Words& words) {
    std::vector<std::string> list;
    list.reserve(words.size());
    for (const auto& word : words) list.emplace_back(word.text);
    return list;
}

/// The value of the word `text`; nothing for a text that is none of the words.
template <class Words>
auto value_of(const Words& words, std::string_view text) {
    std::optional<decltype(words.front().value)> value;
    for (const auto& word : words)
        if (word.text == text) value.emplace(word.value);
    return value;
}

/// The word of a value, e.g. "usl"; empty for a value without a word.
template <class Words, class Value>
std::string_view text_of(const Words& words, const Value& value) {
    for (const auto& word : words)
        if (word.value == value) return word.text;
    return {};
}

} // namespace abut
