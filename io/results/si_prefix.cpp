#include "io/results/si_prefix.h"

#include <array>
#include <cmath>
#include <fmt/format.h>

namespace abut {
namespace {

constexpr std::array<SiPrefix, 10> prefixes{{{1e-15, "f"},
                                             {1e-12, "p"},
                                             {1e-9, "n"},
                                             {1e-6, "u"},
                                             {1e-3, "m"},
                                             {1, ""},
                                             {1e3, "k"},
                                             {1e6, "M"},
                                             {1e9, "G"},
                                             {1e12, "T"}}};

SiPrefix time_prefix(double seconds) {
    return std::abs(seconds) < 1 ? si_prefix(seconds) : SiPrefix{};
}

} // namespace

SiPrefix si_prefix(double value) {
    SiPrefix best;
    if (std::abs(value) < prefixes.front().factor || !std::isfinite(value)) return best;
    for (const SiPrefix& prefix : prefixes) // the tolerance keeps 0.999999999999e-6 s from being "1000 ns"
        if (prefix.factor <= std::abs(value) * (1 + 1e-9)) best = prefix;
    return best;
}

std::string format_time(double seconds) {
    const SiPrefix prefix = time_prefix(seconds);
    return fmt::format("{:.4g} {}s", seconds / prefix.factor, prefix.symbol);
}

std::string format_time(double seconds, double end) {
    const SiPrefix prefix = time_prefix(end);
    const double shown_end = end / prefix.factor;
    const int decimals = shown_end >= 100 ? 1 : shown_end >= 10 ? 2 : 3;
    return fmt::format("{:.{}f} {}s", seconds / prefix.factor, decimals, prefix.symbol);
}

std::string format_time_of(double seconds, double end) {
    const SiPrefix prefix = time_prefix(end);
    return fmt::format("{} of {:.6g} {}s", format_time(seconds, end), end / prefix.factor, prefix.symbol);
}

} // namespace abut
