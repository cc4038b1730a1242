#include "geometry/packing/ellipse_contact.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace abut {

Outline outline(const Ellipse& ellipse) {
    const double c = std::cos(ellipse.angle), s = std::sin(ellipse.angle);
    const auto [a, b] = ellipse.semi_axes;
    return {ellipse.center[0],
            ellipse.center[1],
            a * a * c * c + b * b * s * s,
            (a * a - b * b) * c * s,
            a * a * s * s + b * b * c * c,
            std::max(a, b)};
}

Closeness closeness(const Outline& a, const Outline& b, double enough) {
    const double x = b.x - a.x, y = b.y - a.y;
    // F = max over λ in [0, 1] of λ (1 − λ) rᵀ [(1 − λ) A + λ B]⁻¹ r, a concave function of λ. Every λ gives a lower
    // bound of F, so that a search which stops early never calls overlapping ellipses apart.
    const auto value = [&](double lambda) {
        const double mu = 1 - lambda;
        const double xx = mu * a.xx + lambda * b.xx, xy = mu * a.xy + lambda * b.xy, yy = mu * a.yy + lambda * b.yy;
        return lambda * mu * (yy * x * x - 2 * xy * x * y + xx * y * y) / (xx * yy - xy * xy);
    };
    const double middle = value(0.5);
    if (middle >= enough) return {middle, 0.5};
    constexpr double golden = 1 / std::numbers::phi;
    double lower = 0, upper = 1;
    double p = upper - golden, q = lower + golden;
    double value_p = value(p), value_q = value(q);
    for (int step = 0; step < 32 && std::max(value_p, value_q) < enough; ++step) {
        if (value_p > value_q) {
            upper = q;
            q = p;
            value_q = value_p;
            p = upper - golden * (upper - lower);
            value_p = value(p);
        } else {
            lower = p;
            p = q;
            value_p = value_q;
            q = lower + golden * (upper - lower);
            value_q = value(q);
        }
    }
    if (middle >= value_p && middle >= value_q) return {middle, 0.5};
    return value_p > value_q ? Closeness{value_p, p} : Closeness{value_q, q};
}

double contact_function(const Outline& a, const Outline& b, double enough) {
    return closeness(a, b, enough).value;
}

Outline outline_with_gap(Ellipse ellipse, double gap) {
    const auto [a, b] = ellipse.semi_axes;
    const double extra = 0.5 * gap * (a + b) / (2 * std::sqrt(a * b));
    for (double& axis : ellipse.semi_axes) axis += extra;
    return outline(ellipse);
}

std::array<double, 2> half_extent(const Ellipse& ellipse) {
    const double c = std::cos(ellipse.angle), s = std::sin(ellipse.angle);
    const auto [a, b] = ellipse.semi_axes;
    return {std::hypot(a * c, b * s), std::hypot(a * s, b * c)};
}

} // namespace abut
