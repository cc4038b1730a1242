#include "io/scene/elastic_constants.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>

namespace abut {
namespace {

/// Both moduli come back from every pair of constants computed from them by the textbook definitions.
void expect_every_pair(double bulk, double shear) {
    const double lame = bulk - 2 * shear / 3;
    ElasticConstants all{bulk, shear, 9 * bulk * shear / (3 * bulk + shear), lame / (2 * (lame + shear)), lame};
    const std::array<std::optional<double> ElasticConstants::*, 5> members{
        &ElasticConstants::bulk_modulus, &ElasticConstants::shear_modulus, &ElasticConstants::youngs_modulus,
        &ElasticConstants::poissons_ratio, &ElasticConstants::lame_lambda};
    for (std::size_t i = 0; i < members.size(); ++i) {
        for (std::size_t j = i + 1; j < members.size(); ++j) {
            ElasticConstants two;
            two.*members[i] = all.*members[i];
            two.*members[j] = all.*members[j];
            const Moduli moduli = bulk_and_shear(two);
            EXPECT_NEAR(moduli.bulk, bulk, 1e-9 * bulk) << "constants " << i << " and " << j;
            EXPECT_NEAR(moduli.shear, shear, 1e-9 * bulk) << "constants " << i << " and " << j;
        }
    }
}

TEST(ElasticConstants, EveryPairGivesTheModuli) {
    expect_every_pair(78.09e9, 27.6e9);
    expect_every_pair(1, 1e-3);
    expect_every_pair(1, 5); // negative Poisson's ratio
}

TEST(ElasticConstants, YoungAndLameOfANearlyIncompressibleSolid) {
    const double lame = 1e12;
    const double shear = 1.0;
    const double young = shear * (3 * lame + 2 * shear) / (lame + shear);
    const Moduli moduli = bulk_and_shear({.youngs_modulus = young, .lame_lambda = lame});
    EXPECT_NEAR(moduli.shear, shear, 1e-9);
}

std::string error_of(const ElasticConstants& constants) {
    try {
        bulk_and_shear(constants);
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
    return "";
}

TEST(ElasticConstants, Errors) {
    using testing::HasSubstr;
    EXPECT_THAT(error_of({}), HasSubstr("exactly two elastic constants are needed, not 0"));
    EXPECT_THAT(error_of({.bulk_modulus = 1}), HasSubstr("not 1"));
    EXPECT_THAT(error_of({.bulk_modulus = 1, .shear_modulus = 1, .youngs_modulus = 1}), HasSubstr("not 3"));
    EXPECT_THAT(error_of({.youngs_modulus = 1, .poissons_ratio = 0.5}),
                HasSubstr("infinite bulk modulus; use e.g. 0.49"));
    EXPECT_THAT(error_of({.youngs_modulus = 1, .poissons_ratio = -1}), HasSubstr("between -1 and 0.5"));
    EXPECT_THAT(error_of({.bulk_modulus = 1, .youngs_modulus = 10}), HasSubstr("the first must be positive"));
    EXPECT_THAT(error_of({.bulk_modulus = 1, .youngs_modulus = 9}), HasSubstr("the first must be positive"));
    EXPECT_THAT(error_of({.bulk_modulus = 1, .lame_lambda = 2}), HasSubstr("the second not negative"));
    EXPECT_THAT(error_of({.shear_modulus = 3, .lame_lambda = -2}), HasSubstr("the first must be positive"));
    EXPECT_THAT(error_of({.poissons_ratio = 0, .lame_lambda = 0}), HasSubstr("leaves the stiffness open"));
    EXPECT_EQ(error_of({.bulk_modulus = 1, .shear_modulus = 0}), ""); // a fluid
}

} // namespace
} // namespace abut
