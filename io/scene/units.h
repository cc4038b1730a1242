#pragma once
/// \file units.h
/// Physical quantities as a scene writes them: "78.09 GPa", "2.78 g/cm^3", "14.3 um", "-9.81 m/s^2", "30 deg".

#include <stdexcept>
#include <string>
#include <string_view>

namespace abut {

/// Powers of the base units of a quantity. An angle counts as a dimension of its own, so that "30 deg" is no length.
struct Dimension {
    int length = 0;      ///< of m
    int mass = 0;        ///< of kg
    int time = 0;        ///< of s
    int temperature = 0; ///< of K
    int angle = 0;       ///< of rad

    friend bool operator==(const Dimension&, const Dimension&) = default;
};

namespace dimensions {
inline constexpr Dimension none{};
inline constexpr Dimension length{.length = 1};
inline constexpr Dimension time{.time = 1};
inline constexpr Dimension angle{.angle = 1};
inline constexpr Dimension temperature{.temperature = 1};
inline constexpr Dimension rate{.time = -1};
inline constexpr Dimension velocity{.length = 1, .time = -1};
inline constexpr Dimension acceleration{.length = 1, .time = -2};
inline constexpr Dimension density{.length = -3, .mass = 1};
inline constexpr Dimension pressure{.length = -1, .mass = 1, .time = -2};
inline constexpr Dimension stiffness{.length = -2, .mass = 1, .time = -2};      ///< of an interface
inline constexpr Dimension film_viscosity{.length = -2, .mass = 1, .time = -1}; ///< viscosity over thickness
inline constexpr Dimension angular_velocity{.time = -1, .angle = 1};
} // namespace dimensions

/// A value in SI units with its dimension.
struct Quantity {
    double value = 0;
    Dimension dimension;
};

/// A text is no quantity, or one of another dimension; what() says it in words for the user.
class UnitError : public std::invalid_argument {
public:
    using std::invalid_argument::invalid_argument;
};

/// Reads a number and its unit. Units: m g s Pa N J W K Hz rad with the prefixes p n u (µ) m c k M G T; min, h, deg.
/// They are combined by `*` and `/` (read from left to right) and raised by `^`; ², ³, · and ° are read as well.
/// Powers of ten are exact: "14.3 um" is the double nearest to 14.3e-6. Throws UnitError.
Quantity parse_quantity(std::string_view text);

/// The value in SI units of a text that must have the dimension `needed`. Throws UnitError, e.g. with
/// "3 mm is a length; a density (kg/m^3) is needed".
double parse_quantity(std::string_view text, const Dimension& needed);

/// The SI unit of a dimension: "kg/m^3", "Pa"; "1" for a plain number.
std::string unit_of(const Dimension& dimension);

/// A dimension in words with its article: "a density", "an angle"; "a quantity in m^2*kg/s" where there is no word.
std::string name_of(const Dimension& dimension);

} // namespace abut
