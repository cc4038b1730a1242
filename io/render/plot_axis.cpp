#include "io/render/plot_axis.h"

#include "io/render/values.h"
#include "io/results/si_prefix.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <iterator>
#include <limits>
#include <utility>

namespace abut {
namespace {

/// The ends of a range.
struct Ends {
    double lower = 0, upper = 0;
};

Range range_of_all(std::span<const std::span<const double>> values, bool positive_only) {
    Range range;
    for (const std::span<const double> list : values) {
        std::vector<double> positive;
        if (positive_only)
            std::copy_if(list.begin(), list.end(), std::back_inserter(positive), [](double v) { return v > 0; });
        range = joined(range, positive_only ? range_of(positive) : range_of(list));
    }
    return range;
}

struct ShownUnit {
    double factor = 1;
    std::string name;
};

/// "1e-30 J" where no prefix reaches.
ShownUnit power_of_ten(double magnitude, const std::string& unit) {
    const double exponent = std::max(std::floor(std::log10(magnitude)), -307.0); // 1e-308 is not exact any more
    return {std::pow(10, exponent), fmt::format("1e{:.0f}{}{}", exponent, unit.empty() ? "" : " ", unit)};
}

ShownUnit shown_unit(double magnitude, const std::string& unit) {
    if (magnitude == 0) return {1, unit};
    const bool no_prefix = unit.empty() || (unit == "s" && magnitude >= 1); // nobody reads kiloseconds
    if (no_prefix && magnitude >= 1e-3 * (1 - 1e-9) && magnitude < 1e5) return {1, unit};
    if (no_prefix) return power_of_ten(magnitude, unit);
    const int power = unit == "m²" ? 2 : 1;
    const SiPrefix prefix = si_prefix(power == 2 ? std::sqrt(magnitude) : magnitude);
    const double factor = std::pow(prefix.factor, power);
    if (magnitude < factor * (1 - 1e-6) || magnitude >= 1e5 * factor * power) return power_of_ten(magnitude, unit);
    return {factor, (prefix.symbol == "u" ? "µ" : std::string(prefix.symbol)) + unit};
}

std::string title_of(const std::string& quantity, const std::string& unit) {
    return unit.empty() ? quantity : fmt::format("{} ({})", quantity, unit);
}

void add_linear_ticks(PlotScale& scale, int intervals) {
    const double step = round_up_nicely((scale.upper - scale.lower) / intervals);
    // A run that stops just short of a tick shall end at one.
    const double beyond = std::ceil(scale.upper / step) * step;
    if (beyond - scale.upper < 0.02 * (scale.upper - scale.lower)) scale.upper = beyond;
    const int decimals = std::max(0, static_cast<int>(-std::floor(std::log10(step) + 1e-9)));
    const double slack = 1e-9 * step;
    for (double n = std::ceil((scale.lower - slack) / step); n * step <= scale.upper + slack; ++n) {
        const double value = n == 0 ? 0 : n * step; // no -0
        scale.ticks.push_back(
            {(value - scale.lower) / (scale.upper - scale.lower), fmt::format("{:.{}f}", value, decimals)});
    }
}

std::string label_of(double digit, int exponent) {
    if (exponent < -3 || exponent > 4) return fmt::format("{:g}e{}", digit, exponent);
    return fmt::format("{:g}", digit * std::pow(10, exponent));
}

/// At powers of ten; within two of them also at 2 and 5 times these.
void add_logarithmic_ticks(PlotScale& scale, int intervals) {
    const double length = scale.upper - scale.lower;
    const int every = std::max(1, static_cast<int>(std::ceil(length / intervals - 1e-9)));
    for (int exponent = static_cast<int>(std::floor(scale.lower)); exponent <= scale.upper + 1e-9; ++exponent)
        for (const double digit : {1.0, 2.0, 5.0}) {
            if (digit > 1 && length > 2) continue;
            if (digit == 1 && exponent % every != 0) continue;
            const double fraction = (exponent + std::log10(digit) - scale.lower) / length;
            if (fraction < -1e-9 || fraction > 1 + 1e-9) continue;
            scale.ticks.push_back({fraction, label_of(digit, exponent)});
        }
}

PlotScale logarithmic_scale(const PlotAxis& axis, Ends range, const PlotAxisWishes& wishes) {
    PlotScale scale;
    scale.logarithmic = true;
    scale.title = title_of(axis.quantity, axis.unit);
    scale.lower = std::log10(range.lower);
    scale.upper = std::log10(range.upper);
    // Without two ticks an axis can't be read.
    if (scale.upper - scale.lower < 0.7) {
        scale.lower = std::floor(scale.lower);
        scale.upper = std::max(std::ceil(scale.upper), scale.lower + 1);
    }
    if (wishes.margin) {
        const double margin = 0.03 * (scale.upper - scale.lower);
        scale.lower -= margin;
        scale.upper += margin;
    }
    add_logarithmic_ticks(scale, wishes.intervals);
    return scale;
}

/// A range with a length, of values in the shown unit.
Ends widened(Ends range, bool margin) {
    const double magnitude = std::max(std::abs(range.lower), std::abs(range.upper));
    const double length = range.upper - range.lower;
    // A constant, but for round-off: in the middle.
    if (length <= 1e-12 * magnitude || length == 0) {
        const double half = magnitude == 0 ? 1 : 0.1 * magnitude;
        return {range.lower - half, range.upper + half};
    }
    if (!margin) return range;
    if (range.lower > 0 && range.lower < 0.4 * range.upper) range.lower = 0;
    if (range.upper < 0 && range.upper > 0.4 * range.lower) range.upper = 0;
    const double room = 0.04 * (range.upper - range.lower);
    // At zero only as much as keeps a curve there from being cut along its middle.
    return {range.lower - (range.lower == 0 ? 0.3 : 1) * room, range.upper + (range.upper == 0 ? 0.3 : 1) * room};
}

} // namespace

double PlotScale::fraction(double value) const {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    if (!std::isfinite(value) || (logarithmic && value <= 0)) return none;
    return ((logarithmic ? std::log10(value) : value / factor) - lower) / (upper - lower);
}

PlotScale plot_scale(const PlotAxis& axis, std::span<const std::span<const double>> values,
                     const PlotAxisWishes& wishes) {
    const auto [lower, upper] =
        range_of_all(values, axis.logarithmic).value_or(axis.logarithmic ? std::pair(1.0, 10.0) : std::pair(0.0, 0.0));
    const Ends range{lower, upper};
    if (axis.logarithmic) return logarithmic_scale(axis, range, wishes);
    const ShownUnit unit = shown_unit(std::max(std::abs(range.lower), std::abs(range.upper)), axis.unit);
    PlotScale scale;
    scale.factor = unit.factor;
    scale.title = title_of(axis.quantity, unit.name);
    const Ends shown = widened({range.lower / unit.factor, range.upper / unit.factor}, wishes.margin);
    scale.lower = shown.lower;
    scale.upper = shown.upper;
    add_linear_ticks(scale, wishes.intervals);
    return scale;
}

} // namespace abut
