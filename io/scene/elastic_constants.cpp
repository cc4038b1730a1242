#include "io/scene/elastic_constants.h"

#include <cmath>

#include <fmt/format.h>

namespace abut {

namespace {

/// E = 9KG/(3K+G), λ = K - 2G/3, ν = λ/(2(λ+G)) (small strain, 3D), solved for K and G.
Moduli convert(const ElasticConstants& given) {
    const auto& [bulk, shear, young, poisson, lame] = given;
    if (bulk && shear) return {*bulk, *shear};
    if (bulk && young) return {*bulk, 3 * *bulk * *young / (9 * *bulk - *young)};
    if (bulk && poisson) return {*bulk, 3 * *bulk * (1 - 2 * *poisson) / (2 * (1 + *poisson))};
    if (bulk && lame) return {*bulk, 1.5 * (*bulk - *lame)};
    if (shear && young) return {*young * *shear / (3 * (3 * *shear - *young)), *shear};
    if (shear && poisson) return {2 * *shear * (1 + *poisson) / (3 * (1 - 2 * *poisson)), *shear};
    if (shear && lame) return {*lame + 2 * *shear / 3, *shear};
    if (young && poisson) return {*young / (3 * (1 - 2 * *poisson)), *young / (2 * (1 + *poisson))};
    if (young && lame) {
        const double root = std::sqrt(*young * *young + 9 * *lame * *lame + 2 * *young * *lame);
        // G = (E - 3λ + R)/4 cancels for λ >> E; there R² - (3λ - E)² = 8Eλ gives the same without a difference.
        const double excess = 3 * *lame - *young;
        const double from_difference = (root - excess) / 4;
        return {(*young + 3 * *lame + root) / 6, excess > 0 ? 2 * *young * *lame / (root + excess) : from_difference};
    }
    return {*lame * (1 + *poisson) / (3 * *poisson), *lame * (1 - 2 * *poisson) / (2 * *poisson)};
}

} // namespace

Moduli bulk_and_shear(const ElasticConstants& constants) {
    const auto& [bulk, shear, young, poisson, lame] = constants;
    const int count = int(bulk.has_value()) + int(shear.has_value()) + int(young.has_value()) +
                      int(poisson.has_value()) + int(lame.has_value());
    if (count != 2) throw std::invalid_argument(fmt::format("exactly two elastic constants are needed, not {}", count));
    if (poisson && *poisson == 0.5) {
        throw std::invalid_argument(
            "Poisson's ratio 0.5, an incompressible solid, has an infinite bulk modulus; use e.g. 0.49");
    }
    if (poisson && !(*poisson > -1 && *poisson < 0.5))
        throw std::invalid_argument(fmt::format("Poisson's ratio must lie between -1 and 0.5, not at {}", *poisson));
    if (poisson && lame && (*poisson == 0 || *lame == 0)) {
        throw std::invalid_argument("a zero Poisson's ratio or lame_lambda makes both zero and leaves the stiffness "
                                    "open; give another constant instead of one of them");
    }
    const Moduli moduli = convert(constants);
    const bool usable =
        std::isfinite(moduli.bulk) && std::isfinite(moduli.shear) && moduli.bulk > 0 && moduli.shear >= 0;
    if (!usable) {
        throw std::invalid_argument(
            fmt::format("these elastic constants give the bulk modulus {:g} Pa and the shear modulus "
                        "{:g} Pa; the first must be positive and the second not negative",
                        moduli.bulk, moduli.shear));
    }
    return moduli;
}

} // namespace abut
