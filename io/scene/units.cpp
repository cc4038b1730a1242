#include "io/scene/units.h"

#include "scene/suggest.h"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace abut {

namespace {

/// symbol = factor × 10^power_of_ten in SI. Powers of ten are kept apart because only they can be applied exactly.
struct Unit {
    std::string_view symbol;
    Dimension dimension;
    int power_of_ten = 0;
    double factor = 1;
    bool takes_prefix = true;
};

constexpr std::array units{
    Unit{"m", dimensions::length},
    Unit{"g", {.mass = 1}, -3},
    Unit{"s", dimensions::time},
    Unit{"K", {.temperature = 1}},
    Unit{"Pa", dimensions::pressure},
    Unit{"N", {.length = 1, .mass = 1, .time = -2}},
    Unit{"J", {.length = 2, .mass = 1, .time = -2}},
    Unit{"W", {.length = 2, .mass = 1, .time = -3}},
    Unit{"Hz", dimensions::rate},
    Unit{"rad", dimensions::angle},
    Unit{"deg", dimensions::angle, 0, std::numbers::pi / 180, false},
    Unit{"min", dimensions::time, 0, 60, false},
    Unit{"h", dimensions::time, 0, 3600, false},
};

struct Prefix {
    char symbol;
    int power_of_ten;
};
constexpr std::array prefixes{Prefix{'p', -12}, Prefix{'n', -9}, Prefix{'u', -6}, Prefix{'m', -3}, Prefix{'c', -2},
                              Prefix{'k', 3},   Prefix{'M', 6},  Prefix{'G', 9},  Prefix{'T', 12}};

struct NamedDimension {
    Dimension dimension;
    std::string_view name;
    std::string_view unit;
};
constexpr std::array named_dimensions{
    NamedDimension{dimensions::none, "a plain number", "1"},
    NamedDimension{dimensions::length, "a length", "m"},
    NamedDimension{{.length = 2}, "an area", "m^2"},
    NamedDimension{{.length = 3}, "a volume", "m^3"},
    NamedDimension{{.mass = 1}, "a mass", "kg"},
    NamedDimension{dimensions::time, "a time", "s"},
    NamedDimension{{.temperature = 1}, "a temperature", "K"},
    NamedDimension{dimensions::angle, "an angle", "rad"},
    NamedDimension{dimensions::rate, "a rate", "1/s"},
    NamedDimension{dimensions::velocity, "a velocity", "m/s"},
    NamedDimension{dimensions::acceleration, "an acceleration", "m/s^2"},
    NamedDimension{dimensions::density, "a density", "kg/m^3"},
    NamedDimension{dimensions::pressure, "a pressure", "Pa"},
    NamedDimension{dimensions::stiffness, "a stiffness of an interface", "Pa/m"},
    NamedDimension{dimensions::film_viscosity, "a viscosity over a thickness", "Pa*s/m"},
    NamedDimension{dimensions::angular_velocity, "an angular velocity", "rad/s"},
    NamedDimension{{.length = 1, .mass = 1, .time = -2}, "a force", "N"},
    NamedDimension{{.length = 2, .mass = 1, .time = -2}, "an energy", "J"},
    NamedDimension{{.length = 2, .mass = 1, .time = -3}, "a power", "W"},
};

void replace_all(std::string& text, std::string_view from, std::string_view to) {
    for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
        text.replace(at, from.size(), to);
}

/// Everything to ASCII: both Unicode characters for micro, superscripts, the product dot and the degree sign.
std::string plain(std::string_view text) {
    static constexpr std::array<std::pair<std::string_view, std::string_view>, 7> replacements{{{"\u00b5", "u"},
                                                                                                {"\u03bc", "u"},
                                                                                                {"\u00b2", "^2"},
                                                                                                {"\u00b3", "^3"},
                                                                                                {"\u00b7", "*"},
                                                                                                {"\u00b0", "deg"},
                                                                                                {"\u2212", "-"}}};
    std::string ascii(text);
    for (const auto& [from, to] : replacements) replace_all(ascii, from, to);
    return ascii;
}

bool is_digit(char letter) {
    return letter >= '0' && letter <= '9';
}
bool is_letter(char letter) {
    return (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z');
}

/// Reads a text from left to right.
struct Cursor {
    std::string_view rest;

    void skip_blanks() {
        while (!rest.empty() && (rest.front() == ' ' || rest.front() == '\t')) rest.remove_prefix(1);
    }
    bool take(char letter) {
        if (rest.empty() || rest.front() != letter) return false;
        rest.remove_prefix(1);
        return true;
    }
    template <class Test>
    std::string_view take_while(Test test) {
        std::size_t count = 0;
        while (count < rest.size() && test(rest[count])) ++count;
        const std::string_view taken = rest.substr(0, count);
        rest.remove_prefix(count);
        return taken;
    }
};

/// A signed whole number of at most 4 digits, so that sums of such exponents cannot overflow.
std::optional<int> take_integer(Cursor& cursor) {
    const bool negative = cursor.take('-');
    if (!negative) cursor.take('+');
    const std::string_view digits = cursor.take_while(is_digit);
    if (digits.empty() || digits.size() > 4) return {};
    int value = 0;
    std::from_chars(digits.data(), digits.data() + digits.size(), value);
    return negative ? -value : value;
}

struct Decimal {
    std::string mantissa;
    int exponent = 0;
};

std::optional<Decimal> take_decimal(Cursor& cursor) {
    Decimal number;
    if (cursor.take('-')) {
        number.mantissa = "-";
    } else {
        cursor.take('+');
    }
    const std::string_view whole = cursor.take_while(is_digit);
    std::string_view fraction;
    if (cursor.take('.')) fraction = cursor.take_while(is_digit);
    if (whole.empty() && fraction.empty()) return {};
    number.mantissa += fmt::format("{}.{}", whole.empty() ? "0" : whole, fraction.empty() ? "0" : fraction);
    Cursor behind = cursor;
    if (behind.take('e') || behind.take('E')) {
        if (const std::optional<int> exponent = take_integer(behind)) {
            number.exponent = *exponent;
            cursor = behind;
        }
    }
    return number;
}

std::vector<std::string> all_symbols() {
    std::vector<std::string> symbols;
    for (const Unit& unit : units) {
        symbols.emplace_back(unit.symbol);
        if (!unit.takes_prefix) continue;
        for (const Prefix& prefix : prefixes) symbols.push_back(prefix.symbol + std::string(unit.symbol));
    }
    return symbols;
}

Unit find_unit(std::string_view symbol) {
    for (const Unit& unit : units)
        if (unit.symbol == symbol) return unit;
    for (const Unit& unit : units) {
        if (!unit.takes_prefix || symbol.size() != unit.symbol.size() + 1 || !symbol.ends_with(unit.symbol)) continue;
        for (const Prefix& prefix : prefixes) {
            if (prefix.symbol != symbol.front()) continue;
            Unit prefixed = unit;
            prefixed.power_of_ten += prefix.power_of_ten;
            return prefixed;
        }
    }
    throw UnitError(fmt::format("unknown unit \"{}\"{}", symbol, did_you_mean(symbol, all_symbols())));
}

/// What the units of a text amount to: value × 10^power_of_ten × multiplied / divided.
struct Scale {
    Dimension dimension;
    int power_of_ten = 0;
    double multiplied = 1;
    double divided = 1;
};

void apply(Scale& scale, const Unit& unit, int power) {
    scale.dimension.length += power * unit.dimension.length;
    scale.dimension.mass += power * unit.dimension.mass;
    scale.dimension.time += power * unit.dimension.time;
    scale.dimension.temperature += power * unit.dimension.temperature;
    scale.dimension.angle += power * unit.dimension.angle;
    scale.power_of_ten += power * unit.power_of_ten;
    for (int i = 0; i < std::abs(power); ++i) (power > 0 ? scale.multiplied : scale.divided) *= unit.factor;
}

/// FACTOR { (*|/) FACTOR } with FACTOR = symbol[^integer] or 1.
Scale take_units(Cursor& cursor) {
    Scale scale;
    bool divide = cursor.take('/'); // "5 /s"
    for (;;) {
        cursor.skip_blanks();
        if (!cursor.take('1')) {
            const std::string_view symbol = cursor.take_while(is_letter);
            if (symbol.empty()) throw UnitError(fmt::format("a unit is needed before \"{}\"", cursor.rest));
            const Unit unit = find_unit(symbol);
            int power = 1;
            cursor.skip_blanks();
            if (cursor.take('^')) {
                cursor.skip_blanks();
                const std::optional<int> exponent = take_integer(cursor);
                if (!exponent || std::abs(*exponent) > 9)
                    throw UnitError(fmt::format("a small whole number is needed after \"{}^\"", symbol));
                power = *exponent;
            }
            apply(scale, unit, divide ? -power : power);
        }
        cursor.skip_blanks();
        if (cursor.rest.empty()) return scale;
        divide = cursor.take('/');
        if (!divide && !cursor.take('*'))
            throw UnitError(fmt::format("\"*\" or \"/\" is needed before \"{}\"", cursor.rest));
    }
}

} // namespace

Quantity parse_quantity(std::string_view text) {
    const std::string ascii = plain(text);
    Cursor cursor{ascii};
    cursor.skip_blanks();
    const std::optional<Decimal> number = take_decimal(cursor);
    if (!number) throw UnitError(fmt::format("\"{}\" does not begin with a number", text));
    cursor.skip_blanks();
    Scale scale;
    if (!cursor.rest.empty()) {
        try {
            scale = take_units(cursor);
        } catch (const UnitError& error) {
            throw UnitError(fmt::format("\"{}\": {}", text, error.what()));
        }
    }
    const std::string decimal = fmt::format("{}e{}", number->mantissa, number->exponent + scale.power_of_ten);
    double value = 0;
    const auto [end, error] = std::from_chars(decimal.data(), decimal.data() + decimal.size(), value);
    value = value * scale.multiplied / scale.divided;
    if (error != std::errc{} || !std::isfinite(value))
        throw UnitError(fmt::format("\"{}\" is too large or too small a number", text));
    return {value, scale.dimension};
}

double parse_quantity(std::string_view text, const Dimension& needed) {
    const Quantity quantity = parse_quantity(text);
    if (quantity.dimension == needed) return quantity.value;
    if (quantity.dimension == dimensions::none) {
        throw UnitError(
            fmt::format("\"{0}\" has no unit; {1} is needed: \"{0} {2}\", or a number without quotes, in {2}", text,
                        name_of(needed), unit_of(needed)));
    }
    throw UnitError(fmt::format("{} is {}; {} ({}) is needed", text, name_of(quantity.dimension), name_of(needed),
                                unit_of(needed)));
}

std::string unit_of(const Dimension& dimension) {
    for (const NamedDimension& named : named_dimensions)
        if (named.dimension == dimension) return std::string(named.unit);
    const std::array<std::pair<std::string_view, int>, 5> powers{{{"m", dimension.length},
                                                                  {"kg", dimension.mass},
                                                                  {"s", dimension.time},
                                                                  {"K", dimension.temperature},
                                                                  {"rad", dimension.angle}}};
    std::string above;
    std::string below;
    for (const auto& [symbol, power] : powers) {
        if (power == 0) continue;
        const std::string raised =
            std::abs(power) == 1 ? std::string(symbol) : fmt::format("{}^{}", symbol, std::abs(power));
        if (power > 0) above += (above.empty() ? "" : "*") + raised;
        if (power < 0) below += "/" + raised;
    }
    return (above.empty() ? "1" : above) + below;
}

std::string name_of(const Dimension& dimension) {
    for (const NamedDimension& named : named_dimensions)
        if (named.dimension == dimension) return std::string(named.name);
    return "a quantity in " + unit_of(dimension);
}

} // namespace abut
