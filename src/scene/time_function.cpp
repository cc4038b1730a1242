#include "scene/time_function.h"

#include <algorithm>

namespace abut {

double TimeFunction::at(double t) const {
    if (t <= time.front()) return value.front();
    if (t >= time.back()) return value.back();
    const auto after = std::upper_bound(time.begin(), time.end(), t) - time.begin();
    const double share = (t - time[after - 1]) / (time[after] - time[after - 1]);
    return value[after - 1] + share * (value[after] - value[after - 1]);
}

double TimeFunction::integral(double t) const {
    if (is_constant()) return value.front() * t;
    // Counted from the first point, wherever 0 lies.
    const auto since_first = [this](double to) {
        if (to <= time.front()) return value.front() * (to - time.front());
        double sum = 0;
        for (std::size_t i = 1; i < time.size() && time[i - 1] < to; ++i) {
            const double end = std::min(time[i], to);
            sum += 0.5 * (value[i - 1] + at(end)) * (end - time[i - 1]);
        }
        if (to > time.back()) sum += value.back() * (to - time.back());
        return sum;
    };
    return since_first(t) - since_first(0);
}

double TimeFunction::smallest() const {
    return *std::min_element(value.begin(), value.end());
}

double TimeFunction::largest() const {
    return *std::max_element(value.begin(), value.end());
}

} // namespace abut
