#pragma once
#include <optional>
#include <stdexcept>

namespace abut {

/// Constants of an isotropic elastic solid as a scene gives them; exactly two are set.
struct ElasticConstants {
    std::optional<double> bulk_modulus{};   ///< K [Pa]
    std::optional<double> shear_modulus{};  ///< G [Pa]
    std::optional<double> youngs_modulus{}; ///< E [Pa]
    std::optional<double> poissons_ratio{}; ///< ν
    std::optional<double> lame_lambda{};    ///< λ [Pa]
};

struct Moduli {
    double bulk = 0;  ///< K [Pa]
    double shear = 0; ///< G [Pa]
};

/// K and G from any two constants. Throws std::invalid_argument, in words for the user, unless there are exactly two of
/// them, -1 < ν < 0.5, K > 0 and G >= 0.
Moduli bulk_and_shear(const ElasticConstants& constants);

} // namespace abut
