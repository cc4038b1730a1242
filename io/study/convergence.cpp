#include "io/study/convergence.h"

#include <cmath>

namespace abut {

namespace {

/// (h1^p − h2^p)/(h2^p − h3^p), which grows with p. \param r12, r23 h1/h2 and h2/h3
double ratio_of_differences(double r12, double r23, double p) {
    return std::expm1(p * std::log(r12)) / -std::expm1(-p * std::log(r23));
}

} // namespace

Extrapolation extrapolate(std::span<const double> sizes, std::span<const double> values) {
    const std::size_t n = sizes.size();
    if (n < 3) return {{}, {}, "three sizes with a value are needed"};
    const double f1 = values[n - 3], f2 = values[n - 2], f3 = values[n - 1];
    const double r12 = sizes[n - 3] / sizes[n - 2], r23 = sizes[n - 2] / sizes[n - 1];
    if (f2 == f3) return {f3, {}, "the two finest have the same value"};
    const double ratio = (f1 - f2) / (f2 - f3);
    if (ratio < 0) return {{}, {}, "the three finest values oscillate"};
    constexpr double least = 1e-3, most = 30;
    if (!(ratio > ratio_of_differences(r12, r23, least)))
        return {{}, {}, "the three finest values don't approach a limit"};
    double low = least, high = most;
    for (int i = 0; i < 200; ++i) {
        const double middle = 0.5 * (low + high);
        (ratio_of_differences(r12, r23, middle) < ratio ? low : high) = middle;
    }
    const double p = 0.5 * (low + high);
    return {f3 + (f3 - f2) / std::expm1(p * std::log(r23)), p, ""};
}

std::optional<double> fit_order(std::span<const double> sizes, std::span<const double> values) {
    double n = 0, sum_x = 0, sum_y = 0, sum_xx = 0, sum_xy = 0;
    for (std::size_t i = 0; i < sizes.size(); ++i) {
        if (values[i] == 0 || !(sizes[i] > 0)) continue;
        const double x = std::log(sizes[i]), y = std::log(std::abs(values[i]));
        n += 1;
        sum_x += x;
        sum_y += y;
        sum_xx += x * x;
        sum_xy += x * y;
    }
    const double spread = n * sum_xx - sum_x * sum_x;
    if (n < 2 || !(spread > 1e-12 * n * sum_xx)) return {};
    return (n * sum_xy - sum_x * sum_y) / spread;
}

} // namespace abut
