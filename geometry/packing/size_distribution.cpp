#include "geometry/packing/size_distribution.h"

#include "scene/suggest.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <functional>
#include <stdexcept>

namespace abut {

namespace {

/// Numbers between commas; none of them if one is not a finite number.
std::vector<double> numbers(std::string_view text) {
    std::vector<double> result;
    while (true) {
        const std::string_view word = text.substr(0, text.find(','));
        double value = 0;
        const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
        if (error != std::errc() || end != word.data() + word.size() || !std::isfinite(value)) return {};
        result.push_back(value);
        if (word.size() == text.size()) return result;
        text.remove_prefix(word.size() + 1);
    }
}

} // namespace

double SizeDistribution::sample(Random& random) const {
    if (kind == Kind::equal) return 1;
    if (kind == Kind::uniform) return random.between(min, max);
    // Rounded far above round-off: exp() differs in its last digit between machines.
    return std::round(std::exp(sigma * random.normal()) * 0x1p20) * 0x1p-20;
}

std::vector<double> sample_sizes(const SizeDistribution& sizes, int count, Random& random) {
    std::vector<double> result;
    for (int k = 0; k < count; ++k) result.push_back(sizes.sample(random));
    std::sort(result.begin(), result.end(), std::greater<>());
    return result;
}

SizeDistribution parse_sizes(std::string_view text) {
    const std::vector<std::string> names{"equal", "uniform", "lognormal"};
    const std::string_view name = text.substr(0, text.find(':'));
    const bool has_values = name.size() < text.size();
    const std::vector<double> values = has_values ? numbers(text.substr(name.size() + 1)) : std::vector<double>{};
    SizeDistribution sizes;
    if (name == "equal") {
        if (has_values) throw std::invalid_argument(fmt::format("sizes \"{}\": equal takes no numbers", text));
        sizes.kind = SizeDistribution::Kind::equal;
    } else if (name == "uniform") {
        if (values.size() != 2)
            throw std::invalid_argument(fmt::format("sizes \"{}\": write uniform:MIN,MAX, e.g. uniform:0.6,1.4", text));
        sizes.min = values[0];
        sizes.max = values[1];
    } else if (name == "lognormal") {
        if (values.size() != 1)
            throw std::invalid_argument(fmt::format("sizes \"{}\": write lognormal:SIGMA, e.g. lognormal:0.3", text));
        sizes.kind = SizeDistribution::Kind::lognormal;
        sizes.sigma = values[0];
    } else {
        throw std::invalid_argument(fmt::format("no size distribution \"{}\"{} (there are: equal, uniform:MIN,MAX and "
                                                "lognormal:SIGMA)",
                                                name, did_you_mean(name, names)));
    }
    check_sizes(sizes);
    return sizes;
}

void check_sizes(const SizeDistribution& sizes) {
    if (!(sizes.min > 0 && sizes.max >= sizes.min))
        throw std::invalid_argument("sizes must be larger than 0, the largest not below the smallest");
    if (!(sizes.sigma >= 0 && sizes.sigma <= 1))
        throw std::invalid_argument("the deviation of lognormal sizes must lie between 0 and 1");
}

} // namespace abut
