#include "io/scene/units.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

namespace abut {
namespace {

std::string error_of(std::string_view text, const Dimension& needed) {
    try {
        parse_quantity(text, needed);
    } catch (const UnitError& error) {
        return error.what();
    }
    return "";
}

TEST(Units, PowersOfTenAreExact) {
    EXPECT_EQ(parse_quantity("78.09 GPa", dimensions::pressure), 78.09e9);
    EXPECT_EQ(parse_quantity("2.78 g/cm^3", dimensions::density), 2780);
    EXPECT_EQ(parse_quantity("14.3 um", dimensions::length), 14.3e-6);
    EXPECT_EQ(parse_quantity("14.3 \u00b5m", dimensions::length), 14.3e-6);
    EXPECT_EQ(parse_quantity("14.3 \u03bcm", dimensions::length), 14.3e-6);
    EXPECT_EQ(parse_quantity("15 us", dimensions::time), 15e-6);
    EXPECT_EQ(parse_quantity("100 m/s", dimensions::velocity), 100);
    EXPECT_EQ(parse_quantity("-9.81 m/s^2", dimensions::acceleration), -9.81);
    EXPECT_EQ(parse_quantity("-9.81 m/s²", dimensions::acceleration), -9.81);
    EXPECT_EQ(parse_quantity("0.1 mm", dimensions::length), 0.1e-3);
    EXPECT_EQ(parse_quantity("3 cm", dimensions::length), 0.03);
    EXPECT_EQ(parse_quantity("1e-3 kg*m^-3", dimensions::density), 1e-3);
    EXPECT_EQ(parse_quantity("1e3mm", dimensions::length), 1);
    EXPECT_EQ(parse_quantity("+.5 m", dimensions::length), 0.5);
    EXPECT_EQ(parse_quantity("5. m", dimensions::length), 5);
    EXPECT_EQ(parse_quantity("  7 mm ", dimensions::length), 7e-3);
}

TEST(Units, OtherFactors) {
    EXPECT_DOUBLE_EQ(parse_quantity("30 deg", dimensions::angle), std::numbers::pi / 6);
    EXPECT_DOUBLE_EQ(parse_quantity("30°", dimensions::angle), std::numbers::pi / 6);
    EXPECT_EQ(parse_quantity("0.5 rad", dimensions::angle), 0.5);
    EXPECT_EQ(parse_quantity("2 min", dimensions::time), 120);
    EXPECT_EQ(parse_quantity("1 h", dimensions::time), 3600);
    EXPECT_DOUBLE_EQ(parse_quantity("36 m/h", dimensions::velocity), 0.01);
}

TEST(Units, CompoundUnits) {
    EXPECT_EQ(parse_quantity("3 1/s", dimensions::rate), 3);
    EXPECT_EQ(parse_quantity("3 /s", dimensions::rate), 3);
    EXPECT_EQ(parse_quantity("2 kHz", dimensions::rate), 2000);
    EXPECT_EQ(parse_quantity("2 N/m^2", dimensions::pressure), 2);
    EXPECT_EQ(parse_quantity("2 kN/mm^2", dimensions::pressure), 2e9);
    EXPECT_EQ(parse_quantity("2 J / m^3", dimensions::pressure), 2);
    EXPECT_EQ(parse_quantity("2 W*s/m/m/m", dimensions::pressure), 2);
    EXPECT_EQ(parse_quantity("2 N·s²/m^4", dimensions::density), 2);
    EXPECT_EQ(parse_quantity("4 K").dimension, (Dimension{.temperature = 1}));
}

TEST(Units, WrongDimension) {
    EXPECT_EQ(error_of("3 mm", dimensions::density), "3 mm is a length; a density (kg/m^3) is needed");
    EXPECT_EQ(error_of("30 deg", dimensions::length), "30 deg is an angle; a length (m) is needed");
    EXPECT_EQ(error_of("3 kg*m/s", dimensions::time), "3 kg*m/s is a quantity in m*kg/s; a time (s) is needed");
    EXPECT_THAT(error_of("3", dimensions::density), testing::HasSubstr("no unit"));
}

TEST(Units, Nonsense) {
    using testing::HasSubstr;
    EXPECT_THAT(error_of("", dimensions::length), HasSubstr("does not begin with a number"));
    EXPECT_THAT(error_of("nan m", dimensions::length), HasSubstr("does not begin with a number"));
    EXPECT_THAT(error_of("inf m", dimensions::length), HasSubstr("does not begin with a number"));
    EXPECT_THAT(error_of("fast", dimensions::velocity), HasSubstr("does not begin with a number"));
    EXPECT_THAT(error_of("-", dimensions::velocity), HasSubstr("does not begin with a number"));
    EXPECT_THAT(error_of("1e400 m", dimensions::length), HasSubstr("too large"));
    EXPECT_THAT(error_of("1e308 Gm", dimensions::length), HasSubstr("too large"));
    EXPECT_THAT(error_of("3 mmm", dimensions::length), HasSubstr("unknown unit \"mmm\"; did you mean \"mm\"?"));
    EXPECT_THAT(error_of("3 gpa", dimensions::pressure), HasSubstr("did you mean \"GPa\"?"));
    EXPECT_THAT(error_of("3 m//s", dimensions::velocity), HasSubstr("a unit is needed before \"/s\""));
    EXPECT_THAT(error_of("3 m/", dimensions::velocity), HasSubstr("a unit is needed"));
    EXPECT_THAT(error_of("3 m/s^", dimensions::velocity), HasSubstr("whole number is needed after"));
    EXPECT_THAT(error_of("3 m^99999999999", dimensions::length), HasSubstr("whole number is needed after"));
    EXPECT_THAT(error_of("3 kg m", dimensions::length), HasSubstr("\"*\" or \"/\" is needed before \"m\""));
    EXPECT_THAT(error_of("3 4 m", dimensions::length), HasSubstr("a unit is needed before \"4 m\""));
    EXPECT_NE(error_of("0x10 m", dimensions::length), "");
    EXPECT_NE(error_of("3 10 m", dimensions::length), "");
}

} // namespace
} // namespace abut
