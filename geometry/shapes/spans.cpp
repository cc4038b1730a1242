#include "geometry/shapes/solid.h"

#include <algorithm>
#include <limits>

namespace abut {

namespace {

/// Walks along both lists of spans and keeps where `wanted(in a, in b)` holds.
template <class Wanted>
Spans combined(const Spans& a, const Spans& b, Wanted wanted) {
    Spans result;
    std::size_t i = 0; // ends passed so far: twice the spans, plus one inside of one
    std::size_t j = 0;
    const auto end_of = [](const Spans& spans, std::size_t k) {
        if (k >= 2 * spans.size()) return std::numeric_limits<double>::infinity();
        return k % 2 == 0 ? spans[k / 2].from : spans[k / 2].to;
    };
    bool inside = false;
    while (i < 2 * a.size() || j < 2 * b.size()) {
        const double x = std::min(end_of(a, i), end_of(b, j));
        while (i < 2 * a.size() && end_of(a, i) <= x) ++i;
        while (j < 2 * b.size() && end_of(b, j) <= x) ++j;
        const bool now = wanted(i % 2 == 1, j % 2 == 1);
        if (now == inside) continue;
        if (now)
            result.push_back({x, x});
        else
            result.back().to = x;
        inside = now;
    }
    return result;
}

} // namespace

Spans united(const Spans& a, const Spans& b) {
    return combined(a, b, [](bool in_a, bool in_b) { return in_a || in_b; });
}

Spans intersection(const Spans& a, const Spans& b) {
    return combined(a, b, [](bool in_a, bool in_b) { return in_a && in_b; });
}

Spans difference(const Spans& a, const Spans& b) {
    return combined(a, b, [](bool in_a, bool in_b) { return in_a && !in_b; });
}

} // namespace abut
