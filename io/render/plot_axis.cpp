#include "io/render/plot_axis.h"

#include "io/results/si_prefix.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace abut {
namespace {

struct Range {
    double lower = std::numeric_limits<double>::infinity();
    double upper = -std::numeric_limits<double>::infinity();
    bool empty() const { return lower > upper; }
};

Range range_of(std::span<const std::span<const double>> values, bool positive_only) {
    Range range;
    for (const std::span<const double> list : values)
        for (const double value : list) {
            if (!std::isfinite(value) || (positive_only && value <= 0)) continue;
            range.lower = std::min(range.lower, value);
            range.upper = std::max(range.upper, value);
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

/// The smallest of 1, 2, 5, 10, … that parts `length` into at most `intervals`.
double nice_step(double length, int intervals) {
    const double rough = length / intervals;
    const double power = std::pow(10, std::floor(std::log10(rough)));
    for (const double digit : {1.0, 2.0, 5.0})
        if (digit * power >= rough * (1 - 1e-9)) return digit * power;
    return 10 * power;
}

void add_linear_ticks(PlotScale& scale, int intervals) {
    const double step = nice_step(scale.upper - scale.lower, intervals);
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

PlotScale logarithmic_scale(const PlotAxis& axis, Range range, const PlotAxisWishes& wishes) {
    PlotScale scale;
    scale.logarithmic = true;
    scale.title = title_of(axis.quantity, axis.unit);
    if (range.empty()) range = {1, 10};
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
Range widened(Range range, bool margin) {
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
    Range range = range_of(values, axis.logarithmic);
    if (axis.logarithmic) return logarithmic_scale(axis, range, wishes);
    if (range.empty()) range = {0, 0};
    const ShownUnit unit = shown_unit(std::max(std::abs(range.lower), std::abs(range.upper)), axis.unit);
    PlotScale scale;
    scale.factor = unit.factor;
    scale.title = title_of(axis.quantity, unit.name);
    const Range shown = widened({range.lower / unit.factor, range.upper / unit.factor}, wishes.margin);
    scale.lower = shown.lower;
    scale.upper = shown.upper;
    add_linear_ticks(scale, wishes.intervals);
    return scale;
}

} // namespace abut
