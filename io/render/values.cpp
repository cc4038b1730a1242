#include "io/render/values.h"

#include "io/results/si_prefix.h"
#include "results/arrays.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <string_view>

namespace abut {
namespace {

struct Unit {
    std::string quantity, unit;
    bool prefixed; ///< whether the unit takes an SI prefix as it stands
};

Unit unit_of(const Array& array) {
    Unit result{array.name, std::string(unit_of_array(array.name)), false};
    if (array.name == "deformation_gradient")
        result.quantity = "F";
    else if (array.name == "von_mises_stress")
        result.quantity = "von Mises stress";
    else
        std::replace(result.quantity.begin(), result.quantity.end(), '_', ' ');
    constexpr std::array<std::string_view, 5> takes_prefix{"m", "m/s", "Pa", "N", "J/m^3"};
    result.prefixed = std::count(takes_prefix.begin(), takes_prefix.end(), result.unit) > 0;
    for (const auto& [power, sign] : {std::pair{"^2", "²"}, std::pair{"^3", "³"}})
        if (const auto at = result.unit.find(power); at != std::string::npos) result.unit.replace(at, 2, sign);
    return result;
}

std::string component_name(int component, int components) {
    constexpr std::array vector{"x", "y", "z"};
    constexpr std::array symmetric{"xx", "yy", "zz", "xy", "yz", "xz"};
    constexpr std::array full{"xx", "xy", "xz", "yx", "yy", "yz", "zx", "zy", "zz"};
    const auto c = static_cast<std::size_t>(component);
    switch (components) {
    case 3:
        return vector[c];
    case 6:
        return symmetric[c];
    case 9:
        return full[c];
    default:
        return fmt::format("{}", component);
    }
}

void add_ticks(ColourScale& scale, double shown_factor) {
    const double lower = scale.lower / shown_factor, upper = scale.upper / shown_factor;
    const double step = round_down_nicely((upper - lower) / 4);
    const int decimals = std::max(0, static_cast<int>(std::ceil(-std::log10(step) - 1e-9)));
    for (double k = std::ceil(lower / step - 1e-6); k * step <= upper + 1e-6 * step; ++k)
        scale.ticks.emplace_back(k * step * shown_factor, fmt::format("{:.{}f}", k == 0 ? 0.0 : k * step, decimals));
}

/// Ends that read well, and whether the range is one around zero.
void choose_range(ColourScale& scale, double lowest, double highest) {
    const double size = std::max(std::abs(lowest), std::abs(highest));
    const auto up = [](double v) { // to the next of 1, 1.2, 1.5, 2, 2.5, 3, 4, 5, 6, 8 times a power of ten
        const double power = std::pow(10, std::floor(std::log10(v) + 1e-9));
        for (const double m : {1.0, 1.2, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0})
            if (v <= m * power * (1 + 1e-9)) return m * power;
        return 10 * power;
    };
    if (size == 0) return; // 0 to 1
    if (lowest < -0.05 * size && highest > 0.05 * size) {
        scale.map = ColourMap::diverging;
        scale.upper = up(size);
        scale.lower = -scale.upper;
    } else if (lowest > 0.5 * highest || highest < 0.5 * lowest) { // far from zero
        scale.lower = lowest;
        scale.upper = highest;
    } else {
        scale.lower = highest > -lowest ? 0 : -up(size);
        scale.upper = highest > -lowest ? up(size) : 0;
    }
}

} // namespace

const Array* find_array(const PointFrame& frame, const std::string& name) {
    const auto found =
        std::find_if(frame.arrays.begin(), frame.arrays.end(), [&](const Array& a) { return a.name == name; });
    return found == frame.arrays.end() ? nullptr : &*found;
}

std::vector<double> values_of(const Array& array, int component) {
    return std::visit(
        [&](const auto& values) {
            const auto n = static_cast<std::size_t>(array.components);
            std::vector<double> result(values.size() / n);
            for (std::size_t i = 0; i < result.size(); ++i) {
                const auto* tuple = &values[i * n];
                if (component >= 0 || n == 1) {
                    result[i] = static_cast<double>(tuple[std::max(component, 0)]);
                    continue;
                }
                double square = 0; // off-diagonal components of a symmetric tensor stand for two
                for (std::size_t k = 0; k < n; ++k)
                    square +=
                        (n == 6 && k >= 3 ? 2.0 : 1.0) * static_cast<double>(tuple[k]) * static_cast<double>(tuple[k]);
                result[i] = std::sqrt(square);
            }
            return result;
        },
        array.values);
}

Range range_of(std::span<const double> values) {
    Range range;
    for (const double v : values) {
        if (!std::isfinite(v)) continue;
        range = range ? std::pair(std::min(range->first, v), std::max(range->second, v)) : std::pair(v, v);
    }
    return range;
}

Range range_of(const std::vector<double>& values, double percentile) {
    std::vector<double> finite;
    std::copy_if(values.begin(), values.end(), std::back_inserter(finite), [](double v) { return std::isfinite(v); });
    if (finite.empty()) return {};
    const auto rank = [&](double percent) { // nearest rank
        const auto n = static_cast<double>(finite.size());
        const auto place =
            static_cast<std::ptrdiff_t>(std::clamp(std::ceil(percent / 100 * n * (1 - 1e-12)), 1.0, n)) - 1;
        std::nth_element(finite.begin(), finite.begin() + place, finite.end());
        return finite[static_cast<std::size_t>(place)];
    };
    const double lowest = *std::min_element(finite.begin(), finite.end());
    const double upper = rank(percentile);
    return std::pair(lowest < 0 ? rank(100 - percentile) : lowest, upper);
}

Range joined(const Range& a, const Range& b) {
    if (!a || !b) return a ? a : b;
    return std::pair(std::min(a->first, b->first), std::max(a->second, b->second));
}

ColourScale colour_scale(const Array& array, int component, Range range, bool exact) {
    const Unit unit = unit_of(array);
    ColourScale scale;
    scale.quantity = unit.quantity;
    if (component >= 0 && array.components > 1)
        scale.quantity = fmt::format("{} {}", unit.quantity, component_name(component, array.components));
    if (range && exact) {
        scale.lower = range->first;
        scale.upper = range->second;
        if (scale.lower == -scale.upper) scale.map = ColourMap::diverging;
    } else if (range) {
        choose_range(scale, range->first, range->second);
    }
    const double size = std::max(std::abs(scale.lower), std::abs(scale.upper));
    if (scale.upper - scale.lower <= 1e-9 * size ||
        !(scale.upper > scale.lower)) { // constant: the middle of some range
        const double half = size > 0 ? 0.1 * size : 1;
        scale.lower -= half;
        scale.upper += half;
    }

    double factor = 1;
    if (unit.prefixed) {
        const SiPrefix prefix = si_prefix(size);
        factor = prefix.factor;
        scale.unit = fmt::format("{}{}", prefix.symbol == "u" ? "µ" : prefix.symbol, unit.unit);
    } else if (size < 1e-3 || size >= 1e5) {
        const int exponent = static_cast<int>(std::floor(std::log10(size) + 1e-9));
        factor = std::pow(10, exponent);
        scale.unit = fmt::format("1e{} {}", exponent, unit.unit);
    } else {
        scale.unit = unit.unit;
    }
    add_ticks(scale, factor);
    return scale;
}

double round_down_nicely(double value) {
    const double power = std::pow(10, std::floor(std::log10(value) + 1e-9));
    for (const double m : {5.0, 2.0})
        if (value >= m * power * (1 - 1e-9)) return m * power;
    return power;
}

double round_up_nicely(double value) {
    const double power = std::pow(10, std::floor(std::log10(value)));
    for (const double m : {1.0, 2.0, 5.0})
        if (m * power >= value * (1 - 1e-9)) return m * power;
    return 10 * power;
}

} // namespace abut
